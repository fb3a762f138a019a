// Nodes along the axis and the links between each and the next: a beam element, or a joint of no length.
#pragma once

#include <vector>

#include "simplified/beam/model/tunnel.hpp"

namespace adit::simplified::beam {

struct Link {
  int section = -1;  // of the beam element, or −1
  int joint = -1;    // or −1
};

struct Mesh {
  std::vector<double> nodes;  // [m] chainages, two at a joint
  std::vector<Link> links;    // links[i] joins nodes i and i + 1
  std::vector<int> elements;  // links that are beam elements, in order
  std::vector<int> joints;    // links that are joints: those of the tunnel, in order
};

Mesh build_mesh(const Tunnel& tunnel);  // of a checked tunnel

}  // namespace adit::simplified::beam
