#include "libautomata/monitor/conjunction.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "libautomata/monitor/conjunct.hpp"
#include "libltl/rewriting/nnf.hpp"

namespace waymark::automata {

using ltl::Formula;
using ltl::Op;

namespace {

constexpr std::size_t most_letters = 4096, most_answers = 1U << 18U;  // that are remembered
constexpr std::size_t most_witnesses = 4;

void add_conjuncts(Formula f, std::vector<Formula>& out) {
  if (f.op() == Op::And) {
    for (const Formula g : f.operands()) add_conjuncts(g, out);
  } else if (ltl::is_always(f) && f[1].op() == Op::And) {
    for (const Formula g : f[1].operands()) add_conjuncts(ltl::always(g), out);
  } else {
    out.push_back(f);
  }
}

}  // namespace

std::vector<Formula> conjuncts(Formula f) {
  std::vector<Formula> out;
  add_conjuncts(f, out);
  return out;
}

class ConjunctionMonitor::Run {
 public:
  Run(std::vector<Conjunct> conjuncts, Words words, const JointEffort& effort, std::stop_token stop)
      : conjuncts_(std::move(conjuncts)), words_(words), effort_(effort), stop_(std::move(stop)) {
    for (const Conjunct& c : conjuncts_)
      for (const ltl::Proposition p : c.kinds.reads()) blocks_ = std::max<std::size_t>(blocks_, p.index / 64 + 1);
    find_groups();
  }
  std::size_t parts() const { return conjuncts_.size(); }

  void read(const ltl::Letter& letter) {
    ++letters_;
    const std::uint32_t* kinds = kinds_of(letter);
    for (std::size_t i = 0; i < conjuncts_.size(); ++i) {
      conjuncts_[i].yes.read(kinds[i], letter);
      conjuncts_[i].no.read(kinds[i], letter);
      if (conjuncts_[i].yes.forgets_places() || conjuncts_[i].no.forgets_places())
        for (Group& group : groups_) group.known.clear();
    }
  }

  MonitorVerdict verdict() {
    MonitorVerdict out;
    bool all_good = true, some_bad = is_bad_, all_accept = true;
    for (const Conjunct& c : conjuncts_) {
      some_bad = some_bad || c.yes.is_lost();
      all_good = all_good && c.no.is_lost();
      all_accept = all_accept && c.yes.is_accepting();
    }
    if (words_ == Words::Finite && letters_ > 0) out.now = all_accept;
    if (!some_bad && all_good) out.foresight = Foresight::True;
    if (!some_bad && !all_good && !(words_ == Words::Finite && (all_accept || letters_ == 0)))
      for (Group& group : groups_) {
        const Known answer = asked(group);
        some_bad = some_bad || answer == Known::No;
        out.is_known_satisfiable = out.is_known_satisfiable && answer != Known::Unknown;
      }
    is_bad_ = some_bad;
    if (some_bad) {
      out.foresight = Foresight::False;
      out.is_known_satisfiable = true;
    }
    return out;
  }

 private:
  enum class Known : std::uint8_t { Unknown, No, Yes };
  using Places = std::vector<Part::Place>;
  struct HashOfPlaces {
    std::size_t operator()(const Places& places) const {
      std::uint64_t hash = 0;
      for (const Part::Place place : places) hash = (hash ^ place) * 0x9E37'79B9'7F4A'7C15ULL + (hash >> 32U);
      return hash;
    }
  };
  struct Step {
    ltl::Letter letter;
    std::vector<std::uint32_t> kinds;  // by conjunct
  };

  struct Group {  // conjuncts that share propositions, directly or through others; two or more
    std::vector<std::size_t> members;
    std::unordered_map<Places, Known, HashOfPlaces> known;
    std::vector<std::vector<Step>> witnesses;  // the last ones first
  };

