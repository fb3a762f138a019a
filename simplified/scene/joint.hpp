// The force laws of a joint of the scene, for both models.
#pragma once

#include <string>

#include "protocol/messages/scene.pb.h"
#include "simplified/beam/model/tunnel.hpp"
#include "simplified/chain/model/chain.hpp"
#include "simplified/scene/tunnel.hpp"

namespace adit::simplified {

// A rectangle about the axis, across it [m].
struct Outline {
  double width, height;
  double perimeter() const { return 2 * (width + height); }
  // Second moment of the perimeter over its length, for rotation in the horizontal (vertical) plane [m^2].
  double lateral_lever2() const { return lever2(width, height); }
  double vertical_lever2() const { return lever2(height, width); }

 private:
  // The two sides b at the ends of the lever a contribute 2 b (a/2)^2, the two sides along it 2 a^3/12.
  static double lever2(double a, double b) { return (b * a * a / 2 + a * a * a / 6) / (2 * (a + b)); }
};

// The outline of the joint at a node inside the tunnel: the rectangle that the faces of the sections before
// and after it have in common. Gaskets, cables and bolts bear on both faces, so they lie within it, and the
// edges that open against each other by rotation are its edges. Counting the chainage from the other end
// changes nothing.
Outline joint_outline(const scene::Tunnel& tunnel, const Line& line, std::size_t node);

// Throws UserError below `path`, the path of the group, if its tables or its parts do not describe a joint.
void check(const scene::Joints& group, const std::string& path);

beam::Joint beam_joint(const scene::Joints& group, const Outline& outline, double chainage);

// The flexibility of the lining between the centres of two rigid bodies [m/N], [rad/(N m)]. A hinge is the
// joint and this lining in series.
struct Flexibility {
  double axial, lateral, rotation;
};
chain::Hinge hinge(const scene::Joints& group, const Outline& outline, const Flexibility& lining);
chain::Hinge hinge(const Flexibility& lining);  // the lining alone, where there is no joint

}  // namespace adit::simplified
