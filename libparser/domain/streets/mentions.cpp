#include "libparser/domain/streets/mentions.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "libparser/corpus/token.hpp"

namespace waymark::streets {
namespace {

constexpr std::size_t spare_words = 2;      // of a stretch, beyond those of the longest name
constexpr std::size_t most_name_words = 6;  // whose subsequences are all parts; longer names keep their stretches only
constexpr double frequent = 0.004;          // share of the texts of a city
constexpr float missing_letter = 0.1F;      // what a letter of the name that was left out costs
constexpr float most_behind = 2.5F;         // letters by which a name may fit worse and still be kept

constexpr float one_more = 1.5F;  // letters that a mention costs, so that names are not torn apart

std::size_t slips_allowed(std::size_t letters) { return letters < 4 ? 0 : letters / 4; }

// Base letters of U+00C0 … U+00FF.
constexpr std::string_view latin = "aaaaaaaceeeeiiiidnooooo ouuuuy saaaaaaaceeeeiiiidnooooo ouuuuy y";

std::vector<std::string> words_of_name(const Landmark& landmark) {
  std::vector<std::string> words;
  for (const std::string& token : parser::tokenize(landmark.name)) {
    std::string word;
    for (std::size_t i = 0; i <= token.size(); ++i) {
      if (i < token.size() && token[i] != '-' && token[i] != '/') {
        word += token[i];
        continue;
      }
      std::string letters = letters_of(word);
      word.clear();
      const bool joined = letters == "s" && !words.empty();  // "Ashley's"
      if (joined)
        words.back() += letters;
      else if (!letters.empty())
        words.push_back(std::move(letters));
    }
  }
  return words;
}

}  // namespace

std::string letters_of(std::string_view word) {
  std::string out;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const auto c = static_cast<unsigned char>(word[i]);
    if (c == 0xC3 && i + 1 < word.size()) {
      const char base = latin[static_cast<unsigned char>(word[++i]) & 0x3FU];
      if (base != ' ') out += base;
    } else if (c >= 'A' && c <= 'Z') {
      out += static_cast<char>(c - 'A' + 'a');
    } else if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c >= 0x80) {
      out += static_cast<char>(c);
    }
  }
  if (out == "street") out = "st";
  if (out == "avenue") out = "ave";
  if (out == "road") out = "rd";
  return out;
}

std::size_t slips(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), now(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    now[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      now[j] = std::min({last[j] + 1, now[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0U : 1U)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) now[j] = std::min(now[j], before[j - 2] + 1);
    }
    std::swap(before, last);
    std::swap(last, now);
  }
  return last[b.size()];
}

CommonWords common_words(std::span<const StreetInstruction* const> instructions, const std::vector<StreetMap>& maps) {
  std::vector<std::set<std::string>> named(maps.size());
  for (std::size_t m = 0; m < maps.size(); ++m)
    for (const Landmark& landmark : maps[m].landmarks)
      for (std::string& word : words_of_name(landmark)) named[m].insert(std::move(word));
  std::vector<std::size_t> texts(maps.size(), 0);
  std::map<std::string, std::map<std::size_t, std::size_t>> counts;  // texts by word and city
  for (const StreetInstruction* instruction : instructions) {
    ++texts[instruction->map];
    std::set<std::string> words;
    for (const std::string& token : instruction->tokens) words.insert(letters_of(token));
    for (const std::string& word : words)
      if (!word.empty() && !named[instruction->map].contains(word)) ++counts[word][instruction->map];
  }
  CommonWords common;
  for (const auto& [word, by_city] : counts) {
    std::size_t cities = 0;
    for (const auto& [city, count] : by_city)
      cities += static_cast<double>(count) >= frequent * static_cast<double>(texts[city]) ? 1U : 0U;
    if (cities >= 2) common.insert(word);
  }
  return common;
}

MentionFinder::MentionFinder(const StreetMap& map, const CommonWords& common) : common_(common) {
  for (LandmarkIndex i = 0; i < map.landmarks.size(); ++i) add_parts(i, words_of_name(map.landmarks[i]));
}

