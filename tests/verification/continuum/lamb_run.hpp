// Lamb's problem on the grid beside its closed form.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "fdm_server/solver/continuum.hpp"
#include "fdm_server/zones/critical_step.hpp"
#include "tests/verification/continuum/grids.hpp"
#include "tests/verification/continuum/oracles/lamb.hpp"

namespace adit::fdm::test {
inline const oracle::Medium kGround{plane_strain(1e9, 0.25), 2000};
inline constexpr double kForce = 1e6, kFrequency = 10;

// Largest errors and displacements of one receiver over time [m].
struct Peaks {
  double error_x = 0, error_y = 0, exact_x = 0, exact_y = 0;
};

// Largest errors at receivers so many Rayleigh wavelengths from the load, with so many zones a wavelength.
// The grid is half of the ground (x = 0 is an axis of symmetry) and ends where no reflection comes back in
// time.
inline std::vector<Peaks> lamb_errors(ZoneKind kind, std::vector<double> wavelengths, std::uint32_t zones) {
  const double wavelength = oracle::rayleigh_speed(kGround) / kFrequency, h = wavelength / zones;
  const oracle::Ricker source{kFrequency, 1.2 / kFrequency};
  const double farthest = wavelengths.back() * wavelength;
  const double end = farthest / oracle::rayleigh_speed(kGround) + 2.2 / kFrequency;
  const double reach = kGround.p_speed() * (end - 0.3 / kFrequency);  // of what the load sent out
  const auto columns = static_cast<std::uint32_t>(std::ceil((reach + farthest) / 2 / h));
  const auto rows = static_cast<std::uint32_t>(std::ceil(reach / 2 / h));
  const Grid grid = make_grid({0, columns * h, -(rows * h), 0, columns, rows});
  const std::uint32_t first = rows * (columns + 1);  // of the surface
  std::vector<std::uint32_t> axis;
  for (std::uint32_t j = 0; j <= rows; ++j) axis.push_back(j * (columns + 1));

  const std::vector<double> ones(grid.zones.size(), 1.0);
  Continuum continuum(ZoneSet(kind, grid, kGround.law, ones), lumped_masses(grid, ones, kGround.density),
                      {{{first}, {0}, {-kForce / 2}, [&](double t) { return source(t).real(); }}},
                      {{axis, Axis::kX, 0, [](double) { return 0.0; }}});
  const auto steps = static_cast<std::uint64_t>(
      std::ceil(end / (0.9 * critical_step(kind, grid, kGround.law, kGround.density))));
  const double dt = end / static_cast<double>(steps);
  std::vector<Peaks> peaks(wavelengths.size());
  for (std::uint64_t n = 0; n <= steps; ++n) {
    continuum.step({n, dt});
    if (n % 8 != 0) continue;
    for (std::size_t r = 0; r < wavelengths.size(); ++r) {
      const auto column = static_cast<std::uint32_t>(std::lround(wavelengths[r] * zones));
      const auto [x, y] = oracle::lamb(kGround, kForce, source, column * h, static_cast<double>(n) * dt);
      auto& peak = peaks[r];
      peak.exact_x = std::max(peak.exact_x, std::abs(x));
      peak.exact_y = std::max(peak.exact_y, std::abs(y));
      peak.error_x = std::max(peak.error_x, std::abs(continuum.ux()[first + column] - x));
      peak.error_y = std::max(peak.error_y, std::abs(continuum.uy()[first + column] - y));
    }
  }
  return peaks;
}

}  // namespace adit::fdm::test
