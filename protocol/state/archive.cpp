#include "protocol/state/archive.hpp"

#include <fmt/format.h>

#include <zlib.h>

#include <algorithm>
#include <cstring>

#include "protocol/errors.hpp"
#include "protocol/text.hpp"

namespace adit::state {
namespace {

[[noreturn]] void refuse(const std::string& why) {
  throw protocol::UserError("", "the state does not fit this model: " + why +
                                    "; it goes on with the scene and the release that it is of");
}

}  // namespace

std::uint64_t size_of(const Parts& parts) {
  std::uint64_t size = 0;
  for (const std::string& part : parts) size += part.size();
  return size;
}

std::uint32_t checksum(std::string_view bytes, std::uint32_t before) {
  return static_cast<std::uint32_t>(
      crc32_z(before, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
}

void Archive::operator()(const char* name, bool& value) {
  std::uint8_t flag = value ? 1 : 0;
  (*this)(name, flag);
  value = flag != 0;
}

void Archive::operator()(const char* name, std::vector<bool>& values) {
  std::vector<std::uint8_t> flags(values.begin(), values.end());
  (*this)(name, std::span(flags));
  if (reads_) values.assign(flags.begin(), flags.end());
}

void Archive::operator()(const char* name, std::string& text) {
  text.resize(begin(name, 1, text.size()));
  bytes(text.data(), text.size());
}

void Archive::require_end() const {
  if (left_ > 0) refuse("it holds more than the model has");
}

std::size_t Archive::begin(const char* name, std::size_t value_bytes, std::size_t count) {
  const std::string expected = name;
  std::uint64_t length = expected.size(), number = count, width = value_bytes;
  bytes(&length, sizeof length);
  std::string found = expected;
  if (length != expected.size()) refuse("it lacks `" + expected + "`");
  bytes(found.data(), found.size());
  bytes(&width, sizeof width);
  bytes(&number, sizeof number);
  if (found != expected)
    refuse("it holds " + protocol::quote(found) + " where `" + expected + "` was expected");
  if (width != value_bytes) refuse("`" + expected + "` has values of another kind");
  if (reads_ && number > left_ / value_bytes) refuse("it ends within `" + expected + "`");
  return number;
}

void Archive::begin_fixed(const char* name, std::size_t value_bytes, std::size_t count) {
  const std::size_t found = begin(name, value_bytes, count);
  if (found != count) refuse(fmt::format("`{}` has {} values, the model {}", name, found, count));
}

void Archive::bytes(void* data, std::size_t size) {
  reads_ ? read(data, size) : write(data, size);
}

void Archive::write(const void* data, std::size_t size) {
  const char* from = static_cast<const char*>(data);
  while (size > 0) {
    if (parts_.empty() || parts_.back().size() == kPartBytes) parts_.emplace_back().reserve(kPartBytes);
    const std::size_t some = std::min(size, kPartBytes - parts_.back().size());
    parts_.back().append(from, some);
    from += some;
    size -= some;
  }
}

void Archive::read(void* data, std::size_t size) {
  if (size > left_) refuse("it ends too early");
  left_ -= size;
  char* to = static_cast<char*>(data);
  while (size > 0) {
    const std::size_t some = std::min(size, parts_[part_].size() - at_);
    std::memcpy(to, parts_[part_].data() + at_, some);
    to += some;
    size -= some;
    at_ += some;
    if (at_ < parts_[part_].size()) continue;
    ++part_;
    at_ = 0;
  }
}

void require_of_model(bool holds, const char* name) {
  if (!holds) refuse("`" + std::string(name) + "` is not of this model");
}

void require_below(std::span<const std::uint32_t> numbers, std::size_t count, const char* name) {
  if (std::ranges::any_of(numbers, [count](std::uint32_t number) { return number >= count; }))
    refuse("`" + std::string(name) + "` names what the model does not have");
}

}  // namespace adit::state
