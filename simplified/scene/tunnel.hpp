// The scene's tunnel along its chainage: where what is.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "protocol/messages/scene.pb.h"

namespace adit::simplified {

struct PlacedJoint {
  double chainage;    // [m]
  std::size_t group;  // of tunnel.joints
};

struct Line {
  std::vector<double> nodes;            // [m], ascending, first and last are the portals; every joint is one
  std::vector<std::size_t> section;     // of tunnel.sections, one a piece between two nodes
  std::vector<PlacedJoint> joints;      // ascending
  std::vector<std::size_t> joint_node;  // of nodes, one a joint
};

// Divides the tunnel into elements or bodies. Throws UserError at "simplified.tunnel…" for sections with a
// gap or an overlap between them, for joints outside the tunnel, and for groups that name no place.
Line divide(const scene::Tunnel& tunnel);

// Depth of the axis below the ground's surface [m].
double axis_depth(const scene::Tunnel& tunnel, double chainage);

}  // namespace adit::simplified
