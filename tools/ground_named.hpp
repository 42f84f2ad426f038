// waymark ground over named things instead of a hallway map: landmarks, propositions, or domains that each line names.
#pragma once
#include <mutex>
#include <optional>
#include <string>

#include "libparser/decode/grounder.hpp"
#include "libparser/domain/commands/command_reader.hpp"
#include "libparser/grounding/instruction.hpp"
#include "tools/shell/command.hpp"
#include "tools/shell/parallel.hpp"

namespace waymark::tools {

struct NamedOptions {
  std::string landmarks, propositions;  // files
  std::string domains, maps;            // of lines that name their domain
  bool any() const { return !landmarks.empty() || !propositions.empty() || !domains.empty(); }
};
void add_named_options(Command command, NamedOptions& options);

class NamedGrounding {
 public:
  // The model outlives this. Throws UsageError when it has no reader of commands, or when several kinds of named things
  // are given.
  NamedGrounding(const NamedOptions& options, const parser::Grounder& model, std::size_t top, bool json, bool force);

  // Formulas over infinite words. Safe to call from several threads.
  Reply operator()(const parser::Instruction& instruction, const Text& line);

 private:
  const parser::CommandDomain& domain_of(const parser::Instruction& instruction, const Text& line);
  Reply of_domain(const parser::Instruction& instruction, const parser::CommandDomain& domain) const;
  Reply of_things(const std::string& text) const;
  Reply not_understood(const std::string& text, double probability) const;

  const parser::LiftedReader& reader_;
  std::size_t top_;
  bool json_, force_;
  std::string file_;
  std::optional<parser::CommandDomain> things_;
  std::optional<parser::CommandDomains> domains_;
  std::mutex reading_;
};

}  // namespace waymark::tools
