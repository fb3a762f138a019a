// Quantities over time: motions of the particles nearest to the scene's points, means over circles, forces on
// walls, in sections and of springs, motions of joints, diameters of ovals, widths of cracks, demands on
// facets, stress and slip of bars.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dem_server/lining/lining.hpp"
#include "dem_server/observe/circles.hpp"
#include "dem_server/observe/observable.hpp"
#include "protocol/messages/scene.pb.h"
#include "protocol/participant/history.hpp"
#include "protocol/state/archive.hpp"

namespace adit::dem {

// Which of the scene's quantities particles have, and over what.
enum class Over {
  kParticle,
  kCircle,
  kWall,
  kSection,
  kJoint,
  kSpring,
  kOval,
  kCracks,
  kDemand,
  kBar,
  kNothing
};

inline Over taken_over(scene::Quantity quantity) {
  if (protocol::is_motion(quantity)) return Over::kParticle;
  switch (quantity) {
    case scene::STRESS_XX:
    case scene::STRESS_YY:
    case scene::STRESS_XY:
    case scene::STRAIN_RATE_XX:
    case scene::STRAIN_RATE_YY:
    case scene::SHEAR_STRAIN_RATE_XY:
    case scene::COORDINATION:
    case scene::POROSITY:
      return Over::kCircle;
    case scene::FORCE_X:
    case scene::FORCE_Y:
      return Over::kWall;
    case scene::THRUST:
    case scene::MOMENT:
    case scene::SHEAR_FORCE:
    case scene::UTILISATION:
    case scene::SHEAR_STRENGTH:
      return Over::kSection;
    case scene::OPENING:
    case scene::OFFSET:
    case scene::ROTATION:
      return Over::kJoint;
    case scene::SPRING_FORCE:
      return Over::kSpring;
    case scene::LARGEST_DIAMETER_CHANGE:
    case scene::SMALLEST_DIAMETER_CHANGE:
    case scene::LARGEST_DIAMETER_DIRECTION:
      return Over::kOval;
    case scene::CRACK_WIDTH:
      return Over::kCracks;
    case scene::DEMAND:
      return Over::kDemand;
    case scene::BAR_STRESS:
    case scene::BAR_SLIP:
      return Over::kBar;
    default:
      return Over::kNothing;
  }
}

class Histories {
 public:
  // Motions are of the nearest centre at rest, against that nearest to `relative_to` where the scene gives
  // one; of two equally near ones the first. protocol::UserError for a place farther than a diameter from all
  // of them, for circles without radius or particles, for walls, sections, joints, springs, ovals and groups
  // that do not exist, for cracks where there are no cells, for the demand on what cannot break, and for
  // quantities that are none of these.
  Histories(const scene::Particles& scene, const Observable& observed, const Lining& lining);

  // The velocities of these particles await the correction by another model after every step.
  void tie(std::span<const std::uint32_t> particles);

  // Before every step, after the correction of the step before.
  void remember(const Particles& particles);

  // Adds the values at the step just made, in the scene's order and as scene.proto defines them. Circles stay
  // where they are; strain rates are of the velocities of half a step later, NaN where fewer than three
  // particles are left in the circle.
  void read(const Observable& observed, const Lining& lining, const protocol::Step& step,
            std::vector<double>& values) const;

  void exchange(state::Archive& archive) {
    for (History& history : histories_) archive("history_velocity", history.velocity);
  }

 private:
  struct History {
    scene::Quantity quantity;
    std::uint32_t particle = 0;              // of a motion
    std::optional<std::uint32_t> against{};  // the particle that it counts against
    bool tied = false;
    protocol::HalfStepVelocity velocity{};  // its component
    std::optional<Circle> circle{};         // cracks: else in the group
    std::size_t named = 0;  // the wall, section, joint, spring, oval, group or element of a bar
    bool second = false;    // of a bar: which end of the element
  };
  // A component of a particle's motion.
  using MotionOf = double(const Particles& particles, scene::Quantity quantity, std::uint32_t particle);
  static double motion(const History& history, const MotionOf& of, const Particles& particles);
  static bool holds(const History& history, const ObservedCrack& crack, const Observable& observed);

  std::vector<History> histories_;
};

}  // namespace adit::dem
