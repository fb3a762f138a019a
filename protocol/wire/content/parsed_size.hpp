// The memory that a message takes once it is parsed. Two bytes of a frame can stand for an empty message of
// hundreds of bytes, so it is estimated from the bytes before any is taken.
#pragma once

#include <google/protobuf/descriptor.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace adit::protocol {

// Bytes of memory for a message of this type, room for growing lists included; nothing where the bytes cannot
// be read as such a message, or it is nested deeper than the parser allows.
std::optional<std::uint64_t> parsed_size(std::span<const std::byte> bytes,
                                         const google::protobuf::Descriptor* type);

}  // namespace adit::protocol
