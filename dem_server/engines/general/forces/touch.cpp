#include "dem_server/engines/general/forces/touch.hpp"

#include "dem_server/laws/spring.hpp"

namespace adit::dem {
namespace {

double inverse_slip_mass(const InverseMasses& inverse, const Arms& arms) {
  return inverse_slip_mass(inverse.mass_1 + inverse.mass_2, arms, inverse.inertia_1, inverse.inertia_2);
}

}  // namespace

// Where the surfaces part, friction has taken what the shear spring held.
TouchStep advance(const LinearContact& law, const Encounter& now, const InverseMasses& inverse, double dt,
                  Touch& touch) {
  const Touch before = touch;
  LinearContact stiffened = law;
  stiffened.normal_stiffness *= now.stiffening;
  const bool touches = now.gap < 0;
  const ContactSprings springs = contact_springs(stiffened, now.gap, now.slip_rate, dt, before.shear);
  TouchStep step;
  touch = {};
  if (touches) {
    const Arms lever_n{across(now.nx, now.ny, now.arm_1.x, now.arm_1.y),
                       across(now.nx, now.ny, now.arm_2.x, now.arm_2.y)},
        lever_t{along(now.nx, now.ny, now.arm_1.x, now.arm_1.y),
                along(now.nx, now.ny, now.arm_2.x, now.arm_2.y)};
    step.forces = with_dashpots(stiffened, springs, true, inverse_slip_mass(inverse, lever_n),
                                inverse_slip_mass(inverse, lever_t), now.stretch_rate, now.slip_rate, dt);
    touch = {stiffened.normal_stiffness,
             springs.shear,
             step.forces.normal,
             {step.forces.normal - springs.normal, step.forces.shear - springs.shear}};
  }
  if (law.shear_stiffness > 0)
    step.loss.friction = stiffness_times_friction_work(springs, before.shear) / law.shear_stiffness;
  step.loss.dashpots = dashpot_work(dt, before.dashpots, touch.dashpots, now.stretch_rate, now.slip_rate);
  return step;
}

double strain_energy(const LinearContact& law, const Touch& touch) {
  return spring_energy(touch.normal - touch.dashpots.normal, touch.stiffness) +
         spring_energy(touch.shear, law.shear_stiffness);
}

}  // namespace adit::dem
