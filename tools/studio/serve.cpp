// waymark serve: the studio, a page in the browser.
#include <malloc.h>

#include <cstdlib>
#include <iostream>
#include <memory>

#include "tools/shell/data_directory.hpp"
#include "tools/shell/models.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/subcommand.hpp"
#include "tools/studio/server.hpp"

namespace waymark::tools {
namespace {

struct ServeOptions {
  studio::Access access{.port = 8321};
  ModelOptions model;
  std::string data;
};

ExitCode run_serve(const ServeOptions& options, const Session& session) {
#ifdef M_ARENA_MAX  // glibc keeps what was freed for each thread: twice the memory under load, and slower
  mallopt(M_ARENA_MAX, 2);
  mallopt(M_MMAP_THRESHOLD, 262'144);  // else it grows with what was freed, and large blocks are no longer given back
  mallopt(M_TRIM_THRESHOLD, 1'048'576);
#endif
  studio::Api api(read_model(options.model, options.data), data_directory(options.data));
  studio::Access access = options.access;
  if (!studio::is_loopback(access.host)) access.token = studio::new_token();
  studio::Server server(access, api);
  server.bind();
  std::cout << "The studio is at " << studio::address_of(server.access()) << "\n";
  if (!access.token.empty())
    std::cout << "Others on the network reach it, and what they send is not encrypted; the token lets them in.\n";
  std::cout << "Ctrl-C ends it.\n" << std::flush;
  // Idle connections would hold their threads for seconds, and nothing is left to be written.
  const std::stop_callback end(session.stop, [] { std::_Exit(static_cast<int>(ExitCode::Done)); });
  server.run(session.stop);
  return ExitCode::Done;
}

}  // namespace

Runner setup_serve(Command command) {
  const auto options = std::make_shared<ServeOptions>();
  command.add_option("--host", options->access.host, "address to listen on; another one asks for a token")
      .type_name("ADDRESS")
      .show_default();
  command.add_option("--port", options->access.port, "port to listen on; 0: any free one")
      .type_name("N")
      .between(0, 65535)
      .show_default();
  add_model_options(command, options->model);
  add_data_option(command, options->data);
  return [options](const Session& session) { return run_serve(*options, session); };
}

}  // namespace waymark::tools
