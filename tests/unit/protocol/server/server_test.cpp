#include "protocol/server/server.hpp"

#include <gmock/gmock.h>
#include <signal.h>

#include <boost/process.hpp>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "tests/unit/protocol/wire/loopback.hpp"

namespace adit::protocol::server_test {
namespace {

namespace process = boost::process;
using namespace std::chrono_literals;
using testing::AllOf;
using testing::HasSubstr;

// -1: still running.
int exit_code_within(process::child& child, std::chrono::milliseconds time) {
  const auto deadline = std::chrono::steady_clock::now() + time;
  while (child.running()) {
    if (std::chrono::steady_clock::now() > deadline) return -1;
    std::this_thread::sleep_for(2ms);
  }
  return child.exit_code();
}

// The program scripted_server, listening on a free port.
class Server {
 public:
  explicit Server(const std::vector<std::string>& arguments = {})
      : child_(SCRIPTED_SERVER, "--log-level", "off", process::args(arguments), process::std_out > output_) {
    std::string line;
    std::getline(output_, line);
    const std::string expected = "listening on ";
    if (line.rfind(expected, 0) != 0) throw std::runtime_error("the server said: " + line);
    address_ = parse_address(line.substr(expected.size()));
  }
  ~Server() { child_.terminate(); }

  const Address& address() const { return address_; }
  void signal(int number) { ::kill(child_.id(), number); }
  int exit_code_within(std::chrono::milliseconds time) { return server_test::exit_code_within(child_, time); }
  std::string rest_of_output() {
    std::string rest;
    std::getline(output_, rest, '\0');
    return rest;
  }

 private:
  process::ipstream output_;
  process::child child_;
  Address address_;
};

// A coupler, as far as the server can tell.
class Client {
 public:
  explicit Client(const Server& server, const std::string& secret = "")
      : connection_(connect(server.address(), "scripted_server")) {
    handshake(*connection_, "coupler", End::kClient, secret);
  }
  const wire::Frame& ask(const wire::Frame& request) {
    connection_->send(request);
    connection_->receive(reply_);
    return reply_;
  }
  const wire::Frame& set_up(const std::string& run_id) {
    wire::Frame request;
    request.mutable_setup()->set_run_id(run_id);
    request.mutable_setup()->mutable_scene()->mutable_time()->set_duration(1);
    return ask(request);
  }
  // Goes away while the server computes.
  void leave_computing() {
    std::thread leaving([&] {
      std::this_thread::sleep_for(100ms);
      connection_->interrupt();
    });
    try {
      set_up("compute for ever");
    } catch (...) {
      leaving.join();
      throw;
    }
  }
  void wait() { connection_->receive(reply_); }
  const wire::Frame& advance(std::uint64_t step) {
    wire::Frame request;
    request.mutable_advance()->set_step(step);
    return ask(request);
  }
  std::uint64_t finish() {
    wire::Frame request;
    request.mutable_finish();
    return ask(request).bye().updates();
  }

