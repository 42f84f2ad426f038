#include "libparser/model_file.hpp"

#include <array>
#include <memory>
#include <utility>

#include "libparser/model/weights_bytes.hpp"

namespace waymark::parser {
namespace {

constexpr std::int32_t largest = 4096;  // size of a layer, while reading

std::array<std::int32_t*, 5> sizes_of(NetworkOptions& options) {
  return {&options.word, &options.width, &options.query, &options.symbol, &options.history};
}

// The greatest of its layers alone.
std::size_t least_weights(const NetworkOptions& options, std::size_t words) {
  const auto size = [](std::int32_t n) { return static_cast<std::size_t>(n); };
  return size(options.word) * (words + 8 * size(options.width)) +
         8 * size(options.width) * size(options.width) +
         size(options.query) * (size(options.history) * size(options.symbol) + 4 * size(options.width)) +
         size(options.symbol) * (size(options.query) + 2 * size(options.width));
}

std::shared_ptr<const LinearModel> read_linear(WeightsReader& in, const RankingModel& ranking) {
  auto model = std::make_shared<LinearModel>(ranking.language);
  model->words = ranking.words;
  model->weights = in.table(model->weights.columns());
  return model;
}

std::shared_ptr<const NetworkModel> read_network(WeightsReader& in, const ProgramLanguage& language) {
  WordTable words = in.words();
  NetworkOptions options;
  for (std::int32_t* size : sizes_of(options)) {
    const std::uint64_t stored = in.number();
    if (stored < 1 || stored > largest) in.fail("a layer of no possible size");
    *size = static_cast<std::int32_t>(stored);
  }
  if (least_weights(options, words.words().size()) > in.left() / 4)  // before room is made for them
    in.fail("the model file promises more than it holds");
  options.lexicon = in.number() != 0;
  EncoderDecoder network(TypedPostfix(language), std::move(words), options, [] { return 0.5; });
  neural::Vector& values = network.parameters().values();
  in.floats({values.data(), static_cast<std::size_t>(values.size())});
  return std::make_shared<const NetworkModel>(std::move(network));
}

Grounder read_grounder(WeightsReader& in) {
  auto ranking = std::make_shared<RankingModel>(in.vocabulary(), in.header().dialect);
  ranking->words = in.words();
  WordModel word_model = in.header().kind == ModelHeader::Linear
                             ? WordModel(read_linear(in, *ranking))
                             : WordModel(read_network(in, ranking->language));
  ranking->reranker = in.table(1);
  ranking->start_pose_model = in.table(1);
  in.end();
  return {std::move(word_model), std::move(ranking)};
}

constexpr ModelHeader::Kind kind_of(const LinearModel&) { return ModelHeader::Linear; }
constexpr ModelHeader::Kind kind_of(const NetworkModel&) { return ModelHeader::EncoderDecoder; }

void write(WeightsWriter& out, const LinearModel& model, double threshold) {
  out.table(model.weights, threshold);
}

void write(WeightsWriter& out, const NetworkModel& model, double) {
  out.strings(model.network.words().words());
  NetworkOptions options = model.network.options();
  for (const std::int32_t* size : sizes_of(options)) out.number(static_cast<std::uint64_t>(*size));
  out.number(options.lexicon ? 1 : 0);
  const neural::Vector& values = model.network.parameters().values();
  out.list(std::span<const float>(values.data(), static_cast<std::size_t>(values.size())));
}

}  // namespace

std::string serialize(const Grounder& grounder, double threshold) {
  const RankingModel& ranking = *grounder.ranking;
  return std::visit(
      [&](const auto& word_model) {
        WeightsWriter out({kind_of(*word_model), ranking.language.dialect()});
        out.strings(ranking.language.vocabulary().names());
        out.strings(ranking.words.words());
        write(out, *word_model, threshold);
        out.table(ranking.reranker, least_of_rerankers * threshold);
        out.table(ranking.start_pose_model, least_of_rerankers * threshold);
        return out.finish();
      },
      grounder.word_model);
}

std::string serialize_within(const Grounder& grounder, std::size_t bytes) {
  double threshold = least_weight;
  std::string out = serialize(grounder, threshold);
  while (out.size() > bytes && threshold < 65'504) out = serialize(grounder, threshold *= 1.25);
  return out;
}

Grounder parse_grounder(std::string_view bytes, std::string_view source) {
  WeightsReader in(std::make_shared<const MappedFile>(bytes), source);
  return read_grounder(in);
}

Grounder load_grounder(const std::filesystem::path& file) {
  const std::string source = file.string();
  WeightsReader in(std::make_shared<const MappedFile>(file), source);
  return read_grounder(in);
}

void save(const Grounder& grounder, const std::filesystem::path& file) {
  write_weights(serialize_within(grounder, most_bytes), file.string());
}

}  // namespace waymark::parser
