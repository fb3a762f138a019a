#pragma once

#include <cstdint>

namespace adit::protocol {

// Bytes of memory that this process holds now; 0 where the system does not tell.
std::uint64_t resident_bytes();

// Bytes of memory that this machine has, used or not.
std::uint64_t machine_bytes();

}  // namespace adit::protocol
