#include "libplan/model/jani/jani_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "libplan/world/json_position.hpp"
#include "libplan/world/json_reader.hpp"

namespace waymark::plan {

JaniText::JaniText(std::string_view text, std::string_view source) : json_(text), source_(source) {
  using Json = JsonReader::Value;
  const Json document = JsonReader(text, source).parse();
  std::vector<const Json*> from{&document};
  values_.emplace_back();
  for (Id at = 0; at < values_.size(); ++at) {  // breadth first
    const Json& json = *from[at];
    Value value = std::move(values_[at]);
    value.first = static_cast<std::uint32_t>(values_.size());
    if (json.is_boolean()) {
      value.kind = Kind::Bool;
      value.number = json.get<bool>() ? 1 : 0;
    } else if (json.is_number()) {
      value.kind = Kind::Number;
      value.whole = json.is_number_integer();
      value.number = json.get<double>();
    } else if (json.is_string()) {
      value.kind = Kind::Text;
      value.text = json.get<std::string>();
    } else if (json.is_structured()) {
      value.kind = json.is_array() ? Kind::List : Kind::Object;
      for (const auto& item : json.items()) {
        Value& made = values_.emplace_back();
        made.parent = at;
        made.index = value.size++;
        if (json.is_object()) made.key = item.key();
        from.push_back(&item.value());
      }
    }
    values_[at] = std::move(value);
  }
}

const std::string& JaniText::text(Id value) const {
  if (kind(value) != Kind::Text) fail(value, "expected a text");
  return values_[value].text;
}
double JaniText::number(Id value) const {
  if (kind(value) != Kind::Number || !std::isfinite(values_[value].number)) fail(value, "expected a finite number");
  return values_[value].number;
}
bool JaniText::truth(Id value) const {
  if (kind(value) != Kind::Bool) fail(value, "expected true or false");
  return values_[value].number != 0;
}

std::vector<JaniText::Id> JaniText::elements(Id value) const {
  if (kind(value) != Kind::List) fail(value, "expected a list");
  std::vector<Id> out(values_[value].size);
  for (std::uint32_t i = 0; i < out.size(); ++i) out[i] = values_[value].first + i;
  return out;
}

std::optional<JaniText::Id> JaniText::find(Id object, std::string_view key) const {
  if (kind(object) != Kind::Object) fail(object, "expected an object");
  const Value& in = values_[object];
  for (Id i = in.first; i < in.first + in.size; ++i)
    if (values_[i].key == key) return i;
  return std::nullopt;
}
JaniText::Id JaniText::member(Id object, std::string_view key) const {
  const std::optional<Id> found = find(object, key);
  if (!found) fail(object, "the key \"" + std::string(key) + "\" is missing");
  return *found;
}
std::vector<JaniText::Id> JaniText::list(Id object, std::string_view key) const {
  const std::optional<Id> found = find(object, key);
  return found ? elements(*found) : std::vector<Id>();
}

void JaniText::expect_keys(Id object, std::initializer_list<std::string_view> keys) const {
  if (kind(object) != Kind::Object) fail(object, "expected an object");
  const Value& in = values_[object];
  for (Id i = in.first; i < in.first + in.size; ++i) {
    const std::string& key = values_[i].key;
    if (key != "comment" && !key.starts_with("x-") && std::find(keys.begin(), keys.end(), key) == keys.end())
      fail(i, "the key \"" + key + "\" is not read here: what is read is docs/formats/prism.md");
  }
}

std::string JaniText::infix(Id expression) const { return infix(expression, 0); }

std::string JaniText::infix(Id expression, std::size_t depth) const {
  const Value& value = values_[expression];
  if (value.kind == Kind::Text) return value.text;
  if (value.kind == Kind::Bool) return value.number != 0 ? "true" : "false";
  if (value.kind == Kind::Number) {
    std::array<char, 32> out{};
    return {out.data(), std::to_chars(out.data(), out.data() + out.size(), value.number).ptr};
  }
  const auto below = [&](Id part) { return infix(part, depth + 1); };
  std::string op, left, right, parts;
  for (Id i = value.first; i < value.first + value.size; ++i) {
    const std::string& key = values_[i].key;
    if (key == "comment") continue;
    const std::string part = key == "op" ? values_[i].text : below(i);
    if (key != "op") parts += (parts.empty() ? "" : ", ") + part;
    (key == "op" ? op : key == "left" ? left : right) = part;
  }
  if (value.size >= 3 && !left.empty() && find(expression, "right")) {
    const std::string both = left + ' ' + op + ' ' + right;
    return depth == 0 ? both : '(' + both + ')';
  }
  return op == "¬" ? op + parts : op + '(' + parts + ')';
}

std::string JaniText::path(Id value) const {
  std::vector<Id> way;
  for (; value != 0; value = values_[value].parent) way.push_back(value);
  std::string out;
  for (std::size_t i = way.size(); i-- > 0;) {
    const Value& at = values_[way[i]];
    if (kind(at.parent) == Kind::List)
      out += '[' + std::to_string(at.index) + ']';
    else
      out += (out.empty() ? "" : ".") + at.key;
  }
  return out;
}

std::exception_ptr JaniText::error(ltl::Span where, const std::string& message) const {
  constexpr std::size_t shown = 60;  // bytes of a long path, at either end
  const std::string way = path(static_cast<Id>(where.begin));
  const std::string named =
      way.size() <= 2 * shown ? way : way.substr(0, shown) + " … " + way.substr(way.size() - shown);
  return std::make_exception_ptr(
      format_error_at(source_, json_, offset_of(json_, way), named.empty() ? message : named + ": " + message));
}

}  // namespace waymark::plan
