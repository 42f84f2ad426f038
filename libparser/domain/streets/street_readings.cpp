#include "libparser/domain/streets/street_readings.hpp"

#include <algorithm>
#include <string>
#include <unordered_map>

namespace waymark::streets {
namespace {

// Mentions in the order in which a text is to be walked, if what it says about order is followed.
std::vector<std::size_t> walking_order(LandmarkIndex start, const std::vector<PlacedMention>& mentions,
                                       const std::vector<MentionCue>& cues) {
  std::vector<std::size_t> order;
  std::size_t target = 0;  // where in `order` the last landmark stands that was said to be reached
  for (std::size_t m = 0; m < mentions.size(); ++m) {
    const bool from_start = cues[m].cue == Cue::From && mentions[m].landmark == start;
    const bool earlier = (cues[m].cue == Cue::Via && !cues[m].onwards) || cues[m].cue == Cue::After;
    if (from_start && !order.empty()) {
      order.insert(order.begin(), m);
      ++target;
    } else if (earlier && !order.empty() && mentions[order[target]].landmark != start) {
      order.insert(order.begin() + static_cast<std::ptrdiff_t>(target), m);
      ++target;
    } else {
      order.push_back(m);
      target = order.size() - 1;
    }
  }
  return order;
}

bool ends_clause(std::string_view word) {
  return word == "." || word == "," || word == "then" || word == "and" || word == "but" || word == "until";
}

bool dropped(Cue cue) { return cue == Cue::Past || cue == Cue::Not; }

}  // namespace

Cue cue_of(std::string_view word) {
  static const std::unordered_map<std::string_view, Cue> cues{
      {"via", Cue::Via},        {"through", Cue::Via},   {"thru", Cue::Via},      {"way", Cue::Via},
      {"traversing", Cue::Via}, {"stopping", Cue::Via},  {"past", Cue::Past},     {"pass", Cue::Past},
      {"passing", Cue::Past},   {"passes", Cue::Past},   {"passed", Cue::Past},   {"by", Cue::Past},
      {"not", Cue::Not},        {"n't", Cue::Not},       {"avoid", Cue::Not},     {"avoiding", Cue::Not},
      {"without", Cue::Not},    {"bypass", Cue::Not},    {"bypassing", Cue::Not}, {"skip", Cue::Not},
      {"skipping", Cue::Not},   {"ignore", Cue::Not},    {"ignoring", Cue::Not},  {"instead", Cue::Not},
      {"miss", Cue::Not},       {"before", Cue::Before}, {"after", Cue::After},   {"first", Cue::First},
      {"from", Cue::From},      {"starting", Cue::From}, {"start", Cue::From},    {"beginning", Cue::From},
      {"begin", Cue::From},     {"leave", Cue::From},    {"leaving", Cue::From},  {"to", Cue::To},
      {"until", Cue::To},       {"reach", Cue::To},      {"towards", Cue::To},    {"toward", Cue::To},
      {"onto", Cue::To},        {"end", Cue::End},       {"ending", Cue::End},    {"finish", Cue::End},
      {"finally", Cue::End},    {"lastly", Cue::End},    {"stop", Cue::End},      {"back", Cue::Back},
      {"return", Cue::Back}};
  const auto at = cues.find(word);
  return at == cues.end() ? Cue::None : at->second;
}

std::vector<MentionCue> mention_cues(const std::vector<std::string>& tokens, const std::vector<Mention>& mentions) {
  std::vector<MentionCue> out(mentions.size());
  std::size_t begin = 0;
  for (std::size_t m = 0; m < mentions.size(); ++m) {
    bool joined = m > 0, via = false,
         denied = false;  // "without going to b": what is denied, is so to the end of its clause
    for (std::size_t i = begin; i < mentions[m].begin; ++i) {
      const std::string& word = tokens[i];
      const Cue cue = cue_of(word);
      via = via || cue == Cue::Via;
      denied = (denied || cue == Cue::Not) && !ends_clause(word);
      if (cue != Cue::None) out[m].cue = cue;
      joined = joined && (word == "and" || word == "," || word == "the" || word == "&");
    }
    if (via && out[m].cue != Cue::Not && out[m].cue != Cue::End)
      out[m].cue = Cue::Via;  // "by way of", "passing through"
    if (denied) out[m].cue = Cue::Not;
    if (joined) out[m].cue = out[m - 1].cue;
    begin = mentions[m].end;
  }
  for (std::size_t m = mentions.size(); m-- > 0;) {
    const std::size_t end = m + 1 < mentions.size() ? mentions[m + 1].begin : mentions[m].end;
    bool stops = m + 1 == mentions.size();
    for (std::size_t i = mentions[m].end; i < end; ++i) stops = stops || tokens[i] == ".";
    const bool handed_on = m + 1 < mentions.size() && out[m + 1].cue == out[m].cue;
    out[m].onwards = !stops && (handed_on ? out[m + 1].onwards : out[m + 1].cue == Cue::To);
  }
  return out;
}

std::vector<Interpretation> readings(LandmarkIndex start, const std::vector<PlacedMention>& mentions,
                                     const std::vector<MentionCue>& cues) {
  const std::vector<std::size_t> order = walking_order(start, mentions, cues);
  std::vector<Interpretation> out;
  for (unsigned followed = 0; followed < 8; ++followed) {
    Interpretation reading{followed, {start}};
    for (std::size_t i = 0; i < mentions.size(); ++i) {
      const std::size_t m = (followed & Interpretation::reordered) != 0 ? order[i] : i;
      if ((followed & Interpretation::passed_by) != 0 && dropped(cues[m].cue)) continue;
      if ((followed & Interpretation::another_start) != 0 && m == 0 && mentions.size() > 1) continue;
      const LandmarkIndex here = mentions[m].landmark;
      if (std::find(reading.landmarks.begin(), reading.landmarks.end(), here) == reading.landmarks.end())
        reading.landmarks.push_back(here);
    }
    const bool fresh =
        std::none_of(out.begin(), out.end(), [&](const Interpretation& r) { return r.landmarks == reading.landmarks; });
    if (fresh) out.push_back(std::move(reading));
  }
  return out;
}

}  // namespace waymark::streets
