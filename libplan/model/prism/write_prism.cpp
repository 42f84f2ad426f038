#include "libplan/model/prism/write_prism.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "libplan/model/prism/prism_names.hpp"

namespace waymark::plan {
namespace {

std::string text(double value) {  // the shortest that reads back
  std::array<char, 32> out{};
  return {out.data(), std::to_chars(out.data(), out.data() + out.size(), value).ptr};
}

// Does every state ask the same cost for all its choices, and does the whole model?
bool costs_by_state(const Mdp& mdp) {
  for (std::uint32_t s = 0; s < mdp.states(); ++s)
    for (std::uint32_t k = 1; k < mdp.choices(s); ++k)
      if (mdp.cost(s, k) != mdp.cost(s, 0)) return false;
  return true;
}
std::optional<double> only_cost(const Mdp& mdp) {
  for (std::uint32_t s = 0; s < mdp.states(); ++s)
    if (mdp.cost(s, 0) != mdp.cost(0, 0)) return std::nullopt;
  return mdp.cost(0, 0);
}

std::vector<std::string> label_names(const ltl::Vocabulary& vocabulary) {
  PrismNames names({"init", "deadlock"});
  std::vector<std::string> out;
  for (const std::string& name : vocabulary.names()) out.push_back(names.add(name));
  return out;
}

class ActionNames {  // one for every action, or for every action at one cost
 public:
  explicit ActionNames(bool by_cost) : by_cost_(by_cost) {}
  const std::string& operator()(std::string_view action, double cost) {
    const auto [at, fresh] = names_.try_emplace({std::string(action), by_cost_ ? cost : 0});
    if (fresh) at->second = unused_.add(action);
    return at->second;
  }
  const auto& all() const { return names_; }

 private:
  bool by_cost_;
  PrismNames unused_;
  std::map<std::pair<std::string, double>, std::string> names_;
};

// ---- explicit files

std::string transitions(const Mdp& mdp) {
  std::string out =
      std::to_string(mdp.states()) + ' ' + std::to_string(mdp.choices()) + ' ' + std::to_string(mdp.outcomes()) + '\n';
  ActionNames actions(false);
  for (std::uint32_t s = 0; s < mdp.states(); ++s)
    for (std::uint32_t k = 0; k < mdp.choices(s); ++k) {
      const std::string& action = actions(mdp.action(s, k), mdp.cost(s, k));
      for (const ModelOutcome& o : mdp.outcomes(s, k))
        out += std::to_string(s) + ' ' + std::to_string(k) + ' ' + std::to_string(o.target) + ' ' +
               text(o.probability) + ' ' + action + '\n';
    }
  return out;
}

std::string states(const StateLabelled& model) {
  const StateValues& values = model.values;
  const std::size_t width = values.variables.size();
  PrismNames names;
  std::string out;
  for (std::size_t v = 0; v < width; ++v) out += (v == 0 ? "(" : ",") + names.add(values.variables[v]);
  out += ")\n";
  for (std::size_t s = 0; s < model.mdp.states(); ++s) {
    out += std::to_string(s) + ':';
    for (std::size_t v = 0; v < width; ++v) out += (v == 0 ? "(" : ",") + std::to_string(values.values[s * width + v]);
    out += ")\n";
  }
  return out;
}

std::string labels(const StateLabelled& model) {
  const std::vector<std::string> names = label_names(model.mdp.letters().vocabulary());
  std::string out = R"(0="init" 1="deadlock")";
  for (std::size_t i = 0; i < names.size(); ++i) out += ' ' + std::to_string(i + 2) + "=\"" + names[i] + '"';
  out += '\n';
  for (std::size_t s = 0; s < model.mdp.states(); ++s) {
    std::string holds = s == 0 ? " 0" : "";
    for (ltl::Proposition p : model.mdp.letters()[model.letter[s]].members())
      holds += ' ' + std::to_string(p.index + 2);
    if (!holds.empty()) out += std::to_string(s) + ':' + holds + '\n';
  }
  return out;
}

std::string state_rewards(const Mdp& mdp) {
  std::string rows;
  std::size_t count = 0;
  for (std::uint32_t s = 0; s < mdp.states(); ++s) {
    if (mdp.cost(s, 0) == 0) continue;
    rows += std::to_string(s) + ' ' + text(mdp.cost(s, 0)) + '\n';
    ++count;
  }
  return std::to_string(mdp.states()) + ' ' + std::to_string(count) + '\n' + rows;
}

std::string transition_rewards(const Mdp& mdp) {
  std::string rows;
  std::size_t count = 0;
  for (std::uint32_t s = 0; s < mdp.states(); ++s)
    for (std::uint32_t k = 0; k < mdp.choices(s); ++k) {
      if (mdp.cost(s, k) == 0) continue;
      for (const ModelOutcome& o : mdp.outcomes(s, k)) {
        rows += std::to_string(s) + ' ' + std::to_string(k) + ' ' + std::to_string(o.target) + ' ' +
                text(mdp.cost(s, k)) + '\n';
        ++count;
      }
    }
  return std::to_string(mdp.states()) + ' ' + std::to_string(mdp.choices()) + ' ' + std::to_string(count) + '\n' + rows;
}

// ---- the language

class LanguageWriter {
 public:
  explicit LanguageWriter(const StateLabelled& model)
      : model_(model), mdp_(model.mdp), by_state_(costs_by_state(mdp_)), actions_(!by_state_) {
    PrismNames names;
    for (const std::string& variable : model.values.variables) variables_.push_back(names.add(variable));
  }

