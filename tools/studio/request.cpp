#include "tools/studio/request.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "libltl/text/parse.hpp"

namespace waymark::studio {
namespace {

[[noreturn]] void reject(const std::string& message) { throw RequestError(400, "request", message); }
[[noreturn]] void too_large(const std::string& message) { throw RequestError(413, "too large", message); }

class Bounds : public nlohmann::json_sax<nlohmann::json> {
 public:
  bool null() override { return value(); }
  bool boolean(bool) override { return value(); }
  bool number_integer(number_integer_t) override { return value(); }
  bool number_unsigned(number_unsigned_t) override { return value(); }
  bool number_float(number_float_t, const string_t&) override { return value(); }
  bool string(string_t&) override { return value(); }
  bool binary(binary_t&) override { return value(); }
  bool start_object(std::size_t) override { return begin(); }
  bool start_array(std::size_t) override { return begin(); }
  bool key(string_t&) override { return true; }
  bool end_object() override { return end(); }
  bool end_array() override { return end(); }
  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception&) override { return false; }

 private:
  bool value() {
    if (++values_ > most_values) too_large("the request has more than " + std::to_string(most_values) + " values");
    return true;
  }
  bool begin() {
    if (++levels_ > most_levels) too_large("the request nests deeper than " + std::to_string(most_levels) + " levels");
    return value();
  }
  bool end() {
    --levels_;
    return true;
  }

  std::size_t values_ = 0, levels_ = 0;
};

plan::PoseId pose_of(const nlohmann::json& value, const std::string& where, const plan::Map& map) {
  const auto is_whole = [](const nlohmann::json& number) {  // and an int
    return number.is_number_integer() && std::abs(number.get<double>()) <= INT32_MAX;
  };
  if (!value.is_array() || value.size() != 3 || !std::all_of(value.begin(), value.end(), is_whole))
    reject(where + ": expected [x, y, heading]");
  const plan::Pose pose{value[0].get<int>(), value[1].get<int>(), value[2].get<int>()};
  const auto found = map.find(pose);
  if (!found) reject(where + ": the map has no pose " + plan::show(pose));
  return *found;
}

}  // namespace

void check_json_bounds(std::string_view json) {
  if (json.size() > most_body) too_large("the request has more than 1 MiB");
  Bounds bounds;
  nlohmann::json::sax_parse(json, &bounds);
}

Request::Request(std::string_view body) {
  check_json_bounds(body);
  try {
    members_ = std::make_shared<const nlohmann::json>(nlohmann::json::parse(body));
  } catch (const nlohmann::json::parse_error& error) {
    reject("no JSON: byte " + std::to_string(error.byte));
  } catch (const nlohmann::json::exception&) {  // 1e999
    reject("a number in the JSON is too large");
  }
  if (!members_->is_object()) reject("expected a JSON object");
}

bool Request::has(const std::string& name) const {
  const auto found = members_->find(name);
  return found != members_->end() && !found->is_null();
}

std::string Request::text(const std::string& name) const {
  if (!has(name)) reject("'" + name + "' is missing");
  const nlohmann::json& value = (*members_)[name];
  if (!value.is_string()) reject("'" + name + "': expected a text");
  const auto& text = value.get_ref<const std::string&>();
  if (text.size() > most_text) too_large("'" + name + "' has more than " + std::to_string(most_text) + " bytes");
  return text;
}

std::string Request::text_or(const std::string& name, const std::string& otherwise) const {
  return has(name) ? text(name) : otherwise;
}

std::string Request::one_of(const std::string& name, const std::vector<std::string>& values) const {
  std::string value = text_or(name, values.front());
  if (std::find(values.begin(), values.end(), value) == values.end()) {
    std::string known;
    for (const std::string& v : values) known += (known.empty() ? "" : ", ") + v;
    reject("'" + name + "' is one of: " + known);
  }
  return value;
}

bool Request::flag(const std::string& name) const {
  if (!has(name)) return false;
  const nlohmann::json& value = (*members_)[name];
  if (!value.is_boolean()) reject("'" + name + "': expected true or false");
  return value.get<bool>();
}

double Request::number_or(const std::string& name, double otherwise, double least, double most) const {
  if (!has(name)) return otherwise;
  const nlohmann::json& value = (*members_)[name];
  if (!value.is_number()) reject("'" + name + "': expected a number");
  const double number = value.get<double>();
  if (!(least <= number && number <= most))
    reject("'" + name + "' lies between " + std::to_string(least) + " and " + std::to_string(most));
  return number;
}

std::size_t Request::count_or(const std::string& name, std::size_t otherwise, std::size_t least,
                              std::size_t most) const {
  if (!has(name)) return otherwise;
  const nlohmann::json& value = (*members_)[name];
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() < least || value.get<std::uint64_t>() > most)
    reject("'" + name + "' is a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  return value.get<std::size_t>();
}

plan::Trajectory Request::trajectory(const std::string& name, const plan::Map& map) const {
  if (!has(name)) reject("'" + name + "' is missing");
  const nlohmann::json& poses = (*members_)[name];
  if (!poses.is_array() || poses.empty()) reject("'" + name + "': expected a list of poses");
  if (poses.size() > most_poses) too_large("'" + name + "' has more than " + std::to_string(most_poses) + " poses");
  plan::Trajectory walk;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const std::string where = name + "[" + std::to_string(i) + "]";
    const plan::PoseId pose = pose_of(poses[i], where, map);
    if (i > 0) {
      const auto action = plan::action_between(map, walk.poses.back(), pose);
      if (!action)
        reject(where + ": no action leads from " + plan::show(map.pose(walk.poses.back())) + " to " +
               plan::show(map.pose(pose)));
      walk.actions.push_back(*action);
    }
    walk.poses.push_back(pose);
  }
  return walk;
}

ltl::Formula formula_of(const Request& request, ltl::Arena& arena) {
  const ltl::Formula formula = ltl::parse(request.text("formula"), arena, {.unknown = ltl::Unknown::Reject});
  if (ltl::tree_size(formula) > most_formula)
    too_large("'formula' has more than " + std::to_string(most_formula) + " operators, bounds spelled out");
  return formula;
}

}  // namespace waymark::studio
