#include "libautomata/monitor/joint_search.hpp"

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

namespace waymark::automata {
namespace {

using Tuple = std::vector<Part::Place>;

// Marks of all parts: part after part.
class MarkSet {
 public:
  explicit MarkSet(std::size_t marks) : blocks_((marks + 63) / 64, 0) {}
  void insert(std::size_t mark) { blocks_[mark / 64] |= std::uint64_t{1} << (mark % 64); }
  void unite(const MarkSet& other) {
    for (std::size_t i = 0; i < blocks_.size(); ++i) blocks_[i] |= other.blocks_[i];
  }
  friend bool operator==(const MarkSet&, const MarkSet&) = default;

 private:
  std::vector<std::uint64_t> blocks_;
};

struct TooManyMoves {};

// The combinations of one move of each part whose cubes agree, in the order of the moves, one at a time.
class Combinations {
 public:
  Combinations(std::span<Part* const> parts, Tuple from) : from_(std::move(from)), pick_(parts.size(), 0) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const auto& moves = parts[i]->moves(from_[i]);
      if (!moves) throw TooManyMoves{};
    }
  }

  // false: there is no other one.
  bool advance(std::span<Part* const> parts, Budget& budget) {
    values_.clear();
    asked_.assign(parts.size(), {});
    std::size_t i = 0;
    if (std::exchange(begun_, true)) {
      for (; i + 1 < parts.size(); ++i) assign(move(parts, i), i);
      ++pick_[i];
    }
    while (true) {
      const std::vector<Part::Move>& moves = *parts[i]->moves(from_[i]);
      while (pick_[i] < moves.size() && !agrees(moves[pick_[i]], budget)) ++pick_[i];
      if (pick_[i] < moves.size()) {
        assign(moves[pick_[i]], i);
        if (++i == parts.size()) return true;
        pick_[i] = 0;
      } else {
        if (i == 0) return false;
        --i;
        for (const ltl::Proposition p : asked_[i]) values_.erase(p.index);
        asked_[i].clear();
        ++pick_[i];
      }
    }
  }

  // Of the last combination.
  Tuple targets(std::span<Part* const> parts) const {
    Tuple out;
    for (std::size_t i = 0; i < parts.size(); ++i) out.push_back(move(parts, i).target);
    return out;
  }
  MarkSet marks(std::span<Part* const> parts, std::size_t all) const {
    MarkSet out(all);
    std::size_t first = 0;
    for (std::size_t i = 0; i < parts.size(); first += parts[i++]->sets())
      for (const std::uint32_t mark : move(parts, i).marks.members()) out.insert(first + mark);
    return out;
  }
  ltl::Letter letter() const {
    ltl::Letter out;
    for (const auto& [index, value] : values_)
      if (value) out.insert({index});
    return out;
  }
  const Tuple& from() const { return from_; }

 private:
  const Part::Move& move(std::span<Part* const> parts, std::size_t i) const {
    return (*parts[i]->moves(from_[i]))[pick_[i]];
  }
  bool agrees(const Part::Move& move, Budget& budget) const {
    budget.step();
    return std::all_of(move.cube.begin(), move.cube.end(), [&](const Part::Literal& l) {
      const auto known = values_.find(l.proposition.index);
      return known == values_.end() || known->second == l.value;
    });
  }
  void assign(const Part::Move& move, std::size_t i) {
    for (const Part::Literal& l : move.cube)
      if (values_.try_emplace(l.proposition.index, l.value).second) asked_[i].push_back(l.proposition);
  }

  Tuple from_;
  std::vector<std::size_t> pick_;  // by part, in its moves
  bool begun_ = false;
  std::unordered_map<std::uint32_t, bool> values_;    // of the letter, where some move asks for them
  std::vector<std::vector<ltl::Proposition>> asked_;  // by part: the values that it was the first to ask for
};

class Search {
 public:
  Search(std::span<Part* const> parts, Words words, Budget& budget) : parts_(parts), words_(words), budget_(budget) {
    for (const Part* part : parts) marks_ += part->sets();
    all_ = MarkSet(marks_);
    for (std::size_t i = 0; i < marks_; ++i) all_.insert(i);
  }

  JointAnswer run(const Tuple& from) {
    if (enter(from, MarkSet(marks_))) return {JointAnswer::Verdict::Yes, {}};
    while (!path_.empty()) {
      if (!path_.back().ways.advance(parts_, budget_)) {
        leave();
        continue;
      }
      const Combinations& ways = path_.back().ways;
      path_.back().letter = ways.letter();
      const Tuple target = ways.targets(parts_);
      const MarkSet marks = ways.marks(parts_, marks_);
      const auto known = number_.find(target);
      const bool accepts = known == number_.end()  ? enter(target, marks)
                           : known->second == dead ? false
                                                   : closes(known->second, marks);
      if (accepts) return {JointAnswer::Verdict::Yes, letters()};
    }
    return {JointAnswer::Verdict::No, {}};
  }

 private:
  static constexpr std::size_t dead = 0;  // no word is accepted from there
  struct Open {                           // a tuple on the path
    Combinations ways;
    std::size_t number;
    ltl::Letter letter;  // of the way that was taken last
  };
  struct Component {  // along the path, with the marks on the way into it and inside it
    std::size_t first;
    MarkSet into, inside;
  };

  // true: a word ends here, or goes round here.
  bool enter(const Tuple& tuple, const MarkSet& marks) {
    if (words_ == Words::Finite) {
      bool all = true;
      for (std::size_t i = 0; i < parts_.size(); ++i) all = all && parts_[i]->is_accepting(tuple[i]);
      if (all) return true;
    }
    number_.insert_or_assign(tuple, ++last_);
    alive_.push_back(tuple);
    components_.push_back({last_, marks, MarkSet(marks_)});
    path_.push_back({Combinations(parts_, tuple), last_, {}});
    return false;
  }
  bool closes(std::size_t number, MarkSet marks) {
    if (words_ == Words::Finite) return false;
    while (components_.back().first > number) {
      marks.unite(components_.back().into);
      marks.unite(components_.back().inside);
      components_.pop_back();
    }
    components_.back().inside.unite(marks);
    return components_.back().inside == all_;
  }
  void leave() {
    if (components_.back().first == path_.back().number) {
      for (; !alive_.empty() && number_.at(alive_.back()) >= path_.back().number; alive_.pop_back())
        number_.at(alive_.back()) = dead;
      components_.pop_back();
    }
    path_.pop_back();
  }
  std::vector<ltl::Letter> letters() const {
    std::vector<ltl::Letter> out;
    for (const Open& open : path_) out.push_back(open.letter);
    return out;
  }

  std::span<Part* const> parts_;
  Words words_;
  Budget& budget_;
  std::size_t marks_ = 0, last_ = dead;
  MarkSet all_{0};
  std::map<Tuple, std::size_t> number_;  // in the order of discovery, or dead
  std::vector<Tuple> alive_;             // numbers ascend
  std::vector<Component> components_;    // numbers ascend
  std::vector<Open> path_;
};

}  // namespace

JointAnswer joint_word(std::span<Part* const> parts, const std::vector<Part::Place>& from, Words words,
                       Budget& budget) {
  try {
    return Search(parts, words, budget).run(from);
  } catch (const TooManyMoves&) {
    return {JointAnswer::Verdict::Unknown, {}};
  }
}

}  // namespace waymark::automata
