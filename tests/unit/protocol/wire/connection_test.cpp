#include "protocol/wire/connection.hpp"
#include "protocol/release.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <ctime>
#include <thread>

#include "tests/unit/protocol/wire/frames.hpp"
#include "tests/unit/protocol/wire/loopback.hpp"

namespace adit::protocol::connection_test {
namespace {

using namespace std::chrono_literals;
using testing::AllOf;
using testing::HasSubstr;
using testing::MatchesRegex;

constexpr Patience kShort{.silence = 200ms,
                          .answer = 2s,
                          .connect = 300ms,
                          .heartbeat = 40ms,
                          .first_request = 300ms,
                          .frame = 300ms,
                          .farewell = 100ms};

double seconds_of(const auto& action) {
  const auto start = std::chrono::steady_clock::now();
  action();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST(Connection, CarriesFramesOfAnySizeBothWays) {
  ConnectionPair pair;
  std::thread echo([&] {
    wire::Frame frame;
    for (int i = 0; i < 6; ++i) {
      pair.far.receive(frame);
      pair.far.send(frame);
    }
  });
  wire::Frame back;
  for (const int values : {0, 1, 10, 1000, 100000, 1000000}) {
    const auto sent = predicted(static_cast<std::uint64_t>(values), values);
    pair.near.send(sent);
    pair.near.receive(back);
    EXPECT_EQ(back.SerializeAsString(), sent.SerializeAsString());
  }
  echo.join();
  EXPECT_EQ(pair.near.traffic().bytes_received, pair.far.traffic().bytes_sent);
  EXPECT_GT(pair.near.traffic().bytes_sent, 8u * 1101011u);
  EXPECT_GT(pair.near.traffic().seconds_waited, 0);
}

double cpu_seconds() {
  timespec time;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// Whoever waits for long leaves the processor to others: no less after thousands of waits, on a socket that
// once had no room for a frame.
TEST(Connection, WaitsAsleep) {
  constexpr int kMeasured = 100, kBetween = 5000;
  ConnectionPair pair;
  std::thread slow([&] {
    wire::Frame frame;
    std::this_thread::sleep_for(50ms);
    pair.far.receive(frame);
    const auto answer = [&pair](int times, std::chrono::microseconds after) {
      for (int i = 0; i < times; ++i) {
        std::this_thread::sleep_for(after);
        pair.far.send(predicted(1, 10));
      }
    };
    answer(kMeasured, 3ms);
    answer(kBetween, 550us);  // longer than an end spins
    answer(kMeasured, 3ms);
  });
  wire::Frame back;
  const auto cost_of_waits = [&](int times) {
    const double before = cpu_seconds();
    for (int i = 0; i < times; ++i) pair.near.receive(back);
    return cpu_seconds() - before;
  };
  pair.near.send(predicted(1, 1000000));  // 8 MB
  const double at_first = cost_of_waits(kMeasured);
  cost_of_waits(kBetween);
  EXPECT_LT(cost_of_waits(kMeasured), 1.3 * at_first);
  slow.join();
}

// A silent peer is named, with the time for which it was silent, when that time has passed.
TEST(Connection, SilenceEndsInPeerLost) {
  SocketPair sockets;
  Connection connection(std::move(sockets.near), "dem_server", kShort);
  wire::Frame frame;
  const double waited = seconds_of([&] {
    EXPECT_THAT(message_of<PeerLost>([&] { connection.receive(frame); }),
                MatchesRegex("dem_server at 127.0.0.1:[0-9]+: no sign of life for 0.2 s"));
  });
  EXPECT_GE(waited, 0.2);
  EXPECT_LT(waited, 1.5);
}

// A peer that computes for longer than the permitted silence is kept alive by its heartbeats.
TEST(Connection, HeartbeatsKeepASlowAnswerAlive) {
  ConnectionPair pair(kShort, kShort);
  std::thread slow([&] {
    std::this_thread::sleep_for(3 * kShort.silence);
    pair.far.send(predicted(3, 10));
  });
  wire::Frame frame;
  EXPECT_NO_THROW(pair.near.receive(frame));
  EXPECT_EQ(frame.predicted().step(), 3u);
  slow.join();
}

// Who waits may look at what the other end told, from another thread, until the answer is there.
TEST(Connection, HeartbeatsTellHowFarTheOtherEndIs) {
  ConnectionPair pair(kShort, kShort);
  pair.far.tell_progress("step 3 of 20");
  std::string while_waiting;
  std::thread other([&] {
    std::this_thread::sleep_for(3 * kShort.heartbeat);
    while_waiting = pair.near.progress_of_peer();
    pair.far.send(predicted(3, 10));
  });
  wire::Frame frame;
  pair.near.receive(frame);
  other.join();
  EXPECT_EQ(while_waiting, "step 3 of 20");
  EXPECT_EQ(pair.near.progress_of_peer(), "");
}

// A client that has stopped does not keep a server for the whole of a packing; one that beats does.
TEST(Connection, APeerThatIsSilentWhileThisEndWorksIsLost) {
  const auto work = [](Connection& connection) {
    const auto end = std::chrono::steady_clock::now() + 3 * kShort.silence;
    while (std::chrono::steady_clock::now() < end) {
      connection.tell_progress("growing");
      std::this_thread::sleep_for(10ms);
    }
  };
  SocketPair sockets;
  Connection stopped(std::move(sockets.near), "coupler", kShort);
  EXPECT_THAT(message_of<PeerLost>([&] { work(stopped); }), HasSubstr("sent nothing for"));
  ConnectionPair pair(kShort, kShort);
  EXPECT_NO_THROW(work(pair.far));
}

// Heartbeats do not prolong a wait for ever.
TEST(Connection, AnAnswerThatNeverComesEndsInPeerLostDespiteHeartbeats) {
  ConnectionPair pair(kShort, kShort);
  wire::Frame frame;
  const double waited = seconds_of([&] {
    EXPECT_THAT(message_of<PeerLost>([&] { pair.near.receive(frame, 500ms); }),
                HasSubstr("no answer within 0.5 s"));
  });
  EXPECT_GE(waited, 0.5);
  EXPECT_LT(waited, 1.8);
}

// A peer that neither reads nor shows a sign of life does not block the sender for ever.
TEST(Connection, SendingToAPeerThatDoesNotReadEndsInPeerLost) {
  SocketPair sockets;
  Connection connection(std::move(sockets.near), "dem_server", kShort);
  connection.establish(hello_without_parts());
  const auto large = predicted(1, 2000000);
  const double waited = seconds_of([&] {
    EXPECT_THAT(message_of<PeerLost>([&] { connection.send(large); }), HasSubstr("no sign of life"));
  });
  EXPECT_LT(waited, 1.8);
}

// A peer that is busy, but alive, may take its time to read. A second, because a sanitizer takes its own to
// write and read so large a frame.
TEST(Connection, SendingWaitsForAPeerThatIsAlive) {
  Patience patience = kShort;
  patience.silence = 1s;
  patience.answer = 10s;
  ConnectionPair pair(patience, patience);
  const auto large = predicted(1, 2000000);
  wire::Frame received;
  std::thread busy([&] {
    std::this_thread::sleep_for(2 * patience.silence);
    pair.far.receive(received);
  });
  EXPECT_NO_THROW(pair.near.send(large));
  busy.join();
  EXPECT_EQ(received.predicted().velocities_size(), 2000000);
}

// Frames of the owner and heartbeats of the background thread never mix: heartbeats at the highest pace.
TEST(Connection, HeartbeatsNeverInterleaveWithFrames) {
  Patience busy;
  busy.heartbeat = 2ms;
  ConnectionPair pair(busy, busy);
  std::thread sender([&] {
    for (int i = 0; i < 300; ++i) {
      pair.far.send(predicted(static_cast<std::uint64_t>(i), 5000));
      if (i % 10 == 0) std::this_thread::sleep_for(3ms);
    }
  });
  wire::Frame frame;
  for (int i = 0; i < 300; ++i) {
    pair.near.receive(frame);
    ASSERT_EQ(frame.predicted().step(), static_cast<std::uint64_t>(i));
    ASSERT_EQ(frame.predicted().velocities_size(), 5000);
  }
  sender.join();
}

TEST(Connection, AClosedConnectionIsPeerLost) {
  ConnectionPair pair;
  std::thread other([&] { pair.far.close(); });
  wire::Frame frame;
  EXPECT_THAT(message_of<PeerLost>([&] { pair.near.receive(frame); }), HasSubstr("closed the connection"));
  pair.near.close();
  other.join();
}

// What a peer said before it went is the cause that is reported, also to one who was sending.
TEST(Connection, ThePeersLastWordIsHeardBySenders) {
  SocketPair sockets;
  Connection connection(std::move(sockets.near), "dem_server", {});
  wire::Frame error;
  error.mutable_error()->set_kind(wire::Error::SCENE);
  error.mutable_error()->set_path("particles.radius");
  error.mutable_error()->set_message("must be positive");
  write_frame(sockets.far, error);
  sockets.far.close();
  const auto frame = predicted(1, 10);
  EXPECT_THAT(message_of<UserError>([&] {
                for (int i = 0; i < 1000; ++i) {
                  connection.send(frame);
                  std::this_thread::sleep_for(1ms);
                }
              }),
              HasSubstr("must be positive"));
}

TEST(Connection, InterruptWakesWhoeverWaits) {
  ConnectionPair pair;
  std::thread other([&] {
    std::this_thread::sleep_for(50ms);
    pair.near.interrupt();
  });
  wire::Frame frame;
  EXPECT_LT(seconds_of([&] { EXPECT_THROW(pair.near.receive(frame), PeerLost); }), 5.0);
  other.join();
}

// What the other end was told before it was dropped.
std::string told(tcp::socket& socket) {
  std::vector<std::byte> bytes(1000);
  boost::system::error_code end;
  const std::size_t count = boost::asio::read(socket, boost::asio::buffer(bytes), end);
  FrameDecoder decoder;
  std::ranges::copy(std::span(bytes).first(count), decoder.space().begin());
  decoder.arrived(count);
  wire::Frame frame;
  return decoder.take(frame) ? frame.error().message() : "nothing";
}

// Both users learn what was wrong: the one who read it, and the one whose program sent it.
TEST(Connection, BytesThatAreNoFrameArePeerLost) {
  SocketPair sockets;
  Connection connection(std::move(sockets.near), "dem_server", kShort);
  write_raw(sockets.far, std::as_bytes(std::span("\x03\0\0\0abc", 7)));
  wire::Frame frame;
  EXPECT_THAT(message_of<PeerLost>([&] { connection.receive(frame); }),
              AllOf(HasSubstr("dem_server at"), HasSubstr("not a frame of this protocol")));
  EXPECT_THAT(told(sockets.far), HasSubstr("sent 3 bytes that are not a frame of this protocol"));
}

TEST(Connection, AFrameAboveTheLimitOfThePhaseIsPeerLost) {
  SocketPair sockets;
  Connection connection(std::move(sockets.near), "dem_server", kShort);
  connection.accept_up_to(100);
  write_frame(sockets.far, predicted(1, 20));
  wire::Frame frame;
  EXPECT_THAT(message_of<PeerLost>([&] { connection.receive(frame); }), HasSubstr("at most 100 are allowed"));
  EXPECT_THAT(told(sockets.far), HasSubstr("at most 100 are allowed"));
}

// A byte now and then is a sign of life, but the whole frame has a deadline.
TEST(Connection, AFrameThatComesByteByByteEndsInPeerLost) {
  SocketPair sockets;
  Connection connection(std::move(sockets.near), "dem_server", kShort);
  std::atomic<bool> lost = false;
  std::thread slow([&] {
    write_raw(sockets.far, std::as_bytes(std::span("\xff\0\0\0", 4)));
    while (!lost) {
      boost::system::error_code ignored;
      boost::asio::write(sockets.far, boost::asio::buffer("a", 1), ignored);
      std::this_thread::sleep_for(20ms);
    }
  });
  wire::Frame frame;
  const double waited = seconds_of([&] {
    EXPECT_THAT(message_of<PeerLost>([&] { connection.receive(frame); }),
                HasSubstr("sent a frame more slowly than 256 KiB/s after the first 0.3 s"));
  });
  lost = true;
  slow.join();
  EXPECT_GE(waited, 0.3);
  EXPECT_LT(waited, 1.5);
}

// A peer that takes a frame byte by byte, and beats, is waited for as long as for an answer, not for ever.
TEST(Connection, AFrameThatIsReadSlowlyEndsInPeerLost) {
  ConnectionPair pair(kShort, kShort);
  const auto large = predicted(1, 2000000);
  std::thread sender([&] {
    EXPECT_THAT(message_of<PeerLost>([&] { pair.near.send(large, 700ms); }),
                HasSubstr("did not read what was sent to it"));
  });
  sender.join();
}

// Text of a peer that would forge a line of a log or change a terminal arrives without it.
TEST(Connection, TextArrivesOnOneLineAndWithoutControlCharacters) {
  ConnectionPair pair;
  wire::Frame frame;
  frame.mutable_model()->add_notes("fine\n[error] forged \x1b]0;title\x07");
  pair.far.send(frame);
  pair.near.receive(frame);
  EXPECT_EQ(frame.model().notes(0), "fine [error] forged  ]0;title ");
  frame.mutable_error()->set_message("one\ntwo");
  pair.far.send(frame);
  EXPECT_THAT(message_of<PeerLost>([&] { pair.near.receive(frame); }), HasSubstr("one two"));
}

// Who computes does not read; it is told within an interval of heartbeats that the peer has closed.
TEST(Connection, TellsWhoComputesThatThePeerHasGone) {
  SocketPair sockets;
  Connection connection(std::move(sockets.near), "client", kShort);
  std::atomic<bool> gone = false;
  connection.when_gone([&] { gone = true; });
  connection.establish(hello_without_parts());
  std::this_thread::sleep_for(3 * kShort.heartbeat);
  EXPECT_FALSE(gone);
  sockets.far.close();
  std::this_thread::sleep_for(5 * kShort.heartbeat);
  EXPECT_TRUE(gone);
}

wire::Frame error_frame(wire::Error::Kind kind) {
  wire::Frame frame;
  frame.mutable_error()->set_kind(kind);
  frame.mutable_error()->set_path("time.dt");
  frame.mutable_error()->set_message("the reason");
  return frame;
}

// Any thread may end the traffic, also while the owner closes the connection: neither sees the socket half
// closed, nor ends a later one of its number (what the thread sanitizer looks for).
TEST(Connection, IsInterruptedWhileItsOwnerClosesIt) {
  for (int i = 0; i < 20; ++i) {
    ConnectionPair pair;
    std::thread other([&] { pair.near.interrupt(); });
    pair.near.close();
    other.join();
  }
}

// Each kind of error frame is thrown as the exception that it stands for.
TEST(Connection, ErrorFramesAreThrown) {
  ConnectionPair pair;
  wire::Frame frame;
  pair.far.send(error_frame(wire::Error::SCENE));
  try {
    pair.near.receive(frame);
    ADD_FAILURE() << "no error";
  } catch (const UserError& error) {
    EXPECT_EQ(error.path(), "time.dt");
    EXPECT_STREQ(error.what(), "the reason");
  }
  pair.far.send(error_frame(wire::Error::UNSTABLE));
  EXPECT_THAT(message_of<Unstable>([&] { pair.near.receive(frame); }), HasSubstr("the reason"));
  pair.far.send(error_frame(wire::Error::REFUSED));
  EXPECT_THAT(message_of<UserError>([&] { pair.near.receive(frame); }),
              AllOf(HasSubstr("dem_server at 127.0.0.1"), HasSubstr("refused: the reason")));
  pair.far.send(error_frame(wire::Error::INTERNAL));
  EXPECT_THAT(message_of<PeerLost>([&] { pair.near.receive(frame); }), HasSubstr("the reason"));
}

TEST(Handshake, TellsEachEndWhoTheOtherIs) {
  SocketPair sockets;
  Connection near(std::move(sockets.near), "dem_server", {});
  Connection far(std::move(sockets.far), "client", {});
  wire::Hello of_near;
  std::thread other([&] { of_near = handshake(far, "dem_server"); });
  const auto of_far = handshake(near, "coupler");
  other.join();
  EXPECT_EQ(of_far.program(), "dem_server");
  EXPECT_EQ(of_near.program(), "coupler");
  EXPECT_EQ(of_near.max_frame_bytes(), kMaxFrameBytes);
  EXPECT_EQ(of_far.release(), release());
}

// Older and newer versions are refused alike; the message names both programs and both versions.
TEST(Handshake, AnotherProtocolVersionIsAUserError) {
  for (const std::uint32_t version : {0u, kProtocolVersion - 1, kProtocolVersion + 1, 7u}) {
    SocketPair sockets;
    Connection connection(std::move(sockets.near), "dem_server", kShort);
    wire::Frame hello;
    hello.mutable_hello()->set_protocol_version(version);
    hello.mutable_hello()->set_program("dem_server");
    hello.mutable_hello()->set_release("9.9.9");
    write_raw(sockets.far, encode_preamble(version));
    write_frame(sockets.far, hello);
    EXPECT_THAT(message_of<UserError>([&] { handshake(connection, "coupler"); }),
                AllOf(HasSubstr("dem_server 9.9.9"), HasSubstr("protocol version " + std::to_string(version)),
                      HasSubstr("coupler " + std::string(release())),
                      HasSubstr("speaks version " + std::to_string(kProtocolVersion))));
  }
}

// A right preamble does not excuse a hello of another version.
TEST(Handshake, TheVersionOfHelloCountsToo) {
  SocketPair sockets;
  Connection connection(std::move(sockets.near), "dem_server", kShort);
  wire::Frame hello;
  hello.mutable_hello()->set_protocol_version(99);
  hello.mutable_hello()->set_program("dem_server");
  write_raw(sockets.far, encode_preamble());
  write_frame(sockets.far, hello);
  EXPECT_THAT(message_of<UserError>([&] { handshake(connection, "coupler"); }),
              HasSubstr("speaks protocol version 99"));
}

// Errors call another code by its own name, not by that of the server whose place it takes.
TEST(Handshake, APeerIsCalledAsItSays) {
  SocketPair sockets;
  Connection connection(std::move(sockets.near), "fdm_server", kShort);
  Connection far(std::move(sockets.far), "coupler", kShort);
  std::thread other([&] { handshake(far, "my\ncode"); });
  handshake(connection, "coupler");
  other.join();
  EXPECT_THAT(connection.peer(), MatchesRegex("my code at 127.0.0.1:[0-9]+"));
}

TEST(Handshake, AnotherProgramIsAUserError) {
  SocketPair sockets;
  Connection connection(std::move(sockets.near), "dem_server", kShort);
  write_raw(sockets.far, std::as_bytes(std::span("SSH-2.0-OpenSSH_9.2p1\r\n", 23)));
  EXPECT_THAT(message_of<UserError>([&] { handshake(connection, "coupler"); }),
              AllOf(HasSubstr("dem_server at 127.0.0.1"), HasSubstr("does not speak the Adit protocol"),
                    HasSubstr("check host and port")));
}

// A peer may reset the connection before this end has sent its hello: what came of its preamble is no frame,
// and what came behind it says why.
TEST(Handshake, APeerThatIsGoneBeforeHelloIsUnderstood) {
  const auto reset_after = [](std::span<const std::byte> bytes) {
    SocketPair sockets;
    Connection connection(std::move(sockets.near), "dem_server", kShort);
    write_raw(sockets.far, bytes);
    sockets.far.set_option(boost::asio::socket_base::linger(true, 0));
    sockets.far.close();
    handshake(connection, "coupler");
  };
  const Preamble preamble = encode_preamble();
  EXPECT_THAT(message_of<PeerLost>([&] { reset_after(std::span(preamble).first(4)); }),
              HasSubstr("the connection broke"));
  EXPECT_THAT(message_of<UserError>([&] { reset_after(std::as_bytes(std::span("HTTP/1.1 400 ", 13))); }),
              HasSubstr("does not speak the Adit protocol"));
  FrameEncoder encoder;
  const auto error = encoder.encode(error_frame(wire::Error::REFUSED), kMaxFrameBytes);
  std::vector<std::byte> refusal(preamble.begin(), preamble.end());
  refusal.insert(refusal.end(), error.begin(), error.end());
  EXPECT_THAT(message_of<UserError>([&] { reset_after(refusal); }), HasSubstr("refused: the reason"));
}

// Before hello nobody can make us hold more than 64 KiB.
TEST(Handshake, AHelloAboveTheLimitIsRefused) {
  SocketPair sockets;
  Connection connection(std::move(sockets.near), "dem_server", kShort);
  write_raw(sockets.far, encode_preamble());
  write_raw(sockets.far, std::as_bytes(std::span("\x01\0\x01\0", 4)));
  EXPECT_THAT(message_of<PeerLost>([&] { handshake(connection, "coupler"); }), HasSubstr("65537 bytes"));
}

TEST(Connect, NothingListensIsAUserError) {
  Address address{"127.0.0.1", 0};
  {
    boost::asio::io_context io;
    tcp::acceptor acceptor(io, tcp::endpoint(boost::asio::ip::address_v4::loopback(), 0));
    address.port = acceptor.local_endpoint().port();
  }
  EXPECT_THAT(message_of<UserError>([&] { connect(address, "dem_server", kShort); }),
              AllOf(HasSubstr("nothing listens at " + to_string(address)),
                    HasSubstr("dem_server there with --listen")));
}

TEST(Address, IsAPathOfThisMachine) {
  EXPECT_EQ(parse_address("unix:/run/adit/fdm").path, "/run/adit/fdm");
  EXPECT_EQ(to_string(parse_address("unix:/run/adit/fdm")), "unix:/run/adit/fdm");
  EXPECT_NO_THROW(parse_address("unix:/" + std::string(106, 'x')));
  for (const std::string& text : {std::string("unix:"), "unix:/" + std::string(107, 'x')})
    EXPECT_THAT(message_of<UserError>([&] { parse_address(text); }), HasSubstr("write unix:PATH"));
}

TEST(Address, IsAHostAndAPort) {
  EXPECT_EQ(to_string(parse_address("127.0.0.1:4711")), "127.0.0.1:4711");
  EXPECT_EQ(parse_address("[::1]:0").host, "::1");
  EXPECT_EQ(to_string(parse_address("[::1]:80")), "[::1]:80");
  for (const char* text : {"", "localhost", "localhost:", ":80", "a:65536", "a:-1", "a:80x", "::1:80"}) {
    EXPECT_THAT(message_of<UserError>([&] { parse_address(text); }), HasSubstr("write HOST:PORT")) << text;
  }
}

}  // namespace
}  // namespace adit::protocol::connection_test