void MentionFinder::add_parts(LandmarkIndex landmark, const std::vector<std::string>& words) {
  const std::size_t n = words.size();
  most_words_ = std::max(most_words_, n + spare_words);
  std::string name;
  for (const std::string& word : words) name += word;
  const auto add = [&](auto&& holds) {
    NamePart part{landmark, {}, name.size(), true};
    for (std::size_t i = 0; i < n; ++i)
      if (holds(i)) {
        part.letters += words[i];
        part.common = part.common && common_.contains(words[i]);
      }
    part.common = part.common && part.letters != name;
    if (part.letters.size() > 1 || part.letters == name) parts_.push_back(std::move(part));
  };
  if (n <= most_name_words) {
    for (unsigned subset = 1; subset < 1U << n; ++subset) add([&](std::size_t i) { return (subset >> i & 1U) != 0; });
  } else {
    for (std::size_t begin = 0; begin < n; ++begin)
      for (std::size_t end = begin + 1; end <= n; ++end) add([&](std::size_t i) { return begin <= i && i < end; });
  }
}

// The names that a stretch of letters fits. `common`: every word of it is a common one, which must then be a whole
// name.
const std::vector<NameFit>& MentionFinder::fits(const std::string& letters, bool common) {
  const auto [at, fresh] = known_[common ? 1 : 0].try_emplace(letters);
  std::vector<NameFit>& found = at->second;
  if (!fresh || letters.empty()) return found;
  std::map<LandmarkIndex, NameFit> best;
  for (const NamePart& part : parts_) {
    if (part.common) continue;
    const std::size_t longer = std::max(part.letters.size(), letters.size());
    const std::size_t shorter = std::min(part.letters.size(), letters.size());
    const std::size_t allowed = common ? 0 : slips_allowed(longer);
    if (longer - shorter > allowed || (common && part.letters.size() != part.name_letters)) continue;
    const std::size_t off = slips(letters, part.letters);
    if (off > allowed) continue;
    const auto size = static_cast<float>(part.letters.size()), whole = static_cast<float>(part.name_letters);
    const NameFit fit{part.landmark, size - 2 * static_cast<float>(off) - missing_letter * (whole - size),
                      size / whole};
    const auto [old, first] = best.try_emplace(part.landmark, fit);
    if (!first && fit.letters > old->second.letters) old->second = fit;
  }
  for (const auto& [landmark, fit] : best)
    if (fit.letters > 0) found.push_back(fit);
  std::stable_sort(found.begin(), found.end(),
                   [](const NameFit& a, const NameFit& b) { return a.letters > b.letters; });
  while (found.size() > 1 && found.back().letters < found.front().letters - most_behind) found.pop_back();
  return found;
}

std::vector<Mention> MentionFinder::find(const std::vector<std::string>& tokens) {
  const std::size_t n = tokens.size();
  struct Segment {
    float letters = 0;
    std::size_t words = 0;  // of the stretch that ends here; 0: the word is no part of a name
  };
  std::vector<Segment> steps(n + 1);
  std::vector<std::string> letters(n);
  for (std::size_t i = 0; i < n; ++i) letters[i] = letters_of(tokens[i]);
  for (std::size_t end = 1; end <= n; ++end) {
    steps[end] = {steps[end - 1].letters, 0};
    if (letters[end - 1].empty()) continue;
    std::string stretch;
    bool common = true;
    for (std::size_t begin = end; begin-- > 0 && end - begin <= most_words_;) {
      stretch.insert(0, letters[begin]);
      common = common && common_.contains(letters[begin]);
      if (letters[begin].empty()) continue;
      const auto& found = fits(stretch, common);
      if (found.empty()) continue;
      const float sum = steps[begin].letters + found.front().letters - one_more;
      if (sum > steps[end].letters) steps[end] = {sum, end - begin};
    }
  }
  std::vector<Mention> mentions;
  for (std::size_t end = n; end > 0;) {
    const std::size_t words = steps[end].words;
    if (words > 0) {
      std::string stretch;
      bool common = true;
      for (std::size_t i = end - words; i < end; ++i) {
        stretch += letters[i];
        common = common && common_.contains(letters[i]);
      }
      mentions.push_back({end - words, end, fits(stretch, common)});
    }
    end -= std::max<std::size_t>(words, 1);
  }
  std::reverse(mentions.begin(), mentions.end());
  return mentions;
}

}  // namespace waymark::streets
