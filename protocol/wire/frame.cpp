#include "protocol/wire/frame.hpp"

#include <fmt/format.h>
#include <google/protobuf/io/coded_stream.h>

#include <algorithm>
#include <boost/endian/conversion.hpp>
#include <cstring>
#include <string>
#include <string_view>

#include "protocol/text.hpp"
#include "protocol/wire/content/parsed_size.hpp"

namespace adit::protocol {
namespace {

constexpr std::size_t kLengthBytes = 4;
constexpr std::uint32_t kGoesOn = 1u << 31;  // beside the length
static_assert(kMaxFrameBytes < kGoesOn);
constexpr char kMagic[] = {'A', 'D', 'I', 'T'};

std::uint32_t load(const std::byte* bytes) {
  return boost::endian::load_little_u32(reinterpret_cast<const unsigned char*>(bytes));
}

void store(std::byte* bytes, std::uint32_t value) {
  boost::endian::store_little_u32(reinterpret_cast<unsigned char*>(bytes), value);
}

// What a program sends that is not of ours, where its first bytes tell it: those of HTTP, or of an alert of
// TLS.
struct Language {
  std::string_view begins, name;
};
constexpr Language kLanguages[] = {{"HTTP/", " but HTTP"}, {"<", " but HTTP"}, {"\x15\x03", " but TLS"}};

std::string_view language_of(std::string_view bytes) {
  const auto* known = std::ranges::find_if(
      kLanguages, [&](const Language& language) { return bytes.starts_with(language.begins); });
  return known != std::end(kLanguages) ? known->name : "";
}

// Whether more bytes may tell it.
bool may_tell_language(std::string_view bytes) {
  return std::ranges::any_of(kLanguages, [&](const Language& language) {
    return bytes.size() < language.begins.size() && language.begins.starts_with(bytes);
  });
}

constexpr int tag_of(int field) {
  return field << 3 | 2;
}  // 2: length-delimited

// A heartbeat is known by its first byte, so that it is skipped without parsing and the message of the last
// frame keeps its memory.
bool is_heartbeat(std::span<const std::byte> payload) {
  constexpr int kTag = tag_of(wire::Frame::kHeartbeat);
  static_assert(kTag < 128, "one byte");
  return !payload.empty() && std::to_integer<int>(payload[0]) == kTag;
}

bool greets(int field) {
  return field == wire::Frame::kHello || field == wire::Frame::kProof || field == wire::Frame::kError;
}

// The bytes of a content and of the parts of its message before it; what they take once they are parsed.
void require_moderate(std::uint64_t bytes, std::uint64_t memory, const std::string& content) {
  if (memory > most_parsed_bytes(bytes))
    throw Malformed(
        fmt::format("sent {} bytes of {} that would take {} bytes of memory, where {} are allowed", bytes,
                    content, memory, most_parsed_bytes(bytes)));
}

}  // namespace

Preamble encode_preamble(std::uint32_t version) {
  Preamble preamble;
  std::memcpy(preamble.data(), kMagic, sizeof kMagic);
  store(preamble.data() + sizeof kMagic, version);
  return preamble;
}

std::vector<std::byte> heartbeat_frame(const std::string& progress) {
  wire::Frame frame;
  auto& heartbeat = *frame.mutable_heartbeat();
  if (progress.size() <= kMaxProgressBytes) heartbeat.set_progress(progress);
  FrameEncoder encoder;
  const auto encoded = encoder.encode(frame, kMaxHelloBytes);
  return {encoded.begin(), encoded.end()};
}

std::span<const std::byte> FrameEncoder::encode(const wire::Frame& frame, std::uint64_t limit, bool goes_on) {
  const std::size_t length = frame.ByteSizeLong();
  if (length > limit) {
    throw std::length_error(
        fmt::format("a frame of {} bytes is longer than the {} that the other end accepts", length, limit));
  }
  if (buffer_.size() < kLengthBytes + length) buffer_.resize(kLengthBytes + length);
  store(buffer_.data(), static_cast<std::uint32_t>(length) | (goes_on ? kGoesOn : 0));
  frame.SerializeWithCachedSizesToArray(reinterpret_cast<std::uint8_t*>(buffer_.data() + kLengthBytes));
  return {buffer_.data(), kLengthBytes + length};
}

// A payload holds one content and nothing else: tag, length, bytes. The content is parsed into the message
// that held the last one, so that the memory of its arrays is reused; parsing the whole frame would free it.
// Two bytes can stand for hundreds of bytes of memory. Short messages are not looked at, which by that factor
// take some MiB at most.
void FrameDecoder::parse(std::span<const std::byte> payload, wire::Frame& frame) {
  google::protobuf::io::CodedInputStream bytes(reinterpret_cast<const std::uint8_t*>(payload.data()),
                                               static_cast<int>(payload.size()));
  const int tag = static_cast<int>(bytes.ReadTag());
  const auto* field = wire::Frame::descriptor()->FindFieldByNumber(tag >> 3);
  std::uint32_t length = 0;
  const bool well_formed = field != nullptr && tag == tag_of(field->number()) &&
                           bytes.ReadVarint32(&length) &&
                           length == payload.size() - static_cast<std::size_t>(bytes.CurrentPosition());
  if (well_formed && greeting_ && !greets(field->number()))
    throw Malformed(fmt::format("sent {} in the place of a greeting", field->name()));
  const auto refuse = [&] {
    throw Malformed(fmt::format("sent {} bytes that are not a frame of this protocol", payload.size()));
  };
  if (!well_formed) refuse();
  if (length > kMaxHelloBytes || goes_on_ || before_ > 0) {
    const auto memory = parsed_size(payload.last(length), field->message_type());
    if (!memory) refuse();
    memory_before_ += *memory;
    require_moderate(before_ + length, memory_before_, field->message_type()->name());
  }
  if (!wire::Frame::GetReflection()->MutableMessage(&frame, field)->ParseFromCodedStream(&bytes) ||
      !bytes.ConsumedEntireMessage())
    refuse();
}

void FrameDecoder::set_limit(std::uint64_t bytes) {
  limit_ = bytes;
  if (buffered() == 0 && buffer_.size() > kLengthBytes + std::max(longest_now(), kMaxHelloBytes)) {
    buffer_ = std::vector<std::byte>(kMaxHelloBytes);
    begin_ = end_ = 0;
  }
}

std::uint64_t FrameDecoder::longest_now() const {
  return std::min(longest_frame_, limit_ - std::min(before_, limit_));
}

std::span<std::byte> FrameDecoder::space() {
  if (begin_ == end_) begin_ = end_ = 0;
  // Bytes are moved only if the buffer is full to its end, which is rare beside the frames taken.
  if (end_ == buffer_.size() && begin_ > 0) {
    std::memmove(buffer_.data(), buffer_.data() + begin_, buffered());
    end_ -= begin_;
    begin_ = 0;
  }
  if (end_ == buffer_.size())
    buffer_.resize(
        std::clamp<std::size_t>(kLengthBytes + longest_now(), buffer_.size() + 1, 2 * buffer_.size()));
  return std::span(buffer_).subspan(end_);
}

std::optional<std::uint32_t> FrameDecoder::take_preamble() {
  const std::byte* bytes = buffer_.data() + begin_;
  const std::string_view text(reinterpret_cast<const char*>(bytes), buffered());
  // As many bytes as there are are compared, so that another program is noticed at its first wrong byte, or
  // at those that tell its language, instead of by a deadline.
  if (!text.starts_with(std::string_view(kMagic, sizeof kMagic).substr(0, text.size()))) {
    if (may_tell_language(text)) return std::nullopt;
    throw ForeignPreamble(fmt::format("does not speak the Adit protocol{}", language_of(text)));
  }
  if (buffered() < sizeof(Preamble)) return std::nullopt;
  begin_ += sizeof(Preamble);
  return load(bytes + sizeof kMagic);
}

// A heartbeat is only a sign of life where what it says is too long or cannot be read, or comes from a
// stranger.
void FrameDecoder::hear_heartbeat(std::span<const std::byte> payload) {
  wire::Frame frame;
  const bool read = !greeting_ && payload.size() <= kMaxHelloBytes &&
                    frame.ParseFromArray(payload.data(), static_cast<int>(payload.size())) &&
                    frame.heartbeat().progress().size() <= kMaxProgressBytes;
  progress_ = read ? one_line(frame.heartbeat().progress()) : "";
}

bool FrameDecoder::take(wire::Frame& frame) {
  while (buffered() >= kLengthBytes) {
    const std::byte* bytes = buffer_.data() + begin_;
    const std::uint32_t announced = load(bytes);
    const bool goes_on = parts_ && (announced & kGoesOn) != 0;
    const std::size_t length = goes_on ? announced & ~kGoesOn : announced;
    if (length > longest_now())
      throw Malformed(fmt::format("announced a frame of {} bytes{}, but at most {} are allowed", length,
                                  before_ > 0 ? fmt::format(" after {} of its message", before_) : "",
                                  length > longest_frame_ ? std::min(longest_frame_, limit_) : limit_));
    if (buffered() < kLengthBytes + length) return false;
    begin_ += kLengthBytes + length;
    taken_ = std::span(bytes, kLengthBytes + length);
    const auto payload = taken_.subspan(kLengthBytes);
    if (is_heartbeat(payload)) {
      hear_heartbeat(payload);
      continue;
    }
    goes_on_ = goes_on;
    progress_.clear();
    parse(payload, frame);
    before_ = goes_on_ ? before_ + length : 0;
    if (!goes_on_) memory_before_ = 0;
    return true;
  }
  return false;
}

}  // namespace adit::protocol
