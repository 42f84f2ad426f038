// waymark help: the pages of the manual on formats and conventions, in the terminal.
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <string>

#include "libltl/vocabulary.hpp"
#include "tools/help/markdown.hpp"
#include "tools/help/topics.hpp"
#include "tools/shell/exit_code.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {
namespace {

struct HelpOptions {
  std::string topic;
  bool json = false;
};

struct Window {
  std::size_t columns = 100, rows = 0;  // rows 0: no terminal
};

Window window() {
  constexpr std::size_t least = 40, greatest = 100;  // longer lines are hard to read
  winsize size{};
  if (::isatty(STDOUT_FILENO) == 0 || ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return {};
  return {std::clamp<std::size_t>(size.ws_col, least, greatest), size.ws_row};
}

// By $PAGER, else less; printed where neither runs.
void show(const std::string& text, const Window& window) {
  const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  if (window.rows > 0 && lines >= window.rows) {
    std::cout.flush();
    const char* pager = std::getenv("PAGER");
    const std::string command = pager != nullptr && *pager != '\0' ? pager : "less -R";
    const auto before = std::signal(SIGPIPE, SIG_IGN);  // a pager may be left before the end
    FILE* pipe = ::popen(command.c_str(), "w");
    if (pipe != nullptr) {
      std::fwrite(text.data(), 1, text.size(), pipe);
      const int status = ::pclose(pipe);
      std::signal(SIGPIPE, before);
      constexpr int not_found = 127;
      if (WIFEXITED(status) && WEXITSTATUS(status) != not_found) return;
    }
    std::signal(SIGPIPE, before);
  }
  std::cout << text;
}

ExitCode list_topics(const HelpOptions& options) {
  if (options.json) {
    JsonArray topics;
    for (const HelpTopic& topic : help_topics())
      topics.add(JsonObject().add("topic", std::string(topic.name)).add("title", title_of(topic)));
    std::cout << JsonObject().add("topics", topics).text() << '\n';
    return ExitCode::Done;
  }
  std::size_t width = 0;
  for (const HelpTopic& topic : help_topics()) width = std::max(width, topic.name.size());
  std::cout << "waymark help TOPIC shows a page of the manual; waymark SUBCOMMAND --help, the options of a "
               "subcommand.\n\n";
  for (const HelpTopic& topic : help_topics())
    std::cout << "  " << topic.name << std::string(width + 2 - topic.name.size(), ' ') << title_of(topic) << '\n';
  return ExitCode::Done;
}

ExitCode run_help(const HelpOptions& options, const Session& session) {
  if (options.topic.empty()) return list_topics(options);
  const HelpTopic* topic = find_topic(options.topic);
  if (topic == nullptr) {
    ltl::Vocabulary known;
    for (const HelpTopic& one : help_topics()) known.add(std::string(one.name));
    const auto nearest = known.nearest(options.topic);
    throw UsageError("there is no topic '" + options.topic + "'" +
                     (nearest ? " (did you mean '" + *nearest + "'?)" : "; see waymark help"));
  }
  if (options.json) {
    const std::string text = readable(topic->page, Window().columns, {});
    std::cout
        << JsonObject().add("topic", std::string(topic->name)).add("title", title_of(*topic)).add("text", text).text()
        << '\n';
    return ExitCode::Done;
  }
  const Window size = window();
  show(readable(topic->page, size.columns, session.out), size);
  return ExitCode::Done;
}

}  // namespace

Runner setup_help(Command command) {
  const auto options = std::make_shared<HelpOptions>();
  command.add_option("topic", options->topic, "a page, by its name or a word of it; without: the list of pages")
      .type_name("TOPIC");
  command.add_flag("--json", options->json, "one JSON object");
  return [options](const Session& session) { return run_help(*options, session); };
}

}  // namespace waymark::tools
