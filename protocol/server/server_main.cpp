#include <google/protobuf/stubs/logging.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdlib>
#include <optional>

#include "protocol/errors.hpp"
#include "protocol/log/log.hpp"
#include "protocol/log/option.hpp"
#include "protocol/machine/refusal.hpp"
#include "protocol/release.hpp"
#include "protocol/server/server.hpp"
#include "protocol/server/server_log.hpp"
#include "protocol/server/socket_file.hpp"
#include "protocol/standard_streams.hpp"
#include "protocol/threads/most_threads.hpp"
#include "protocol/trust/secret.hpp"
#include "protocol/wire/greeting.hpp"

namespace adit::protocol {
namespace {

// The signals of a terminal or a scheduler, which go to all processes of a run, are the coupler's: it still
// needs the servers for what it writes at the end, and then ends them by kOwnerSignal. That one waits until
// the listener looks at it: before, it would end this process with its socket and folder left behind.
// False where the coupler has ended already: the process is then the child of another one.
bool exit_with(pid_t parent) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_IGN);
  sigset_t owner;
  ::sigemptyset(&owner);
  ::sigaddset(&owner, kOwnerSignal);
  ::pthread_sigmask(SIG_BLOCK, &owner, nullptr);
  ::prctl(PR_SET_PDEATHSIG, kOwnerSignal);
  return ::getppid() == parent;
}

// Of a file that the user names, or handed over by the coupler that started this process.
std::string own_secret(const std::string& file) {
  if (!file.empty()) return read_secret(file);
  const char* given = std::getenv(kSecretVariable);
  return given ? given : "";
}

}  // namespace

int server_main(int argc, char** argv, std::string_view program, std::vector<std::string> computes,
                const ParticipantFactory& make_participant, std::size_t* threads, const Patience& patience,
                bool begins_anew) {
  guard_standard_streams();
  google::protobuf::SetLogHandler(nullptr);  // what it meets is told by this program, once and in its form
  ServerOptions options;
  options.program = program;
  options.computes = std::move(computes);
  options.patience = patience;
  options.command.assign(argv, argv + argc);
  options.begins_anew = begins_anew;
  std::string listen = to_string(options.listen);
  std::string secret_file, tls_folder;
  std::string log_level = "info", log_format = "text";
  pid_t parent = 0;
  bool in_private = false;

  CLI::App app("Takes part in the runs of the Adit coupler, one after another, until SIGINT or SIGTERM.",
               options.program);
  app.add_option("--listen", listen,
                 "HOST:PORT to listen on, port 0 takes any free one; or unix:PATH, for this machine")
      ->capture_default_str();
  app.add_option("--tls", tls_folder,
                 "folder of this machine's certificate, as adit certificates makes it: clients must have "
                 "one of the same authority, or know the secret");
  app.add_flag(
      "--insecure", options.insecure,
      "allow a HOST beyond loopback without TLS: anyone on the way can read and change what is sent");
  app.add_option("--secret-file", secret_file,
                 "file whose first line clients must know; only its owner may read it");
  app.add_option(
      "--exit-with-parent", parent,
      "id of the process that starts this one: end by SIGUSR1 or with it, not by SIGINT or SIGTERM");
  app.add_flag(
      "--private", in_private,
      "listen at a Unix socket in a folder that only this user can enter; where none can be made, at "
      "--listen");
  if (threads)
    app.add_option("--threads", *threads, "threads that share the computing; 0: as many as speed it up")
        ->check(CLI::Range(std::size_t{0}, kMostThreads))
        ->capture_default_str();
  app.add_option("--log-level", log_level, "least severity of the log on stderr")
      ->check(CLI::IsMember({"debug", "info", "warn", "error", "off"}))
      ->capture_default_str();
  add_log_format(app, log_format);
  app.add_option("--adopt", options.adopt)->group("");  // not for the user: begin_anew.hpp
  app.set_version_flag("--version", options.program + " " + std::string(release()));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kSuccess : kUserError;
  }

  if (options.adopt >= 0) options.command.resize(options.command.size() - 2);
  begin_server_log(options.program, log_level, log_format == "json");
  try {
    options.listen = parse_address(listen);
    if (parent > 0) {
      options.stop_signals = {kOwnerSignal};
      if (!exit_with(parent)) return kSuccess;
    }
    std::optional<PrivateFolder> folder;
    if (in_private && options.adopt < 0) folder.emplace();
    if (folder && !folder->path().empty()) options.listen.path = folder->path() / options.program;
    options.secret = own_secret(secret_file);
    if (!tls_folder.empty() && !options.listen.path.empty())
      throw UserError("", listen + " does not leave this machine, and --tls is for others: leave it out");
    if (!tls_folder.empty()) options.tls.emplace(tls_folder, End::kServer, !options.secret.empty());
    return serve(options, make_participant);
  } catch (const UserError& error) {
    tell(Severity::kError, options.program + ": ", error.what());
    return kUserError;
  } catch (const std::exception& error) {
    if (const auto refusal = refusal_of(error)) {
      tell(Severity::kError, options.program + ": ", refusal->message);
      return refusal->code;
    }
    tell(Severity::kError, options.program + ": internal error: ", error.what());
    return kInternalError;
  }
}

}  // namespace adit::protocol
