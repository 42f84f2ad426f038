#include "tests/support/two_languages.hpp"

#include <array>
#include <map>
#include <memory>
#include <vector>

namespace waymark::testing {
namespace {

struct Term {  // of an expression in both languages
  std::string prism, jani;
};

std::string joined(const std::vector<std::string>& parts, const std::string& by = ",") {
  std::string out;
  for (const std::string& part : parts) out += (out.empty() ? "" : by) + part;
  return out;
}
std::string quoted(const std::string& text) { return '"' + text + '"'; }
std::string binary(const std::string& op, const std::string& left, const std::string& right) {
  return R"({"op":")" + op + R"(","left":)" + left + R"(,"right":)" + right + '}';
}
std::string ite(const std::string& condition, const std::string& yes) {
  return R"({"op":"ite","if":)" + condition + R"(,"then":)" + yes + R"(,"else":0})";
}

struct Assigned {  // an update of two variables of a module
  int eighths;
  Term first, second;
  bool later;  // JANI makes the second over the value of the first
};
struct Command {
  std::string action;
  Term guard;
  std::vector<Assigned> updates;
};

class Writer {
 public:
  explicit Writer(std::mt19937& random) : random_(random) {}

  TwoLanguages write() {
    is_mdp_ = below(4) > 0;
    for (auto& module : modules_)
      for (int i = 0, n = 2 + below(3); i < n; ++i) module.push_back(command(&module == modules_.data() ? 0 : 1));
    goal_ = condition({0, 1, 2, 3});
    state_reward_ = condition({0, 1, 2, 3});
    action_reward_ = condition({0, 1, 2, 3});
    rewarded_ = std::array<std::string, 3>{"", "a", "b"}[static_cast<std::size_t>(below(3))];
    return {prism(), properties(), jani()};
  }

 private:
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

  // x, y : [0..2] of module 0; z : [0..2], b : bool of module 1.
  static bool is_bool(int v) { return v == 3; }
  static std::string name(int v) { return std::string(1, "xyzb"[v]); }
  static Term variable(int v) { return {name(v), quoted(name(v))}; }

  Term number(const std::vector<int>& from, const std::map<int, Term>& instead = {}) {
    const auto at = [&](int v) { return instead.contains(v) ? instead.at(v) : variable(v); };
    const int v = from[static_cast<std::size_t>(below(static_cast<int>(from.size())))];
    const std::string constant = std::to_string(below(3));
    if (is_bool(v)) {
      const Term b = at(v);
      return {"(" + b.prism + "?" + constant + ":0)", ite(b.jani, constant)};
    }
    const Term x = at(v);
    switch (below(5)) {
      case 0: return {constant, constant};
      case 1: return x;
      case 2: return {"(" + x.prism + "+" + constant + ")", binary("+", x.jani, constant)};
      case 3: return {"mod(" + x.prism + "*2,3)", binary("%", binary("*", x.jani, "2"), "3")};
      default: return {"max(" + x.prism + "-1,0)", binary("max", binary("-", x.jani, "1"), "0")};
    }
  }
  Term condition(const std::vector<int>& from, const std::map<int, Term>& instead = {}) {
    static constexpr std::array<std::array<const char*, 2>, 5> comparisons{
        {{"=", "="}, {"!=", "≠"}, {"<=", "≤"}, {"<", "<"}, {">=", "≥"}}};
    const auto& [prism, jani] = comparisons[static_cast<std::size_t>(below(5))];
    const Term left = number(from, instead), right = number(from, instead);
    const Term one{left.prism + prism + right.prism, binary(jani, left.jani, right.jani)};
    if (below(3) > 0) return one;
    const Term other = condition(from, instead);
    if (below(2) == 0) return {"(" + one.prism + " & " + other.prism + ")", binary("∧", one.jani, other.jani)};
    return {"(!(" + one.prism + ") | " + other.prism + ")",
            binary("∨", R"({"op":"¬","exp":)" + one.jani + "}", other.jani)};
  }
  Term value(int v, const std::vector<int>& from, const std::map<int, Term>& instead = {}) {
    if (is_bool(v)) return condition(from, instead);
    const Term e = number(from, instead);
    return {"min(2," + e.prism + ")", binary("min", "2", e.jani)};
  }

