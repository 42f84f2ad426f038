#include "libparser/import/irregularities.hpp"

#include <algorithm>
#include <cstdlib>

namespace waymark::parser {
namespace {

using plan::Pose;

bool same_place(const Pose& a, const Pose& b) { return a.x == b.x && a.y == b.y; }

class Check {
 public:
  Check(ReleasedParagraph& paragraph, const ReleasedMap* map) : p_(paragraph), map_(map) {}

  std::vector<Irregularity> run() {
    if (map_ == nullptr) report(here(), "unknown-map", "there is no map called " + p_.map);
    if (p_.sentences.empty())
      report(here(), "unsegmented", "no sentences, only text and path of the paragraph");
    for (ReleasedSentence& sentence : p_.sentences) check_path(sentence.path, of(sentence));
    check_path(p_.path, here());
    numbers();
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

  void report(At at, const char* kind, std::string message) {
    found_.push_back({at.file, at.line, kind, p_.id + ": " + std::move(message)});
  }

  bool joined(const Pose& a, const Pose& b) const {
    return std::any_of(map_->edges.begin(), map_->edges.end(), [&](const plan::Edge& e) {
      const plan::Node &x = map_->nodes[e.a], &y = map_->nodes[e.b];
      return (x.x == a.x && x.y == a.y && y.x == b.x && y.y == b.y) ||
             (x.x == b.x && x.y == b.y && y.x == a.x && y.y == a.y);
    });
  }

  void check_path(std::vector<Pose>& path, At at) {
    for (std::size_t i = 1; i < path.size(); ++i) {
      const Pose a = path[i - 1], b = path[i];
      const int turn = std::abs(a.heading - b.heading);
      if (b.heading < 0)
        report(at, "heading-unknown-inside", "the heading is left open after a step, at " + show(b));
      if (a.heading < 0 || b.heading < 0) {
        if (!same_place(a, b)) report(at, "illegal-step", "a move with an open heading, to " + show(b));
      } else if (same_place(a, b) && turn == 180) {
        report(at, "uturn-expanded", "a turn of 180 degrees, written as two LEFT, at " + show(a));
        path.insert(path.begin() + static_cast<std::ptrdiff_t>(i), {a.x, a.y, (a.heading + 270) % 360});
      } else if (!(same_place(a, b) && (turn == 90 || turn == 270)) && !is_forward(a, b)) {
        report(at, "illegal-step", "no single action leads from " + show(a) + " to " + show(b));
      } else if (map_ != nullptr && !same_place(a, b) && !joined(a, b)) {
        report(at, "no-hallway", "no hallway leads from " + show(a) + " to " + show(b));
      }
    }
  }

  static bool is_forward(const Pose& a, const Pose& b) {
    const int dx = a.heading == 90    ? 1
                   : a.heading == 270 ? -1
                                      : 0,
              dy = a.heading == 180 ? 1
                   : a.heading == 0 ? -1
                                    : 0;
    return a.heading == b.heading && b.x == a.x + dx && b.y == a.y + dy;
  }

  void numbers() {  // "12-3": sentences that nobody could align are left out, their numbers missing
    std::string missing;
    int expected = 1;
    for (const ReleasedSentence& sentence : p_.sentences) {
      const std::size_t dash = sentence.id.rfind('-');
      if (dash == std::string::npos) return;
      const int number = std::atoi(sentence.id.c_str() + dash + 1);
      for (; expected < number; ++expected) missing += " " + std::to_string(expected);
      expected = number + 1;
    }
    if (!missing.empty())
      report(of(p_.sentences.front()), "sentence-numbers-missing",
             "the source leaves out the sentences" + missing);
  }

  void joins() {
    for (std::size_t i = 0; i < p_.sentences.size(); ++i) {
      const ReleasedSentence& sentence = p_.sentences[i];
      const bool open = sentence.path.front().heading < 0;
      if (i == 0) {
        if (!open && !p_.sentences[0].id.empty())
          report(of(sentence), "first-heading-known",
                 "the first sentence starts with a heading, " + show(sentence.path.front()));
        continue;
      }
      if (open)
        report(of(sentence), "heading-unknown-inside", "a later sentence starts with an open heading");
      const Pose &end = p_.sentences[i - 1].path.back(), &start = sentence.path.front();
      if (!same_place(end, start))
        report(of(sentence), "gap",
               "starts at " + show(start) + ", the sentence before ends at " + show(end));
      else if (end.heading != start.heading)
        report(of(sentence), "heading-gap",
               "starts at " + show(start) + ", the sentence before ends at " + show(end));
    }
  }

  void against_paragraph() {
    if (p_.sentences.empty()) return;
    std::vector<Pose> whole;
    for (const ReleasedSentence& sentence : p_.sentences)
      for (const Pose& pose : sentence.path)
        if (whole.empty() || whole.back() != pose) whole.push_back(pose);
    const Pose end = whole.back();
    if (p_.goal && !same_place(end, *p_.goal))
      report(of(p_.sentences.back()), "goal-not-reached",
             "ends at " + show(end) + ", the goal is (" + std::to_string(p_.goal->x) + ", " +
                 std::to_string(p_.goal->y) + ")");
    if (p_.path.empty()) {
      p_.path = std::move(whole);
      return;
    }
    if (whole != p_.path)
      report(here(), "differs-from-paragraph-path",
             "the trajectories of its sentences, joined, are not its path");
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
