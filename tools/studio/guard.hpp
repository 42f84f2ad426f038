// Who may ask the studio: which requests are refused before anything of them is read.
//
// A page of another site may send requests to 127.0.0.1 from its visitor's browser. Such a request names another host
// (a name that was bound to 127.0.0.1 afterwards) or another origin, and is refused. Beyond 127.0.0.1 a token is asked
// for, which only who started the studio has seen.
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace waymark::studio {

struct Access {
  std::string host = "127.0.0.1";  // the address that is listened on
  int port = 0;
  std::string token = {};  // empty: none is asked for
};

// An address that only this machine reaches.
bool is_loopback(std::string_view host);
std::string new_token();  // 128 random bits, in hexadecimal
// "http://127.0.0.1:8321/", with the token behind # where there is one: a fragment is not sent, nor logged.
std::string address_of(const Access& access);

struct RequestHead {
  std::string_view method, path;
  std::string_view host = {}, origin = {}, fetch_site = {}, content_type = {}, authorization = {};
};

struct Refusal {
  int status;
  std::string reason;
};
std::optional<Refusal> refusal(const Access& access, const RequestHead& head);

}  // namespace waymark::studio
