// What the tests of motions share.
#pragma once

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include "protocol/errors.hpp"
#include "protocol/motion/motion.hpp"

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

class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "adit_motion_XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path_); }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

}  // namespace adit::motion::test
