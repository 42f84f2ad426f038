// Routes as they are shown. The type of a route says whether, and by what, the route is certified; no flag beside it
// does.
#pragma once
#include <cstddef>
#include <optional>
#include <string_view>
#include <variant>

#include "libplan/certify.hpp"
#include "libplan/solve/least_lasso.hpp"
#include "tools/shell/json.hpp"

namespace waymark::tools {

// What a plan on finite words ends in: a route certified by the formula, or by the automaton where there is no formula.
using CheckedRoute = std::variant<plan::CertifiedRoute, plan::AcceptedRoute>;
// What pictures and printers take. A walk on the map is certified by nothing.
using ShownRoute = std::variant<plan::CertifiedRoute, plan::AcceptedRoute, plan::CertifiedLasso, plan::Walk>;

ShownRoute shown(const CheckedRoute& route);
const plan::Route& route_of(const CheckedRoute& route);
// On the map whose model the lasso is of: states of the model are the poses of the map.
plan::Route route_of(const plan::ChoiceRoute& route, const plan::Map& map);

// Pose by pose; of a lasso the prefix and one round of the cycle.
plan::Trajectory trajectory_of(const ShownRoute& route, const plan::Map& map);
// So many actions at the end of the trajectory are repeated for ever: the cycle of a lasso.
std::size_t repeated_actions(const ShownRoute& route);
// What the certificate rests on: "definition" or "automaton"; absent of a walk.
std::optional<std::string_view> certifier(const ShownRoute& route);
// The keys "certified" and "certified_by".
void add_certificate(JsonObject& json, const ShownRoute& route);

}  // namespace waymark::tools
