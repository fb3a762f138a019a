#include "dem_server/engines/general/pairs/bond_breaking.hpp"

#include "dem_server/engines/general/pairs/pair_state.hpp"
#include "dem_server/laws/linear_contact.hpp"
#include "dem_server/laws/parallel_bond.hpp"
#include "dem_server/laws/spring.hpp"

namespace adit::dem {
namespace {

// What the bond gave up, unweighted [J]. A contact that did not act beside it takes over what is compressed.
double released_by(const PairLaw& law, const BondSprings& springs, const PairForces& bond,
                   double contact_normal, const PairKinematics& pair, double dt) {
  const double taken_over =
      law.contact_beside_bond
          ? 0
          : released_energy(contact_normal, law.contact.normal_stiffness, dt * pair.stretch_rate);
  return released_energy(bond.normal, springs.kn, dt * pair.stretch_rate) +
         released_energy(bond.shear, springs.ks, dt * pair.slip_rate) +
         released_energy(bond.moment, springs.km, dt * pair.turn_rate) - taken_over;
}

}  // namespace

bool break_bond(const PairLaw& law, std::uint32_t pair, std::uint32_t k, double dt, const ChunkDiscs& discs,
                Pairs& pairs, ChunkForces& forces, double& released) {
  if (pairs.state[pair] != BondState::kIntact) return false;
  const PairShape s = shape_of(pairs, pair, discs.ux[k], discs.uy[k]);
  const BondSprings springs = springs_of(law, pairs, pair);
  const PairForces bond{bond_normal_force(springs.kn, s.elongation) + pairs.initial[pair], pairs.shear[pair],
                        pairs.moment[pair]};
  const double width = pairs.width[pair];
  const bool tensile = breaks_in_tension(bond, width, law.moment_factor, law.tensile_strength);
  if (!tensile && !breaks_in_shear(bond, width, law.cohesion, law.tan_friction_angle)) return false;

  const Arms arms = arms_of(s.length, pairs.half_difference[pair]);
  const PairKinematics now{s.nx,
                           s.ny,
                           s.length,
                           s.elongation,
                           arms.first,
                           arms.second,
                           along(s.nx, s.ny, discs.vx[k], discs.vy[k]),
                           slip_rate(across(s.nx, s.ny, discs.vx[k], discs.vy[k]), s.length,
                                     pairs.half_difference[pair], discs.spin_sum[k], discs.turn_rate[k]),
                           discs.turn_rate[k]};
  const double contact = contact_normal_force(law.contact.normal_stiffness, s.elongation + pairs.slack[pair]);
  const double w = pairs.weight[pair];
  released += w * released_by(law, springs, bond, contact, now, dt);
  pairs.state[pair] = tensile ? BondState::kTensileCrack : BondState::kShearCrack;
  pairs.shear[pair] = pairs.moment[pair] = 0;

  double normal = contact, shear = pairs.slide[pair];
  if (!pairs.normal_dashpot.empty()) {
    normal += pairs.normal_dashpot[pair];
    shear += pairs.shear_dashpot[pair];
  }
  const PlaneVector force = vector_of(s.nx, s.ny, normal, shear);
  forces.normal[k] = normal;
  forces.x[k] = w * force.x;
  forces.y[k] = w * force.y;
  forces.moment_1[k] = w * shear * arms.first;
  forces.moment_2[k] = w * shear * arms.second;
  return true;
}

}  // namespace adit::dem
