// The reader of lifted texts: its network against the definition in double precision, learning, and its file.
#include "libparser/lifted/lifted_reader.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <sstream>

#include "libltl/diagnostic.hpp"
#include "libparser/lifted/learn_lifted.hpp"
#include "libparser/lifted/learn_matcher.hpp"
#include "libparser/model_file.hpp"
#include "tests/libneural/reference.hpp"
#include "tests/libparser/lifted/few_words.hpp"

namespace waymark::parser {
namespace {

using neural::Index;
using neural::reference::Reader, neural::reference::Real;

LiftedExample example(const std::string& text, const char* lifted, const char* domain = "") {
  LiftedExample out{{{}, {}, domain}, parse_lifted(lifted)};
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    out.text.tokens.push_back(word);
    if (word[0] == '#') out.text.scope.slots = std::max(out.text.scope.slots, static_cast<std::size_t>(word[1] - '0'));
  }
  return out;
}

std::vector<LiftedExample> toys() {
  return {example("go to #1", "eventually #1"),
          example("walk to #1 then to #2", "sequence #1 #2 end"),
          example("never go to #1", "never #1 end"),
          example("walk to #1 and avoid #2", "and eventually #1 never #2 end end", "yard"),
          example("walk to #2 and never #1", "and eventually #2 never #1 end end", "yard"),
          example("go to #1 again and again", "patrol #1 end"),
          example("hello", "nothing")};
}

constexpr LiftedSizes tiny{.word = 3, .vector = 2, .width = 3, .query = 4, .symbol = 3};

LiftedNetwork tiny_network() {
  WordTable table;
  for (const char* word : {"#1", "#2", "<yard>", "go", "to"}) table.add(word);
  ltl::Random random(3);
  LiftedNetwork network(table, few_vectors(), tiny, [&] { return random.unit(); });
  network.parameters().values() *= 2;
  return network;
}

// Scores of all symbols after a prefix, as the header of the network says.
Real scores_of(const LiftedNetwork& network, const WordVectors& vectors, const Eigen::VectorXd& theta,
               const LiftedText& text, std::span<const LiftedSymbol> prefix) {
  Reader read(theta);
  const auto symbols = static_cast<Index>(lifted_symbols);
  const Real table = read.take(tiny.word, static_cast<Index>(network.words().words().size())),
             project = read.take(tiny.vector, WordVectors::dimensions), phi = read.take(tiny.symbol, symbols + 1);
  std::vector<std::string> tokens = text.tokens;
  tokens.insert(tokens.begin(), "<" + text.domain + ">");
  Real x = Real::Zero(tiny.word + tiny.vector, static_cast<Index>(tokens.size()));
  for (Index t = 0; t < x.cols(); ++t) {
    const std::string& token = tokens[static_cast<std::size_t>(t)];
    x.col(t).head(tiny.word) = table.col(network.words().find(token).index);
    const auto row = vectors.find(token);
    for (std::size_t i = 0; row && i < WordVectors::dimensions; ++i)
      x.col(t).tail(tiny.vector) +=
          project.col(static_cast<Index>(i)) * static_cast<double>(vectors.scale(*row)) * vectors.entries(*row)[i];
  }
  const Real there = neural::reference::lstm(read, x, tiny.width),
             back = neural::reference::lstm(read, x.rowwise().reverse(), tiny.width);
  Real h(2 * tiny.width, x.cols()), e(2 * tiny.width, 1);
  h << there, back.rowwise().reverse();
  e << there.rightCols(1), back.rightCols(1);
  LiftedPrefix grammar;
  for (const LiftedSymbol s : prefix) grammar.append(s);
  const auto open = grammar.open();
  Real seen = Real::Zero(5 * tiny.symbol + 20, 1);
  for (std::size_t k = 0; k < 5; ++k) {
    const bool there_is = k < 3 ? k < prefix.size() : k - 3 < open.size();
    const Index which =
        !there_is ? symbols
                  : static_cast<Index>(k < 3 ? prefix[prefix.size() - 1 - k] : open[open.size() - 1 - (k - 3)].symbol);
    seen.middleRows(static_cast<Index>(k) * tiny.symbol, tiny.symbol) = phi.col(which);
  }
  if (!open.empty()) seen(5 * tiny.symbol + std::min<Index>(open.back().operands, 7)) = 1;
  for (const LiftedSymbol s : prefix)
    if (is_slot(s)) seen(5 * tiny.symbol + 8 + static_cast<Index>(number_of(s)) - 1) = 1;
  return neural::reference::attention(read, phi.leftCols(symbols), tiny.query, h, e, Real::Zero(symbols, 1), seen);
}

TEST(LiftedNetworkGradient, IsThatOfTheDefinition) {
  LiftedNetwork network = tiny_network();
  const auto vectors = few_vectors();
  const std::vector<LiftedExample> all = toys();
  const std::vector<LiftedExample> examples{all[1], all[3]};
  std::vector<LiftedNetwork::Sentence> sentences;
  std::vector<const LiftedNetwork::Sentence*> batch;
  for (const LiftedExample& one : examples) sentences.push_back(network.sentence(one.text));
  for (const auto& sentence : sentences) batch.push_back(&sentence);
  std::vector<LiftedNetwork::Prefix> prefixes;
  std::vector<Index> begin{0};
  for (const LiftedExample& one : examples) {
    LiftedNetwork::Prefix prefix;
    for (const LiftedSymbol s : one.lifted) {
      prefixes.push_back(prefix);
      prefix = prefix.after(s);
    }
    begin.push_back(static_cast<Index>(prefixes.size()));
  }
  LiftedNetwork::Pass pass;
  pass.encode(network, network.parameters(), batch);
  neural::Matrix dscores = pass.decode(begin, prefixes);  // of half the sum of squares
  network.parameters().gradients().setZero();
  pass.backward(network.parameters(), dscores);

  Eigen::VectorXd theta = network.parameters().values().cast<double>();
  const auto loss = [&] {
    double sum = 0;
    for (const LiftedExample& one : examples)
      for (std::size_t n = 0; n < one.lifted.size(); ++n)
        sum += scores_of(network, *vectors, theta, one.text, std::span(one.lifted).first(n)).squaredNorm() / 2;
    return sum;
  };
  neural::reference::check(theta, network.parameters().gradients().data(), loss, "parameters");
  EXPECT_GT(network.parameters().gradients().cwiseAbs().maxCoeff(), 0.02);  // there was something to check
}

LiftedTraining toy_training(std::size_t threads) {
  LiftedTraining how;
  how.sizes = {.word = 12, .vector = 8, .width = 16, .query = 16, .symbol = 12};
  how.epochs = 900;
  how.batch = 7;
  how.rate = 1e-2;
  how.dropout = how.word_dropout = 0.05;
  how.threads = threads;
  return how;
}

TEST(LearnLifted, LearnsAToySetWholly) {
  const auto network = learn_lifted(toys(), few_vectors(), toy_training(2));
  for (const LiftedExample& toy : toys()) {
    const auto readings = read_lifted(*network, toy.text, 4);
    ASSERT_FALSE(readings.empty());
    EXPECT_EQ(print(readings.front().lifted), print(toy.lifted));
    double total = 0;
    for (const LiftedReading& reading : readings) total += std::exp(reading.log_probability);
    EXPECT_LE(total, 1 + 1e-5);
  }
}

TEST(LearnLifted, TheNumberOfThreadsChangesNoByte) {
  const auto learn = [](std::size_t threads) {
    LiftedTraining how = toy_training(threads);
    how.epochs = 20;
    return learn_lifted(toys(), few_vectors(), how);
  };
  EXPECT_EQ(learn(1)->parameters().values(), learn(2)->parameters().values());
}

Grounder with_commands() {
  Grounder grounder = grounder_of(LinearModel(ltl::Vocabulary({"chair", "moved"})));
  std::vector<std::shared_ptr<const LiftedNetwork>> networks(2, std::make_shared<const LiftedNetwork>(tiny_network()));
  grounder.commands = std::make_shared<const LiftedReader>(few_vectors(), networks);
  return grounder;
}

TEST(LiftedReaderFile, IsReadAsItWasWritten) {
  const Grounder written = with_commands();
  const std::string bytes = serialize(written);
  const Grounder read = parse_grounder(bytes);
  ASSERT_TRUE(read.commands);
  EXPECT_EQ(serialize(read), bytes);
  ASSERT_EQ(read.commands->networks().size(), 2U);
  EXPECT_TRUE(read.commands->knows("go"));
  EXPECT_FALSE(read.commands->knows("walk"));  // a vector only
  for (const LiftedExample& toy : toys()) {
    const auto before = written.commands->read(toy.text), after = read.commands->read(toy.text);
    ASSERT_FALSE(before.empty());
    ASSERT_EQ(before.size(), after.size());
    EXPECT_EQ(before.front().lifted, after.front().lifted);
    EXPECT_NEAR(before.front().log_probability, after.front().log_probability, 0.02);  // 16-bit floats
  }
  EXPECT_FALSE(parse_grounder(serialize(grounder_of(LinearModel(ltl::Vocabulary({"chair"}))))).commands);
}

TEST(LiftedReaderFile, EveryCutAndEveryFlippedBitIsNoticed) {
  const std::string bytes = serialize(with_commands());
  for (std::size_t n = 0; n < bytes.size(); n += 1 + n / 50)
    EXPECT_THROW(parse_grounder(bytes.substr(0, n)), ltl::FormatError) << n;
  for (std::size_t i = 0; i < bytes.size(); i += 13) {
    std::string altered = bytes;
    altered[i] = static_cast<char>(altered[i] ^ 1 << i % 8);
    EXPECT_THROW(parse_grounder(altered), ltl::FormatError) << i;
  }
}

// What a beam finds has the probability that the formula is given when it is asked for; what is not in scope has none.
TEST(LiftedNetwork, FormulasThatAreAskedForHaveTheProbabilityOfTheBeam) {
  const LiftedNetwork network = tiny_network();
  const LiftedText text = toys()[1].text;
  std::vector<Lifted> formulas;
  const auto readings = read_lifted(network, text, 6);
  ASSERT_FALSE(readings.empty());
  for (const LiftedReading& r : readings) formulas.push_back(r.lifted);
  formulas.push_back(parse_lifted("eventually #3"));
  const std::vector<double> log_p = score_lifted(network, text, formulas);
  for (std::size_t i = 0; i < readings.size(); ++i) EXPECT_NEAR(log_p[i], readings[i].log_probability, 1e-4) << i;
  EXPECT_EQ(log_p.back(), -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(score_lifted(network, text, {}).empty());
}

// What the networks give to formulas that the matcher knows is dealt anew among these, and nothing else changes.
TEST(LiftedReader, DecidesByNetworksAndMatcher) {
  const std::vector<LiftedExample> all = toys();
  MatcherTraining training{.width = 8, .draws = 2000, .batch = 8, .rate = 1e-2, .feature_dropout = 0, .dropout = 0};
  training.least_texts = 1;
  const auto matcher = learn_matcher(all, training);
  const auto network = std::make_shared<const LiftedNetwork>(tiny_network());
  const LiftedReader with(few_vectors(), {network}, {}, matcher), without(few_vectors(), {network});
  const LiftedText text = all[1].text;
  std::map<Lifted, double> before;
  for (const LiftedReading& r : without.read(text)) before[r.lifted] = r.log_probability;
  double by_networks = 0, dealt = 0;
  std::vector<Lifted> known;
  std::vector<double> log_p;
  for (const LiftedReading& r : with.read(text)) {
    if (!matcher->knows(r.lifted) || r.lifted == Lifted{LiftedSymbol::Nothing}) {
      ASSERT_TRUE(before.contains(r.lifted));
      EXPECT_NEAR(r.log_probability, before[r.lifted], 1e-6);
      continue;
    }
    dealt += std::exp(r.log_probability);
    known.push_back(r.lifted);
    log_p.push_back(r.log_probability);
  }
  ASSERT_GE(known.size(), 3U);
  const std::vector<double> networks = score_lifted(*network, text, known);
  const neural::Vector encoded = matcher->encode(text);
  for (const double p : networks) by_networks += std::exp(p);
  EXPECT_NEAR(dealt, by_networks, 1e-5);
  for (std::size_t i = 1; i < known.size(); ++i)
    EXPECT_NEAR(log_p[i] - log_p[0],
                0.6 * (networks[i] - networks[0]) +
                    0.4 * (matcher->score(encoded, known[i]) - matcher->score(encoded, known[0])),
                1e-3)
        << print(known[i]);
}

// What no writer writes, under a checksum that fits.
TEST(LiftedReaderFile, NetworksThatCannotBeAreRefused) {
  const auto message = [](std::uint64_t networks, std::uint64_t layer, std::size_t weights, std::uint16_t weight,
                          std::size_t mentions = mention_features, float mention = 1) {
    WeightsWriter out({.kind = LinearModel::file_kind});
    out.list(bytes_of_vectors({"go", "to"}));
    out.number(networks);
    out.strings(WordTable().words());
    for (int i = 0; i < 5; ++i) out.number(layer);
    out.list(std::vector<std::uint16_t>(weights, weight));
    out.number(0);  // no matcher
    out.list(std::vector<float>(mentions, mention));
    out.strings(std::vector<std::string>{});
    const auto file = std::make_shared<const MappedFile>(std::string_view(out.finish()));
    WeightsReader in(file, "a.waymark");
    try {
      LiftedReader::read_from(in, file);
    } catch (const ltl::FormatError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const LiftedNetwork one(WordTable(), few_vectors(), {1, 1, 1, 1, 1}, [] { return 0.5; });
  const auto size = static_cast<std::size_t>(one.parameters().values().size());
  EXPECT_EQ(message(1, 1, size, 0), "");
  EXPECT_NE(message(0, 1, size, 0).find("number of networks"), std::string::npos);
  EXPECT_NE(message(17, 1, size, 0).find("number of networks"), std::string::npos);
  EXPECT_NE(message(1, 0, size, 0).find("no possible size"), std::string::npos);
  EXPECT_NE(message(1, 1025, size, 0).find("no possible size"), std::string::npos);
  EXPECT_NE(message(1, 1, size + 1, 0).find("another size"), std::string::npos);
  EXPECT_EQ(message(1, 1, size, 0, mention_features - 1), "");
  EXPECT_NE(message(1, 1, size, 0, mention_features + 1).find("more weights"), std::string::npos);
  EXPECT_NE(message(1, 1, size, 0, mention_features, 1e9F).find("cannot be"), std::string::npos);
  EXPECT_NE(message(1, 1, size, 0, mention_features, NAN).find("cannot be"), std::string::npos);
  EXPECT_NE(message(1, 1, size, 0x7C00).find("no finite number"), std::string::npos);
}

}  // namespace
}  // namespace waymark::parser
