#include "fdm_server/structures/member.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adit::fdm {
namespace {

// Of a beam, by the sense in which its larger moment bends it.
double strength_in_shear(const MemberStrength& strength, const Beam& beam,
                         const sections::FibreSection& section) {
  const BeamForces forces = beam.forces();
  const double moment = std::abs(forces.first) > std::abs(forces.second) ? forces.first : forces.second;
  return sections::shear_capacity(
      section.shape(), strength.shear,
      moment >= 0 ? sections::Bending::kOuterStretched : sections::Bending::kInnerStretched, forces.thrust);
}

bool crushed(const FibreBeam& fibres) {
  return std::ranges::any_of(std::array{0, 1}, [&](std::size_t side) {
    const sections::FibreStates& states = fibres.states(side);
    return fibres.section().crushed(states.strain(), states.curvature());
  });
}

// How far the last end has moved across the first one, over the length.
double drift(std::span<const Beam> beams, std::span<const MemberBeam> member_beams) {
  double x = 0, y = 0, length = 0;
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const Chord& now = member_beams[i].chord();
    x += now.x * now.length;
    y += now.y * now.length;
    length += beams[i].chord().length;
  }
  const Chord& straight = beams.front().chord();
  return std::abs(straight.x * y - straight.y * x) / length;
}

}  // namespace

double axial_failure_drift(const MemberStrength& strength, double thrust) {
  const double tangent = std::tan(65 * std::numbers::pi / 180), compression = std::max(-thrust, 0.0);
  const double stirrups =
      strength.shear.stirrup_area * strength.shear.stirrup_yield * strength.core * tangent;
  return 0.04 * (1 + tangent * tangent) /
         (tangent + (compression > 0 ? compression / stirrups : 0.0));  // without stirrups at once
}

std::optional<double> Member::left() const {
  if (failed_.shear < 0 && failed_.crushed < 0) return std::nullopt;
  return left_;
}

void Member::look(std::span<const Beam> beams, std::span<MemberBeam> member_beams, double time) {
  if (failed_.axial >= 0 || failed_.crushed >= 0) return;
  for (MemberBeam& beam : member_beams)
    if (crushed(*beam.fibres())) {
      beam.lose();
      failed_.crushed = time;
      left_ = 0;
      return;
    }
  slide(beams, member_beams, time);
  if (failed_.shear < 0) return;
  MemberBeam& beam = member_beams[sliding_];
  if (drift(beams, member_beams) < axial_failure_drift(strength_, beams[sliding_].forces().thrust)) return;
  beam.lose();
  failed_.axial = time;
  left_ = 0;
}

void Member::slide(std::span<const Beam> beams, std::span<MemberBeam> member_beams, double time) {
  if (failed_.shear < 0) {
    double most = 1;
    for (std::uint32_t i = 0; i < count_; ++i) {
      const double strength = strength_in_shear(strength_, beams[i], member_beams[i].fibres()->section()),
                   use = std::abs(beams[i].forces().shear) / std::max(strength, 1.0);
      if (use <= most) continue;
      most = use;
      sliding_ = i;
      shear_strength_ = strength;
      failed_.shear = time;
    }
    if (failed_.shear < 0) return;
  }
  const double slid = std::min(member_beams[sliding_].slip() / strength_.sliding, 1.0);
  left_ = shear_strength_ * (1 - (1 - strength_.residual) * slid);
  member_beams[sliding_].limit_shear(left_);
}

}  // namespace adit::fdm
