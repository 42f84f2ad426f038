#include "tools/studio/guard.hpp"

#include <algorithm>
#include <random>

namespace waymark::studio {
namespace {

std::string in_brackets(std::string_view host) {  // an IPv6 address as URLs have it
  const bool v6 = host.find(':') != std::string_view::npos;
  return v6 ? "[" + std::string(host) + "]" : std::string(host);
}

// A literal address cannot be bound to another one by its owner's name server.
bool is_literal_address(std::string_view host) {
  const auto all = [&](std::string_view allowed) {
    return !host.empty() && host.find_first_not_of(allowed) == std::string_view::npos;
  };
  return all("0123456789.") || (host.starts_with('[') && host.ends_with(']') && all("0123456789abcdefABCDEF:[]"));
}

bool names_us(const Access& access, std::string_view host) {
  const std::string port = ":" + std::to_string(access.port);
  if (!host.ends_with(port)) return access.port == 80 && host.find(':') == std::string_view::npos;
  host.remove_suffix(port.size());
  if (host == in_brackets(access.host)) return true;
  if (is_loopback(access.host)) return host == "127.0.0.1" || host == "localhost" || host == "[::1]";
  return is_literal_address(host);
}

// In a time that does not depend on where they differ.
bool equal(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference |= static_cast<unsigned char>(a[i] ^ b[i]);
  return difference == 0;
}

}  // namespace

bool is_loopback(std::string_view host) { return host == "127.0.0.1" || host == "localhost" || host == "::1"; }

std::string new_token() {
  std::random_device device;
  constexpr std::string_view digits = "0123456789abcdef";
  std::string token;
  for (int i = 0; i < 32; ++i) token += digits[device() % 16];
  return token;
}

std::string address_of(const Access& access) {
  return "http://" + in_brackets(access.host) + ':' + std::to_string(access.port) + '/' +
         (access.token.empty() ? "" : "#token=" + access.token);
}

std::optional<Refusal> refusal(const Access& access, const RequestHead& head) {
  if (!names_us(access, head.host)) return Refusal{403, "the Host of the request is not this server"};
  if (!head.origin.empty() && head.origin != "http://" + std::string(head.host))
    return Refusal{403, "the request comes from another origin"};
  if (head.fetch_site == "cross-site" || head.fetch_site == "same-site")
    return Refusal{403, "the request comes from another site"};
  if (head.method != "GET" && head.method != "HEAD" && head.method != "POST")
    return Refusal{405, "only GET and POST are answered"};
  if (!head.path.starts_with("/api/")) return std::nullopt;
  if (head.method == "POST" && !head.content_type.starts_with("application/json"))
    return Refusal{415, "the body of a request is application/json"};
  if (!access.token.empty() && !equal(head.authorization, "Bearer " + access.token))
    return Refusal{401, "the token that was printed when the studio started is missing or wrong"};
  return std::nullopt;
}

}  // namespace waymark::studio
