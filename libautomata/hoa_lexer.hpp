// The tokens of the HOA format. [BBD+15, Sec. 3]
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace waymark::automata {

struct HoaToken {
  enum class Kind : std::uint8_t {
    Header,
    Identifier,
    Alias,
    String,
    Integer,
    Punctuation,
    Body,
    End,
    Abort,
    Eof
  };
  Kind kind = Kind::Eof;
  std::string_view text;    // as written; of a header without the colon
  std::uint64_t value = 0;  // of an Integer
  std::uint32_t line = 0, column = 0;
};

// The last token is Eof. Throws ltl::FormatError. Comments may be nested.
std::vector<HoaToken> hoa_tokens(std::string_view text, std::string_view source);

std::string unquoted(std::string_view quoted);  // of a String: quotes and escapes removed
std::string described(const HoaToken& token);   // for messages: "'['", "the end of the file", …

}  // namespace waymark::automata
