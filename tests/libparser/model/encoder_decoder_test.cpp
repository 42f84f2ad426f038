// The whole encoder-decoder, from embeddings to objectives, against its definition in double precision, number by
// number.
#include "libparser/model/encoder_decoder.hpp"

#include <numeric>

#include "libneural/packing.hpp"
#include "libparser/decode/network_trie.hpp"
#include "libparser/training/objective.hpp"
#include "tests/libneural/reference.hpp"
#include "tests/libparser/model/small_network.hpp"

namespace waymark::parser {
namespace {

using neural::Index;
using neural::reference::Reader, neural::reference::Real;

// What a pass leaves out of a sentence: 0, or what makes up for it.
struct Masks {
  std::vector<WordId> words;
  Real embedded, h;
};

// Drawn in the order in which a pass draws: words, then embeddings as they are packed, then h sentence by sentence.
std::vector<Masks> masks_of(std::span<const NetworkSentence> sentences, const NetworkOptions& sizes,
                            const Dropout& dropout) {
  std::vector<Masks> out(sentences.size());
  std::vector<std::size_t> order(sentences.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return sentences[a].words.size() > sentences[b].words.size(); });
  const auto draw = [&](Real&& mask) {
    for (double& entry : mask.reshaped()) entry = dropout.uniform() < dropout.signals ? 0 : 1 / (1 - dropout.signals);
    return mask;
  };
  for (std::size_t s = 0; s < out.size(); ++s) {
    out[s].words = sentences[s].words;
    for (std::size_t t = 1; t < out[s].words.size(); ++t)
      if (dropout.uniform() < dropout.words) out[s].words[t] = WordTable::unknown;
    out[s].embedded = Real(sizes.word, static_cast<Index>(out[s].words.size()));
  }
  for (Index t = 0; t < out[order.front()].embedded.cols(); ++t)
    for (const std::size_t s : order)
      if (t < out[s].embedded.cols()) out[s].embedded.col(t) = draw(Real(sizes.word, 1));
  for (Masks& m : out) m.h = draw(Real(2 * sizes.width, m.embedded.cols()));
  return out;
}

class Definition {
 public:
  Definition(const EncoderDecoder& network, const Eigen::VectorXd& theta) : network_(network), theta_(theta) {}

  // Scores of all symbols after a history.
  Real scores(const NetworkSentence& sentence, const Masks& masks, const History& history) const {
    const NetworkOptions& o = network_.options();
    const auto symbols = static_cast<Index>(network_.symbols().symbols());
    Reader read(theta_);
    const Real phi = read.take(o.symbol, symbols + 1),
               table = read.take(o.word, static_cast<Index>(network_.words().words().size()));
    Real x(o.word, masks.embedded.cols());
    for (Index t = 0; t < x.cols(); ++t) x.col(t) = table.col(masks.words[static_cast<std::size_t>(t)].index);
    x = x.cwiseProduct(masks.embedded).eval();
    const Real there = neural::reference::lstm(read, x, o.width),
               back = neural::reference::lstm(read, x.rowwise().reverse(), o.width);
    Real h(2 * o.width, x.cols()), e(2 * o.width, 1), said(o.symbol * o.history, 1), marks = Real::Zero(symbols, 1);
    h << there, back.rowwise().reverse();
    e << there.rightCols(1), back.rightCols(1);
    for (Index k = 0; k < o.history; ++k)
      said.middleRows(k * o.symbol, o.symbol) = phi.col(history[static_cast<std::size_t>(k)]);
    for (const Symbol symbol : sentence.marked) marks(symbol) = 1;
    return neural::reference::attention(read, phi.leftCols(symbols), o.query, h.cwiseProduct(masks.h), e, marks, said);
  }

  // log p of a program: the softmax over what is allowed, symbol by symbol; what is forced costs nothing.
  double log_p(const NetworkSentence& sentence, const Masks& masks, const Program& program) const {
    const TypedPostfix& symbols = network_.symbols();
    TypedState state;
    History history = network_.first_history();
    double out = 0;
    for (const Symbol symbol : symbols.symbols_of(program)) {
      const std::vector<bool> allowed = symbols.allowed(state);
      if (std::count(allowed.begin(), allowed.end(), true) > 1) {
        const Real score = scores(sentence, masks, history);
        double total = 0;
        for (std::size_t v = 0; v < allowed.size(); ++v)
          if (allowed[v] && !sentence.forbidden[v]) total += std::exp(score(static_cast<Index>(v)));
        out += score(symbol) - std::log(total);
      }
      state = symbols.after(state, symbol);
      EncoderDecoder::remember(history, symbol);
    }
    return out;
  }

