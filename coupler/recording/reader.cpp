#include "coupler/recording/reader.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <boost/endian/conversion.hpp>
#include <sstream>
#include <string_view>
#include <utility>

#include "protocol/errors.hpp"
#include "protocol/state/archive.hpp"
#include "protocol/text.hpp"
#include "protocol/wire/frame.hpp"

namespace adit::coupler {
namespace {

constexpr std::uint64_t kLongestContent = protocol::kMaxFrameBytes + sizeof(std::uint32_t);

template <class Integer>
Integer load(std::string_view bytes, std::size_t at) {
  return boost::endian::endian_load<Integer, sizeof(Integer), boost::endian::order::little>(
      reinterpret_cast<const unsigned char*>(bytes.data() + at));
}

}  // namespace

RecordingReader::RecordingReader(const std::filesystem::path& path) : path_(path) {
  if (!std::filesystem::is_regular_file(path)) refuse("there is no such file");
  stream_.open(path, std::ios::binary);
  size_ = std::filesystem::file_size(path);
  std::string head(kFileHeadBytes, '\0');
  if (!stream_) refuse("the file cannot be read");
  if (!stream_.read(head.data(), kFileHeadBytes) || !head.starts_with(kRecordingMagic))
    refuse("this is no recording; coupler run --record writes one");
  const auto version = load<std::uint32_t>(head, kRecordingMagic.size());
  const auto protocol = load<std::uint32_t>(head, kRecordingMagic.size() + sizeof version);
  if (version != kRecordingVersion || protocol != protocol::kProtocolVersion)
    refuse(
        fmt::format("this is a recording of format {} of protocol {}, where {} and {} are read; take the "
                    "release that recorded it",
                    version, protocol, kRecordingVersion, protocol::kProtocolVersion));
  at_ = kFileHeadBytes;
  while ((has_first_ = read(first_)) && first_.kind == Kind::kParticipant) introduce(first_);
}

bool RecordingReader::next(Entry& entry) {
  if (std::exchange(has_first_, false))
    std::swap(entry, first_);
  else if (!read(entry))
    return false;
  const bool speaks = entry.kind == Kind::kRequest || entry.kind == Kind::kAnswer;
  if (!speaks || entry.participant >= speakers_.size())
    refuse("it has an entry of a participant that was not introduced, or of no kind");
  return true;
}

bool RecordingReader::read(Entry& entry) {
  if (cut_) return false;
  std::string head(kEntryHeadBytes, '\0');
  const std::uint64_t left = size_ - at_;
  cut_ = left > 0 && left < kEntryHeadBytes;
  if (left < kEntryHeadBytes) return false;
  stream_.read(head.data(), kEntryHeadBytes);
  const std::uint64_t length = load<std::uint32_t>(head, 0);
  if (length > kLongestContent) refuse(fmt::format("the entry at byte {} is too long", at_));
  cut_ = left - kEntryHeadBytes < length;
  if (cut_) return false;
  std::string& content = entry.content;
  content.assign(head, kUncheckedBytes);
  const std::size_t checked = content.size();
  content.resize(checked + length);
  if (!stream_.read(content.data() + checked, static_cast<std::streamsize>(length)))
    refuse("the file cannot be read to its end");
  if (state::checksum(content) != load<std::uint32_t>(head, sizeof(std::uint32_t)))
    refuse(fmt::format("it is damaged at byte {}: a checksum is another one", at_));
  entry.time = std::chrono::nanoseconds(load<std::uint64_t>(content, 0));
  entry.participant = load<std::uint16_t>(content, sizeof(std::uint64_t));
  entry.kind = static_cast<Kind>(load<std::uint16_t>(content, sizeof(std::uint64_t) + sizeof(std::uint16_t)));
  content.erase(0, checked);
  at_ += kEntryHeadBytes + length;
  return true;
}

void RecordingReader::introduce(const Entry& entry) {
  if (entry.participant != speakers_.size()) refuse("its participants are not in their order");
  std::istringstream lines(entry.content);
  Speaker speaker;
  std::string role;
  for (std::string* line : {&speaker.name, &role, &speaker.program, &speaker.release}) {
    std::getline(lines, *line);
    *line = protocol::one_line(*line);
  }
  const auto named = [&](Role candidate) { return role == to_string(candidate); };
  if (!named(Role::kContinuum) && !named(Role::kParticles)) refuse("a participant has no role");
  speaker.role = named(Role::kContinuum) ? Role::kContinuum : Role::kParticles;
  speakers_.push_back(std::move(speaker));
}

void RecordingReader::refuse(const std::string& why) const {
  throw protocol::UserError("", path_.string() + ": " + why);
}

}  // namespace adit::coupler
