#include "tools/shown_route.hpp"

namespace waymark::tools {

ShownRoute shown(const CheckedRoute& route) {
  return std::visit([](const auto& checked) { return ShownRoute(checked); }, route);
}

const plan::Route& route_of(const CheckedRoute& route) {
  return std::visit([](const auto& checked) -> const plan::Route& { return checked.route(); }, route);
}

plan::Route route_of(const plan::ChoiceRoute& route, const plan::Map& map) {
  plan::Trajectory walk;
  for (const std::uint32_t place : route.places) walk.poses.push_back(plan::PoseId{place});
  for (std::size_t i = 0; i < route.choices.size(); ++i)
    walk.actions.push_back(plan::action_between(map, walk.poses[i], walk.poses[i + 1]).value());
  return plan::priced(std::move(walk), map);
}

plan::Trajectory trajectory_of(const ShownRoute& route, const plan::Map& map) {
  if (const auto* walk = std::get_if<plan::Walk>(&route)) return walk->trajectory;
  if (const auto* certified = std::get_if<plan::CertifiedRoute>(&route)) return certified->route();
  if (const auto* accepted = std::get_if<plan::AcceptedRoute>(&route)) return accepted->route();
  const plan::LassoRoute& lasso = std::get<plan::CertifiedLasso>(route).route();
  plan::Trajectory walk = route_of(lasso.prefix, map);
  const plan::Trajectory cycle = route_of(lasso.cycle, map);
  walk.poses.insert(walk.poses.end(), cycle.poses.begin() + 1, cycle.poses.end());
  walk.actions.insert(walk.actions.end(), cycle.actions.begin(), cycle.actions.end());
  return walk;
}

std::size_t repeated_actions(const ShownRoute& route) {
  if (const auto* walk = std::get_if<plan::Walk>(&route)) return walk->repeated;
  const auto* lasso = std::get_if<plan::CertifiedLasso>(&route);
  return lasso != nullptr ? lasso->route().cycle.choices.size() : 0;
}

std::optional<std::string_view> certifier(const ShownRoute& route) {
  if (std::holds_alternative<plan::Walk>(route)) return std::nullopt;
  const auto* lasso = std::get_if<plan::CertifiedLasso>(&route);
  const bool by_definition =
      lasso != nullptr ? lasso->by_definition() : std::holds_alternative<plan::CertifiedRoute>(route);
  return by_definition ? "definition" : "automaton";
}

void add_certificate(JsonObject& json, const ShownRoute& route) {
  const auto by = certifier(route);
  json.add("certified", by.has_value());
  if (by) json.add("certified_by", std::string(*by));
}

}  // namespace waymark::tools
