#include "libplan/solve/drop_conjuncts.hpp"

#include <algorithm>

#include "libltl/text/print.hpp"

namespace waymark::plan {
namespace {

using Formulas = std::vector<ltl::Formula>;

Formulas without(const Formulas& all, const Formulas& some) {
  Formulas out;
  for (ltl::Formula f : all)
    if (std::find(some.begin(), some.end(), f) == some.end()) out.push_back(f);
  return out;
}

class Dropping {
 public:
  Dropping(ltl::Formula f, const std::function<bool(ltl::Formula)>& is_possible)
      : arena_(f.arena()), is_possible_(is_possible) {
    if (f.op() == ltl::Op::And)
      conjuncts_.assign(f.operands().begin(), f.operands().end());
    else
      conjuncts_ = {f};
  }

  Violation run() {
    Violation out{conflict(conjuncts_), {}};
    if (conjuncts_.size() == 1) return out;
    out.dropped = fewest();
    if (out.dropped.size() == conjuncts_.size()) out.dropped.clear();
    return out;
  }

 private:
  bool possible(const Formulas& part) const { return is_possible_(ltl::conjunction(arena_, part)); }

  // A conjunct that can be left out is, until none can.
  Formulas conflict(Formulas part) const {
    for (std::size_t i = 0; i < part.size() && part.size() > 1;) {
      Formulas less = part;
      less.erase(less.begin() + static_cast<std::ptrdiff_t>(i));
      if (possible(less))
        ++i;
      else
        part = std::move(less);
    }
    return part;
  }

  Formulas fewest() const {
    std::size_t asked = 0;
    for (std::size_t size = 1; size < conjuncts_.size(); ++size) {
      std::vector<bool> chosen(conjuncts_.size(), false);
      std::fill(chosen.begin(), chosen.begin() + static_cast<std::ptrdiff_t>(size), true);
      do {
        if (++asked > most_sets) return one_by_one();
        Formulas dropped;
        for (std::size_t i = 0; i < chosen.size(); ++i)
          if (chosen[i]) dropped.push_back(conjuncts_[i]);
        if (possible(without(conjuncts_, dropped))) return dropped;
      } while (std::prev_permutation(chosen.begin(), chosen.end()));
    }
    return conjuncts_;
  }

  Formulas one_by_one() const {
    Formulas dropped, kept = conjuncts_;
    while (!kept.empty() && !possible(kept)) {
      dropped.push_back(conflict(kept).front());
      kept = without(conjuncts_, dropped);
    }
    return dropped;
  }

  ltl::Arena& arena_;
  const std::function<bool(ltl::Formula)>& is_possible_;
  Formulas conjuncts_;
};

}  // namespace

Violation fewest_dropped(ltl::Formula f, const std::function<bool(ltl::Formula)>& is_possible) {
  return Dropping(f, is_possible).run();
}

std::string in_words(const Violation& violation, bool must_be_sure) {
  return conflict_behind(must_be_sure ? "no strategy is sure to satisfy " : "no strategy has a chance to satisfy ",
                         violation);
}

std::string conflict_behind(std::string_view words, const Violation& violation) {
  std::string out(words);
  for (std::size_t i = 0; i < violation.conflict.size(); ++i)
    out += (i == 0 ? "" : i + 1 == violation.conflict.size() ? " and " : ", ") + ltl::print(violation.conflict[i]);
  return violation.conflict.size() > 1 ? out + " together" : out;
}

std::vector<std::string> absent(const ltl::Letter& seen, const ltl::Vocabulary& vocabulary,
                                const std::vector<ltl::Formula>& formulas) {
  std::vector<std::string> names;
  for (ltl::Formula f : formulas)
    for (ltl::Proposition p : ltl::propositions(f)) {
      const std::string& name = f.arena().vocabulary().name(p);
      const auto ours = vocabulary.find(name);
      if (!ours || !seen.contains(*ours)) names.push_back(name);
    }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

}  // namespace waymark::plan
