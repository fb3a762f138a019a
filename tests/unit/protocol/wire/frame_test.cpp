#include "protocol/wire/frame.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>
#include <string>

#include "tests/unit/protocol/wire/frames.hpp"

namespace adit::protocol::frame_test {
namespace {

using testing::HasSubstr;

std::vector<std::byte> bytes_of(const wire::Frame& frame) {
  FrameEncoder encoder;
  const auto bytes = encoder.encode(frame, kMaxFrameBytes);
  return {bytes.begin(), bytes.end()};
}

std::vector<std::byte> header(std::uint32_t length) {
  std::vector<std::byte> bytes;
  for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<std::byte>(length >> (8 * i)));
  return bytes;
}

TEST(Frame, IsItsLengthInLittleEndianAndItsPayload) {
  const auto frame = predicted(7, 100);
  const auto bytes = bytes_of(frame);
  ASSERT_EQ(bytes.size(), 4 + frame.ByteSizeLong());
  EXPECT_TRUE(std::equal(bytes.begin(), bytes.begin() + 4, header(bytes.size() - 4).begin()));
}

// However the stream is cut into pieces, the same frames come out.
TEST(Frame, SurvivesAnyCutting) {
  std::vector<std::byte> stream;
  for (int step = 0; step < 5; ++step)
    for (const auto& bytes : {bytes_of(predicted(step, 20 * step)), heartbeat_frame("step 3 of 20")})
      stream.insert(stream.end(), bytes.begin(), bytes.end());
  for (const std::size_t piece : {1, 2, 3, 7, 64, 10000}) {
    FrameDecoder decoder;
    wire::Frame frame;
    std::uint64_t step = 0;
    for (std::size_t at = 0; at < stream.size(); at += piece) {
      feed(decoder, std::span(stream).subspan(at, std::min(piece, stream.size() - at)));
      while (decoder.take(frame)) {
        EXPECT_EQ(frame.SerializeAsString(),
                  predicted(step, 20 * static_cast<int>(step)).SerializeAsString());
        ++step;
      }
    }
    EXPECT_EQ(step, 5u) << "pieces of " << piece;
  }
}

TEST(Frame, AHeartbeatTellsProgressWithinItsBound) {
  FrameDecoder decoder;
  wire::Frame frame;
  const auto heard = [&](const std::string& progress) {
    frame.mutable_heartbeat()->set_progress(progress);
    feed(decoder, bytes_of(frame));
    EXPECT_FALSE(decoder.take(frame));
    return decoder.progress();
  };
  EXPECT_EQ(heard("step 3\nof 20"), "step 3 of 20");
  EXPECT_EQ(heard(std::string(kMaxProgressBytes, 'x')), std::string(kMaxProgressBytes, 'x'));
  EXPECT_EQ(heard(std::string(kMaxProgressBytes + 1, 'x')), "");
  EXPECT_EQ(heard("step 4 of 20"), "step 4 of 20");
  feed(decoder, bytes_of(predicted(0, 1)));
  EXPECT_TRUE(decoder.take(frame));
  EXPECT_EQ(decoder.progress(), "") << "that work is done";
}

// What a stranger says is not even parsed.
TEST(Frame, AHeartbeatOfAStrangerTellsNothing) {
  FrameDecoder decoder;
  decoder.expect_greeting(true);
  feed(decoder, heartbeat_frame("step 3 of 20"));
  wire::Frame frame;
  EXPECT_FALSE(decoder.take(frame));
  EXPECT_EQ(decoder.progress(), "");
}

// A megabyte passes through the buffer, which begins at 64 KiB.
TEST(Frame, MayBeLongerThanTheBuffer) {
  FrameDecoder decoder;
  decoder.set_limit(kMaxFrameBytes);
  const auto sent = predicted(1, 200000);
  feed(decoder, bytes_of(sent));
  wire::Frame frame;
  ASSERT_TRUE(decoder.take(frame));
  EXPECT_EQ(frame.SerializeAsString(), sent.SerializeAsString());
}

// A length above the limit is refused when it is read, and costs no memory.
TEST(Frame, LengthAboveTheLimitIsRefusedBeforeAnyAllocation) {
  FrameDecoder decoder;
  wire::Frame frame;
  feed(decoder, header(kMaxHelloBytes + 1));
  const std::size_t space = decoder.space().size();
  try {
    decoder.take(frame);
    FAIL() << "accepted";
  } catch (const Malformed& error) {
    EXPECT_THAT(error.what(), HasSubstr("announced a frame of 65537 bytes, but at most 65536 are allowed"));
  }
  EXPECT_EQ(decoder.space().size(), space);
}

// A peer that announces the largest frame and sends four bytes makes us allocate nothing.
TEST(Frame, MemoryGrowsWithWhatArrived) {
  FrameDecoder decoder;
  decoder.set_limit(kMaxFrameBytes);
  wire::Frame frame;
  feed(decoder, header(kMaxFrameBytes));
  EXPECT_FALSE(decoder.take(frame));
  EXPECT_LE(decoder.space().size(), kMaxHelloBytes);
}

// The buffer of a long frame is given back when shorter ones are expected.
TEST(Frame, MemoryOfALongFrameIsGivenBack) {
  FrameDecoder decoder;
  decoder.set_limit(kMaxFrameBytes);
  feed(decoder, bytes_of(predicted(1, 200000)));
  wire::Frame frame;
  ASSERT_TRUE(decoder.take(frame));
  EXPECT_GT(decoder.space().size(), 1000000u);
  decoder.set_limit(kMaxHelloBytes);
  EXPECT_EQ(decoder.space().size(), kMaxHelloBytes);
}

// Messages of two bytes each take some fifty times the length of the frame.
TEST(Frame, OfManyEmptyMessagesIsRefusedBeforeItTakesMemory) {
  wire::Frame sent;
  auto& regions = *sent.mutable_setup()->mutable_scene()->mutable_regions();
  constexpr int kRegions = 4'000'000;
  for (int i = 0; i < kRegions; ++i) regions.Add();
  FrameDecoder decoder;
  decoder.set_limit(kMaxFrameBytes);
  feed(decoder, bytes_of(sent));
  wire::Frame frame;
  try {
    decoder.take(frame);
    FAIL() << "accepted";
  } catch (const Malformed& error) {
    EXPECT_THAT(error.what(), HasSubstr("bytes of Setup that would take"));
  }
}

TEST(Frame, LongerThanThePeerAcceptsIsNotEncoded) {
  FrameEncoder encoder;
  EXPECT_THROW(encoder.encode(predicted(1, 1000), 100), std::length_error);
}

// In a steady conversation the arrays of the message stay where they are.
TEST(Frame, MemoryOfTheMessageIsUsedAgain) {
  FrameDecoder decoder;
  wire::Frame frame;
  feed(decoder, bytes_of(predicted(1, 500)));
  ASSERT_TRUE(decoder.take(frame));
  const double* before = frame.predicted().velocities().data();
  feed(decoder, bytes_of(predicted(2, 400)));
  ASSERT_TRUE(decoder.take(frame));
  EXPECT_EQ(frame.predicted().velocities().data(), before);
  EXPECT_EQ(frame.SerializeAsString(), predicted(2, 400).SerializeAsString());
}

// A frame is exactly one known content.
TEST(Frame, WithoutContentOrOfAnUnknownKindIsRefused) {
  for (const std::vector<std::byte>& payload :
       {std::vector<std::byte>{}, std::vector<std::byte>{std::byte{0x08}, std::byte{1}},
        std::vector<std::byte>{std::byte{0x82}, std::byte{1}, std::byte{0}}}) {
    FrameDecoder decoder;
    wire::Frame frame = predicted(1, 1);
    feed(decoder, header(payload.size()));
    feed(decoder, payload);
    EXPECT_THROW(decoder.take(frame), Malformed) << payload.size() << " bytes";
  }
}

// Random bytes, and frames with random bytes changed, end in a frame or in Malformed, never otherwise.
TEST(Frame, AnyBytesAreAFrameOrMalformed) {
  std::mt19937 random(20240611);
  int malformed = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    auto bytes = bytes_of(predicted(trial, trial % 50));
    if (trial % 2 == 0) {
      for (auto& byte : bytes) byte = static_cast<std::byte>(random());
      const auto length = header(bytes.size() - 4);
      if (trial % 4 == 0) std::copy(length.begin(), length.end(), bytes.begin());
    } else {
      for (int i = 0; i < 3; ++i) bytes[random() % bytes.size()] = static_cast<std::byte>(random());
    }
    FrameDecoder decoder;
    wire::Frame frame;
    try {
      feed(decoder, bytes);
      while (decoder.take(frame)) {
        EXPECT_NE(frame.content_case(), wire::Frame::CONTENT_NOT_SET);
      }
    } catch (const Malformed&) {
      ++malformed;
    }
  }
  EXPECT_GT(malformed, 10000);
}

