#include "libparser/experiment/action_network.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "libltl/structure/random.hpp"
#include "libneural/adam.hpp"
#include "libparser/corpus/token.hpp"
#include "libparser/model/sentence_encoder.hpp"
#include "libparser/training/training_instance.hpp"

namespace waymark::parser {
namespace {

using neural::Index;
using neural::Matrix;

constexpr Index actions = 3, stop = 3, symbols = 4, none = 4;
constexpr std::size_t most_actions = 40, places = 10;  // of a route; of the beam

// A choice: the latest actions, and where it is made.
struct Moment {
  std::vector<Index> history;  // the latest first
  Arrival pose;                // without the action that led there
};

class ActionNetwork {
 public:
  ActionNetwork(const NetworkOptions& o, WordTable words, std::size_t propositions, const neural::Uniform& uniform)
      : options_(o),
        words_(std::move(words)),
        phi_(parameters.add_for_relu(o.symbol, symbols + 1, 60, uniform)),
        seen_(parameters.add_for_relu(o.symbol, static_cast<Index>(propositions), 60, uniform)),
        encoder_(parameters, words_.words().size(), o.word, o.width, uniform),
        decoder_(parameters,
                 {.encoded = Index{2} * o.width,
                  .inputs = (o.history + Index{1}) * o.symbol,
                  .width = o.query,
                  .symbol = o.symbol,
                  .symbols = symbols},
                 phi_, uniform) {}

  neural::Parameters parameters;
  const NetworkOptions& options() const { return options_; }

  SentenceEncoder::Words words_of(const SentenceInput& input) const {
    SentenceEncoder::Words out{input.heading_unknown ? WordTable::end : WordTable::begin};
    for (const std::string& word : input.tokens) out.push_back(words_.find(word));
    return out;
  }
  Moment first(plan::PoseId start) const {
    return {std::vector<Index>(static_cast<std::size_t>(options_.history), none), Arrival::start(start)};
  }

  struct Seen {  // what holds where a choice is made
    const Executor* executor;
    std::span<const std::uint16_t> images;  // of propositions
  };
  struct Pass {
    SentenceEncoder::Pass encoder;
    neural::AttentionDecoder::Signals decoder;
    std::vector<Index> begin, said;
    Matrix x, dx;
    std::vector<std::vector<Index>> rows;  // by choice: columns of seen_
  };

  void encode(Pass& pass, std::span<const SentenceEncoder::Words* const> sentences, const Dropout& dropout) const {
    pass.encoder.forward(encoder_, parameters, sentences, dropout);
  }

  // seen: by sentence.
  const Matrix& decode(Pass& pass, std::span<const Moment> moments, std::span<const Seen> seen) const {
    const Index size = options_.symbol;
    pass.x.setZero((options_.history + 1) * size, static_cast<Index>(moments.size()));
    pass.rows.assign(moments.size(), {});
    pass.said.resize(moments.size());
    std::iota(pass.said.begin(), pass.said.end(), Index{0});
    std::size_t sentence = 0;
    for (std::size_t c = 0; c < moments.size(); ++c) {
      while (static_cast<Index>(c) >= pass.begin[sentence + 1]) ++sentence;
      auto column = pass.x.col(static_cast<Index>(c));
      for (Index k = 0; k < options_.history; ++k)
        column.segment(k * size, size) = parameters.value(phi_).col(moments[c].history[static_cast<std::size_t>(k)]);
      for (std::size_t p = 0; p < seen[sentence].images.size(); ++p)
        if (seen[sentence].executor->holds(static_cast<std::uint16_t>(p), moments[c].pose))
          pass.rows[c].push_back(seen[sentence].images[p]);
      for (Index p : pass.rows[c]) column.tail(size) += parameters.value(seen_).col(p);
    }
    decoder_.forward(parameters, pass.encoder.sequences(pass.begin, pass.said, nullptr), pass.x, pass.decoder);
    return pass.decoder.scores;
  }

