// An XML file whose errors name the line. Only sources of readers include this header, because it includes pugixml.
#pragma once
#include <pugixml.hpp>
#include <string>
#include <string_view>

namespace waymark::plan {

class XmlDocument {
 public:
  // Throws ltl::FormatError for malformed XML.
  XmlDocument(std::string_view text, std::string_view source);
  // The one element of the document, which must have that name.
  pugi::xml_node root(const char* name) const;

  // All throw ltl::FormatError with the line of the element.
  [[noreturn]] void fail(const pugi::xml_node& at, const std::string& message) const;
  std::string attribute(const pugi::xml_node& element, const char* name) const;  // must be there
  double number(const pugi::xml_node& element, std::string_view text) const;     // finite

 private:
  std::size_t line_of(std::ptrdiff_t offset) const;
  std::string_view text_;
  std::string source_;
  pugi::xml_document document_;
};

}  // namespace waymark::plan
