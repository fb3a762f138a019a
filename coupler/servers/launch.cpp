#include "coupler/servers/launch.hpp"

#include <fcntl.h>
#include <spdlog/fmt/fmt.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/process.hpp>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <thread>

#include "protocol/errors.hpp"
#include "protocol/log/log.hpp"
#include "protocol/trust/secret.hpp"
#include "protocol/wire/bounds.hpp"
#include "protocol/wire/greeting.hpp"

namespace adit::coupler {
namespace {

namespace process = boost::process;
using protocol::kStartPatience;
using protocol::kStopPatience;
using protocol::PeerLost;

constexpr std::chrono::seconds kEndPatience{1};  // after its output has ended

// The program beside the coupler, as installed, or in its own folder beside the coupler's, as in the build
// tree.
std::filesystem::path find_program(const std::string& program) {
  const auto here = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  for (const auto& candidate : {here / program, here.parent_path() / program / program})
    if (std::filesystem::is_regular_file(candidate)) return candidate;
  throw PeerLost(program, "is found neither in " + here.string() + " nor in " +
                              (here.parent_path() / program).string() +
                              "; install or build it, or start it yourself and give its address");
}

// What the program writes to standard error, as a file that it may write and this program may read.
using Log = std::unique_ptr<std::FILE, decltype(&std::fclose)>;

// A file without a name where no path is given.
Log open_log(const std::filesystem::path& path) {
  const int file = path.empty()
                       ? ::memfd_create("log", MFD_CLOEXEC)
                       : ::open(path.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0644);
  if (file >= 0) return {::fdopen(file, "r+"), &std::fclose};
  throw protocol::UserError("", "the log " + path.string() + " cannot be written: " +
                                    (errno == ELOOP ? "it is a link, which is not followed; remove it"
                                                    : std::generic_category().message(errno)));
}

std::string last_line(std::FILE* log) {
  std::string text(4096, '\0');
  const off_t size = ::lseek(::fileno(log), 0, SEEK_END), begin = std::max<off_t>(0, size - 4096);
  text.resize(static_cast<std::size_t>(
      std::max<ssize_t>(0, ::pread(::fileno(log), text.data(), text.size(), begin))));
  text.erase(text.find_last_not_of('\n') + 1);
  return text.substr(text.find_last_of('\n') + 1);
}

// The first line that the server prints: `listening on ADDRESS`; empty where it ends before, or takes too
// long.
std::string first_line(boost::asio::io_context& io, process::async_pipe& pipe) {
  std::string text;
  bool complete = false;
  boost::asio::async_read_until(
      pipe, boost::asio::dynamic_buffer(text, 1024), '\n',
      [&](const boost::system::error_code& error, std::size_t) { complete = !error; });
  io.run_for(kStartPatience);
  return complete ? text.substr(0, text.find('\n')) : std::string();
}

// Whether it ended within the time. Polling, because wait_for() of Boost 1.74 misses the end of a child and
// waits for the whole time.
bool ends_within(process::child& child, std::chrono::milliseconds time) {
  std::error_code ignored;
  const auto limit = std::chrono::steady_clock::now() + time;
  while (child.running(ignored)) {
    if (std::chrono::steady_clock::now() > limit) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

std::string how_it_ended(const process::child& child) {
  const int status = child.native_exit_code();
  return WIFSIGNALED(status)
             ? fmt::format("was ended by signal {} ({})", WTERMSIG(status), ::strsignal(WTERMSIG(status)))
             : fmt::format("ended with exit code {}", child.exit_code());
}

}  // namespace

struct ServerProcess::Child {
  boost::asio::io_context io;
  process::async_pipe output{io};
  process::child process;
};

ServerProcess::ServerProcess(const std::string& program, const std::filesystem::path& log,
                             bool by_unix_socket, std::vector<std::string> options)
    : program_(program), child_(std::make_unique<Child>()), secret_(protocol::random_secret()) {
  const auto path = find_program(program);
  options.insert(options.end(), {"--exit-with-parent", std::to_string(::getpid())});
  if (by_unix_socket) options.emplace_back("--private");
  if (protocol::logs_json()) options.insert(options.end(), {"--log-format", "json"});
  const Log log_file = open_log(log);
  // Servers that are started later would hold this one's pipe open.
  for (const int end : {child_->output.native_source(), child_->output.native_sink()})
    ::fcntl(end, F_SETFD, FD_CLOEXEC);
  process::environment environment = boost::this_process::environment();
  environment[protocol::kSecretVariable] = secret_;
  child_->process = process::child(process::exe = path.string(), process::args = options, environment,
                                   process::std_in<process::null, process::std_out> child_->output,
                                   process::std_err > log_file.get());
  if (!child_->process.valid())  // Boost 1.74 does not tell that no process could be made
    throw std::system_error(errno, std::generic_category(), "cannot start " + program);
  const std::string greeting = "listening on ";
  const std::string line = first_line(child_->io, child_->output);
  if (!line.starts_with(greeting)) {
    // A server whose output has ended is about to end itself.
    const bool ended = ends_within(child_->process, kEndPatience);
    std::error_code ignored;
    child_->process.terminate(ignored);
    const std::string said = last_line(log_file.get());
    throw PeerLost(program,
                   (ended ? how_it_ended(child_->process) + " before it listened"
                          : fmt::format("did not start listening within {} s", kStartPatience.count())) +
                       (said.empty() ? "" : "; the last line of its log: " + said));
  }
  address_ = protocol::parse_address(line.substr(greeting.size()));
}

std::unique_ptr<protocol::Connection> ServerProcess::connect() {
  auto connection = protocol::connect(address_, program_);
  std::error_code ignored;
  if (!address_.path.empty())
    std::filesystem::remove_all(std::filesystem::path(address_.path).parent_path(), ignored);
  return connection;
}

ServerProcess::~ServerProcess() {
  std::error_code ignored;
  if (!child_->process.running(ignored)) return;
  ::kill(child_->process.id(), SIGUSR1);
  if (!ends_within(child_->process, kStopPatience)) child_->process.terminate(ignored);
}

}  // namespace adit::coupler
