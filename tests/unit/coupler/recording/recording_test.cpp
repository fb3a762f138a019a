#include <gmock/gmock.h>

#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "coupler/recording/reader.hpp"
#include "coupler/recording/turns.hpp"
#include "coupler/recording/writer.hpp"
#include "protocol/wire/frame.hpp"
#include "tests/support/refusals.hpp"
#include "tests/support/scratch_folder.hpp"

namespace adit::coupler::recording_test {
namespace {

using test::expect_refusal;
using testing::ElementsAre;

wire::Frame advance(std::uint64_t step, bool relax = false) {
  wire::Frame frame;
  frame.mutable_advance()->set_step(step);
  frame.mutable_advance()->set_relax(relax);
  return frame;
}

wire::Frame predicted(std::uint64_t step, double velocity) {
  wire::Frame frame;
  frame.mutable_predicted()->set_step(step);
  frame.mutable_predicted()->add_velocities(velocity);
  return frame;
}

std::string read_bytes(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// What a reader finds, an entry each: participant, kind, content.
std::vector<std::string> entries_of(const std::string& path, bool* cut = nullptr) {
  RecordingReader reader(path);
  std::vector<std::string> found;
  for (Entry entry; reader.next(entry);)
    found.push_back(std::to_string(entry.participant) + (entry.kind == Kind::kRequest ? ">" : "<") +
                    entry.content);
  if (cut != nullptr) *cut = reader.cut();
  return found;
}

class RecordingTest : public testing::Test {
 protected:
  RecordingTest() : path_(folder_.path("recording")) {
    RecordingWriter writer(path_);
    const auto ground = writer.introduce({"continuum", Role::kContinuum, "fdm_server", "1.2.0"});
    const auto lining = writer.introduce({"lining", Role::kParticles, "other", "7"});
    for (int step = 0; step < 2; ++step) {
      say(writer, ground, Kind::kRequest, advance(step));
      say(writer, lining, Kind::kRequest, advance(step));
      say(writer, lining, Kind::kAnswer, predicted(step, 0.1));
      say(writer, ground, Kind::kAnswer, predicted(step, 0.2));
    }
  }

  void say(RecordingWriter& writer, std::uint16_t participant, Kind kind, const wire::Frame& frame,
           bool goes_on = false) {
    protocol::FrameEncoder encoder;
    const auto bytes = encoder.encode(frame, protocol::kMaxFrameBytes, goes_on);
    writer.add(participant, kind, bytes);
    said_.push_back(std::to_string(participant) + (kind == Kind::kRequest ? ">" : "<") +
                    std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  }

  test::ScratchFolder folder_;
  std::string path_;
  std::vector<std::string> said_;
};

// What was said is read back in its order, byte for byte, and who said it.
TEST_F(RecordingTest, HoldsWhatWasSaid) {
  bool cut = true;
  EXPECT_EQ(entries_of(path_, &cut), said_);
  EXPECT_FALSE(cut);
  const RecordingReader reader(path_);
  ASSERT_EQ(reader.speakers().size(), 2);
  EXPECT_EQ(reader.speakers()[1].name, "lining");
  EXPECT_EQ(reader.speakers()[1].role, Role::kParticles);
  EXPECT_EQ(reader.speakers()[1].program, "other");
  EXPECT_EQ(reader.speakers()[1].release, "7");
}

TEST_F(RecordingTest, BeginsWithItsNameItsVersionAndThatOfTheProtocol) {
  EXPECT_EQ(read_bytes(path_).substr(0, 16), std::string("ADITREC\n\1\0\0\0\2\0\0\0", 16));
}

// A run may be killed at any byte: what is whole until there is read, and the reader tells of the rest.
TEST_F(RecordingTest, IsReadUpToWhereItWasCut) {
  const std::string whole = read_bytes(path_);
  std::size_t whole_ends = 0;
  for (std::size_t size = kFileHeadBytes; size < whole.size(); ++size) {
    bool cut = false;
    const auto found = entries_of(folder_.write("cut", whole.substr(0, size)), &cut);
    ASSERT_LT(found.size(), said_.size());
    EXPECT_TRUE(std::equal(found.begin(), found.end(), said_.begin())) << size;
    whole_ends += cut ? 0 : 1;
  }
  EXPECT_EQ(whole_ends, 2 + said_.size());  // after the head, two introductions, and all entries but the last
}

// Nothing can change without notice: the file is refused, or its rest taken for cut.
TEST_F(RecordingTest, NoticesAChangedBitOfAnyByte) {
  const std::string whole = read_bytes(path_);
  for (std::size_t byte = 0; byte < whole.size(); ++byte) {
    std::string changed = whole;
    changed[byte] = static_cast<char>(changed[byte] ^ (1 << byte % 8));
    bool cut = false;
    try {
      const auto found = entries_of(folder_.write("changed", changed), &cut);
      EXPECT_TRUE(cut && found.size() < said_.size()) << "byte " << byte;
    } catch (const protocol::UserError&) {
    }
  }
}

TEST_F(RecordingTest, RefusesWhatIsNoRecording) {
  const auto refuse = [&](const std::string& path, const std::string& why) {
    expect_refusal([&] { RecordingReader{path}; }, "", why);
  };
  refuse(folder_.path("missing"), "there is no such file");
  refuse(folder_.path(), "there is no such file");
  refuse(folder_.write("empty", ""), "this is no recording");
  refuse(folder_.write("scene.yaml", "time: {duration: 3 ms}"), "this is no recording");
  std::string later = read_bytes(path_);
  later[8] = 9;
  refuse(folder_.write("later", later), "format 9 of protocol 2");
  std::string damaged = read_bytes(path_);
  damaged.back() ^= 1;
  expect_refusal([&] { entries_of(folder_.write("damaged", damaged)); }, "", "damaged at byte");
}

// A file of another kind is never overwritten; another recording is.
TEST_F(RecordingTest, KeepsFilesThatAreNoRecordings) {
  const std::string thesis = folder_.write("thesis.txt", "years of work");
  expect_refusal([&] { RecordingWriter{thesis}; }, "", "this is no recording, and it is kept");
  EXPECT_EQ(read_bytes(thesis), "years of work");
  expect_refusal([&] { RecordingWriter{folder_.path("no/such/folder")}; }, "", "cannot write");
  { RecordingWriter again(path_); }
  EXPECT_EQ(read_bytes(path_).size(), kFileHeadBytes);
}

// A participant's turns: each request with its answer and its place in the run, also one without an answer.
TEST_F(RecordingTest, IsATurnAfterTheOtherForEachParticipant) {
  const std::string path = folder_.path("turns");
  {
    RecordingWriter writer(path);
    writer.introduce({"continuum", Role::kContinuum, "fdm_server", "1"});
    wire::Frame setup, snapshot;
    setup.mutable_setup();
    snapshot.mutable_snapshot_request();
    say(writer, 0, Kind::kRequest, setup);
    say(writer, 0, Kind::kAnswer, predicted(0, 1));
    say(writer, 0, Kind::kRequest, advance(3, true));
    say(writer, 0, Kind::kAnswer, predicted(3, 1));
    say(writer, 0, Kind::kRequest, snapshot);
    say(writer, 0, Kind::kAnswer, predicted(0, 1));
    say(writer, 0, Kind::kRequest, advance(0));
  }
  Turns turns(path, 0);
  std::vector<std::string> places;
  for (Turn turn; turns.next(turn);) places.push_back(turn.place + (turn.answered ? "" : "?"));
  EXPECT_THAT(places, ElementsAre("setup", "step 3 of statics", "snapshot_request after step 3 of statics",
                                  "step 0?"));
  Turns of_lining(path_, 1);
  Turn turn;
  ASSERT_TRUE(of_lining.next(turn));
  EXPECT_EQ(turn.answer.predicted().velocities(0), 0.1);
}

// A message in parts is one request or one answer; without its last part it was not said.
TEST_F(RecordingTest, PutsPartsTogether) {
  const std::string path = folder_.path("parts");
  {
    RecordingWriter writer(path);
    writer.introduce({"continuum", Role::kContinuum, "fdm_server", "1"});
    protocol::divide(advance(7), 8, [&](const wire::Frame& part, bool goes_on) {
      say(writer, 0, Kind::kRequest, part, goes_on);
    });
    wire::Frame answer = predicted(7, 1);
    for (int i = 2; i < 100; ++i) answer.mutable_predicted()->add_velocities(i);
    protocol::divide(answer, 8, [&](const wire::Frame& part, bool goes_on) {
      say(writer, 0, Kind::kAnswer, part, goes_on);
    });
    say(writer, 0, Kind::kRequest, advance(8));
    say(writer, 0, Kind::kAnswer, predicted(8, 1), true);
  }
  Turns turns(path, 0);
  Turn turn;
  ASSERT_TRUE(turns.next(turn));
  EXPECT_EQ(turn.place, "step 7");
  ASSERT_TRUE(turn.answered);
  EXPECT_EQ(turn.answer.predicted().velocities_size(), 99);
  ASSERT_TRUE(turns.next(turn));
  EXPECT_FALSE(turn.answered);
  EXPECT_FALSE(turns.next(turn));
}

}  // namespace
}  // namespace adit::coupler::recording_test
