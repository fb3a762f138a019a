// How many threads of this machine are worth calling for so many particles.
#pragma once

#include <algorithm>
#include <cstddef>
#include <thread>

namespace adit::dem {

inline std::size_t useful_threads(std::size_t particles) {
  constexpr std::size_t kWorthACall = 4096;
  return std::clamp<std::size_t>(particles / kWorthACall, 1,
                                 std::max(1u, std::thread::hardware_concurrency()));
}

}  // namespace adit::dem