  Command command(int module) {
    Command out{
        std::array<std::string, 4>{"", "a", "b", "b"}[static_cast<std::size_t>(below(4))], condition({0, 1, 2, 3}), {}};
    const int v = 2 * module, w = v + 1;
    for (int left = 8; left > 0;) {
      const int eighths = below(2) == 0 ? left : 1 + below(left);
      left -= eighths;
      Assigned& made = out.updates.emplace_back(Assigned{eighths, value(v, {0, 1, 2, 3}), {}, below(2) == 0});
      if (!made.later) {
        made.second = value(w, {0, 1, 2, 3});
        continue;
      }
      // The same draw twice: over the new value in JANI, which PRISM has to write out.
      const std::mt19937 before = random_;
      made.second.jani = value(w, {v, w}).jani;
      random_ = before;
      made.second.prism = value(w, {v, w}, {{v, made.first}}).prism;
    }
    return out;
  }

  // ---- PRISM

  std::string prism() const {
    std::string out = is_mdp_ ? "mdp\nconst int k;\n" : "dtmc\nconst int k;\n";
    for (int m = 0; m < 2; ++m) {
      out += "module m" + std::to_string(m) + "\n";
      for (int v = 2 * m; v < 2 * m + 2; ++v)
        out += "  " + name(v) + (is_bool(v) ? " : bool;\n" : " : [0..2] init k;\n");
      for (const Command& c : modules_[static_cast<std::size_t>(m)]) {
        out += "  [" + c.action + "] " + c.guard.prism + " -> ";
        std::vector<std::string> updates;
        for (const Assigned& u : c.updates)
          updates.push_back(std::to_string(u.eighths) + "/8:(" + name(2 * m) + "'=" + u.first.prism + ")&(" +
                            name(2 * m + 1) + "'=" + u.second.prism + ")");
        out += joined(updates, " + ") + ";\n";
      }
      out += "endmodule\n";
    }
    return out + "label \"goal\" = " + goal_.prism + ";\nrewards \"r\"\n  " + state_reward_.prism + " : 3;\n  [" +
           rewarded_ + "] " + action_reward_.prism + " : 2;\nendrewards\n";
  }

  std::string properties() const {
    const std::string low = is_mdp_ ? "min" : "", high = is_mdp_ ? "max" : "";
    return "P" + high + "=? [ F \"goal\" ]\nP" + low + "=? [ F<=3 \"goal\" ]\nP" + high +
           "=? [ (x<=1) U[1,4] \"goal\" ]\nP" + low + "=? [ (G F z=1) | (F G b) ]\nP" + low +
           "=? [ !b W x=2 ]\nR{\"r\"}" + high + "=? [ C<=4 ]\nR{\"r\"}" + low + "=? [ F \"goal\" ]\nP>=0.5 [ F x=2 ]\n";
  }

  // ---- JANI

