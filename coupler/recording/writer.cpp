#include "coupler/recording/writer.hpp"

#include <boost/endian/conversion.hpp>
#include <exception>
#include <fstream>

#include "protocol/errors.hpp"
#include "protocol/state/archive.hpp"
#include "protocol/wire/frame.hpp"

namespace adit::coupler {
namespace {

// Frames are gathered, because a system call for each would take as long as the exchange of a short step.
constexpr std::size_t kGathered = std::size_t{64} << 10;

template <class Integer>
void store(std::string& bytes, std::size_t at, Integer value) {
  boost::endian::endian_store<Integer, sizeof value, boost::endian::order::little>(
      reinterpret_cast<unsigned char*>(bytes.data() + at), value);
}

template <class Integer>
void append(std::string& bytes, Integer value) {
  bytes.resize(bytes.size() + sizeof value);
  store(bytes, bytes.size() - sizeof value, value);
}

bool begins_as_recording(const std::filesystem::path& path) {
  std::string begin(kRecordingMagic.size(), '\0');
  return std::ifstream(path, std::ios::binary)
             .read(begin.data(), static_cast<std::streamsize>(begin.size())) &&
         begin == kRecordingMagic;
}

results::GrowingFile open(const std::filesystem::path& path) {
  namespace fs = std::filesystem;
  const auto refuse = [&](const std::string& why) {
    throw protocol::UserError("", "--record " + path.string() + ": " + why);
  };
  if (fs::exists(path) && !begins_as_recording(path))
    refuse("this is no recording, and it is kept; name a file that is not there yet");
  try {
    return results::GrowingFile(path);
  } catch (const protocol::DiskFull&) {
    throw;
  } catch (const std::exception& error) {
    refuse(std::string(error.what()) + "; name a file in a folder that can be written");
    throw;
  }
}

}  // namespace

RecordingWriter::RecordingWriter(const std::filesystem::path& path) : file_(open(path)) {
  waiting_ = kRecordingMagic;
  append(waiting_, kRecordingVersion);
  append(waiting_, protocol::kProtocolVersion);
}

RecordingWriter::~RecordingWriter() {
  try {
    hand_over();
  } catch (const std::exception&) {  // a full disk, of which the run has told
  }
}

void RecordingWriter::listen(const Speaker& speaker, protocol::Connection& connection) {
  const std::uint16_t number = introduce(speaker);
  connection.overhear([this, number](protocol::Direction direction, std::span<const std::byte> frame) {
    add(number, direction == protocol::Direction::kSent ? Kind::kRequest : Kind::kAnswer, frame);
  });
}

std::uint16_t RecordingWriter::introduce(const Speaker& speaker) {
  const std::string lines =
      speaker.name + "\n" + to_string(speaker.role) + "\n" + speaker.program + "\n" + speaker.release;
  add(participants_, Kind::kParticipant, std::as_bytes(std::span(lines)));
  hand_over();
  return participants_++;
}

void RecordingWriter::add(std::uint16_t participant, Kind kind, std::span<const std::byte> content) {
  const std::size_t begin = waiting_.size();
  append(waiting_, static_cast<std::uint32_t>(content.size()));
  append(waiting_, std::uint32_t{0});  // the checksum, once the rest is there
  append(waiting_, std::uint64_t(std::chrono::nanoseconds(Clock::now() - start_).count()));
  append(waiting_, participant);
  append(waiting_, static_cast<std::uint16_t>(kind));
  waiting_.append(reinterpret_cast<const char*>(content.data()), content.size());
  const auto checked = std::string_view(waiting_).substr(begin + kUncheckedBytes);
  store(waiting_, begin + kUncheckedBytes - sizeof(std::uint32_t), state::checksum(checked));
  if (waiting_.size() >= kGathered) hand_over();
}

void RecordingWriter::hand_over() {
  file_.append(waiting_);
  waiting_.clear();
}

}  // namespace adit::coupler
