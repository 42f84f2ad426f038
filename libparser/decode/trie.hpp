// A trie of programs: shared prefixes are scored once, whatever the word model.
//
// A node is a prefix at which the grammar leaves a choice; what it forces after a token is taken with that token.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "libparser/programs/postfix_grammar.hpp"

namespace waymark::parser {

// Prefix: of one kind of word model (model/word_model.hpp).
template <class Prefix>
class ProgramTrie {
 public:
  struct Child {                                                       // of a node
    Token token;                                                       // that leads there
    std::int32_t to;                                                   // a node, or ~program
    bool is_program() const { return to < 0; }                         // else a node
    std::size_t node() const { return static_cast<std::size_t>(to); }  // of a node
    std::size_t program() const {                                      // of a program
      const std::int32_t number = ~to;
      return static_cast<std::size_t>(number);
    }
  };
  struct Node {                   // a prefix with a choice
    Prefix prefix;                // of the model
    std::vector<Child> children;  // by token
  };

  // Weights multiply probabilities: 1 counts fully. A program that is in already keeps its first weight.
  // Returns whether it was new. Throws as PostfixGrammar::tokens_of.
  template <class Prefixes>
  bool add(const Prefixes& prefixes, const Program& program, double weight) {
    const auto tokens = prefixes.tokens_of(program);
    if (nodes_.empty()) nodes_.push_back({prefixes.first(), {}});
    std::vector<Token> taken;
    for (std::size_t at = 0, i = 0;;) {
      const auto& children = nodes_[at].children;
      const Token token = tokens[i];
      const auto child =
          std::find_if(children.begin(), children.end(), [&](const Child& c) { return c.token == token; });
      taken.clear();
      Prefix next = prefixes.after(nodes_[at].prefix, token, taken);
      i += taken.size();
      if (child != children.end()) {
        if (child->to < 0) return false;
        at = static_cast<std::size_t>(child->to);
        continue;
      }
      const bool complete = i == tokens.size();
      const std::size_t to = nodes_.size();
      nodes_[at].children.push_back(
          {token, complete ? ~static_cast<std::int32_t>(programs()) : static_cast<std::int32_t>(to)});
      if (complete) break;
      nodes_.push_back({std::move(next), {}});
      at = to;
    }
    log_weights_.push_back(static_cast<float>(std::log(weight)));
    return true;
  }

  std::size_t programs() const { return log_weights_.size(); }            // in the trie
  const std::vector<float>& log_weights() const { return log_weights_; }  // by program
  std::span<const Node> nodes() const { return nodes_; }                  // parents before children

 private:
  std::vector<Node> nodes_;
  std::vector<float> log_weights_;
};

}  // namespace waymark::parser