  static std::string declaration(int v) {
    if (is_bool(v)) return R"({"name":"b","type":"bool","initial-value":false})";
    return R"({"name":")" + name(v) +
           R"(","type":{"kind":"bounded","base":"int","lower-bound":0,"upper-bound":2},"initial-value":"k"})";
  }
  static std::string assignment(const std::string& ref, const std::string& value, int index = 0) {
    return R"({"ref":")" + ref + R"(","value":)" + value +
           (index > 0 ? R"(,"index":)" + std::to_string(index) : std::string()) + '}';
  }
  bool has(std::size_t module, const std::string& action) const {
    for (const Command& c : modules_[module])
      if (c.action == action) return true;
    return false;
  }

  std::string automaton(int m) const {
    std::vector<std::string> edges, variables;
    for (const Command& c : modules_[static_cast<std::size_t>(m)]) {
      const bool rewarded = c.action == rewarded_ && (c.action.empty() || m == 0 || !has(0, c.action));
      std::vector<std::string> destinations;
      for (const Assigned& u : c.updates) {
        std::vector<std::string> made{assignment(name(2 * m), u.first.jani),
                                      assignment(name(2 * m + 1), u.second.jani, u.later ? 7 : 0)};
        if (rewarded) made.push_back(assignment("r", ite(action_reward_.jani, "2")));
        destinations.push_back(R"({"location":"l","probability":{"exp":)" +
                               binary("/", std::to_string(u.eighths), "8") + R"(},"assignments":[)" + joined(made) +
                               "]}");
      }
      edges.push_back(R"({"location":"l",)" +
                      (c.action.empty() ? std::string() : R"("action":")" + c.action + R"(",)") + R"("guard":{"exp":)" +
                      c.guard.jani + R"(},"destinations":[)" + joined(destinations) + "]}");
    }
    const std::string values = m == 0 ? R"(,"transient-values":[)" + assignment("goal", goal_.jani) + ',' +
                                            assignment("r", ite(state_reward_.jani, "3")) + ']'
                                      : std::string();
    return R"({"name":"m)" + std::to_string(m) + R"(","locations":[{"name":"l")" + values +
           R"(}],"initial-locations":["l"],"edges":[)" + joined(edges, ",\n ") + "]}";
  }

  static std::string property(const std::string& values) {
    return R"({"name":"p","expression":{"op":"filter","fun":"max","states":{"op":"initial"},"values":)" + values + "}}";
  }
  static std::string probability(const std::string& extreme, const std::string& path) {
    return R"({"op":"P)" + extreme + R"(","exp":)" + path + '}';
  }
  static std::string finally(const std::string& what) { return R"({"op":"F","exp":)" + what + '}'; }
  static std::string always(const std::string& what) { return R"({"op":"G","exp":)" + what + '}'; }

  static std::string jani_properties() {
    const std::string rewards = R"("exp":"r","accumulate":["steps","exit"],)";
    return joined({property(probability("max", finally(R"("goal")"))),
                   property(probability("min", R"({"op":"F","exp":"goal","step-bounds":{"upper":3}})")),
                   property(probability("max", R"({"op":"U","left":{"op":"≤","left":"x","right":1},"right":"goal",)"
                                               R"("step-bounds":{"lower":0,"lower-exclusive":true,"upper":4}})")),
                   property(probability("min", binary("∨", always(finally(binary("=", quoted("z"), "1"))),
                                                      finally(always(quoted("b")))))),
                   property(probability("min", R"({"op":"W","left":{"op":"¬","exp":"b"},"right":)" +
                                                   binary("=", quoted("x"), "2") + '}')),
                   property(R"({"op":"Emax",)" + rewards + R"("step-instant":4})"),
                   property(R"({"op":"Emin",)" + rewards + R"("reach":"goal"})"),
                   R"({"name":"p","expression":)" +
                       binary("≤", "0.5", probability("min", finally(binary("=", quoted("x"), "2")))) + '}'},
                  ",\n");
  }

  std::string jani() const {
    std::vector<std::string> syncs;
    for (const std::string action : {"a", "b"}) {
      if (!has(0, action) && !has(1, action)) continue;
      const auto in = [&](std::size_t m) { return has(m, action) ? quoted(action) : std::string("null"); };
      syncs.push_back(R"({"synchronise":[)" + in(0) + ',' + in(1) + R"(],"result":")" + action + "\"}");
    }
    return R"({"jani-version":1,"name":"random","type":")" + std::string(is_mdp_ ? "mdp" : "dtmc") +
           R"(","actions":[{"name":"a"},{"name":"b"}],"constants":[{"name":"k","type":"int"}],)"
           R"("variables":[{"name":"goal","type":"bool","transient":true,"initial-value":false},)"
           R"({"name":"r","type":"real","transient":true,"initial-value":0},)" +
           declaration(0) + ',' + declaration(1) + ',' + declaration(2) + ',' + declaration(3) + "],\n\"automata\":[" +
           automaton(0) + ",\n" + automaton(1) +
           "],\n\"system\":{\"elements\":[{\"automaton\":\"m0\"},{\"automaton\":\"m1\"}],\"syncs\":[" + joined(syncs) +
           "]},\n\"properties\":[" + jani_properties() + "]}\n";
  }

  std::mt19937& random_;
  bool is_mdp_ = true;
  std::array<std::vector<Command>, 2> modules_;
  Term goal_, state_reward_, action_reward_;
  std::string rewarded_;
};

}  // namespace

TwoLanguages random_program(std::mt19937& random) { return Writer(random).write(); }

}  // namespace waymark::testing
