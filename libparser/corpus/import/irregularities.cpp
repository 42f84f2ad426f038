#include "libparser/corpus/import/irregularities.hpp"

#include <algorithm>
#include <cstdlib>

namespace waymark::parser {
namespace {

using plan::Pose;

bool same_place(const Pose& a, const Pose& b) { return a.x == b.x && a.y == b.y; }

class Check {
 public:
  Check(ReleasedParagraph& paragraph, const ReleasedMap* map)
      : p_(paragraph), map_(map), found_(std::move(paragraph.noted)) {}

  std::vector<Irregularity> run() {
    if (map_ == nullptr) report(here(), "unknown-map", "there is no map called " + p_.map);
    if (p_.sentences.empty()) report(here(), "unsegmented", "no sentences, only text and path of the paragraph");
    std::vector<ReleasedSentence> kept;
    for (ReleasedSentence& sentence : p_.sentences) {
      check_labels(sentence);
      if (check_path(sentence.trace.poses, of(sentence)))
        kept.push_back(sentence);
      else
        report(of(sentence), "left-out", "the sentence \"" + sentence.text + "\", whose trajectory is none");
    }
    numbers();
    p_.sentences = std::move(kept);
    joins();
    against_paragraph();
    return std::move(found_);
  }

 private:
  struct At {  // a place in a file
    const std::string& file;
    std::size_t line;
  };
  At here() const { return {p_.file, p_.line}; }
  static At of(const ReleasedSentence& sentence) { return {sentence.file, sentence.line}; }

  static std::string not_at(const Pose& place) {
    return "not at (" + std::to_string(place.x) + ", " + std::to_string(place.y) + ")";
  }

  void report(At at, const char* kind, std::string message) {
    found_.push_back({at.file, at.line, kind, p_.id + ": " + std::move(message)});
  }

  bool stands(const Pose& a) const {
    return std::any_of(map_->nodes.begin(), map_->nodes.end(),
                       [&](const plan::Node& node) { return node.x == a.x && node.y == a.y; });
  }

  bool joined(const Pose& a, const Pose& b) const {
    return std::any_of(map_->edges.begin(), map_->edges.end(), [&](const plan::Edge& e) {
      const plan::Node &x = map_->nodes[e.a], &y = map_->nodes[e.b];
      return (x.x == a.x && x.y == a.y && y.x == b.x && y.y == b.y) ||
             (x.x == b.x && x.y == b.y && y.x == a.x && y.y == a.y);
    });
  }

  void check_labels(const ReleasedSentence& sentence) {
    const std::vector<Pose>& poses = sentence.trace.poses;
    for (const std::size_t k : sentence.trace.mislabelled)
      report(of(sentence), "action-differs",
             "the action from " + show(poses[k]) + " to " + show(poses[k + 1]) + " is " +
                 std::string(action_between(poses[k], poses[k + 1])) + ", and is called something else");
  }

  // Is it, as mended, a trajectory of the map (of any map, where it is not known)?
  bool check_path(std::vector<Pose>& path, At at) {
    bool fine = true;
    const auto fault = [&](const char* kind, std::string message) {
      report(at, kind, std::move(message));
      fine = false;
    };
    if (map_ != nullptr && !stands(path[0])) fault("off-map", "no node of the map is at " + show(path[0]));
    for (std::size_t i = 1; i < path.size(); ++i) {
      const Pose a = path[i - 1], b = path[i];
      const bool stays = same_place(a, b);
      if (b.heading < 0)
        fault("heading-unknown-inside", "the heading is left open after a step, at " + show(b));
      else if (a.heading < 0 && !stays)
        fault("illegal-step", "a move with an open heading, to " + show(b));
      else if (a == b) {
        report(at, "stands-still", "an action that changes nothing, at " + show(a));
        path.erase(path.begin() + static_cast<std::ptrdiff_t>(i--));
      } else if (a.heading >= 0 && stays && std::abs(a.heading - b.heading) == 180) {
        report(at, "uturn-expanded", "a turn of 180 degrees, written as two LEFT, at " + show(a));
        path.insert(path.begin() + static_cast<std::ptrdiff_t>(i), {a.x, a.y, (a.heading + 270) % 360});
      } else if (a.heading >= 0 && action_between(a, b).empty())
        fault("illegal-step", "no single action leads from " + show(a) + " to " + show(b));
      else if (map_ != nullptr && !stays && !joined(a, b))
        fault("no-hallway", "no hallway leads from " + show(a) + " to " + show(b));
    }
    return fine;
  }