TEST(Preamble, IsTheMagicAndTheVersion) {
  FrameDecoder decoder;
  const auto bytes = encode_preamble(0x01020304);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    EXPECT_FALSE(decoder.take_preamble().has_value());
    feed(decoder, std::span(bytes).subspan(i, 1));
  }
  EXPECT_EQ(decoder.take_preamble(), 0x01020304u);
}

// Another program is known by its first byte; it need not send eight.
TEST(Preamble, OfAnotherProgramIsRefusedAtOnce) {
  FrameDecoder decoder;
  const auto bytes = std::as_bytes(std::span("S", 1));
  feed(decoder, bytes);
  EXPECT_THROW(decoder.take_preamble(), ForeignPreamble);
}

// A language that is known is named however its first bytes arrive.
TEST(Preamble, InHttpIsNamedInAnyPieces) {
  FrameDecoder decoder;
  feed(decoder, std::as_bytes(std::span("HTT", 3)));
  EXPECT_FALSE(decoder.take_preamble().has_value());
  feed(decoder, std::as_bytes(std::span("P/", 2)));
  EXPECT_THAT([&] { decoder.take_preamble(); },
              testing::ThrowsMessage<ForeignPreamble>(testing::HasSubstr("HTTP")));
}

}  // namespace
}  // namespace adit::protocol::frame_test
