// Writes how fast waves travel over regular square grids, as CSV: the zone, Poisson's ratio, zones a
// wavelength, angle from the zones' sides [degrees; empty: the Rayleigh wave], wave, relative error of its
// phase velocity at 0.9 of the critical step.
#include <cstdio>
#include <numbers>

#include "tests/verification/continuum/dispersion.hpp"
#include "tests/verification/continuum/oracles/harmonic_wave.hpp"

int main() {
  using namespace adit::fdm;
  std::puts("zone,poisson,zones,angle,wave,error");
  for (const auto kind : {ZoneKind::kAssumedStrain, ZoneKind::kMixedDiscretization})
    for (const double poisson : {0.25, 0.45}) {
      const char* zone = kind == ZoneKind::kAssumedStrain ? "assumed strain" : "mixed discretization";
      const oracle::Medium medium{plane_strain(1e9, poisson), 2000};
      const test::Dispersion grid(kind, 1, 1, medium.law, medium.density, 0.9);
      for (const std::uint32_t zones : {6u, 8u, 10u, 12u, 16u, 20u, 24u, 32u, 40u}) {
        const double k = 2 * std::numbers::pi / zones;
        for (int angle = 0; angle <= 45; angle += 5) {
          const auto [s, p] = grid.speeds(k, angle * std::numbers::pi / 180);
          std::printf("%s,%g,%u,%d,S,%.6f\n", zone, poisson, zones, angle, s / medium.s_speed() - 1);
          std::printf("%s,%g,%u,%d,P,%.6f\n", zone, poisson, zones, angle, p / medium.p_speed() - 1);
        }
        std::printf("%s,%g,%u,,Rayleigh,%.6f\n", zone, poisson, zones,
                    grid.rayleigh_speed(k, 3 * zones) / oracle::rayleigh_speed(medium) - 1);
      }
    }
}