  void numbers() {               // "12-3": sentences that nobody could align are left out, their numbers missing
    if (p_.number == 0) return;  // navi numbers nothing
    std::string missing;
    int expected = 1;
    for (const ReleasedSentence& sentence : p_.sentences) {
      const std::size_t dash = sentence.id.rfind('-');
      if (dash == std::string::npos) return;
      const int number = std::atoi(sentence.id.c_str() + dash + 1);
      if (number < expected)
        report(of(sentence), "sentence-order", "sentence " + sentence.id + " stands after one that follows it");
      constexpr int most = 1000;  // beyond, it is no number that counts sentences
      for (; expected < number && number < most; ++expected) missing += " " + std::to_string(expected);
      expected = std::max(expected, number + 1);
    }
    if (!missing.empty())
      report(of(p_.sentences.front()), "sentence-numbers-missing", "the source leaves out the sentences" + missing);
  }

  void joins() {
    for (std::size_t i = 0; i < p_.sentences.size(); ++i) {
      const ReleasedSentence& sentence = p_.sentences[i];
      const Pose& start = sentence.trace.poses.front();
      const bool open = start.heading < 0;
      if (i == 0) {
        if (p_.start && !same_place(start, *p_.start))
          report(of(sentence), "start-differs", "starts at " + show(start) + ", " + not_at(*p_.start));
        if (!open && p_.number != 0)  // navi's set traces have no open headings
          report(of(sentence), "first-heading-known", "the first sentence starts with a heading, " + show(start));
        continue;
      }
      if (open) report(of(sentence), "heading-unknown-inside", "a later sentence starts with an open heading");
      const Pose& end = p_.sentences[i - 1].trace.poses.back();
      if (!same_place(end, start))
        report(of(sentence), "gap", "starts at " + show(start) + ", the sentence before ends at " + show(end));
      else if (end.heading != start.heading)
        report(of(sentence), "heading-gap", "starts at " + show(start) + ", the sentence before ends at " + show(end));
    }
  }

  void against_paragraph() {
    if (p_.sentences.empty()) {
      if (!p_.path.empty()) check_path(p_.path, here());
      return;
    }
    std::vector<Pose> whole;
    for (const ReleasedSentence& sentence : p_.sentences)
      for (const Pose& pose : sentence.trace.poses)
        if (whole.empty() || whole.back() != pose) whole.push_back(pose);
    const Pose end = whole.back();
    if (p_.goal && !same_place(end, *p_.goal))
      report(of(p_.sentences.back()), "goal-not-reached", "ends at " + show(end) + ", " + not_at(*p_.goal));
    if (p_.path.empty()) {
      p_.path = std::move(whole);
      return;
    }
    if (whole == p_.path) return;  // its steps were looked at
    check_path(p_.path, here());
    if (whole != p_.path)
      report(here(), "differs-from-paragraph-path", "the trajectories of its sentences, joined, are not its path");
    if (!same_place(end, p_.path.back()))
      report(here(), "end-differs-from-paragraph-path",
             "its sentences end at " + show(end) + ", its path at " + show(p_.path.back()));
  }

  ReleasedParagraph& p_;
  const ReleasedMap* map_;
  std::vector<Irregularity> found_;
};

}  // namespace

std::vector<Irregularity> find_irregularities(ReleasedParagraph& paragraph, const ReleasedMap* map) {
  return Check(paragraph, map).run();
}

}  // namespace waymark::parser
