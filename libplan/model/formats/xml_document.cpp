#include "libplan/model/formats/xml_document.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "libltl/diagnostic.hpp"

namespace waymark::plan {

XmlDocument::XmlDocument(std::string_view text, std::string_view source) : text_(text), source_(source) {
  const pugi::xml_parse_result result = document_.load_buffer(text.data(), text.size());
  if (!result)
    throw ltl::FormatError(source_, line_of(result.offset), 0, std::string("malformed XML: ") + result.description());
}

pugi::xml_node XmlDocument::root(const char* name) const {
  const pugi::xml_node found = document_.document_element();
  if (std::string_view(found.name()) != name) fail(found, "expected <" + std::string(name) + ">");
  return found;
}

void XmlDocument::fail(const pugi::xml_node& at, const std::string& message) const {
  throw ltl::FormatError(source_, line_of(at.offset_debug()), 0, message);
}

std::string XmlDocument::attribute(const pugi::xml_node& element, const char* name) const {
  const pugi::xml_attribute value = element.attribute(name);
  if (!value) fail(element, "<" + std::string(element.name()) + "> has no attribute " + name);
  return value.value();
}

double XmlDocument::number(const pugi::xml_node& element, std::string_view text) const {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    fail(element, "expected a number, not '" + std::string(text.substr(0, 40)) + "'");
  return value;
}

std::size_t XmlDocument::line_of(std::ptrdiff_t offset) const {
  if (offset < 0) return 0;
  const std::string_view before = text_.substr(0, std::min(static_cast<std::size_t>(offset), text_.size()));
  return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
}

}  // namespace waymark::plan
