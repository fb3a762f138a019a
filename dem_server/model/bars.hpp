// Bars through particles: parallel bars along a path, per metre of thickness.
#pragma once

#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "dem_server/laws/bar_bond.hpp"
#include "protocol/materials/steel_law.hpp"

namespace adit::dem {

// Where a bar is held by a particle: in the middle of its way through it.
struct BarNode {
  std::uint32_t disc;
  double x, y;    // at rest [m]
  double length;  // of the bar whose bond acts here [m]
  BarBondLaw bond;
  double dowel_strength;  // to the next node, without tension; of all bars together [N]
  double dowel_stiffness;
};

struct Bar {
  std::vector<BarNode> nodes;  // along the path
  bool closed;                 // the last one is joined to the first
  protocol::SteelLaw steel;
  double limit_strain;      // eps_ud, for the bond of bars that yield
  double area, diameter;    // of all bars together [m^2], of one [m]
  std::uint32_t stage = 0;  // with which it is installed
  std::string path = {};    // in the scene

  std::size_t elements() const { return closed ? nodes.size() : nodes.size() - 1; }
  std::size_t after(std::size_t node) const { return node + 1 < nodes.size() ? node + 1 : 0; }
  double perimeter() const { return 4 * area / diameter; }  // of all bars together [m]
};

}  // namespace adit::dem
