#include "tools/shell/shell_files.hpp"

#include <string>
#include <vector>

#include "tools/shell/output.hpp"

namespace waymark::tools {
namespace {

bool takes_file(const OptionText& option) {
  return option.value.find("FILE") != std::string::npos || option.value.find("DIR") != std::string::npos;
}

std::string joined(const std::vector<std::string>& parts, const std::string& between) {
  std::string out;
  for (const std::string& part : parts) out += (out.empty() ? "" : between) + part;
  return out;
}

std::vector<std::string> flags_of(const CommandText& command) {
  std::vector<std::string> out{"--help", "--help-all"};
  for (const OptionText& option : command.options) out.insert(out.end(), option.names.begin(), option.names.end());
  return out;
}

std::string bash(std::span<const CommandText> commands) {
  std::vector<std::string> names;
  for (const CommandText& command : commands) names.push_back(command.name);
  std::string out =
      "# bash completion of waymark; made by the build\n"
      "_waymark() {\n"
      "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}\n"
      "  if ((COMP_CWORD == 1)); then\n"
      "    mapfile -t COMPREPLY < <(compgen -W '" +
      joined(names, " ") +
      " --help --version' -- \"$word\")\n"
      "    return\n  fi\n"
      "  case ${COMP_WORDS[1]}:$before in\n";
  for (const CommandText& command : commands)
    for (const OptionText& option : command.options)
      if (!option.choices.empty())
        for (const std::string& name : option.names)
          out += "    " + command.name + ":" + name + ") mapfile -t COMPREPLY < <(compgen -W '" +
                 joined(option.choices, " ") + "' -- \"$word\"); return ;;\n";
  out += "  esac\n  case ${COMP_WORDS[1]} in\n";
  for (const CommandText& command : commands)
    out += "    " + command.name + ") [[ $word == -* ]] && mapfile -t COMPREPLY < <(compgen -W '" +
           joined(flags_of(command), " ") + "' -- \"$word\") ;;\n";
  return out +
         "  esac\n"
         "  [[ $word == -* ]] || mapfile -t COMPREPLY < <(compgen -f -- \"$word\")\n"
         "}\n"
         "complete -o filenames -F _waymark waymark\n";
}

// Inside single quotes, in brackets of _arguments.
std::string zsh_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\'') out += "'\\'";
    if (c == '[' || c == ']' || c == ':') out += '\\';
    out += c;
  }
  return out;
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

std::string zsh(std::span<const CommandText> commands) {
  std::string out =
      "#compdef waymark\n# zsh completion of waymark; made by the build\n"
      "_waymark() {\n  local -a commands\n  commands=(\n";
  for (const CommandText& command : commands) out += "    '" + command.name + ":" + zsh_text(command.summary) + "'\n";
  out +=
      "  )\n  if ((CURRENT == 2)); then\n    _describe 'subcommand' commands\n    return\n  fi\n"
      "  case $words[2] in\n";
  for (const CommandText& command : commands) {
    out += "    " + command.name + ") _arguments";
    for (const OptionText& option : command.options)
      for (const std::string& name : option.names) {
        out += " \\\n      '" + name + "[" + zsh_text(first_line(option.help)) + "]";
        if (!option.choices.empty())
          out += ":value:(" + joined(option.choices, " ") + ")";
        else if (!option.value.empty())
          out += takes_file(option) ? ":file:_files" : ":" + zsh_text(option.value) + ":";
        out += "'";
      }
    out += " \\\n      '*:file:_files' ;;\n";
  }
  return out + "  esac\n}\n_waymark \"$@\"\n";
}

std::string fish_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\'' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

std::string fish(std::span<const CommandText> commands) {
  std::string out = "# fish completion of waymark; made by the build\n";
  for (const CommandText& command : commands) {
    out += "complete -c waymark -n __fish_use_subcommand -a " + command.name + " -d '" + fish_text(command.summary) +
           "'\n";
    for (const OptionText& option : command.options) {
      if (option.names.empty()) continue;
      out += "complete -c waymark -n '__fish_seen_subcommand_from " + command.name + "'";
      for (const std::string& name : option.names)
        out += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      if (!option.choices.empty())
        out += " -x -a '" + joined(option.choices, " ") + "'";
      else if (!option.value.empty())
        out += takes_file(option) ? " -r" : " -x";
      out += " -d '" + fish_text(first_line(option.help)) + "'\n";
    }
  }
  return out;
}

// Text for troff: no line begins a request, hyphens are minus signs.
std::string troff(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\' || c == '-') out += '\\';
    if (out.empty() && (c == '.' || c == '\'')) out += "\\&";
    out += c;
  }
  return out;
}

std::string heading(const std::string& page) {
  return ".TH " + page + " 1 \"\" \"waymark " WAYMARK_VERSION "\" \"waymark\"\n.SH NAME\n";
}

std::string manual_page(const CommandText& command) {
  const std::string page = "waymark-" + command.name;
  std::string out = heading(page) + troff(page) + " \\- " + troff(command.summary) + "\n.SH SYNOPSIS\n.B waymark " +
                    troff(command.name) + "\n[options] [arguments]\n.SH OPTIONS\n";
  std::string group = "Options";
  for (const OptionText& option : command.options) {
    if (option.group != group && !option.names.empty()) out += ".SS " + troff(group = option.group) + "\n";
    out += ".TP\n.B " + troff(option.names.empty() ? option.place : joined(option.names, ", "));
    if (!option.value.empty()) out += " \\fI" + troff(option.value) + "\\fR";
    out += "\n" + troff(option.help.empty() ? "\u2014" : option.help);
    if (!option.choices.empty()) out += "\none of: " + troff(joined(option.choices, ", "));
    if (!option.fallback.empty()) out += "\ndefault: " + troff(option.fallback);
    out += "\n";
  }
  if (!command.examples.empty()) out += ".SH EXAMPLES\n";
  for (const std::string& line : command.examples) out += ".PP\n.nf\n" + troff(line) + "\n.fi\n";
  return out + ".SH SEE ALSO\n.BR waymark (1)\n";
}

std::string overview_page(std::span<const CommandText> commands) {
  std::string out = heading("waymark") +
                    "waymark \\- from English route instructions to certified routes\n.SH SYNOPSIS\n"
                    ".B waymark\n\\fIsubcommand\\fR [options] [arguments]\n.SH SUBCOMMANDS\n";
  for (const CommandText& command : commands)
    out += ".TP\n.BR waymark\\-" + troff(command.name) + " (1)\n" + troff(command.summary) + "\n";
  return out +
         ".SH EXIT STATUS\n0: done. 10: the answer is no. 11: gave up. 12: not understood. 20: the command "
         "line is "
         "wrong. 21: the input is wrong. 30: a defect of waymark.\n";
}

}  // namespace

void write_shell_files(std::span<const CommandText> commands, const std::filesystem::path& folder) {
  for (const char* room : {"bash", "zsh", "fish", "man1"}) std::filesystem::create_directories(folder / room);
  write_file(folder / "bash" / "waymark", bash(commands));
  write_file(folder / "zsh" / "_waymark", zsh(commands));
  write_file(folder / "fish" / "waymark.fish", fish(commands));
  write_file(folder / "man1" / "waymark.1", overview_page(commands));
  for (const CommandText& command : commands)
    write_file(folder / "man1" / ("waymark-" + command.name + ".1"), manual_page(command));
}

}  // namespace waymark::tools
