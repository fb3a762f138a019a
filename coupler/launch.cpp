#include "coupler/launch.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/process.hpp>
#include <chrono>
#include <csignal>
#include <thread>

#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

namespace process = boost::process;
using protocol::PeerLost;

constexpr std::chrono::seconds kStartPatience{10};
constexpr std::chrono::seconds kStopPatience{3};  // a server ends within 2 s of the signal by itself

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

// The first line that the server prints: `listening on HOST:PORT`.
std::string first_line(boost::asio::io_context& io, process::async_pipe& pipe) {
  std::string text;
  bool complete = false;
  boost::asio::async_read_until(
      pipe, boost::asio::dynamic_buffer(text, 1024), '\n',
      [&](const boost::system::error_code& error, std::size_t) { complete = !error; });
  io.run_for(kStartPatience);
  return complete ? text.substr(0, text.find('\n')) : std::string();
}

}  // namespace

struct ServerProcess::Child {
  boost::asio::io_context io;
  process::async_pipe output{io};
  process::child process;
};

ServerProcess::ServerProcess(const std::string& program, const std::filesystem::path& log,
                             std::vector<std::string> options)
    : child_(std::make_unique<Child>()) {
  const auto path = find_program(program);
  options.insert(options.end(), {"--listen", "127.0.0.1:0", "--exit-with-parent"});
  child_->process = process::child(process::exe = path.string(), process::args = options,
                                   process::std_in<process::null, process::std_out> child_->output,
                                   process::std_err > log.string());
  const std::string greeting = "listening on ";
  const std::string line = first_line(child_->io, child_->output);
  if (!line.starts_with(greeting)) {
    std::error_code ignored;
    const bool alive = child_->process.running(ignored);
    child_->process.terminate(ignored);
    throw PeerLost(program,
                   (alive ? "did not start listening within " + std::to_string(kStartPatience.count()) + " s"
                          : "ended with exit code " + std::to_string(child_->process.exit_code())) +
                       "; its log is " + log.string());
  }
  address_ = protocol::parse_address(line.substr(greeting.size()));
}

ServerProcess::~ServerProcess() {
  std::error_code ignored;
  if (!child_->process.running(ignored)) return;
  ::kill(child_->process.id(), SIGTERM);
  // Polling, because wait_for() of Boost 1.74 misses the end of a child and waits for the whole time.
  const auto limit = std::chrono::steady_clock::now() + kStopPatience;
  while (child_->process.running(ignored) && std::chrono::steady_clock::now() < limit)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  if (child_->process.running(ignored)) child_->process.terminate(ignored);
}

}  // namespace adit::coupler
