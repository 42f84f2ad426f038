#include "libparser/model_file.hpp"

#include <array>
#include <fstream>
#include <sstream>

#include "libltl/diagnostic.hpp"
#include "libparser/decode/network_search.hpp"
#include "libparser/model/weights_bytes.hpp"

namespace waymark::parser {
namespace {

constexpr std::uint32_t linear = 9, encoder_decoder = 10;  // versions; + 2 in the temporal dialect

std::uint32_t version_of(std::uint32_t kind, const LinearModel& model) {
  return kind + (model.dialect() == Dialect::Temporal ? 2 : 0);
}
bool is_kind(std::uint32_t version, std::uint32_t kind) { return version == kind || version == kind + 2; }
Dialect dialect_of(std::uint32_t version) {
  return version > encoder_decoder ? Dialect::Temporal : Dialect::Plain;
}

constexpr std::int32_t largest = 4096;  // size of a layer, while reading

LinearModel read_linear(WeightsReader& in) {
  LinearModel model(in.vocabulary(), dialect_of(in.version()));
  model.words = in.words();
  in.table(model.reader);
  in.table(model.reranker);
  in.table(model.start_pose_model);
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
  auto model = std::make_shared<LinearModel>(in.vocabulary(), dialect_of(in.version()));
  WordTable words = in.words();
  NetworkOptions options;
  for (std::int32_t* size : sizes_of(options)) {
    *size = in.number<std::int32_t>();
    if (*size < 1 || *size > largest) in.fail("a layer of no possible size");
  }
  if (least_weights(options, words.words().size()) > in.left() / 4)  // before room is made for them
    in.fail("the weights file promises more than it holds");
  options.lexicon = in.number<std::uint8_t>() != 0;
  EncoderDecoder network(TypedPostfix(model->grammar(), model->columns()), std::move(words), options,
                         [] { return 0.5; });
  neural::Vector& values = network.parameters().values();
  in.floats({values.data(), static_cast<std::size_t>(values.size())});
  model->words = in.words();
  in.table(model->reranker);
  in.table(model->start_pose_model);
  in.end();
  return {std::make_shared<const NetworkReader>(std::move(network)), std::move(model)};
}

std::string serialize(const EncoderDecoder& network, const LinearModel& model, double threshold) {
  WeightsWriter out(version_of(encoder_decoder, model));
  out.strings(model.vocabulary().names());
  out.strings(network.words().words());
  NetworkOptions options = network.options();
  for (const std::int32_t* size : sizes_of(options)) out.number(static_cast<std::uint32_t>(*size));
  out.number(static_cast<std::uint8_t>(options.lexicon));
  const neural::Vector& values = network.parameters().values();
  out.floats({values.data(), static_cast<std::size_t>(values.size())});
  out.strings(model.words.words());
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
  WeightsWriter out(version_of(linear, model));
  out.strings(model.vocabulary().names());
  out.strings(model.words.words());
  out.table(model.reader, threshold);
  out.table(model.reranker, least_of_rerankers * threshold);
  out.table(model.start_pose_model, least_of_rerankers * threshold);
  return out.finish();
}

LinearModel parse_linear_model(std::string_view bytes, std::string_view source) {
  WeightsReader in(bytes, source);
  if (!is_kind(in.version(), linear)) in.fail("is no linear model");
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
  WeightsReader in(bytes, source);
  if (is_kind(in.version(), linear)) return grounder_of(read_linear(in));
  if (is_kind(in.version(), encoder_decoder)) return read_encoder_decoder(in);
  in.fail("weights file of an unknown version");
}

void save(const Grounder& grounder, const std::filesystem::path& file) {
  write_weights(serialize_within(grounder, most_bytes), file.string());
}

Grounder load_grounder(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  if (!in || !bytes) throw ltl::FormatError(file.string(), 0, 0, "cannot be read");
  return parse_grounder(bytes.view(), file.string());
}

}  // namespace waymark::parser
