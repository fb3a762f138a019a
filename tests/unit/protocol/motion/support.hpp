// What the tests of motions share.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "protocol/errors.hpp"
#include "protocol/motion/motion.hpp"
#include "tests/support/scratch_folder.hpp"

namespace adit::motion::test {

inline constexpr double kPi = std::numbers::pi;

template <class Function>
Motion sampled(double dt, std::size_t count, const Function& value_at) {
  Motion motion{dt, std::vector<double>(count)};
  for (std::size_t i = 0; i < count; ++i) motion.acceleration[i] = value_at(static_cast<double>(i) * dt);
  return motion;
}

// What `action` refuses; empty where it accepts.
template <class Action>
std::string complaint(const Action& action) {
  try {
    action();
    return {};
  } catch (const protocol::UserError& error) {
    return error.path().empty() ? error.what() : "path: " + error.path();
  }
}

// The largest absolute value of a - b over [first, end).
inline double largest_difference(const std::vector<double>& a, const std::vector<double>& b,
                                 std::size_t first, std::size_t end) {
  double largest = 0;
  for (std::size_t i = first; i < end; ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

using Folder = adit::test::ScratchFolder;

}  // namespace adit::motion::test
