#include "libparser/lifted/learn_lifted.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>

#include "libltl/parallel.hpp"
#include "libltl/structure/random.hpp"
#include "libneural/adam.hpp"

namespace waymark::parser {
namespace {

using neural::Index;

// Slots, domains, and the words of two examples or more that are understood: what else a text says is unknown.
WordTable words_of(std::span<const LiftedExample> examples) {
  WordTable table;
  for (std::size_t n = 1; n <= 12; ++n) table.add(name(slot(n)));
  std::map<std::string, std::size_t> met;
  for (const LiftedExample& example : examples) {
    const bool is_understood = example.lifted.front() != LiftedSymbol::Nothing;
    if (is_understood)
      for (const std::string& token : example.text.tokens) ++met[token];
    met["<" + example.text.domain + ">"] += 2;
  }
  for (const auto& [word, times] : met)
    if (times >= 2) table.add(word);
  return table;
}

bool is_mark(const std::string& token) {
  return token.size() == 1 && std::string_view(",.;:!?").find(token[0]) != std::string_view::npos;
}

// The same text without the commas after its slots; if it has none, with one after each slot that a word follows. A
// comma before another slot separates the places of a list and stays.
LiftedText with_other_commas(const LiftedText& text) {
  const auto is_slot = [](const std::string& token) { return token.size() > 1 && token[0] == '#'; };
  const std::vector<std::string>& tokens = text.tokens;
  LiftedText without = text, with = text;
  without.tokens.clear();
  with.tokens.clear();
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const bool is_between = i > 0 && i + 1 < tokens.size() && is_slot(tokens[i - 1]) && !is_slot(tokens[i + 1]);
    if (tokens[i] != "," || !is_between) without.tokens.push_back(tokens[i]);
    with.tokens.push_back(tokens[i]);
    const bool before_word = i + 1 < tokens.size() && !is_slot(tokens[i + 1]) && !is_mark(tokens[i + 1]);
    if (is_slot(tokens[i]) && before_word) with.tokens.emplace_back(",");
  }
  return without.tokens.size() < tokens.size() ? without : with;
}

class Learner {
 public:
  Learner(std::vector<LiftedExample> examples, std::shared_ptr<const WordVectors> vectors,
          const LiftedTraining& options)
      : examples_(std::move(examples)),
        options_(options),
        random_(options.seed),
        network_(words_of(examples_), std::move(vectors), options.sizes, [this] { return random_.unit(); }),
        adam_(network_.parameters(), {.rate = options.rate}) {
    double total = 0;
    for (const LiftedExample& example : examples_) {
      sentences_.push_back(network_.sentence(example.text));
      other_commas_.push_back(network_.sentence(with_other_commas(example.text)));
      total += example.weight;
      up_to_.push_back(total);
    }
    for (std::size_t s = 0; s < shards; ++s) shards_.emplace_back(network_, options.seed + 1000 * (s + 1));
  }

  std::shared_ptr<const LiftedNetwork> run(const std::function<void(double)>& progress) {
    const std::size_t steps =
        static_cast<std::size_t>(options_.epochs) * ((examples_.size() + options_.batch - 1) / options_.batch);
    for (std::size_t i = 0; i < steps; ++i) {
      const double done = static_cast<double>(i) / static_cast<double>(steps);
      step(done);
      if (progress && i % 64 == 0) progress(done);
    }
    return std::make_shared<const LiftedNetwork>(std::move(network_));
  }

 private:
  static constexpr std::size_t shards = 2;
  struct Shard {
    Shard(const LiftedNetwork& network, std::uint64_t seed) : parameters(network.parameters()), random(seed) {}
    neural::Parameters parameters;
    ltl::Random random;
    LiftedNetwork::Pass pass;
  };

  std::size_t draw() {
    const auto at = std::upper_bound(up_to_.begin(), up_to_.end(), random_.unit() * up_to_.back());
    return std::min(static_cast<std::size_t>(at - up_to_.begin()), examples_.size() - 1);
  }

  void step(double done) {
    std::vector<std::size_t> batch(options_.batch);
    for (std::size_t& i : batch) i = draw();
    neural::Parameters& parameters = network_.parameters();
    for (Shard& shard : shards_) {
      shard.parameters.values() = parameters.values();
      shard.parameters.gradients().setZero();
    }
    ltl::parallel_for(shards, options_.threads, [&](std::size_t s, std::size_t) {
      std::vector<std::size_t> own;
      for (std::size_t i = s; i < batch.size(); i += shards) own.push_back(batch[i]);
      learn(shards_[s], own);
    });
    for (const Shard& shard : shards_) parameters.gradients() += shard.parameters.gradients();
    parameters.gradients() /= static_cast<float>(batch.size());
    neural::clip_gradients(parameters, options_.clip);
    adam_.set_rate(options_.rate * (1 - done));
    adam_.step(parameters);
  }

  void learn(Shard& shard, std::span<const std::size_t> batch) const {
    std::vector<const LiftedNetwork::Sentence*> sentences;
    for (const std::size_t i : batch)
      sentences.push_back(shard.random.chance(options_.other_commas) ? &other_commas_[i] : &sentences_[i]);
    shard.pass.encode(network_, shard.parameters, sentences,
                      {options_.dropout, options_.word_dropout, [&] { return shard.random.unit(); }});
    std::vector<LiftedNetwork::Prefix> prefixes;
    std::vector<Index> begin{0};
    for (const std::size_t i : batch) {
      LiftedNetwork::Prefix prefix;
      for (const LiftedSymbol s : examples_[i].lifted) {
        prefixes.push_back(prefix);
        prefix = prefix.after(s);
      }
      begin.push_back(static_cast<Index>(prefixes.size()));
    }
    const neural::Matrix& scores = shard.pass.decode(begin, prefixes);
    neural::Matrix dscores = neural::Matrix::Zero(scores.rows(), scores.cols());
    std::array<float, lifted_symbols> log_p;
    Index column = 0;
    for (const std::size_t i : batch)
      for (const LiftedSymbol said : examples_[i].lifted) {
        log_softmax(scores, column, prefixes[static_cast<std::size_t>(column)].grammar, examples_[i].text.scope, log_p);
        for (std::size_t v = 0; v < lifted_symbols; ++v)
          if (log_p[v] > -INFINITY) dscores(static_cast<Index>(v), column) = std::exp(log_p[v]);
        dscores(static_cast<Index>(said), column++) -= 1;
      }
    shard.pass.backward(shard.parameters, dscores);
  }

  std::vector<LiftedExample> examples_;
  const LiftedTraining& options_;
  ltl::Random random_;
  LiftedNetwork network_;
  neural::Adam adam_;
  std::vector<LiftedNetwork::Sentence> sentences_, other_commas_;
  std::vector<double> up_to_;
  std::vector<Shard> shards_;
};

}  // namespace

std::vector<LiftedExample> upright(std::span<const LiftedExample> examples) {
  std::vector<LiftedExample> out(examples.begin(), examples.end());
  for (LiftedExample& example : out)
    if (is_read_in_mirror(example.text))
      example = {mirrored(std::move(example.text)), mirrored(std::move(example.lifted)), example.weight};
  return out;
}

std::shared_ptr<const LiftedNetwork> learn_lifted(std::span<const LiftedExample> examples,
                                                  std::shared_ptr<const WordVectors> vectors,
                                                  const LiftedTraining& options,
                                                  const std::function<void(double)>& progress) {
  return Learner(upright(examples), std::move(vectors), options).run(progress);
}

}  // namespace waymark::parser