  // Over finite words all conjuncts are one group: their words have to end together.
  void find_groups() {
    std::vector<std::size_t> group(conjuncts_.size());
    std::iota(group.begin(), group.end(), std::size_t{0});
    const auto find = [&](std::size_t i) {
      while (group[i] != i) i = group[i] = group[group[i]];
      return i;
    };
    std::map<ltl::Proposition, std::size_t> reader;
    for (std::size_t i = 0; i < conjuncts_.size(); ++i) {
      if (words_ == Words::Finite) group[find(i)] = find(0);
      for (const ltl::Proposition p : conjuncts_[i].kinds.reads())
        group[find(i)] = find(reader.try_emplace(p, i).first->second);
    }
    std::map<std::size_t, Group> found;
    for (std::size_t i = 0; i < conjuncts_.size(); ++i) found[find(i)].members.push_back(i);
    for (auto& [first, some] : found)
      if (some.members.size() > 1) groups_.push_back(std::move(some));
  }

  // By conjunct. Remembered until there are too many letters.
  const std::uint32_t* kinds_of(const ltl::Letter& letter) {
    std::vector<std::uint64_t> key;
    for (std::size_t b = 0; b < blocks_; ++b) key.push_back(letter.block(b));
    if (const auto known = kinds_.find(key); known != kinds_.end()) return known->second.data();
    if (kinds_.size() >= most_letters) forget();
    return kinds_.emplace(std::move(key), new_kinds(letter)).first->second.data();
  }
  std::vector<std::uint32_t> new_kinds(const ltl::Letter& letter) {
    std::vector<std::uint32_t> out;
    for (Conjunct& c : conjuncts_) out.push_back(c.kinds.of(letter));
    return out;
  }
  void forget() {
    kinds_.clear();
    for (Group& group : groups_) group.witnesses.clear();
    for (Conjunct& c : conjuncts_) {
      if (c.kinds.size() < most_letters) continue;
      c.kinds.forget();
      c.yes.forget_letters();
      c.no.forget_letters();
    }
  }

  Places places_of(const Group& group) const {
    Places out;
    for (const std::size_t i : group.members) out.push_back(conjuncts_[i].yes.at());
    return out;
  }

  Known asked(Group& group) {
    const Places places = places_of(group);
    if (const auto known = group.known.find(places); known != group.known.end()) return known->second;
    if (by_witness(group, places)) return Known::Yes;  // not remembered: this is as fast
    if (group.known.size() >= most_answers) group.known.clear();
    const Known answer = searched(group, places);
    group.known.insert_or_assign(places, answer);
    return answer;
  }

  // Does a word that was found before lead to places where the answer was yes?
  bool by_witness(Group& group, const Places& places) {
    return std::any_of(group.witnesses.begin(), group.witnesses.end(),
                       [&](const std::vector<Step>& word) { return leads_on(group, places, word); });
  }
  bool leads_on(Group& group, const Places& places, const std::vector<Step>& word) {
    Places at = places;
    for (const Step& step : word) {
      at = after(group, at, step);
      if (std::find(at.begin(), at.end(), Part::nowhere) != at.end()) return false;
      const auto known = group.known.find(at);
      if (known != group.known.end() && known->second == Known::Yes) return true;
    }
    return false;
  }
  Places after(Group& group, const Places& from, const Step& step) {
    Places out(from.size());
    for (std::size_t j = 0; j < out.size(); ++j)
      out[j] = conjuncts_[group.members[j]].yes.next(from[j], step.kinds[group.members[j]], step.letter);
    return out;
  }