 private:
  const EncoderDecoder& network_;
  const Eigen::VectorXd& theta_;
};

double objective_of(Objective objective, double beta, std::span<const double> log_p, std::span<const double> rewards) {
  const double power = objective == Objective::Meritocratic ? beta : 1;
  double sum = 0;
  for (std::size_t z = 0; z < log_p.size(); ++z) sum += std::pow(std::exp(log_p[z]) * rewards[z], power);
  return objective == Objective::Reinforce ? sum : std::log(sum) / power;
}

void check(Objective objective, double dropout) {
  constexpr double beta = 0.4;
  SmallNetwork small(11);
  EncoderDecoder& network = small.network;
  std::vector<NetworkSentence> sentences;
  for (const char* text : {"walk left", "walk to the chair and turn left to place 1", "chair"})
    sentences.push_back(network.sentence({tokenize(text), sentences.size() == 1}));
  const double unit = objective == Objective::Reinforce ? 100 : 1;  // p is small: gradients that can be told from zero
  std::vector<std::pair<Program, double>> programs;                 // with rewards
  for (const auto& [program, log_p] : small.all())
    if (programs.size() < 7) programs.emplace_back(program, unit * (0.2 + 0.15 * static_cast<double>(programs.size())));
  ASSERT_EQ(programs.size(), 7U);

  ltl::Random first(5), second(5);
  const Dropout drop{dropout, dropout, [&] { return first.unit(); }};
  ChoiceMasks masks(network.symbols());
  std::vector<NetworkTrie> tries(sentences.size());
  std::vector<const NetworkSentence*> batch;
  std::vector<History> histories;
  std::vector<Index> begin{0};
  for (std::size_t s = 0; s < sentences.size(); ++s) {
    for (const auto& [program, reward] : programs) tries[s].add(NetworkPrefixes(network, masks), program, reward);
    append_histories(tries[s], histories);
    begin.push_back(static_cast<Index>(histories.size()));
    batch.push_back(&sentences[s]);
  }
  EncoderDecoder::Pass pass;
  pass.encode(network, network.parameters(), batch, drop);
  const neural::Matrix& scores = pass.decode(begin, histories);
  neural::Matrix dscores = neural::Matrix::Zero(scores.rows(), scores.cols());
  for (std::size_t s = 0; s < sentences.size(); ++s) {
    const Likelihoods found = likelihoods(tries[s], scores, begin[s], sentences[s].forbidden);
    backpropagate(tries[s], found, objective_gradient(objective, beta, found.log_p, tries[s].log_weights()), dscores,
                  begin[s]);
  }
  network.parameters().gradients().setZero();
  pass.backward(network.parameters(), dscores);

  const auto left_out = masks_of(sentences, network.options(), {dropout, dropout, [&] { return second.unit(); }});
  Eigen::VectorXd theta = network.parameters().values().cast<double>();
  const Definition definition(network, theta);
  std::vector<double> rewards;
  for (const auto& [program, reward] : programs) rewards.push_back(reward);
  const auto loss = [&] {
    double sum = 0;
    for (std::size_t s = 0; s < sentences.size(); ++s) {
      std::vector<double> log_p;
      for (const auto& [program, reward] : programs)
        log_p.push_back(definition.log_p(sentences[s], left_out[s], program));
      sum += objective_of(objective, beta, log_p, rewards);
    }
    return sum;
  };
  neural::reference::check(theta, network.parameters().gradients().data(), loss, "parameters");
  EXPECT_GT(network.parameters().gradients().cwiseAbs().maxCoeff(), 0.02);  // there was something to check
}

TEST(EncoderDecoderGradient, OfMarginalLikelihood) { check(Objective::MarginalLikelihood, 0); }
TEST(EncoderDecoderGradient, OfExpectedReward) { check(Objective::Reinforce, 0); }
TEST(EncoderDecoderGradient, OfTheMeritocraticObjective) { check(Objective::Meritocratic, 0); }
TEST(EncoderDecoderGradient, WhereWordsAndSignalsAreLeftOut) { check(Objective::MarginalLikelihood, 0.3); }

}  // namespace
}  // namespace waymark::parser
