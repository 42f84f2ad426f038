// XML read element by element, for files that memory should not hold.
//
// Tells where elements begin and end, and their attributes. Text, comments, processing instructions and CDATA are
// skipped; of a document type only its end is looked for. Entities are the five of XML and numbers.
#pragma once
#include <cstddef>
#include <deque>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace waymark::plan {

class XmlStream {
 public:
  enum class Event { Begin, End, Over };  // of an element; of the document

  // The source is named in errors.
  XmlStream(std::istream& in, std::string_view source) : in_(in), source_(source) {}

  // Throws ltl::FormatError with the line: cut short, elements that are not nested, a tag that is none or longer than
  // 16 MiB, two elements side by side that are not in one.
  Event next();
  const std::string& name() const { return name_; }                  // of the element that begins or ends
  std::size_t depth() const { return open_.size(); }                 // elements around it, itself among them
  std::optional<std::string_view> attribute(std::string_view name);  // of the one that begins, until the next event
  std::string_view needed(std::string_view name);                    // an attribute that must be there
  [[noreturn]] void fail(const std::string& message) const;

 private:
  bool fill();                           // more of the file behind what is kept; false at its end
  void consume(std::size_t bytes);       // and count their lines
  bool skip_past(std::string_view end);  // false: the file ends before
  std::string_view tag();                // from < to >
  void begin(std::string_view tag);      // <name a="…">
  std::string_view decoded(std::string_view raw);

  std::istream& in_;
  std::string source_, buffer_, name_;
  std::size_t at_ = 0, line_ = 1;
  std::vector<std::string> open_;
  std::vector<std::pair<std::string_view, std::string_view>> attributes_;  // in the buffer
  std::deque<std::string> decoded_;
  std::size_t taken_ = 0;                                              // bytes of the tag that attributes still lie in
  bool ends_ = false, left_ = false, began_ = false, is_xml_ = false;  // is_xml_: of no other format that is known
};

}  // namespace waymark::plan
