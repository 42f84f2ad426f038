// A command of the command line and its options: what we use of CLI11, behind one door.
//
// CLI11 is a library of headers and templates, and costs every file that includes it about nine seconds of compiling;
// here it is included once, in command.cpp. Both classes are handles of an object of CLI11 and are passed by value.
#pragma once
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace waymark::tools {

// What help says of an option.
struct OptionText {
  std::vector<std::string> names;  // "-m", "--map"; none: an argument by position, or a command, called `place`
  std::string place, value, help;  // the kind of value: "FILE"; empty: a flag
  std::vector<std::string> choices;
  std::string group = {}, fallback = {};  // the default; empty: none that is shown
  bool required = false;
};

class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  // What help shows: the kind of value, the default, the group.
  Option type_name(const std::string& name);
  Option show_default();
  Option group(const std::string& name);

  // What is accepted; anything else is a usage error that names the option.
  Option required(bool required = true);
  Option one_of(const std::vector<std::string>& values);
  Option between(int least, int most);
  Option between(double least, double most);
  Option positive();
  Option not_negative();

  Option separated_by(char separator);  // one argument holds many values

 private:
  CLI::Option* option_;
};

class Command {
 public:
  explicit Command(CLI::App& app) : app_(&app) {}

  // The same command, whose options are added to this group of its help.
  Command in(const std::string& group) const;

  // `names` as CLI11 has them: "-m,--map", or "file" for an argument by position. What is parsed is put into `value`,
  // which must live until then. Values are std::string, std::vector<std::string>, int, double, and the unsigned
  // integers: others do not link.
  template <class Value>
  Option add_option(const std::string& names, Value& value, const std::string& help);
  Option add_option_function(const std::string& names, const std::function<void(const std::string&)>& take,
                             const std::string& help);
  // "--on,!--off" is set to true by the one and to false by the other.
  void add_flag(const std::string& names, bool& value, const std::string& help);
  void add_flag_callback(const std::string& names, const std::function<void()>& call, const std::string& help);

  // Its own commands, one of which must be given.
  Command add_subcommand(const std::string& name, const std::string& help);
  void alias(const std::string& name) const;  // another name of this command
  std::vector<OptionText> options() const;    // its own, then its commands with theirs
  bool parsed() const;                        // was this the command that was given?

 private:
  Command(CLI::App* app, std::string group) : app_(app), group_(std::move(group)) {}
  CLI::App* app_;
  std::string group_ = {};  // empty: "Options"
};

// The options of a command, then its commands with theirs; without --help and --help-all.
std::vector<OptionText> options_of(const CLI::App& app, bool with_commands);

}  // namespace waymark::tools
