#include "fdm_server/materials/admissible.hpp"

#include <cmath>

namespace adit::fdm {
namespace {

double size(const SolidStress& s) {
  return std::abs(s.xx) + std::abs(s.yy) + std::abs(s.zz) + std::abs(s.xy);
}

// What a return changes by rounding only, it leaves alone: a stress may lie on both strengths at once.
bool stays(const Admissible& from, const Admissible& to) {
  return to.yields == kElastic || size(from.stress - to.stress) <= 1e-12 * size(from.stress);
}

}  // namespace

Admissible admissible(const Material& material, const Elasticity& elasticity, double plastic_shear_strain,
                      const SolidStress& predicted, const PlaneDirection& planes) {
  // The strength stays that at the start of the step; softening acts from the next step on.
  const auto to_ground = [&](const Admissible& from) -> Admissible {
    if (!material.mohr_coulomb) return {from.stress, from.plastic_shear_strain, kElastic};
    const auto [stress, yields] =
        material.mohr_coulomb->admissible(elasticity, plastic_shear_strain, from.stress);
    if (yields == kElastic) return {stress, from.plastic_shear_strain, kElastic};
    // The total strain does not change in a return, so the elastic strain that the stress loses is plastic
    // strain.
    return {stress, from.plastic_shear_strain + shear_measure(strain_of(elasticity, from.stress - stress)),
            yields};
  };
  const auto to_plane = [&](const Admissible& from) -> Admissible {
    const auto [stress, yields] = material.weak_plane->admissible(elasticity, from.stress, planes);
    return {stress, from.plastic_shear_strain, yields};
  };
  const Admissible start{predicted, 0, kElastic};
  if (!material.weak_plane) return to_ground(start);

  const auto on_plane = to_plane(start);
  if (stays(on_plane, to_ground(on_plane))) return on_plane;
  Admissible now = to_ground(start);
  unsigned yields = now.yields;
  constexpr int kMost = 100;  // each return takes a share of what is left outside
  for (int turn = 0; turn < kMost; ++turn) {
    const auto next = turn % 2 == 0 ? to_plane(now) : to_ground(now);
    if (stays(now, next)) break;
    now = next;
    yields |= now.yields;
  }
  now.yields = yields;
  return now;
}

}  // namespace adit::fdm
