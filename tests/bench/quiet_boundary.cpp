// Prints what quiet boundaries send back of plane waves, over the angle from the normal: theory and grid.
#include <cstdio>

#include "tests/verification/boundaries/quiet_reflection.hpp"

int main() {
  using namespace adit::fdm;
  using namespace adit::fdm::test;
  const Medium medium{plane_strain(1, 0.25), 1};
  std::puts("wave,angle_deg,theory,assumed_strain,mixed_discretization");
  for (const Incident wave : {Incident::kP, Incident::kSv})
    for (int degrees = 0; degrees <= 80; degrees += 5) {
      const double angle = degrees * std::numbers::pi / 180;
      // a flat packet is long: fewer wavelengths and zones
      const Sampling sampling{.zones_per_wavelength = degrees <= 60 ? 20.0 : 15.0,
                              .wavelengths = degrees <= 45 ? 2 : 1.2};
      std::printf("%s,%d,%.6f", wave == Incident::kP ? "P" : "SV", degrees,
                  reflected_in_theory(medium, wave, angle));
      for (const ZoneKind kind : {ZoneKind::kAssumedStrain, ZoneKind::kMixedDiscretization})
        std::printf(",%.6f", reflected_by_the_grid(kind, medium, wave, angle, sampling));
      std::puts("");
      std::fflush(stdout);
    }
}
