#include "libplan/model/formats/write_jani.hpp"

#include <nlohmann/json.hpp>
#include <set>
#include <vector>

namespace waymark::plan {
namespace {

using Json = nlohmann::ordered_json;

class JaniWriter {
 public:
  JaniWriter(const StateLabelled& model, std::string_view name) : model_(model), mdp_(model.mdp), name_(name) {
    for (const std::string& proposition : mdp_.letters().vocabulary().names())
      labels_.push_back(proposition == cost ? proposition + '_' : proposition);
  }

  std::string write() const {
    const Json automaton = {{"name", "model"},
                            {"locations", locations()},
                            {"initial-locations", Json::array({location(mdp_.initial())})},
                            {"edges", edges()}};
    const Json document = {{"jani-version", 1},
                           {"name", name_},
                           {"type", "mdp"},
                           {"actions", actions()},
                           {"variables", variables()},
                           {"properties", properties()},
                           {"automata", Json::array({automaton})},
                           {"system", {{"elements", Json::array({{{"automaton", "model"}}})}, {"syncs", syncs()}}}};
    return document.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
  }

 private:
  static constexpr const char* cost = "cost";

  static std::string location(std::uint32_t s) { return "s" + std::to_string(s); }

  std::set<std::string> action_names() const {
    std::set<std::string> out;
    for (std::uint32_t s = 0; s < mdp_.states(); ++s)
      for (std::uint32_t k = 0; k < mdp_.choices(s); ++k) out.insert(std::string(mdp_.action(s, k)));
    return out;
  }
  Json actions() const {
    Json out = Json::array();
    for (const std::string& name : action_names()) out.push_back({{"name", name}});
    return out;
  }
  Json syncs() const {
    Json out = Json::array();
    for (const std::string& name : action_names())
      out.push_back({{"synchronise", Json::array({name})}, {"result", name}});
    return out;
  }

  Json variables() const {
    Json out = Json::array();
    out.push_back({{"name", cost}, {"type", "real"}, {"transient", true}, {"initial-value", 0}});
    for (const std::string& label : labels_)
      out.push_back({{"name", label}, {"type", "bool"}, {"transient", true}, {"initial-value", false}});
    return out;
  }

  Json locations() const {
    Json out = Json::array();
    for (std::uint32_t s = 0; s < mdp_.states(); ++s) {
      Json values = Json::array();
      for (ltl::Proposition p : mdp_.letters()[model_.letter[s]].members())
        values.push_back({{"ref", labels_[p.index]}, {"value", true}});
      Json place = {{"name", location(s)}, {"comment", mdp_.name(s)}};
      if (!values.empty()) place["transient-values"] = values;
      out.push_back(place);
    }
    return out;
  }

  Json edges() const {
    Json out = Json::array();
    for (std::uint32_t s = 0; s < mdp_.states(); ++s)
      for (std::uint32_t k = 0; k < mdp_.choices(s); ++k) {
        Json destinations = Json::array();
        for (const ModelOutcome& o : mdp_.outcomes(s, k)) {
          Json destination = {{"location", location(o.target)}};
          if (o.probability != 1) destination["probability"] = {{"exp", o.probability}};
          if (mdp_.cost(s, k) != 0)
            destination["assignments"] = Json::array({{{"ref", cost}, {"value", mdp_.cost(s, k)}}});
          destinations.push_back(destination);
        }
        out.push_back({{"location", location(s)}, {"action", mdp_.action(s, k)}, {"destinations", destinations}});
      }
    return out;
  }

  // The value of an expression in the initial state.
  static Json property(const char* name, const Json& values) {
    return {{"name", name},
            {"expression", {{"op", "filter"}, {"fun", "max"}, {"values", values}, {"states", {{"op", "initial"}}}}}};
  }
  static Json finally(const Json& exp) { return {{"op", "F"}, {"exp", exp}}; }

  Json properties() const {
    Json out = Json::array();
    for (const std::string& label : labels_) {
      if (label == "goal") {
        out.push_back(property("pmax", {{"op", "Pmax"}, {"exp", finally(label)}}));
        out.push_back(property(
            "mincost", {{"op", "Emin"}, {"exp", cost}, {"accumulate", Json::array({"steps"})}, {"reach", label}}));
      }
      if (label == "marked")
        out.push_back(property("recurrence", {{"op", "Pmax"}, {"exp", {{"op", "G"}, {"exp", finally(label)}}}}));
    }
    return out;
  }

  const StateLabelled& model_;
  const Mdp& mdp_;
  std::string name_;
  std::vector<std::string> labels_;  // by proposition
};

}  // namespace

std::string write_jani(const StateLabelled& model, std::string_view name) { return JaniWriter(model, name).write(); }

}  // namespace waymark::plan
