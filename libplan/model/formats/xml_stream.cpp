#include "libplan/model/formats/xml_stream.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <utility>

#include "libltl/diagnostic.hpp"
#include "libltl/text/foreign.hpp"

namespace waymark::plan {
namespace {

constexpr std::size_t bytes_at_once = std::size_t{1} << 16U;
constexpr std::size_t longest_tag = std::size_t{1} << 24U;
constexpr std::size_t longest_text = std::size_t{1} << 26U;
constexpr std::string_view blanks = " \t\r\n";

std::string_view after_blanks(std::string_view s) {
  const std::size_t first = s.find_first_not_of(blanks);
  return first == std::string_view::npos ? std::string_view{} : s.substr(first);
}

void append_utf8(std::string& out, std::uint32_t c) {
  const auto byte = [&](std::uint32_t b) { out += static_cast<char>(static_cast<unsigned char>(b)); };
  if (c < 0x80) return byte(c);
  if (c < 0x800) {
    byte(0xC0U | (c >> 6U));
  } else {
    if (c < 0x10000) {
      byte(0xE0U | (c >> 12U));
    } else {
      byte(0xF0U | (c >> 18U));
      byte(0x80U | ((c >> 12U) & 0x3FU));
    }
    byte(0x80U | ((c >> 6U) & 0x3FU));
  }
  byte(0x80U | (c & 0x3FU));
}

}  // namespace

void XmlStream::fail(const std::string& message) const { throw ltl::FormatError(source_, line_, 0, message); }

bool XmlStream::fill() {
  if (at_ > 0) {
    buffer_.erase(0, at_);
    at_ = 0;
  }
  const std::size_t kept = buffer_.size();
  buffer_.resize(kept + bytes_at_once);
  in_.read(buffer_.data() + kept, static_cast<std::streamsize>(bytes_at_once));
  buffer_.resize(kept + static_cast<std::size_t>(in_.gcount()));
  if (!std::exchange(is_xml_, true)) ltl::refuse_foreign(buffer_, source_, "XML", "an XML document");
  if (buffer_.find('\0', kept) != std::string::npos) fail("a byte 0: this is no XML");
  return buffer_.size() > kept;
}

void XmlStream::consume(std::size_t bytes) {
  const auto from = buffer_.begin() + static_cast<std::ptrdiff_t>(at_);
  line_ += static_cast<std::size_t>(std::count(from, from + static_cast<std::ptrdiff_t>(bytes), '\n'));
  at_ += bytes;
}

bool XmlStream::skip_past(std::string_view end) {
  for (std::size_t skipped = 0;; skipped += bytes_at_once) {
    if (skipped > longest_text) fail("more than 64 MiB without a tag: this is no XML");
    const std::size_t found = buffer_.find(end, at_);
    if (found != std::string::npos) {
      consume(found + end.size() - at_);
      return true;
    }
    if (buffer_.size() - at_ >= end.size()) consume(buffer_.size() - at_ - end.size() + 1);
    if (!fill()) return false;
  }
}

// Attributes may hold > between quotes.
std::string_view XmlStream::tag() {
  std::size_t i = at_ + 1;
  char quote = 0;
  for (;; ++i) {
    if (i == buffer_.size()) {
      const std::size_t length = i - at_;
      if (length > longest_tag) fail("this tag is longer than 16 MiB");
      if (!fill()) fail("the file ends within a tag");
      i = at_ + length;
    }
    const char c = buffer_[i];
    if (quote != 0)
      quote = c == quote ? '\0' : quote;
    else if (c == '"' || c == '\'')
      quote = c;
    else if (c == '>')
      return std::string_view(buffer_).substr(at_, i + 1 - at_);
    else if (c == '<')
      fail("a tag within a tag");
  }
}

void XmlStream::begin(std::string_view tag) {
  if (open_.empty() && began_) fail("expected one element around all others");
  began_ = true;
  std::string_view rest = tag.substr(1, tag.size() - 2);
  ends_ = !rest.empty() && rest.back() == '/';
  if (ends_) rest.remove_suffix(1);
  const std::string_view name = rest.substr(0, rest.find_first_of(blanks));
  if (name.empty()) fail("an element without a name");
  open_.emplace_back(name);
  name_ = open_.back();
  rest = after_blanks(rest.substr(name.size()));
  while (!rest.empty()) {
    const std::size_t equals = rest.find('=');
    if (equals == std::string_view::npos) fail("expected name=\"value\" in <" + name_ + ">");
    std::string_view key = rest.substr(0, equals);
    key = key.substr(0, key.find_first_of(blanks));
    rest = after_blanks(rest.substr(equals + 1));
    if (rest.empty() || (rest[0] != '"' && rest[0] != '\'')) fail("expected a value in quotes in <" + name_ + ">");
    const std::size_t end = rest.find(rest[0], 1);  // there is one: tag() ends outside of quotes
    if (end == std::string_view::npos) fail("expected a value in quotes in <" + name_ + ">");
    attributes_.emplace_back(key, rest.substr(1, end - 1));
    rest = after_blanks(rest.substr(end + 1));
  }
}

XmlStream::Event XmlStream::next() {
  attributes_.clear();
  decoded_.clear();
  consume(std::exchange(taken_, 0));
  if (std::exchange(left_, false)) open_.pop_back();
  if (std::exchange(ends_, false)) {
    left_ = true;
    return Event::End;
  }
  for (;;) {
    const std::size_t found = buffer_.find('<', at_);
    consume((found == std::string::npos ? buffer_.size() : found) - at_);
    if (buffer_.size() - at_ < 9 && fill()) continue;  // enough of it to tell what begins here
    if (at_ == buffer_.size()) {
      if (!open_.empty()) fail("the file ends within <" + open_.back() + ">");
      if (!began_) fail("there is no element");
      return Event::Over;
    }
    const std::string_view ahead = std::string_view(buffer_).substr(at_, 9);
    const auto skip = [&](std::string_view begins, std::string_view ends) {
      if (ahead.substr(0, begins.size()) != begins) return false;
      if (!skip_past(ends)) fail("the file ends within " + std::string(begins));
      return true;
    };
    if (skip("<?", "?>") || skip("<!--", "-->") || skip("<![CDATA[", "]]>") || skip("<!", ">")) continue;
    const bool is_end = ahead.substr(0, 2) == "</";
    const std::string_view text = tag();  // may move the buffer
    taken_ = text.size();
    if (!is_end) {
      begin(text);
      return Event::Begin;
    }
    const std::string_view name = text.substr(2, text.size() - 3);
    if (open_.empty() || name.substr(0, name.find_first_of(blanks)) != open_.back())
      fail("</" + std::string(name) + "> ends what did not begin");
    name_ = open_.back();
    left_ = true;
    return Event::End;
  }
}

std::optional<std::string_view> XmlStream::attribute(std::string_view name) {
  for (const auto& [key, value] : attributes_)
    if (key == name) return value.find('&') == std::string_view::npos ? value : decoded(value);
  return std::nullopt;
}

std::string_view XmlStream::needed(std::string_view name) {
  const auto value = attribute(name);
  if (!value) fail("expected the attribute '" + std::string(name) + "' of <" + name_ + ">");
  return *value;
}

std::string_view XmlStream::decoded(std::string_view raw) {
  constexpr std::pair<std::string_view, char> known[] = {
      {"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"apos", '\''}};
  std::string out;
  while (!raw.empty()) {
    const std::size_t begins = raw.find('&');
    out += raw.substr(0, begins);
    if (begins == std::string_view::npos) break;
    const std::size_t ends = raw.find(';', begins);
    if (ends == std::string_view::npos) fail("an entity without ;");
    const std::string_view entity = raw.substr(begins + 1, ends - begins - 1);
    raw = raw.substr(ends + 1);
    const auto* const found =
        std::find_if(std::begin(known), std::end(known), [&](auto& k) { return k.first == entity; });
    if (found != std::end(known)) {
      out += found->second;
      continue;
    }
    const bool hex = entity.substr(0, 2) == "#x";
    std::uint32_t c = 0;
    const char* const first = entity.data() + std::min(entity.size(), hex ? std::size_t{2} : std::size_t{1});
    const char* const last = entity.data() + entity.size();
    const auto [end, error] = std::from_chars(first, last, c, hex ? 16 : 10);
    if (entity.substr(0, 1) != "#" || first == last || end != last || error != std::errc() || c == 0 || c > 0x10FFFF)
      fail("unknown entity '&" + std::string(entity) + ";'");
    append_utf8(out, c);
  }
  return decoded_.emplace_back(std::move(out));
}

}  // namespace waymark::plan