  void backward(Pass& pass, std::span<const Moment> moments, const Matrix& dscores) {
    const Index size = options_.symbol;
    pass.decoder.dscores = dscores;
    pass.dx.resize(pass.x.rows(), pass.x.cols());
    decoder_.backward(parameters, pass.encoder.sequences(pass.begin, pass.said, nullptr), pass.x, pass.decoder,
                      pass.dx);
    for (std::size_t c = 0; c < moments.size(); ++c) {
      const auto column = pass.dx.col(static_cast<Index>(c));
      for (Index k = 0; k < options_.history; ++k)
        parameters.gradient(phi_).col(moments[c].history[static_cast<std::size_t>(k)]) +=
            column.segment(k * size, size);
      for (Index p : pass.rows[c]) parameters.gradient(seen_).col(p) += column.tail(size);
    }
    pass.encoder.backward(parameters, pass.decoder.dh, pass.decoder.de);
  }

 private:
  NetworkOptions options_;
  WordTable words_;
  neural::Block phi_, seen_;
  SentenceEncoder encoder_;
  neural::AttentionDecoder decoder_;
};

// log p of the four symbols; −∞ for FORWARD into a wall.
std::array<float, symbols> log_probabilities(const Matrix& scores, Index column, const plan::Map& map,
                                             Arrival arrival) {
  std::array<float, symbols> out{};
  float highest = -INFINITY, total = 0;
  for (Index v = 0; v < symbols; ++v) {
    const bool possible = v == stop || map.successor(arrival.pose(), static_cast<plan::Action>(v)).has_value();
    out[static_cast<std::size_t>(v)] = possible ? scores(v, column) : -INFINITY;
    highest = std::max(highest, out[static_cast<std::size_t>(v)]);
  }
  for (float x : out) total += std::exp(x - highest);
  for (float& x : out) x -= highest + std::log(total);
  return out;
}

Moment after(const Moment& moment, Index action, const plan::Map& map) {
  Moment next = moment;
  std::copy_backward(next.history.begin(), next.history.end() - 1, next.history.end());
  next.history.front() = action;
  next.pose = Arrival::start(*map.successor(moment.pose.pose(), static_cast<plan::Action>(action)));
  return next;
}

class ActionFollower : public Follower {
 public:
  explicit ActionFollower(ActionNetwork network) : network_(std::move(network)) {}
  bool reads_formulas() const override { return false; }

  Response follow(const Executor& executor, const SentenceInput& input, plan::PoseId start) const override {
    struct Route {
      Moment moment;
      std::vector<plan::Action> actions;
      float log_p = 0;
    };
    const plan::Map& map = executor.map();
    const SentenceEncoder::Words words = network_.words_of(input);
    const SentenceEncoder::Words* const only = &words;
    std::vector<std::uint16_t> images(executor.propositions());
    std::iota(images.begin(), images.end(), std::uint16_t{0});
    const ActionNetwork::Seen seen{&executor, images};
    ActionNetwork::Pass pass;
    network_.encode(pass, {&only, 1}, {});
    std::vector<Route> beam{{network_.first(start), {}, 0.0F}};
    Route best{beam.front().moment, {}, -INFINITY};  // that has stopped
    for (std::size_t length = 0; length <= most_actions && !beam.empty(); ++length) {
      std::vector<Moment> moments;
      for (const Route& route : beam) moments.push_back(route.moment);
      pass.begin = {0, static_cast<Index>(moments.size())};
      const Matrix& scores = network_.decode(pass, moments, {&seen, 1});
      std::vector<Route> next;
      for (std::size_t i = 0; i < beam.size(); ++i) {
        const auto log_p = log_probabilities(scores, static_cast<Index>(i), map, beam[i].moment.pose);
        if (const float whole = beam[i].log_p + log_p[stop]; whole > best.log_p) {
          best = beam[i];
          best.log_p = whole;
        }
        for (Index a = 0; a < actions; ++a) {
          const float sum = beam[i].log_p + log_p[static_cast<std::size_t>(a)];
          if (!(sum > best.log_p)) continue;
          Route longer{after(beam[i].moment, a, map), beam[i].actions, sum};
          longer.actions.push_back(static_cast<plan::Action>(a));
          next.push_back(std::move(longer));
        }
      }
      std::stable_sort(next.begin(), next.end(), [](const Route& a, const Route& b) { return a.log_p > b.log_p; });
      if (next.size() > places) next.resize(places);
      beam = std::move(next);
    }
    return {best.moment.pose.pose(), best.actions, {}, std::exp(static_cast<double>(best.log_p))};
  }