  Known searched(Group& group, const Places& places) {
    if (spent_ >= effort_.all) return Known::Unknown;
    std::vector<Part*> parts;
    for (const std::size_t i : group.members) parts.push_back(&conjuncts_[i].yes.part());
    const std::size_t most = std::min(effort_.question, effort_.all - spent_);
    Budget budget(most, SIZE_MAX, stop_);
    JointAnswer answer{JointAnswer::Verdict::Unknown};
    try {
      answer = joint_word(parts, places, words_, budget);
    } catch (const Budget::Exceeded& spent) {
      if (spent.reason == Budget::Exceeded::Reason::Stopped) throw;
    }
    spent_ += most - budget.steps_left();
    if (answer.verdict == JointAnswer::Verdict::Unknown) return Known::Unknown;
    if (answer.verdict == JointAnswer::Verdict::No) return Known::No;
    std::vector<Step> witness;
    for (const ltl::Letter& letter : answer.letters) witness.push_back({letter, new_kinds(letter)});
    Places at = places;
    for (const Step& step : witness) group.known.insert_or_assign(at = after(group, at, step), Known::Yes);
    keep(group, places, std::move(witness));
    return Known::Yes;
  }

  // Joined with the last one, letter by letter, where that leads on, too: a word that fulfils what is open in many
  // places is found in a few searches.
  void keep(Group& group, const Places& places, std::vector<Step> witness) {
    if (witness.empty()) return;
    if (!group.witnesses.empty()) {
      std::vector<Step> joined = witness;
      for (std::size_t i = 0; i < std::min(joined.size(), group.witnesses.front().size()); ++i) {
        joined[i].letter.insert_all(group.witnesses.front()[i].letter);
        joined[i].kinds = new_kinds(joined[i].letter);
      }
      if (leads_on(group, places, joined)) witness = std::move(joined);
    }
    group.witnesses.insert(group.witnesses.begin(), std::move(witness));
    if (group.witnesses.size() > most_witnesses) group.witnesses.pop_back();
  }

  std::vector<Conjunct> conjuncts_;
  Words words_;
  JointEffort effort_;
  std::stop_token stop_;
  std::vector<Group> groups_;
  std::map<std::vector<std::uint64_t>, std::vector<std::uint32_t>> kinds_;  // by letter, then by conjunct
  std::size_t blocks_ = 0, letters_ = 0, spent_ = 0;  // of letters, 64 propositions each; read; moves that were tried
  bool is_bad_ = false;                               // once and for all
};

std::variant<ConjunctionMonitor, Exhausted> ConjunctionMonitor::of(Formula f, Words words, const ltl::Limits& limits,
                                                                   const JointEffort& effort) {
  Formula normal = ltl::nnf_keeping_iff(f);
  const bool negated = normal.op() == Op::Or;
  if (negated) normal = ltl::nnf_keeping_iff(ltl::negate(normal));
  std::vector<Conjunct> parts;
  for (const Formula g : conjuncts(normal)) {
    std::variant<Conjunct, Exhausted> made = conjunct_of(g, words, limits);
    if (const auto* exhausted = std::get_if<Exhausted>(&made)) return *exhausted;
    parts.push_back(std::get<Conjunct>(std::move(made)));
  }
  return ConjunctionMonitor(std::make_unique<Run>(std::move(parts), words, effort, limits.stop), negated);
}

ConjunctionMonitor::ConjunctionMonitor(std::unique_ptr<Run> run, bool negated)
    : run_(std::move(run)), negated_(negated), verdict_(shown(run_->verdict())) {}
ConjunctionMonitor::ConjunctionMonitor(ConjunctionMonitor&&) noexcept = default;
ConjunctionMonitor& ConjunctionMonitor::operator=(ConjunctionMonitor&&) noexcept = default;
ConjunctionMonitor::~ConjunctionMonitor() = default;

std::size_t ConjunctionMonitor::parts() const { return run_->parts(); }

MonitorVerdict ConjunctionMonitor::read(const ltl::Letter& letter) {
  run_->read(letter);
  return verdict_ = shown(run_->verdict());
}

MonitorVerdict ConjunctionMonitor::shown(MonitorVerdict of_run) const {
  if (!negated_) return of_run;
  if (of_run.foresight != Foresight::Open)
    of_run.foresight = of_run.foresight == Foresight::True ? Foresight::False : Foresight::True;
  if (of_run.now) of_run.now = !*of_run.now;
  return of_run;
}

}  // namespace waymark::automata
