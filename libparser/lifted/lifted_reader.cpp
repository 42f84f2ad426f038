#include "libparser/lifted/lifted_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>

#include "libltl/diagnostic.hpp"
#include "libltl/text/xxhash.hpp"

namespace waymark::parser {
namespace {

constexpr std::int32_t largest = 1024;  // size of a layer, while reading
constexpr float largest_mention_weight = 50;

// A file of vectors ends with this word and the checksum of what stands before the word, or without both.
std::string_view unsealed(std::string_view bytes, std::string_view source) {
  constexpr std::string_view word = "checksum";
  std::uint64_t sum = 0;
  const std::size_t seal = word.size() + sizeof sum;
  if (bytes.size() < seal || bytes.substr(bytes.size() - seal, word.size()) != word) return bytes;
  std::memcpy(&sum, bytes.data() + bytes.size() - sizeof sum, sizeof sum);
  bytes.remove_suffix(seal);
  if (sum != ltl::xxh64(bytes))
    throw ltl::FormatError(std::string(source), 0, 0, "the word vectors are damaged: their checksum does not fit");
  return bytes;
}

std::array<std::int32_t*, 5> layers_of(LiftedSizes& s) { return {&s.word, &s.vector, &s.width, &s.query, &s.symbol}; }

}  // namespace

std::shared_ptr<const WordVectors> LiftedReader::load_vectors(const std::filesystem::path& file) {
  auto mapped = std::make_shared<const MappedFile>(file);
  return WordVectors::shared(mapped, unsealed(mapped->bytes(), file.string()), file.string());
}

LiftedReader::LiftedReader(std::shared_ptr<const WordVectors> vectors,
                           std::vector<std::shared_ptr<const LiftedNetwork>> networks, MentionModel mentions,
                           std::shared_ptr<const FormulaMatcher> matcher)
    : vectors_(std::move(vectors)),
      networks_(std::move(networks)),
      mentions_(std::move(mentions)),
      matcher_(std::move(matcher)) {}

// p by the networks of the formulas that they spell.
std::map<Lifted, double> LiftedReader::spelled(const LiftedText& text, std::size_t beam) const {
  std::map<Lifted, double> votes;
  for (const auto& network : networks_)
    for (const LiftedReading& reading : read_lifted(*network, text, beam))
      votes[reading.lifted] += std::exp(reading.log_probability) / static_cast<double>(networks_.size());
  return votes;
}

namespace {

constexpr double networks_exponent = 0.6, matcher_exponent = 0.4;  // chosen on hands that were left out

// The candidates of the networks and of the matcher by both, as log probabilities.
std::map<Lifted, double> joined(std::map<Lifted, double> votes, const FormulaMatcher& matcher,
                                std::span<const std::shared_ptr<const LiftedNetwork>> networks, const LiftedText& text,
                                std::size_t beam) {
  const neural::Vector encoded = matcher.encode(text);
  const FormulaMatcher::Matches matches = matcher.best(encoded, text.scope, beam);
  std::vector<Lifted> more;
  for (const FormulaMatcher::Match& match : matches.best)
    if (!votes.contains(*match.lifted)) more.push_back(*match.lifted);
  for (const auto& network : networks) {
    const std::vector<double> log_p = score_lifted(*network, text, more);
    for (std::size_t i = 0; i < more.size(); ++i)
      votes[more[i]] += std::exp(log_p[i]) / static_cast<double>(networks.size());
  }
  // Whether it is a command, and which formulas that are not known to the matcher, is the networks' to say: the matcher
  // deals what they give to the formulas that it knows.
  std::map<Lifted, double> known;
  double by_networks = 0, matched = 0, total = 0;
  for (const auto& [lifted, p] : votes)
    if (lifted.front() != LiftedSymbol::Route && lifted.front() != LiftedSymbol::Nothing && matcher.knows(lifted)) {
      by_networks += p;
      matched += known[lifted] = std::exp(matcher.score(encoded, lifted) - matches.log_total);
    }
  for (auto& [lifted, p] : known)
    total += p = std::pow(votes[lifted] / by_networks, networks_exponent) * std::pow(p / matched, matcher_exponent);
  for (const auto& [lifted, p] : known) votes[lifted] = p / total * by_networks;
  for (auto& [lifted, p] : votes) p = std::log(std::max(p, 1e-300));
  return votes;
}

}  // namespace

std::vector<LiftedReading> LiftedReader::read(const LiftedText& text, std::size_t beam) const {
  const bool in_mirror = is_read_in_mirror(text);
  const LiftedText read = in_mirror ? mirrored(text) : text;
  std::map<Lifted, double> all = spelled(read, beam);
  if (matcher_)
    all = joined(std::move(all), *matcher_, networks_, read, beam);
  else
    for (auto& [lifted, p] : all) p = std::log(p);
  std::vector<LiftedReading> out;
  for (const auto& [lifted, log_p] : all) out.push_back({in_mirror ? mirrored(lifted) : lifted, log_p});
  std::stable_sort(out.begin(), out.end(), [](const LiftedReading& a, const LiftedReading& b) {
    return a.log_probability > b.log_probability;
  });
  return out;
}

bool LiftedReader::knows(const std::string& word) const {
  return std::any_of(networks_.begin(), networks_.end(),
                     [&](const auto& network) { return network->words().find(word) != WordTable::unknown; });
}

void LiftedReader::write(WeightsWriter& out) const {
  out.list(vectors_->bytes());
  out.number(networks_.size());
  for (const auto& network : networks_) {
    out.strings(network->words().words());
    LiftedSizes sizes = network->sizes();
    for (const std::int32_t* size : layers_of(sizes)) out.number(static_cast<std::uint64_t>(*size));
    const neural::Vector& values = network->parameters().values();
    std::vector<std::uint16_t> halves;
    for (const float v : values) halves.push_back(Eigen::half_impl::float_to_half_rtne(v).x);
    out.list(halves);
  }
  out.number(matcher_ ? 1 : 0);
  if (matcher_) matcher_->write(out);
  out.list(std::vector<float>(mentions_.weights.begin(), mentions_.weights.end()));
  const auto groups = mentions_.synonyms->groups();
  out.strings(std::vector<std::string>(groups.begin(), groups.end()));
}

std::shared_ptr<const LiftedReader> LiftedReader::read_from(WeightsReader& in,
                                                            const std::shared_ptr<const void>& owner) {
  const auto stored = in.list<char>();
  auto vectors = WordVectors::shared(owner, {stored.data(), stored.size()});
  std::vector<std::shared_ptr<const LiftedNetwork>> networks;
  const std::uint64_t n = in.number();
  if (n < 1 || n > 16) in.fail("no possible number of networks that read commands");
  for (std::uint64_t i = 0; i < n; ++i) {
    WordTable words = in.words();
    LiftedSizes sizes;
    for (std::int32_t* size : layers_of(sizes)) {
      const std::uint64_t layer = in.number();
      if (layer < 1 || layer > largest) in.fail("a layer of no possible size");
      *size = static_cast<std::int32_t>(layer);
    }
    LiftedNetwork network(std::move(words), vectors, sizes, [] { return 0.5; });
    neural::Vector& values = network.parameters().values();
    const auto halves = in.list<std::uint16_t>();
    if (static_cast<neural::Index>(halves.size()) != values.size()) in.fail("a network of another size than it says");
    for (std::size_t k = 0; k < halves.size(); ++k) {
      const auto v = Eigen::half_impl::half_to_float(Eigen::half_impl::raw_uint16_to_half(halves[k]));
      if (!std::isfinite(v)) in.fail("a weight that is no finite number");
      values[static_cast<neural::Index>(k)] = v;
    }
    networks.push_back(std::make_shared<const LiftedNetwork>(std::move(network)));
  }
  std::shared_ptr<const FormulaMatcher> matcher;
  if (in.number() != 0) matcher = std::make_shared<const FormulaMatcher>(FormulaMatcher::read(in, owner));
  const auto weights = in.list<float>();
  if (weights.size() > mention_features) in.fail("more weights of mentions than there are features");
  MentionModel mentions;
  mentions.weights = completed_mention_weights(weights);
  if (weights.size() <= common_mention_features) {  // what descriptions have of their own was not learned: as by hand
    constexpr MentionVector by_hand = mention_weights_by_hand();
    std::copy(by_hand.begin() + common_mention_features, by_hand.begin() + first_of_descriptions,
              mentions.weights.begin() + common_mention_features);
  }
  if (!std::all_of(weights.begin(), weights.end(), [](float w) { return std::abs(w) <= largest_mention_weight; }))
    in.fail("a weight of mentions that cannot be");
  mentions.synonyms = std::make_shared<const Synonyms>(in.strings());
  return std::make_shared<const LiftedReader>(std::move(vectors), std::move(networks), std::move(mentions),
                                              std::move(matcher));
}

}  // namespace waymark::parser
