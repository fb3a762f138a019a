// Numbers of the pairs of groups of particles, by which laws between groups are listed.
#pragma once

#include <cstdint>

namespace adit::dem {

inline std::uint32_t group_pair_number(std::uint32_t groups, std::uint32_t group_1, std::uint32_t group_2) {
  return group_1 * groups + group_2;
}

}  // namespace adit::dem
