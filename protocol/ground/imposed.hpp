// How statics impose a displacement: over so many steps from the beginning of its stage, in which a model is
// not at rest.
#pragma once

#include <cstdint>

namespace adit::protocol {

// A wave crosses a grid of a hundred by a hundred zones some thirty times meanwhile.
inline constexpr std::uint64_t kImposingSteps = 5000;

// The share of the displacement after so many steps: 3 s^2 - 2 s^3.
inline double imposed_share(std::uint64_t steps) {
  if (steps >= kImposingSteps) return 1;
  const double s = static_cast<double>(steps) / static_cast<double>(kImposingSteps);
  return s * s * (3 - 2 * s);
}

}  // namespace adit::protocol
