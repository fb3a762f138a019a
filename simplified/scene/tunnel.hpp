// The scene's tunnel along its chainage: pieces, sections and joints.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "protocol/messages/scene.pb.h"

namespace adit::simplified {

struct PlacedJoint {
  double chainage;    // [m]
  std::size_t group;  // number in tunnel.joints
};

struct Line {
  std::vector<double> nodes;            // [m], ascending, first and last are the portals; every joint is one
  std::vector<std::size_t> section;     // number in tunnel.sections, for each piece between two nodes
  std::vector<PlacedJoint> joints;      // ascending
  std::vector<std::size_t> joint_node;  // number in `nodes`, for each joint
};

// Divides the tunnel into elements or bodies. Throws UserError at "simplified.tunnel…" if there is a gap or
// an overlap between sections, if a joint lies outside the tunnel, or if a group gives no place.
Line divide(const scene::Tunnel& tunnel);

// Depth of the axis below the ground's surface [m].
double axis_depth(const scene::Tunnel& tunnel, double chainage);

// The section at a chainage; where two meet, the first of them. Beyond the portals, that of the portal.
const scene::Section& section_at(const scene::Tunnel& tunnel, double chainage);

// The depths between which a section lies there, below the ground's surface [m].
struct Heights {
  double top, bottom;
};
Heights heights(const scene::Tunnel& tunnel, double chainage, const scene::Section& section);

}  // namespace adit::simplified
