#include "libplan/model/formats/xml_document.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "libltl/diagnostic.hpp"
#include "libltl/text/foreign.hpp"

namespace waymark::plan {
namespace {

// The next below root in the order of the file, without recursion: files nest as deep as they like. Null: none.
pugi::xml_node after(pugi::xml_node node, const pugi::xml_node& root) {
  if (const pugi::xml_node child = node.first_child()) return child;
  while (node != root && !node.next_sibling()) node = node.parent();
  return node == root ? pugi::xml_node() : node.next_sibling();
}

}  // namespace

XmlDocument::XmlDocument(std::string_view text, std::string_view source, Blanks blanks) : source_(source) {
  ltl::refuse_foreign(text, source, "XML", "an XML document");
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '\n') newlines_.push_back(static_cast<std::ptrdiff_t>(i));
  const unsigned options = pugi::parse_default | (blanks == Blanks::Kept ? pugi::parse_ws_pcdata : 0U);
  const pugi::xml_parse_result result = document_.load_buffer(text.data(), text.size(), options, pugi::encoding_utf8);
  if (!result)
    throw ltl::FormatError(source_, line_of(result.offset), 0, std::string("malformed XML: ") + result.description());
}

pugi::xml_node XmlDocument::root(const char* name) const {
  const pugi::xml_node found = document_.document_element();
  if (std::string_view(found.name()) != name) fail(found, "expected <" + std::string(name) + ">");
  return found;
}

std::vector<pugi::xml_node> XmlDocument::all(std::string_view name) const {
  std::vector<pugi::xml_node> found;
  const pugi::xml_node root = document_.root();
  for (pugi::xml_node node = after(root, root); node; node = after(node, root))
    if (node.name() == name) found.push_back(node);
  return found;
}

std::string XmlDocument::text(const pugi::xml_node& element) {
  std::string out;
  for (pugi::xml_node node = after(element, element); node; node = after(node, element)) out += node.value();
  return out;
}

std::size_t XmlDocument::line(const pugi::xml_node& at) const { return line_of(at.offset_debug()); }

void XmlDocument::fail(const pugi::xml_node& at, const std::string& message) const {
  throw ltl::FormatError(source_, line(at), 0, message);
}

std::string XmlDocument::attribute(const pugi::xml_node& element, const char* name) const {
  const pugi::xml_attribute value = element.attribute(name);
  if (!value) fail(element, "<" + std::string(element.name()) + "> has no attribute " + name);
  return value.value();
}

int XmlDocument::integer(const pugi::xml_node& element, const char* name) const {
  const std::string text = attribute(element, name);
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    fail(element, std::string(name) + ": expected a whole number");
  return value;
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
  const auto before = std::lower_bound(newlines_.begin(), newlines_.end(), offset);
  return 1 + static_cast<std::size_t>(before - newlines_.begin());
}

}  // namespace waymark::plan
