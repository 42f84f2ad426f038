#include "tools/farm/post.hpp"

#include <limits>
#include <stdexcept>
#include <utility>

namespace waymark::tools {
namespace {

constexpr int tag = 1;

}  // namespace

void Post::send(int rank, std::string message) {
  if (message.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw std::length_error("an answer of 2 GiB or more cannot be sent from rank to rank");
  Letter& letter = outgoing_[rank].emplace_back();
  letter.bytes = std::move(message);
  letter.under_way = ranks_.isend(rank, tag, letter.bytes.data(), static_cast<int>(letter.bytes.size()));
}

void Post::receive(const std::function<void(int rank, const std::string& message)>& take) {
  while (const auto found = ranks_.iprobe(boost::mpi::any_source, tag)) {
    Letter& letter = incoming_[found->source()].emplace_back();
    letter.bytes.resize(static_cast<std::size_t>(found->count<char>().value()));
    letter.under_way = ranks_.irecv(found->source(), tag, letter.bytes.data(), static_cast<int>(letter.bytes.size()));
  }
  for (auto& [rank, letters] : incoming_)
    while (!letters.empty() && letters.front().under_way.test()) {
      take(rank, letters.front().bytes);
      letters.pop_front();
    }
}

bool Post::is_all_sent(const std::function<bool(int rank)>& but) {
  bool all = true;
  for (auto& [rank, letters] : outgoing_) {
    while (!letters.empty() && letters.front().under_way.test()) letters.pop_front();
    all = all && (letters.empty() || but(rank));
  }
  return all;
}

}  // namespace waymark::tools
