#include "fdm_server/zones/elastic/pattern_stress.hpp"

#include "fdm_server/zones/shape/assumed_strain.hpp"
#include "fdm_server/zones/shape/mixed_discretization.hpp"

namespace adit::fdm {
namespace {

PatternStress bending_stress(double hx, double hy, double young) {
  const double x = young * hx / 2, y = young * hy / 2;
  return {{x, y}, {x, -y}, {0, 0}};
}

PatternStress triangle_stress(double gx, double gy, double shear) {
  return {{0, 0}, {shear * gx, -shear * gy}, {shear * gy, shear * gx}};
}

void times(std::array<double, 2>& of_amplitudes, const HourglassStiffness& k) {
  const double size = k.xx * k.yy - k.xy * k.xy;
  const auto [x, y] = of_amplitudes;
  of_amplitudes = {(x * k.yy - y * k.xy) / size, (y * k.xx - x * k.xy) / size};
}

}  // namespace

std::array<PatternStress, 4> pattern_stresses(ZoneKind kind, const Corners& corners, const PlaneLaw& law) {
  const bool mixed = kind == ZoneKind::kMixedDiscretization;
  const HourglassStiffness stiffness =
      mixed ? mixed_discretization_stiffness(corners, law) : assumed_strain_stiffness(corners, law);
  std::array<PatternStress, 4> stresses{};
  for (std::size_t k = 0; k < 4; ++k) {
    if (mixed) {
      const auto [gx, gy] = pattern_gradients(triangles(corners))[k];
      stresses[k] = triangle_stress(gx, gy, law.shear);
    } else {
      const auto [area, hx, hy] = corner_points(corners)[k];
      stresses[k] = bending_stress(hx, hy, law.young_prime());
    }
    for (auto* part : {&stresses[k].mean, &stresses[k].difference, &stresses[k].shear})
      times(*part, stiffness);
  }
  return stresses;
}

}  // namespace adit::fdm
