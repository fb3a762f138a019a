#include "fdm_server/output/peaks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fdm_server/output/mean_strain.hpp"
#include "fdm_server/zones/batch/batch.hpp"
#include "fdm_server/zones/shape/hourglass.hpp"
#include "protocol/threads/vector_clones.hpp"

namespace adit::fdm {

namespace {

// Velocities of every point; those of the columns are the last and are not used.
protocol::PlaneVectors velocities(const Continuum& continuum, std::size_t points) {
  return {continuum.vx().first(points), continuum.vy().first(points)};
}

// Mohr's circle of strain has the radius gamma/2.
ADIT_VECTOR_CLONES void raise_shear_strain(std::size_t begin, std::size_t end,
                                           const std::array<const std::int32_t*, 4>& corners,
                                           const std::array<const double*, 4>& gradients,
                                           std::span<const double> ux, std::span<const double> uy,
                                           double* peaks) {
  const auto [c0, c1, c2, c3] = corners;
  const auto [x0, x1, y0, y1] = gradients;
#pragma GCC ivdep
  for (std::size_t z = begin; z < end; ++z) {
    const MeanStrain e = mean_strain({x0[z], x1[z], y0[z], y1[z]}, {c0[z], c1[z], c2[z], c3[z]}, ux, uy);
    const double difference = e.xx - e.yy, strain = std::sqrt(difference * difference + e.xy * e.xy);
    peaks[z] = peaks[z] < strain ? strain : peaks[z];
  }
}

// Of the zones of the grid without its columns, which have the first numbers.
ADIT_VECTOR_CLONES void raise_principal(std::span<const std::uint32_t> numbers, const PlaneStresses& stresses,
                                        std::span<double> largest, std::span<double> smallest) {
  BatchValues radius;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    radius[i] =
        std::sqrt(stresses.difference[i] * stresses.difference[i] + stresses.shear[i] * stresses.shear[i]);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] >= largest.size()) continue;
    largest[numbers[i]] = std::max(largest[numbers[i]], stresses.mean[i] + radius[i]);
    smallest[numbers[i]] = std::min(smallest[numbers[i]], stresses.mean[i] - radius[i]);
  }
}

}  // namespace

Peaks::Peaks(const Grid& grid, const Ground& ground)
    : points_(grid.own_points()),
      motion_(points_),
      shear_strain_(grid.own_zones()),
      largest_principal_(grid.own_zones(), -std::numeric_limits<double>::infinity()),
      smallest_principal_(grid.own_zones(), std::numeric_limits<double>::infinity()),
      demand_(ground.states_strength() ? grid.own_zones() : 0),
      demand_time_(demand_.size()),
      pressure_ratio_(ground.any_wet() ? grid.own_zones() : 0) {
  for (std::size_t z = 0; z < grid.own_zones(); ++z) {
    const auto [x0, x1, y0, y1] = mean_gradient(corners(grid, z));
    const std::array gradient{x0, x1, y0, y1};
    for (std::size_t k = 0; k < 4; ++k) {
      corners_[k].push_back(static_cast<std::int32_t>(grid.zones[z][k]));
      gradients_[k].push_back(gradient[k]);
    }
  }
}

void Peaks::remember(const Continuum& continuum) {
  motion_.remember(velocities(continuum, points_));
}

void Peaks::raise_demand(std::size_t begin, std::size_t end, const ZoneSet& zones, double time) {
  for (std::size_t z = begin; z < end; ++z)
    if (const double demand = zones.demand(z); demand > demand_[z]) {
      demand_[z] = demand;
      demand_time_[z] = time;
    }
}

void Peaks::raise_pressure_ratio(std::size_t begin, std::size_t end, const ZoneSet& zones) {
  for (std::size_t z = begin; z < end; ++z)
    pressure_ratio_[z] = std::max(pressure_ratio_[z], zones.pressure_ratio(z));
}

void Peaks::take(Continuum& continuum, const protocol::Step& step) {
  const auto ux = continuum.ux(), uy = continuum.uy();
  motion_.take([&](std::size_t i) { return std::array{ux[i], uy[i]}; }, velocities(continuum, points_), step);
  const std::size_t zones = shear_strain_.size(), pieces = 16;
  continuum.team().run(pieces, [&](std::size_t piece, std::size_t) {
    raise_shear_strain(
        zones * piece / pieces, zones * (piece + 1) / pieces,
        {corners_[0].data(), corners_[1].data(), corners_[2].data(), corners_[3].data()},
        {gradients_[0].data(), gradients_[1].data(), gradients_[2].data(), gradients_[3].data()}, ux, uy,
        shear_strain_.data());
    raise_demand(demand_.size() * piece / pieces, demand_.size() * (piece + 1) / pieces, continuum.zones(),
                 step.time());
    raise_pressure_ratio(pressure_ratio_.size() * piece / pieces,
                         pressure_ratio_.size() * (piece + 1) / pieces, continuum.zones());
  });
  continuum.zones().see_stresses(
      continuum.team(), [&](std::span<const std::uint32_t> numbers, const PlaneStresses& stresses) {
        raise_principal(numbers, stresses, largest_principal_, smallest_principal_);
      });
}

}  // namespace adit::fdm