 private:
  std::unique_ptr<Connection> connection_;
  wire::Frame reply_;
};

// The server notices a client's end when it reads, so one who comes at once may still find it busy, or, where
// it was computing, be cut off in the moment in which it begins anew. The deadline tells "soon" from the hour
// of a computation, and leaves a busy machine its time.
std::uint64_t serve_soon(const Server& server) {
  const auto deadline = std::chrono::steady_clock::now() + 60s;
  while (true) {
    try {
      Client client(server);
      client.set_up("next");
      return client.finish();
    } catch (const std::exception&) {
      if (std::chrono::steady_clock::now() > deadline) throw;
      std::this_thread::sleep_for(1ms);
    }
  }
}

// A client may come back the moment it has its bye: it is never told that the server is busy with itself.
TEST(Server, ServesOneRunAfterAnother) {
  const Server server;
  for (int run = 0; run < 50; ++run) {
    Client client(server);
    EXPECT_EQ(client.set_up("run " + std::to_string(run)).model().critical_dt(), 0.25);
    EXPECT_EQ(client.finish(), 42u);
  }
}

TEST(Server, RefusesASecondClientAtOnceAndNamesTheRun) {
  const Server server;
  Client first(server);
  first.set_up("cantilever-7");
  EXPECT_THAT(message_of<UserError>([&] { Client(server).set_up("second"); }),
              AllOf(HasSubstr("scripted_server at 127.0.0.1"), HasSubstr("busy with run cantilever-7")));
  EXPECT_EQ(first.finish(), 42u);
}

// A killed client leaves its sockets closed without a word; so does this one.
TEST(Server, GoesOnAfterALostClient) {
  const Server server;
  {
    Client lost(server);
    lost.set_up("lost");
  }
  EXPECT_EQ(serve_soon(server), 42u);
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// A packing may take hours: a server does not go on with it for a client who has left, also when that happens
// again, and it stays the same process at the same address.
TEST(Server, LeavesAComputationWhoseClientHasGone) {
  Server server;
  for (int run = 0; run < 2; ++run) {
    EXPECT_THROW(Client(server).leave_computing(), PeerLost);
    EXPECT_EQ(serve_soon(server), 42u);
  }
  server.signal(SIGTERM);
  EXPECT_EQ(server.exit_code_within(5s), 0);
  EXPECT_EQ(server.rest_of_output(), "") << "stdout holds one line";
}

// Heartbeats do not hold a server: after its hello a client has a bounded time for its setup, and is told so.
TEST(Server, DropsAClientThatSendsNoSetup) {
  const Server server;
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THAT(message_of<RequestError>([&] { Client(server).wait(); }), HasSubstr("no answer within 1.5 s"));
  EXPECT_LT(seconds_since(start), 5);
  EXPECT_EQ(serve_soon(server), 42u);
}

// In a run, requests are short; a client that announces more is told how many bytes are allowed.
TEST(Server, RefusesLongFramesInARun) {
  const Server server;
  Client client(server);
  client.set_up("run");
  wire::Frame weights;
  weights.mutable_weights()->mutable_weights()->Resize(static_cast<int>(kMaxRunBytes / sizeof(double)), 1);
  EXPECT_THAT(message_of<RequestError>([&] { client.ask(weights); }),
              HasSubstr("but at most " + std::to_string(kMaxRunBytes) + " are allowed"));
  EXPECT_EQ(serve_soon(server), 42u);
}

TEST(Server, ReportsErrorsOfTheParticipantAndGoesOn) {
  const Server server;
  try {
    Client(server).set_up("scene error");
    ADD_FAILURE() << "no error";
  } catch (const UserError& error) {
    EXPECT_EQ(error.path(), "particles.radius");
    EXPECT_STREQ(error.what(), "must be positive");
  }
  EXPECT_THAT(message_of<Unstable>([&] { Client(server).set_up("unstable"); }), HasSubstr("not finite"));
  EXPECT_THAT(message_of<PeerLost>([&] { Client(server).set_up("bug"); }), HasSubstr("a bug"));
  EXPECT_EQ(serve_soon(server), 42u);
}

// The rest of a step is computed while the client has its answer already, and takes no part of the next one.
TEST(Server, SendsTheAnswerBeforeItCompletesTheStep) {
  const Server server;
  Client client(server);
  client.set_up("slow rest");
  wire::Frame weights;
  weights.mutable_weights();
  client.ask(weights);
  const auto start = std::chrono::steady_clock::now();
  client.advance(0);
  EXPECT_LT(std::chrono::steady_clock::now() - start, 950ms);
  const auto& second = client.advance(1).predicted();
  EXPECT_GE(second.hidden_seconds(), 1);
  EXPECT_LT(second.compute_seconds(), 0.95);
}

// What goes wrong after an answer reaches the client as the answer to its next request.
TEST(Server, ReportsErrorsOfTheRestOfAStep) {
  const Server server;
  Client client(server);
  client.set_up("unstable rest");
  wire::Frame weights;
  weights.mutable_weights();
  client.ask(weights);
  EXPECT_TRUE(client.advance(0).has_predicted());
  std::this_thread::sleep_for(50ms);
  EXPECT_THAT(message_of<Unstable>([&] { client.finish(); }), HasSubstr("the rest is not finite"));
  EXPECT_EQ(serve_soon(server), 42u);
}

TEST(Server, ReportsARequestOutOfOrder) {
  const Server server;
  Client client(server);
  EXPECT_THAT(message_of<RequestError>([&] { client.finish(); }), HasSubstr("request out of order: finish"));
}

tcp::socket stranger_at(const Server& server, boost::asio::io_context& io) {
  tcp::socket stranger(io);
  stranger.connect({boost::asio::ip::make_address(server.address().host), server.address().port});
  return stranger;
}

TEST(Server, SurvivesAClientThatSpeaksAnotherProtocol) {
  const Server server;
  boost::asio::io_context io;
  tcp::socket stranger = stranger_at(server, io);
  write_raw(stranger, std::as_bytes(std::span("GET / HTTP/1.1\r\n\r\n", 18)));
  EXPECT_EQ(serve_soon(server), 42u);
}

// SIGTERM and SIGINT end it with exit code 0: while it waits for a client, for a request, and in
// mid-computation.
TEST(Server, EndsPromptlyWhenTold) {
  Server idle;
  idle.signal(SIGTERM);
  EXPECT_EQ(idle.exit_code_within(5s), 0);
  EXPECT_EQ(idle.rest_of_output(), "") << "stdout holds one line";

  Server in_run;
  Client client(in_run);
  client.set_up("run");
  in_run.signal(SIGINT);
  EXPECT_EQ(in_run.exit_code_within(5s), 0);
  EXPECT_THROW(client.finish(), PeerLost);

  Server computing;
  std::thread waiting([&] { EXPECT_THROW(Client(computing).set_up("compute for ever"), PeerLost); });
  std::this_thread::sleep_for(200ms);
  computing.signal(SIGTERM);
  EXPECT_EQ(computing.exit_code_within(8s), 0);
  waiting.join();
}

// Clients that connect and say nothing keep nobody away, however many they are.
TEST(Server, ServesWhoGreetsItWhileOthersAreSilent) {
  const Server server;
  boost::asio::io_context io;
  std::vector<tcp::socket> silent;
  for (int i = 0; i < 100; ++i) silent.push_back(stranger_at(server, io));
  Client client(server);
  client.set_up("run");
  EXPECT_EQ(client.finish(), 42u);
}

// A file of the tests' folder that holds a secret, readable by its owner only.
std::string secret_file(const std::string& name, const std::string& secret,
                        std::filesystem::perms permissions) {
  const std::string path = testing::TempDir() + name;
  std::ofstream(path) << secret << '\n';
  std::filesystem::permissions(path, permissions);
  return path;
}

constexpr auto kOwner = std::filesystem::perms::owner_read | std::filesystem::perms::owner_write;
const std::string kSecret = "a word that both ends know";

TEST(Server, WithASecretServesOnlyWhoKnowsIt) {
  const Server server({"--secret-file", secret_file("known_secret", kSecret, kOwner)});
  EXPECT_THAT(message_of<UserError>([&] { Client without(server); }), HasSubstr("--secret-file"));
  EXPECT_THAT(message_of<UserError>([&] { Client wrong(server, "another word of some length"); }),
              HasSubstr("its secret is another one"));
  Client right(server, kSecret);
  right.set_up("run");
  EXPECT_EQ(right.finish(), 42u);
}

// Who sends a request in the place of the proof gets no answer to it.
TEST(Server, WithASecretAnswersNothingBeforeTheProof) {
  const Server server({"--secret-file", secret_file("asked_secret", kSecret, kOwner)});
  boost::asio::io_context io;
  Connection liar(stranger_at(server, io), "scripted_server", {});
  wire::Frame hello, setup, answer;
  hello.mutable_hello()->set_protocol_version(kProtocolVersion);
  hello.mutable_hello()->set_max_frame_bytes(kMaxFrameBytes);
  hello.mutable_hello()->set_challenge(random_challenge());
  setup.mutable_setup()->set_run_id("stolen");
  liar.send_preamble();
  liar.send(hello);
  liar.send(setup);
  liar.receive_preamble();
  liar.receive(answer);
  EXPECT_TRUE(answer.has_hello());
  EXPECT_THAT(message_of<RequestError>([&] { liar.receive(answer); }),
              HasSubstr("sent setup in the place of a greeting"));
  Client right(server, kSecret);
  right.set_up("run");
  EXPECT_EQ(right.finish(), 42u);
}

// A program that took the port of a server cannot pretend to be it.
TEST(Server, WithoutTheSecretIsNotTrusted) {
  const Server server;
  EXPECT_THAT(message_of<UserError>([&] { Client client(server, kSecret); }), HasSubstr("has no secret"));
}

struct Outcome {
  int exit_code;
  std::string errors;
};

Outcome run_with(const std::vector<std::string>& arguments) {
  process::ipstream errors;
  process::child child(SCRIPTED_SERVER, process::args(arguments), process::std_out > process::null,
                       process::std_err > errors);
  const int exit_code = exit_code_within(child, 5s);
  child.terminate();
  std::string text;
  std::getline(errors, text, '\0');
  return {exit_code, text};
}

TEST(Server, APortInUseIsTheUsersError) {
  const Server first;
  const auto outcome = run_with({"--listen", to_string(first.address())});
  EXPECT_EQ(outcome.exit_code, kUserError);
  EXPECT_THAT(outcome.errors,
              AllOf(HasSubstr("port " + std::to_string(first.address().port)), HasSubstr("is in use")));
}

TEST(Server, ListensBeyondLoopbackOnlyWhenAllowed) {
  const auto outcome = run_with({"--listen", "0.0.0.0:0"});
  EXPECT_EQ(outcome.exit_code, kUserError);
  EXPECT_THAT(outcome.errors,
              AllOf(HasSubstr("could read and change"), HasSubstr("ssh"), HasSubstr("--insecure")));
  const Server server({"--listen", "0.0.0.0:0", "--insecure"});
  EXPECT_EQ(server.address().host, "0.0.0.0");
}

TEST(Server, ASecretThatOthersCanReadOrGuessIsTheUsersError) {
  const auto refused = [](const std::string& file, const std::string& reason) {
    const auto outcome = run_with({"--secret-file", file});
    EXPECT_EQ(outcome.exit_code, kUserError);
    EXPECT_THAT(outcome.errors, AllOf(HasSubstr(file), HasSubstr(reason)));
  };
  refused(secret_file("open_secret", kSecret, kOwner | std::filesystem::perms::group_read), "chmod 600");
  refused(secret_file("short_secret", "guess me", kOwner), "openssl rand -hex 32");
  refused(testing::TempDir() + "no_such_secret", "No such file");
}

TEST(Server, AWrongCommandLineIsTheUsersError) {
  EXPECT_EQ(run_with({"--lisen", "127.0.0.1:0"}).exit_code, kUserError);
  EXPECT_EQ(run_with({"--listen", "nowhere"}).exit_code, kUserError);
  EXPECT_EQ(run_with({"--help"}).exit_code, kSuccess);
  EXPECT_EQ(run_with({"--version"}).exit_code, kSuccess);
}

// A shell starts the server in the background and is killed: the server ends, so its stdout does.
TEST(Server, EndsWithItsParentWhenAsked) {
  process::ipstream output;
  process::child shell("/bin/sh", "-c",
                       std::string(SCRIPTED_SERVER) + " --exit-with-parent $$ --log-level off & wait",
                       process::std_out > output);
  std::string line;
  std::getline(output, line);
  const Address address = parse_address(line.substr(std::string("listening on ").size()));
  EXPECT_NO_THROW(connect(address, "scripted_server"));
  shell.terminate();
  const auto deadline = std::chrono::steady_clock::now() + 5s;
  bool gone = false;
  while (!gone && std::chrono::steady_clock::now() < deadline) {
    try {
      connect(address, "scripted_server");
      std::this_thread::sleep_for(10ms);
    } catch (const UserError&) {
      gone = true;
    }
  }
  EXPECT_TRUE(gone);
}

}  // namespace
}  // namespace adit::protocol::server_test
