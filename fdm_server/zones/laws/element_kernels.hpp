// The kernel of zones with Iwan's elements (hysteresis/iwan_elements.hpp): eight zones at a time.
//
// Eight consecutive zones are a group, whose values stand together: a vector of eight for each. Of an element
// these are what it flowed, q, at the four points. A block of elements sleeps until
// the path of the zone's strain could bring one of them to its limit at one of the points.
#pragma once

#include <array>
#include <cstddef>

namespace adit::fdm {

inline constexpr std::size_t kGroup = 8;           // zones
inline constexpr std::size_t kElementBlock = 4;    // elements that sleep together
inline constexpr std::size_t kElementValues = 12;  // of a zone's element: t, s, z of q, each at four points

using GroupValues = std::array<double, kGroup>;

// Elements in whole blocks.
struct ElementTable {
  std::size_t blocks;
  const double *stiffness, *limit;
};

// What the zones of a group remember.
struct GroupState {
  GroupValues* strain;  // t and s of four points, z: deviator of strain
  GroupValues* path;    // its length, the largest of the points'
  GroupValues* wakes;   // length at which each block wakes
  GroupValues* flows;   // kElementValues of each element
};

// A step of zones `begin` … `end` of a group: the strain's growth is replaced by that of the stress over the
// shear modulus, its zz of each point in `across`.
struct GroupStep {
  alignas(64) std::array<GroupValues, 9> growth;
  std::array<GroupValues, 4> across;
  std::array<GroupValues, 4> twice;  // the dissipated energy per volume over the shear modulus
  std::size_t begin, end;
};
void advance_group(const ElementTable& elements, const GroupState& state, GroupStep& step);

// What the elements of a group hold, over the shear modulus: stresses t, s and z of each point, and twice the
// energy per volume.
struct GroupHeld {
  alignas(64) std::array<GroupValues, kElementValues> stress;
  std::array<GroupValues, 4> twice;
};
void find_held(const ElementTable& elements, const GroupValues* strain, const GroupValues* flows,
               GroupHeld& held);

}  // namespace adit::fdm
