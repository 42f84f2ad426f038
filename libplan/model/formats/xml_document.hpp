// An XML file whose errors name the line. Only sources of readers include this header, because it includes pugixml.
#pragma once
#include <cstddef>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace waymark::plan {

class XmlDocument {
 public:
  enum class Blanks { Dropped, Kept };  // beside comments and elements

  // Throws ltl::FormatError for malformed XML.
  XmlDocument(std::string_view text, std::string_view source, Blanks blanks = Blanks::Dropped);
  // The one element of the document, which must have that name. Throws ltl::FormatError.
  pugi::xml_node root(const char* name) const;
  // The elements of that name at any depth, in the order of the file.
  std::vector<pugi::xml_node> all(std::string_view name) const;
  // All the text below an element, whatever stands between.
  static std::string text(const pugi::xml_node& element);

  std::size_t line(const pugi::xml_node& at) const;  // counted from 1; 0 when it is not known

  // All throw ltl::FormatError with the line of the element.
  [[noreturn]] void fail(const pugi::xml_node& at, const std::string& message) const;
  std::string attribute(const pugi::xml_node& element, const char* name) const;  // must be there
  int integer(const pugi::xml_node& element, const char* name) const;            // an attribute
  double number(const pugi::xml_node& element, std::string_view text) const;     // finite

 private:
  std::size_t line_of(std::ptrdiff_t offset) const;
  std::string source_;
  std::vector<std::ptrdiff_t> newlines_;  // where they stand
  pugi::xml_document document_;
};

}  // namespace waymark::plan
