#include "tools/shell/command.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <sstream>
#include <type_traits>

namespace waymark::tools {
namespace {

// "TEXT:{a,b}" → a, b
std::vector<std::string> choices_in(const std::string& type) {
  std::vector<std::string> out;
  const std::size_t open = type.find('{'), close = type.find('}');
  if (open == std::string::npos || close == std::string::npos) return out;
  std::istringstream names(type.substr(open + 1, close - open - 1));
  for (std::string name; std::getline(names, name, ',');) out.push_back(name);
  return out;
}

OptionText option_text(const CLI::Option& option) {
  OptionText out;
  for (const std::string& name : option.get_snames()) out.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) out.names.push_back("--" + name);
  if (out.names.empty()) out.place = option.get_name();
  if (option.get_items_expected_max() > 0) {
    const std::string type = option.get_type_name();
    out.choices = choices_in(type);
    out.value = type.substr(0, type.find(':'));
    if (out.value == "TEXT" && !out.choices.empty()) out.value = "KIND";
    if (out.value == "INT" || out.value == "UINT") out.value = "N";
    if (out.value == "FLOAT") out.value = "X";
    out.fallback = option.get_default_str();
  }
  out.help = option.get_description();
  out.group = option.get_group();
  out.required = option.get_required();
  return out;
}

CLI::Option* grouped(CLI::Option* option, const std::string& group) {
  if (!group.empty()) option->group(group);
  return option;
}

}  // namespace

std::vector<OptionText> options_of(const CLI::App& app, bool with_commands) {
  std::vector<OptionText> out;
  for (const CLI::Option* option : app.get_options())
    if (option != app.get_help_ptr() && option != app.get_help_all_ptr()) out.push_back(option_text(*option));
  if (!with_commands) return out;
  for (const CLI::App* below : app.get_subcommands([](const CLI::App*) { return true; })) {
    out.push_back({{}, below->get_name(), "", below->get_description(), {}});
    const std::vector<OptionText> more = options_of(*below, true);
    out.insert(out.end(), more.begin(), more.end());
  }
  return out;
}

Option Option::type_name(const std::string& name) {
  option_->type_name(name);
  return *this;
}
Option Option::show_default() {
  option_->capture_default_str();
  return *this;
}
Option Option::group(const std::string& name) {
  option_->group(name);
  return *this;
}
Option Option::required(bool required) {
  option_->required(required);
  return *this;
}
Option Option::one_of(const std::vector<std::string>& values) {
  option_->check(CLI::IsMember(values));
  return *this;
}
Option Option::between(int least, int most) {
  option_->check(CLI::Range(least, most));
  return *this;
}
Option Option::between(double least, double most) {
  option_->check([least, most](const std::string& text) -> std::string {
    double value = 0;
    if (CLI::detail::lexical_cast(text, value) && value >= least && value <= most) return {};
    std::ostringstream out;
    out << "expected a number from " << least << " to " << most << ": " << text;
    return out.str();
  });
  return *this;
}
Option Option::positive() {
  option_->check(CLI::PositiveNumber);
  return *this;
}
Option Option::not_negative() {
  option_->check(CLI::NonNegativeNumber);
  return *this;
}
Option Option::separated_by(char separator) {
  option_->delimiter(separator)->allow_extra_args(false);
  return *this;
}

// CLI11 takes "nan" and "inf" for a number, and "-1" for the greatest whole one.
template <class Value>
std::string not_a_number(const std::string& text) {
  if (std::is_unsigned_v<Value> && text.find('-') != std::string::npos)
    return "expected a number of at least 0: " + text;
  if (std::is_floating_point_v<Value> && text.find_first_of("nN") != std::string::npos)  // nan, inf, infinity
    return "expected a finite number: " + text;
  return {};
}

template <class Value>
Option Command::add_option(const std::string& names, Value& value, const std::string& help) {
  CLI::Option* const option = app_->add_option(names, value, help);
  if constexpr (std::is_arithmetic_v<Value>) option->check(not_a_number<Value>);
  return Option(grouped(option, group_));
}
template Option Command::add_option(const std::string&, std::string&, const std::string&);
template Option Command::add_option(const std::string&, std::vector<std::string>&, const std::string&);
template Option Command::add_option(const std::string&, int&, const std::string&);
template Option Command::add_option(const std::string&, double&, const std::string&);
template Option Command::add_option(const std::string&, unsigned&, const std::string&);
template Option Command::add_option(const std::string&, unsigned long&, const std::string&);

Option Command::add_option_function(const std::string& names, const std::function<void(const std::string&)>& take,
                                    const std::string& help) {
  return Option(grouped(app_->add_option_function(names, take, help), group_));
}
void Command::add_flag(const std::string& names, bool& value, const std::string& help) {
  grouped(app_->add_flag(names, value, help), group_);
}
void Command::add_flag_callback(const std::string& names, const std::function<void()>& call, const std::string& help) {
  grouped(app_->add_flag_callback(names, call, help), group_);
}
Command Command::add_subcommand(const std::string& name, const std::string& help) {
  app_->require_subcommand(1);
  return Command(*app_->add_subcommand(name, help));
}
void Command::alias(const std::string& name) const { app_->alias(name); }
Command Command::in(const std::string& group) const { return {app_, group}; }
std::vector<OptionText> Command::options() const { return options_of(*app_, true); }
bool Command::parsed() const { return app_->parsed(); }

}  // namespace waymark::tools
