// An interface of a grid, for results: its contacts in order along a path.
#pragma once

#include <cstdint>
#include <string>

namespace adit::fdm {

struct Interface {
  std::string name;
  std::uint32_t first, count;  // contacts
  bool closed;                 // the last is followed by the first
};

}  // namespace adit::fdm