  std::string write() {
    std::string out = "mdp\n\nmodule model\n";
    for (std::size_t v = 0; v < variables_.size(); ++v) out += declaration(v);
    for (std::uint32_t s = 0; s < mdp_.states(); ++s)
      for (std::uint32_t k = 0; k < mdp_.choices(s); ++k) out += command(s, k);
    out += "endmodule\n\nrewards \"cost\"\n" + rewards() + "endrewards\n";
    const std::vector<std::string> names = label_names(mdp_.letters().vocabulary());
    if (!names.empty()) out += '\n';
    for (std::uint32_t p = 0; p < names.size(); ++p)
      out += "label \"" + names[p] + "\" = " + label(ltl::Proposition{p}) + ";\n";
    return out;
  }

 private:
  std::int32_t value(std::size_t s, std::size_t v) const { return model_.values.values[s * variables_.size() + v]; }

  std::string declaration(std::size_t v) const {
    std::int32_t least = value(0, v), most = least;
    for (std::size_t s = 1; s < mdp_.states(); ++s) {
      least = std::min(least, value(s, v));
      most = std::max(most, value(s, v));
    }
    return "  " + variables_[v] + " : [" + std::to_string(least) + ".." + std::to_string(most) + "] init " +
           std::to_string(value(0, v)) + ";\n";
  }

  std::string guard(std::size_t s) const {
    std::string out;
    for (std::size_t v = 0; v < variables_.size(); ++v)
      out += (v == 0 ? "" : " & ") + variables_[v] + '=' + std::to_string(value(s, v));
    return out;
  }

  std::string update(std::size_t target) const {
    std::string out;
    for (std::size_t v = 0; v < variables_.size(); ++v)
      out += (v == 0 ? "(" : " & (") + variables_[v] + "'=" + std::to_string(value(target, v)) + ')';
    return out;
  }

  std::string command(std::uint32_t s, std::uint32_t k) {
    std::string out = "  [" + actions_(mdp_.action(s, k), mdp_.cost(s, k)) + "] " + guard(s) + " -> ";
    bool first = true;
    for (const ModelOutcome& o : mdp_.outcomes(s, k)) {
      out += (first ? "" : " + ") + text(o.probability) + ':' + update(o.target);
      first = false;
    }
    return out + ";\n";
  }

  std::string rewards() const {
    std::string out;
    if (const auto cost = only_cost(mdp_); cost && by_state_) return "  true : " + text(*cost) + ";\n";
    if (!by_state_) {
      for (const auto& [action, name] : actions_.all()) out += "  [" + name + "] true : " + text(action.second) + ";\n";
      return out;
    }
    for (std::uint32_t s = 0; s < mdp_.states(); ++s)
      if (mdp_.cost(s, 0) != 0) out += "  " + guard(s) + " : " + text(mdp_.cost(s, 0)) + ";\n";
    return out;
  }

  std::string label(ltl::Proposition p) const {
    std::string out;
    for (std::size_t s = 0; s < mdp_.states(); ++s)
      if (mdp_.letters()[model_.letter[s]].contains(p)) out += (out.empty() ? "(" : " | (") + guard(s) + ')';
    return out.empty() ? "false" : out;
  }

