// Which of the scene's quantities particles have, and over what.
#pragma once

#include "protocol/messages/scene.pb.h"
#include "protocol/participant/history.hpp"

namespace adit::dem {

enum class Over { kParticle, kCircle, kWall, kSection, kJoint, kSpring, kOval, kNothing };

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
    default:
      return Over::kNothing;
  }
}

}  // namespace adit::dem