 private:
  ActionNetwork network_;
};

// A sentence, or its mirror image, with the choices of its gold route.
struct TrainingInstance {
  const Executor* executor;
  SentenceEncoder::Words words;
  std::vector<Moment> moments;
  std::vector<Index> answers;
  bool mirrored;
};

class Learner {
 public:
  Learner(std::span<const Example* const> examples, std::span<const Executor> executors, const TrainOptions& options,
          const JobProgress& progress)
      : options_(options),
        how_(options.network),
        progress_(progress),
        random_(options.seed),
        images_(mirror_images(executors.front().map().vocabulary())),
        identity_(images_.size()),
        network_(how_.sizes, words_met_twice(examples), images_.size(), [this] { return random_.unit(); }),
        adam_(network_.parameters, {.rate = how_.rate}) {
    std::iota(identity_.begin(), identity_.end(), std::uint16_t{0});
    for (const Example* example : examples) {
      add_instance(*example, executors[example->map], false);
      if (options.mirrored) add_instance(*example, executors[example->map], true);
    }
  }

  std::shared_ptr<const Follower> run() {
    const auto n = static_cast<double>(instances_.size());
    each_batch(
        instances_.size(), how_.batch, how_.epochs, options_.stop,
        [&](std::size_t bound) { return random_.below(bound); },
        [&](std::span<const std::size_t> instances, int epoch, std::size_t begin) {
          const double done = (epoch + static_cast<double>(begin) / n) / how_.epochs;
          progress_(done);
          step(instances, done);
        });
    return std::make_shared<const ActionFollower>(std::move(network_));
  }

 private:
  void add_instance(const Example& example, const Executor& executor, bool mirrored) {
    SentenceInput input = example.input;
    if (mirrored) input.tokens = mirror(input.tokens);
    TrainingInstance instance{&executor, network_.words_of(input), {network_.first(example.gold.start)}, {}, mirrored};
    for (const plan::Action action : example.gold.actions) {
      Index said = static_cast<Index>(action);
      if (mirrored && action != plan::Action::Forward)
        said = static_cast<Index>(action == plan::Action::Left ? plan::Action::Right : plan::Action::Left);
      instance.answers.push_back(said);
      Moment next = after(instance.moments.back(), static_cast<Index>(action), executor.map());
      next.history.front() = said;
      instance.moments.push_back(std::move(next));
    }
    instance.answers.push_back(stop);
    instances_.push_back(std::move(instance));
  }

  void step(std::span<const std::size_t> which, double done) {
    std::vector<const SentenceEncoder::Words*> words;
    std::vector<Moment> moments;
    std::vector<ActionNetwork::Seen> seen;
    pass_.begin = {0};
    for (std::size_t i : which) {
      const TrainingInstance& instance = instances_[i];
      words.push_back(&instance.words);
      moments.insert(moments.end(), instance.moments.begin(), instance.moments.end());
      seen.push_back({instance.executor, instance.mirrored ? images_ : identity_});
      pass_.begin.push_back(static_cast<Index>(moments.size()));
    }
    network_.encode(pass_, words, {how_.dropout, how_.word_dropout, [&] { return random_.unit(); }});
    Matrix dscores = network_.decode(pass_, moments, seen);
    Index column = 0;
    for (std::size_t i : which)
      for (const Index answer : instances_[i].answers) {  // softmax less the answer: walls are learned from being seen
        auto scores = dscores.col(column++).array();
        scores = (scores - scores.maxCoeff()).exp();
        scores /= scores.sum();
        scores(answer) -= 1;
      }
    dscores /= static_cast<float>(which.size());
    network_.backward(pass_, moments, dscores);
    neural::clip_gradients(network_.parameters, how_.clip);
    adam_.set_rate(how_.rate * (1 - done));
    adam_.step(network_.parameters);
  }

  const TrainOptions& options_;
  const NetworkTraining& how_;
  const JobProgress& progress_;
  ltl::Random random_;
  std::vector<std::uint16_t> images_, identity_;
  ActionNetwork network_;
  neural::Adam adam_;
  ActionNetwork::Pass pass_;
  std::vector<TrainingInstance> instances_;
};

}  // namespace

std::shared_ptr<const Follower> learn_actions(std::span<const Example* const> examples,
                                              std::span<const Executor> executors, const TrainOptions& options,
                                              const JobProgress& progress) {
  return Learner(examples, executors, options, progress).run();
}

}  // namespace waymark::parser
