// The motion in a file of records.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>

#include "protocol/motion/records/records.hpp"

namespace adit::test {

inline motion::Motion read_motion(const std::filesystem::path& file, const motion::RecordKeys& keys = {}) {
  std::ifstream stream(file, std::ios::binary);
  return motion::parse_motion(file, {std::istreambuf_iterator<char>(stream), {}}, keys);
}

}  // namespace adit::test