  const StateLabelled& model_;
  const Mdp& mdp_;
  bool by_state_;
  ActionNames actions_;
  std::vector<std::string> variables_;
};

// ---- grids

using CellTest = std::function<bool(std::uint32_t)>;

std::string range(char variable, std::uint32_t first, std::uint32_t last) {
  const std::string name(1, variable);
  if (first == last) return name + '=' + std::to_string(first);
  return name + ">=" + std::to_string(first) + '&' + name + "<=" + std::to_string(last);
}

// The cells of a set as rectangles: runs of a row, grown downwards while the next row has the same run.
std::string rectangles(const GridWorld& grid, const CellTest& contains) {
  using Run = std::pair<std::uint32_t, std::uint32_t>;  // its first and last x
  std::map<Run, std::uint32_t> open, still;             // → its first row
  std::string out;
  const auto close = [&](Run run, std::uint32_t from, std::uint32_t to) {
    out += (out.empty() ? "(" : " | (") + range('x', run.first, run.second) + '&' + range('y', from, to) + ')';
  };
  for (std::uint32_t y = 0; y <= grid.height(); ++y) {
    still.clear();
    for (std::uint32_t x = 0; y < grid.height() && x < grid.width(); ++x) {
      if (!contains(y * grid.width() + x)) continue;
      const std::uint32_t first = x;
      while (x + 1 < grid.width() && contains(y * grid.width() + x + 1)) ++x;
      const auto before = open.find({first, x});
      still.emplace(Run{first, x}, before == open.end() ? y : before->second);
    }
    for (const auto& [run, from] : open)
      if (!still.contains(run)) close(run, from, y - 1);
    open.swap(still);
  }
  return out.empty() ? "false" : out;
}

std::string grid_command(const GridWorld& grid, std::size_t meant) {
  static constexpr std::array<std::string_view, 4> updates{"y'=barN?y:y-1", "x'=barE?x:x+1", "y'=barS?y:y+1",
                                                           "x'=barW?x:x-1"};
  const SlipChances& c = grid.shape().motion[meant];
  const std::array<double, 4> chance{c.forward, c.right, c.back, c.left};
  std::string out;
  for (std::size_t turn = 0; turn < 4; ++turn)
    if (chance[turn] != 0)
      out += (out.empty() ? "" : " + ") + text(chance[turn]) + ":(" + std::string(updates[(meant + turn) % 4]) + ')';
  return "  [go" + std::string(name(all_compass[meant])) + "] true -> " + out + ";\n";
}

}  // namespace

PrismExplicit write_prism_explicit(const StateLabelled& model) {
  const bool on_states = costs_by_state(model.mdp);
  return {transitions(model.mdp), states(model), labels(model),
          on_states ? state_rewards(model.mdp) : transition_rewards(model.mdp), on_states};
}

std::string write_prism(const StateLabelled& model) { return LanguageWriter(model).write(); }

std::string write_prism(const GridWorld& grid) {
  std::string out = "mdp\n\n";
  for (std::size_t d = 0; d < 4; ++d)
    out += "formula bar" + std::string(name(all_compass[d])) + " = " +
           rectangles(grid,
                      [&](std::uint32_t cell) {
                        return !grid.is_wall(cell) && grid.move(cell, static_cast<std::uint32_t>(d)) == cell;
                      }) +
           ";\n";
  const std::uint32_t start = grid.initial(), width = grid.width();
  out += "\nmodule grid\n  x : [0.." + std::to_string(width - 1) + "] init " + std::to_string(start % width) +
         ";\n  y : [0.." + std::to_string(grid.height() - 1) + "] init " + std::to_string(start / width) + ";\n";
  for (std::size_t d = 0; d < 4; ++d) out += grid_command(grid, d);
  out += "endmodule\n\nrewards \"cost\"\n";
  const std::array<double, 4>& cost = grid.shape().cost;
  if (std::all_of(cost.begin(), cost.end(), [&](double c) { return c == cost[0]; }))
    out += "  true : " + text(cost[0]) + ";\n";
  else
    for (std::size_t d = 0; d < 4; ++d)
      out += "  [go" + std::string(name(all_compass[d])) + "] true : " + text(cost[d]) + ";\n";
  out += "endrewards\n\n";
  const std::vector<std::string> names = label_names(grid.letters().vocabulary());
  for (std::uint32_t p = 0; p < names.size(); ++p)
    out += "label \"" + names[p] + "\" = " +
           rectangles(grid,
                      [&](std::uint32_t cell) {
                        return !grid.is_wall(cell) && grid.letters()[grid.letter(cell)].contains(ltl::Proposition{p});
                      }) +
           ";\n";
  return out;
}

}  // namespace waymark::plan
