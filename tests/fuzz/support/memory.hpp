// The memory that this process has taken and not given back, as the address sanitizer counts it; 0 in other
// builds.
#pragma once

#include <cstdint>

namespace adit::fuzz {

// Begins to count, where it has not begun.
void count_memory();

std::int64_t memory_held();  // since then [bytes]

// The most that was held at once since the last call of this function.
std::int64_t take_memory_peak();

}  // namespace adit::fuzz
