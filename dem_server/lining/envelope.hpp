// The largest and smallest values of the forces in sections over the times that are looked at.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/lining/sections.hpp"
#include "protocol/state/archive.hpp"

namespace adit::dem {

struct Extreme {
  double value = 0, time = 0;  // [N] or [N m], [s]
};

enum class Force : std::uint8_t { kThrust, kMoment, kShear };

struct ForceName {
  Force force;
  const char *name, *unit;
};
inline constexpr std::array<ForceName, 3> kForceNames{
    {{Force::kThrust, "thrust", "N"}, {Force::kMoment, "moment", "Nm"}, {Force::kShear, "shear", "N"}}};

class Envelope {
 public:
  // The forces of all sections at a time [s], ascending.
  void take(std::span<const SectionForces> forces, double time);

  // One of each section; empty before anything was taken.
  std::span<const Extreme> largest(Force force) const { return largest_[static_cast<std::size_t>(force)]; }
  std::span<const Extreme> smallest(Force force) const { return smallest_[static_cast<std::size_t>(force)]; }

  void exchange(std::size_t sections, state::Archive& archive) {
    archive.all_or_none(
        "section_extremes",
        {&largest_[0], &largest_[1], &largest_[2], &smallest_[0], &smallest_[1], &smallest_[2]}, sections);
  }

 private:
  std::array<std::vector<Extreme>, kForceNames.size()> largest_, smallest_;
};

}  // namespace adit::dem
