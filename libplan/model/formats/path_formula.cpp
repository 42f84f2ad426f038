#include "libplan/model/formats/path_formula.hpp"

#include <algorithm>
#include <stdexcept>

namespace waymark::plan {
namespace {

using Id = PrismExpressions::Id;
using Op = PrismExpressions::Op;
using Type = PrismExpressions::Type;

constexpr std::size_t most_written = 500;  // steps before a window of steps begins

class PathWriter {
 public:
  PathWriter(PrismExpressions& expressions, const std::function<std::string(Id)>& name,
             std::vector<PrismProgram::Label>& labels)
      : expressions_(expressions), name_(name), labels_(labels) {}

  std::string write(Id e) {
    if (!expressions_.is_temporal(e)) return condition(e);
    const std::vector<Id> operands = expressions_.operands(e);
    std::vector<std::string> parts;
    for (const Id operand : operands) parts.push_back('(' + write(operand) + ')');
    switch (expressions_.op(e)) {
      case Op::Not: return '!' + parts[0];
      case Op::Implies: return parts[0] + " -> " + parts[1];
      case Op::Iff: return parts[0] + " <-> " + parts[1];
      case Op::Or:
      case Op::And: return joined(parts, expressions_.op(e) == Op::Or ? " | " : " & ");
      case Op::Query: return '"' + path_name(name_(e)) + '"';
      case Op::Next: return "X " + parts[0];
      case Op::Eventually: return within(e, "F", parts[0]);
      case Op::Always: return within(e, "G", parts[0]);
      case Op::Until: return until(e, parts);
      case Op::WeakUntil: return unbounded(e, parts[0] + " W " + parts[1]);
      case Op::Release: return unbounded(e, parts[0] + " R " + parts[1]);
      default: throw std::invalid_argument("a path formula inside of an expression");
    }
  }

 private:
  static std::string joined(const std::vector<std::string>& parts, const std::string& by) {
    std::string out;
    for (const std::string& part : parts) out += (out.empty() ? "" : by) + part;
    return out;
  }

  std::string condition(Id e) {
    expressions_.expect_type(e, Type::Bool);
    std::string name = path_name(name_(e));
    if (name == "true" || name == "false") return name;
    if (std::none_of(labels_.begin(), labels_.end(), [&](const PrismProgram::Label& l) { return l.name == name; }))
      labels_.push_back({name, e});
    return '"' + name + '"';
  }

  struct Steps {
    std::size_t least = 0;
    std::optional<std::size_t> most;
  };
  std::optional<Steps> steps(Id e) {
    const PrismExpressions::Window* window = expressions_.window(e);
    if (window == nullptr) return std::nullopt;
    const PrismExpressions::Window bounds = *window;
    if (bounds.rewards) throw std::invalid_argument("a bound on rewards inside of a path formula, or not from above");
    const auto number = [&](Id at) {
      expressions_.expect_type(at, Type::Int);
      const double found = expressions_.constant(at);
      if (!(found >= 0 && found <= 1e9)) throw std::invalid_argument("a bound on steps outside of [0, 10^9]");
      return static_cast<std::size_t>(found);
    };
    Steps out;
    if (bounds.least) out.least = number(*bounds.least) + (bounds.above_least ? 1 : 0);
    if (bounds.most) {
      std::size_t most = number(*bounds.most);
      if (bounds.below_most && most == 0) throw std::invalid_argument("a bound of fewer than 0 steps");
      most -= bounds.below_most ? 1 : 0;
      if (most < out.least) throw std::invalid_argument("a bound on steps that is empty");
      out.most = most - out.least;
    }
    return out;
  }
  static std::string nexts(std::size_t n) {
    std::string out;
    for (; n > 0; --n) out += "X ";
    return out;
  }

  std::string within(Id e, const std::string& op, const std::string& part) {
    const auto bound = steps(e);
    if (!bound) return op + ' ' + part;
    if (bound->least > most_written) throw std::invalid_argument("more steps than are written out");
    return nexts(bound->least) + (bound->most ? op + "<=" + std::to_string(*bound->most) : op) + ' ' + part;
  }

  std::string until(Id e, const std::vector<std::string>& parts) {
    const auto bound = steps(e);
    if (!bound) return parts[0] + " U " + parts[1];
    if (bound->least > most_written) throw std::invalid_argument("more steps than are written out");
    std::string out =
        '(' + parts[0] + (bound->most ? " U<=" + std::to_string(*bound->most) : " U") + ' ' + parts[1] + ')';
    for (std::size_t n = bound->least; n > 0; --n) out = '(' + parts[0] + " & X " + out + ')';
    return out;
  }

  std::string unbounded(Id e, std::string text) {
    if (expressions_.window(e) != nullptr) throw std::invalid_argument("W and R with a bound on steps");
    return text;
  }

  PrismExpressions& expressions_;
  const std::function<std::string(Id)>& name_;
  std::vector<PrismProgram::Label>& labels_;
};

}  // namespace

std::string path_name(std::string_view text) {
  std::string out;
  for (const char c : text)
    if (c != '"') out += c == '\n' || c == '\t' || c == '\r' ? ' ' : c;
  return out;
}

std::string path_formula(PrismExpressions& expressions, Id path, const std::function<std::string(Id)>& name,
                         std::vector<PrismProgram::Label>& labels) {
  return PathWriter(expressions, name, labels).write(path);
}

}  // namespace waymark::plan
