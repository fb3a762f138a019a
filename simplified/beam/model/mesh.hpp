// Nodes along the axis, and the links between neighbouring nodes: beam elements, and joints without length.
#pragma once

#include <vector>

#include "simplified/beam/model/tunnel.hpp"

namespace adit::simplified::beam {

struct Link {
  int section = -1;  // section of the beam element; −1 for a joint
  int joint = -1;    // number of the joint; −1 for an element
};

struct Mesh {
  std::vector<double> nodes;  // [m] chainages, two at a joint
  std::vector<Link> links;    // links[i] joins nodes i and i + 1
  std::vector<int> elements;  // links that are beam elements, in order
  std::vector<int> joints;    // links that are joints: those of the tunnel, in order
};

Mesh build_mesh(const Tunnel& tunnel);  // the tunnel must have been checked

}  // namespace adit::simplified::beam
