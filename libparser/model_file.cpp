#include "libparser/model_file.hpp"

#include <array>
#include <memory>

#include "libparser/decode/network_search.hpp"
#include "libparser/model/weights_bytes.hpp"

namespace waymark::parser {
namespace {

constexpr std::int32_t largest = 4096;  // size of a layer, while reading

WeightsReader opened(std::string_view bytes, std::string_view source) {
  return {std::make_shared<const MappedFile>(bytes), source};
}

LinearModel read_linear(WeightsReader& in) {
  LinearModel model(in.vocabulary(), in.header().dialect);
  model.words = in.words();
  model.reader = in.table(model.reader.columns());
  model.reranker = in.table(1);
  model.start_pose_model = in.table(1);
  in.end();
  return model;
}

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

Grounder read_encoder_decoder(WeightsReader& in) {
  auto model = std::make_shared<LinearModel>(in.vocabulary(), in.header().dialect);
  model->words = in.words();
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
  EncoderDecoder network(TypedPostfix(model->grammar(), model->columns()), std::move(words), options,
                         [] { return 0.5; });
  neural::Vector& values = network.parameters().values();
  in.floats({values.data(), static_cast<std::size_t>(values.size())});
  model->reranker = in.table(1);
  model->start_pose_model = in.table(1);
  in.end();
  return {std::make_shared<const NetworkReader>(std::move(network)), std::move(model)};
}

Grounder read_grounder(WeightsReader& in) {
  return in.header().kind == ModelHeader::Linear ? grounder_of(read_linear(in)) : read_encoder_decoder(in);
}

std::string serialize(const EncoderDecoder& network, const LinearModel& model, double threshold) {
  WeightsWriter out({ModelHeader::EncoderDecoder, model.dialect()});
  out.strings(model.vocabulary().names());
  out.strings(model.words.words());
  out.strings(network.words().words());
  NetworkOptions options = network.options();
  for (const std::int32_t* size : sizes_of(options)) out.number(static_cast<std::uint64_t>(*size));
  out.number(options.lexicon ? 1 : 0);
  const neural::Vector& values = network.parameters().values();
  out.list(std::span<const float>(values.data(), static_cast<std::size_t>(values.size())));
  out.table(model.reranker, least_of_rerankers * threshold);
  out.table(model.start_pose_model, least_of_rerankers * threshold);
  return out.finish();
}

// Fewer of the small weights until the file fits.
template <class Serialize>
std::string within(std::size_t bytes, const Serialize& serialize_with) {
  double threshold = least_weight;
  std::string out = serialize_with(threshold);
  while (out.size() > bytes && threshold < 65'504) out = serialize_with(threshold *= 1.25);
  return out;
}

}  // namespace

std::string serialize(const LinearModel& model, double threshold) {
  WeightsWriter out({ModelHeader::Linear, model.dialect()});
  out.strings(model.vocabulary().names());
  out.strings(model.words.words());
  out.table(model.reader, threshold);
  out.table(model.reranker, least_of_rerankers * threshold);
  out.table(model.start_pose_model, least_of_rerankers * threshold);
  return out.finish();
}

LinearModel parse_linear_model(std::string_view bytes, std::string_view source) {
  WeightsReader in = opened(bytes, source);
  if (in.header().kind != ModelHeader::Linear) in.fail("is no linear model");
  return read_linear(in);
}

std::string serialize(const Grounder& grounder, double threshold) {
  if (const auto* network = dynamic_cast<const NetworkReader*>(grounder.reader.get()))
    return serialize(network->network(), *grounder.model, threshold);
  return serialize(linear_model_of(grounder), threshold);
}

std::string serialize_within(const Grounder& grounder, std::size_t bytes) {
  if (const auto* network = dynamic_cast<const NetworkReader*>(grounder.reader.get()))
    return within(bytes, [&](double t) { return serialize(network->network(), *grounder.model, t); });
  const LinearModel model = linear_model_of(grounder);
  return within(bytes, [&](double t) { return serialize(model, t); });
}

Grounder parse_grounder(std::string_view bytes, std::string_view source) {
  WeightsReader in = opened(bytes, source);
  return read_grounder(in);
}

void save(const Grounder& grounder, const std::filesystem::path& file) {
  write_weights(serialize_within(grounder, most_bytes), file.string());
}

Grounder load_grounder(const std::filesystem::path& file) {
  const std::string source = file.string();
  WeightsReader in(std::make_shared<const MappedFile>(file), source);
  return read_grounder(in);
}

}  // namespace waymark::parser
