// What the continuum went through: peaks over the steps that are looked at.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/materials/material.hpp"
#include "fdm_server/solver/continuum.hpp"
#include "protocol/participant/peak_motion.hpp"
#include "protocol/state/archive.hpp"

namespace adit::fdm {

class Peaks {
 public:
  // Peaks of the grid without its free-field columns; of the demand where materials state a strength, of the
  // pressure ratio where zones are wet.
  Peaks(const Grid& grid, const Ground& ground);

  // Before a step to look at, after the correction of the step before.
  void remember(const Continuum& continuum);
  // After the step and its own correction.
  void take(Continuum& continuum, const protocol::Step& step);

  const protocol::PeakMotion& motion() const { return motion_; }
  // One value a zone, of the means over it in the plane. Tension is positive.
  std::span<const double> shear_strain() const { return shear_strain_; }  // largest gamma since time began
  std::span<const double> largest_principal() const { return largest_principal_; }    // [Pa]
  std::span<const double> smallest_principal() const { return smallest_principal_; }  // [Pa]
  // Largest share of its strength (materials/demand.hpp), and when the zone reached it [s]; empty without.
  std::span<const double> demand() const { return demand_; }
  std::span<const double> demand_time() const { return demand_time_; }
  // Largest growth of the water's pressure over the effective vertical pressure; empty without.
  std::span<const double> pressure_ratio() const { return pressure_ratio_; }

  void exchange(state::Archive& archive) {
    motion_.exchange(archive);
    archive("zone_peaks_shear_strain", std::span(shear_strain_));
    archive("zone_peaks_largest_principal", std::span(largest_principal_));
    archive("zone_peaks_smallest_principal", std::span(smallest_principal_));
    archive("zone_peaks_demand", std::span(demand_));
    archive("zone_peaks_demand_time", std::span(demand_time_));
    archive("zone_peaks_pressure_ratio", std::span(pressure_ratio_));
  }

 private:
  void raise_pressure_ratio(std::size_t begin, std::size_t end, const ZoneSet& zones);
  void raise_demand(std::size_t begin, std::size_t end, const ZoneSet& zones, double time);

  std::size_t points_;
  protocol::PeakMotion motion_;
  // Of each zone: numbers of its corners, mean gradient of the first two (hourglass.hpp).
  std::array<std::vector<std::int32_t>, 4> corners_;
  std::array<std::vector<double>, 4> gradients_;
  std::vector<double> shear_strain_, largest_principal_, smallest_principal_, demand_, demand_time_,
      pressure_ratio_;
};

}  // namespace adit::fdm
