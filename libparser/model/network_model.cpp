#include "libparser/model/network_model.hpp"

#include <array>
#include <cstddef>
#include <span>

#include "libparser/model/ranking_model.hpp"
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
  return size(options.word) * (words + 8 * size(options.width)) + 8 * size(options.width) * size(options.width) +
         size(options.query) * (size(options.history) * size(options.symbol) + 4 * size(options.width)) +
         size(options.symbol) * (size(options.query) + 2 * size(options.width));
}

}  // namespace

std::shared_ptr<const NetworkModel> NetworkModel::read(WeightsReader& in, const RankingModel& ranking) {
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
  EncoderDecoder network(TypedPostfix(ranking.language), std::move(words), options, [] { return 0.5; });
  neural::Vector& values = network.parameters().values();
  in.floats({values.data(), static_cast<std::size_t>(values.size())});
  return std::make_shared<const NetworkModel>(std::move(network));
}

void NetworkModel::write(WeightsWriter& out, double) const {
  out.strings(network.words().words());
  NetworkOptions options = network.options();
  for (const std::int32_t* size : sizes_of(options)) out.number(static_cast<std::uint64_t>(*size));
  out.number(options.lexicon ? 1 : 0);
  const neural::Vector& values = network.parameters().values();
  out.list(std::span<const float>(values.data(), static_cast<std::size_t>(values.size())));
}

}  // namespace waymark::parser
