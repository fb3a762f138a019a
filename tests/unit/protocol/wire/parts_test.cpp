// Requirement: a message that is longer than a frame may be arrives as it was sent, in frames of bounded
// length, and what bounds a message bounds all of its parts together.
#include "protocol/wire/parts.hpp"

#include <gmock/gmock.h>

#include <string>

#include "protocol/release.hpp"
#include "tests/unit/protocol/wire/frames.hpp"
#include "tests/unit/protocol/wire/loopback.hpp"

namespace adit::protocol::parts_test {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

void fill(google::protobuf::RepeatedField<double>& list, int size, double first) {
  for (int i = 0; i < size; ++i) list.Add(first + i);
}

wire::Frame snapshot(int points) {
  wire::Frame frame;
  for (const std::string name : {"grid", "bonds"}) {
    wire::Piece& piece = *frame.mutable_snapshot()->add_pieces();
    piece.set_name(name);
    piece.set_shape(wire::Piece::LINES);
    fill(*piece.mutable_points(), 2 * points, 0);
    for (int i = 0; i < points; ++i) piece.add_connectivity(static_cast<std::uint32_t>(i));
    for (auto* fields : {piece.mutable_point_fields(), piece.mutable_cell_fields()})
      for (const std::string field : {"velocity_m_per_s", "none", "weight"}) {
        fields->Add()->set_name(field);
        fields->rbegin()->set_components(field == "weight" ? 1 : 2);
        if (field != "none") fill(*fields->rbegin()->mutable_values(), points, 0.5);
      }
  }
  return frame;
}

std::vector<wire::Frame> messages_with_lists() {
  std::vector<wire::Frame> frames(8);
  wire::Model& model = *frames[0].mutable_model();
  model.set_critical_dt(1e-6);
  model.set_engine("lattice");
  for (const char* note : {"one", "two"}) model.add_notes(note);
  fill(*model.mutable_sample_points(), 1001, 0);
  frames[1].mutable_weights()->set_floor(0.01);
  fill(*frames[1].mutable_weights()->mutable_weights(), 100, 0);
  frames[2].mutable_interface()->set_particles(7);
  fill(*frames[2].mutable_interface()->mutable_points(), 100, 0);
  wire::Operator& op = *frames[3].mutable_operator_();
  for (std::uint32_t i = 0; i < 50; ++i) op.add_row_starts(i), op.add_columns(1'000'000 + i);
  fill(*op.mutable_values(), 49, 0);
  fill(*op.mutable_inverse_masses(), 98, 1);
  wire::Predicted& predicted = *frames[4].mutable_predicted();
  predicted.mutable_energies()->set_kinetic(3);
  predicted.mutable_energies()->add_shares()->set_name("friction");
  for (int i = 0; i < 100; ++i) predicted.add_cracks()->set_x(i), predicted.add_histories(i);
  frames[5] = snapshot(40);
  frames[6].mutable_setup()->set_run_id("run");
  frames[6].mutable_setup()->mutable_scene()->set_description(std::string(1000, 'x'));
  frames[7].mutable_couple();
  return frames;
}

// By the bytes of its frames; heartbeats come between parts.
TEST(Parts, AreTogetherTheMessageThatWasSent) {
  for (const wire::Frame& sent : messages_with_lists()) {
    FrameDecoder decoder;
    decoder.accept_parts(kMaxPartBytes);
    FrameEncoder encoder;
    Assembly assembly;
    wire::Frame arrived;
    int parts = 0;
    bool whole = false;
    divide(sent, 64, [&](const wire::Frame& part, bool goes_on) {
      EXPECT_FALSE(whole);
      feed(decoder, heartbeat_frame());
      feed(decoder, encoder.encode(part, kMaxPartBytes, goes_on));
      ASSERT_TRUE(decoder.take(arrived));
      EXPECT_EQ(decoder.goes_on(), goes_on);
      whole = assembly.add(arrived, decoder.goes_on());
      ++parts;
    });
    EXPECT_TRUE(whole);
    EXPECT_GT(parts, 1);
    EXPECT_EQ(arrived.DebugString(), sent.DebugString());
  }
}

TEST(Parts, AreOfOneMessage) {
  Assembly assembly;
  wire::Frame part = predicted(1, 3), other;
  EXPECT_FALSE(assembly.add(part, true));
  other.mutable_model();
  EXPECT_THROW(assembly.add(other, false), Malformed);
}

// Who fails while it sends says so, and what it had sent is forgotten.
TEST(Parts, GiveWayToAnError) {
  Assembly assembly;
  wire::Frame part = predicted(1, 3), error;
  EXPECT_FALSE(assembly.add(part, true));
  error.mutable_error()->set_message("the reason");
  EXPECT_TRUE(assembly.add(error, false));
  EXPECT_EQ(error.error().message(), "the reason");
  part = predicted(2, 3);
  EXPECT_TRUE(assembly.add(part, false));
  EXPECT_EQ(part.predicted().velocities_size(), 3);
}

// The memory of a connection does not grow with the message.
TEST(Parts, AreShortFrames) {
  ConnectionPair pair;
  std::size_t frames = 0, longest = 0;
  pair.far.overhear([&](Direction, std::span<const std::byte> bytes) {
    ++frames;
    longest = std::max(longest, bytes.size());
  });
  const wire::Frame sent = snapshot(400'000);
  ASSERT_GT(sent.ByteSizeLong(), 2 * kMaxPartBytes);
  wire::Frame arrived;
  std::thread other([&] { pair.near.send(sent); });
  pair.far.receive(arrived);
  other.join();
  EXPECT_EQ(arrived.SerializeAsString(), sent.SerializeAsString());
  EXPECT_GT(frames, 2u);
  EXPECT_LT(longest, kMaxPartBytes);

  FrameDecoder decoder;
  decoder.set_limit(kMaxFrameBytes);
  decoder.accept_parts(kMaxPartBytes);
  const std::array<std::uint32_t, 1> length{static_cast<std::uint32_t>(kMaxPartBytes) + 1};
  feed(decoder, std::as_bytes(std::span(length)));
  EXPECT_THROW(decoder.take(arrived), Malformed);
}

TEST(Parts, AreBoundedTogether) {
  ConnectionPair pair;
  const wire::Frame sent = snapshot(400'000);
  pair.far.accept_up_to(sent.ByteSizeLong() / 2);
  std::thread other([&] {
    try {
      pair.near.send(sent);
    } catch (const std::exception&) {  // where it still sends when the other end closes
    }
  });
  wire::Frame arrived;
  EXPECT_THAT(message_of<PeerLost>([&] { pair.far.receive(arrived); }), HasSubstr("are allowed"));
  other.join();
}

// Two bytes can stand for a message of a hundred bytes, also in short parts.
TEST(Parts, TakeTogetherNoMoreMemoryThanOneFrame) {
  FrameDecoder decoder;
  decoder.set_limit(kMaxFrameBytes);
  decoder.accept_parts(kMaxPartBytes);
  wire::Frame part;
  for (int i = 0; i < 1000; ++i) part.mutable_snapshot()->add_pieces();
  FrameEncoder encoder;
  const auto bytes = encoder.encode(part, kMaxPartBytes, true);
  const auto send_many = [&] {
    for (std::uint64_t sent = 0; sent < kMaxParsedBytes; sent += bytes.size()) {
      feed(decoder, bytes);
      decoder.take(part);
    }
  };
  EXPECT_THAT(message_of<Malformed>(send_many), HasSubstr("bytes of memory"));
}

// The time for a frame is that of each part, also where a part has always begun to arrive.
TEST(Parts, MayTakeLongTogether) {
  Patience patience;
  patience.frame = 300ms;
  SocketPair sockets;
  Connection connection(std::move(sockets.near), "dem_server", patience);
  wire::Hello hello = hello_without_parts();
  hello.set_reads_parts(true);
  connection.establish(hello);
  std::vector<std::byte> stream;
  divide(snapshot(20), 64, [&](const wire::Frame& part, bool goes_on) {
    FrameEncoder encoder;
    const auto bytes = encoder.encode(part, kMaxPartBytes, goes_on);
    stream.insert(stream.end(), bytes.begin(), bytes.end());
  });
  const std::size_t piece = stream.size() / 80;
  std::thread other([&] {
    for (std::size_t at = 0; at < stream.size(); at += piece) {
      write_raw(sockets.far, std::span(stream).subspan(at, std::min(piece, stream.size() - at)));
      std::this_thread::sleep_for(10ms);
    }
  });
  wire::Frame arrived;
  EXPECT_NO_THROW(connection.receive(arrived));
  other.join();
  EXPECT_EQ(arrived.SerializeAsString(), snapshot(20).SerializeAsString());
}

// A peer that reads no parts gets one frame, and where it accepts none so long, both releases are named.
TEST(Parts, AreNotSentToWhoReadsNone) {
  SocketPair sockets;
  Connection connection(std::move(sockets.near), "dem_server", {});
  wire::Hello hello = hello_without_parts();
  hello.set_max_frame_bytes(1u << 20);
  connection.establish(hello);
  EXPECT_THAT(message_of<std::length_error>([&] { connection.send(predicted(1, 200'000)); }),
              testing::AllOf(HasSubstr("dem_server 0.4.0"), HasSubstr(std::string(release()))));
}

}  // namespace
}  // namespace adit::protocol::parts_test
