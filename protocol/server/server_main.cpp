#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>

#include "protocol/errors.hpp"
#include "protocol/release.hpp"
#include "protocol/server/server.hpp"
#include "protocol/wire/greeting.hpp"

namespace adit::protocol {
namespace {

constexpr std::size_t kMostThreads = 1024;

void exit_with(pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) std::raise(SIGTERM);  // the parent ended before prctl took effect
}

}  // namespace

int server_main(int argc, char** argv, std::string_view program, const ParticipantFactory& make_participant,
                std::size_t* threads) {
  // The parent is noted before anything else: if it ends meanwhile, exit_with() finds another one in its
  // place.
  const pid_t parent = ::getppid();
  ServerOptions options{.program = std::string(program)};
  std::string listen = to_string(options.listen);
  std::string log_level = "info";
  bool exit_with_parent = false;

  CLI::App app("Takes part in the runs of the Adit coupler, one after another, until SIGINT or SIGTERM.",
               options.program);
  app.add_option("--listen", listen, "HOST:PORT to listen on; port 0 takes any free one")
      ->capture_default_str();
  app.add_flag("--insecure", options.insecure, "allow a HOST beyond loopback, open to anyone who reaches it");
  app.add_flag("--exit-with-parent", exit_with_parent, "end when the process that started this one ends");
  if (threads)
    app.add_option("--threads", *threads, "threads that share the computing; 0: as many as speed it up")
        ->check(CLI::Range(std::size_t{0}, kMostThreads))
        ->capture_default_str();
  app.add_option("--log-level", log_level, "least severity of the log on stderr")
      ->check(CLI::IsMember({"debug", "info", "warn", "error", "off"}))
      ->capture_default_str();
  app.set_version_flag("--version", options.program + " " + std::string(release()));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kSuccess : kUserError;
  }

  spdlog::set_default_logger(spdlog::stderr_color_mt(options.program));
  spdlog::set_level(spdlog::level::from_str(log_level));
  if (exit_with_parent) exit_with(parent);
  try {
    options.listen = parse_address(listen);
    return serve(options, make_participant);
  } catch (const UserError& error) {
    std::cerr << options.program << ": " << error.what() << '\n';
    return kUserError;
  } catch (const std::exception& error) {
    std::cerr << options.program << ": internal error: " << error.what() << '\n';
    return kInternalError;
  }
}

}  // namespace adit::protocol
