// What a section resists, and how far forces use it.
#pragma once

#include <cstddef>
#include <vector>

#include "protocol/sections/capacity.hpp"
#include "protocol/sections/section_shape.hpp"
#include "protocol/sections/shear_capacity.hpp"

namespace adit::sections {

struct Strength {
  SectionShape shape;
  Capacity capacity;
  ShearMaterials shear;
  std::vector<double> damage_states;  // the ratios of moment to capacity from which they begin
};

struct Use {
  double utilisation;     // of thrust and moment (capacity.hpp)
  double moment_ratio;    // of the moment to the ultimate one with this thrust, by size
  double shear_strength;  // with this thrust, on the side that the moment stretches [N]
  double shear;           // shear force over this strength
};

// How many of its states of damage have begun at the largest ratio of the moment.
std::size_t damage_state(const Strength& strength, double moment_ratio);

Use use_of(const Strength& strength, const SectionForces& forces, double shear);

}  // namespace adit::sections
