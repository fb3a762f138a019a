// A joint of the scene as force laws, for both models.
#pragma once

#include <string>

#include "protocol/messages/scene.pb.h"
#include "simplified/beam/model/tunnel.hpp"
#include "simplified/chain/model/chain.hpp"

namespace adit::simplified {

// The outer rectangle of the cross-section [m].
struct Outline {
  double width, height;
  double perimeter() const { return 2 * (width + height); }
  // Second moment of the perimeter over its length, for rotation in the horizontal (vertical) plane [m^2].
  double lateral_lever2() const { return lever2(width, height); }
  double vertical_lever2() const { return lever2(height, width); }

 private:
  // 2 b (a/2)^2 of the sides at the ends of the lever, 2 a^3/12 of those along it.
  static double lever2(double a, double b) { return (b * a * a / 2 + a * a * a / 6) / (2 * (a + b)); }
};

// Throws UserError below `path`, the group's, where its tables or its parts make no joint.
void check(const scene::Joints& group, const std::string& path);

beam::Joint beam_joint(const scene::Joints& group, const Outline& outline, double chainage);

// The joint and the lining between the centres of the two rigid bodies, in series: `flexibility` is that of
// the lining [m/N], [rad/(N m)].
struct Flexibility {
  double axial, lateral, rotation;
};
chain::Hinge hinge(const scene::Joints& group, const Outline& outline, const Flexibility& lining);
chain::Hinge hinge(const Flexibility& lining);  // no joint: the lining alone

}  // namespace adit::simplified
