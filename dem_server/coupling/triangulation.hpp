// The field between the particles: linear on every triangle of three particles that are bonded to each other.
// In a hexagonal packing these triangles are the lattice itself.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "dem_server/particles/bonded_neighbours.hpp"
#include "dem_server/particles/particles.hpp"
#include "protocol/geometry/cells.hpp"

namespace adit::dem {

// Shares of a triangle's particles: they sum to 1 and give the value of every linear field at the place.
struct TrianglePlace {
  std::array<std::uint32_t, 3> particles;
  std::array<double, 3> shares;
};

class Triangulation {
 public:
  Triangulation(const Particles& particles, const BondEnds& bonds);

  // The triangle that holds (x, y) [m]; outside of all, the nearest one, continued linearly, if it lies
  // within a particle's diameter: that is what the notches at the ends of a packing's rows and the halves of
  // its outermost particles need. A place within 1e-9 of a side or a corner depends on its particles only.
  std::optional<TrianglePlace> locate(double x, double y) const;

 private:
  using Triangle = std::array<std::uint32_t, 3>;

  void find_triangles(const BondEnds& bonds);
  const Triangle* holding(double x, double y) const;
  const Triangle* nearest(double x, double y) const;  // within reach
  std::array<double, 3> shares(const Triangle& triangle, double x, double y) const;
  double distance(const Triangle& triangle, double x, double y) const;

  const Particles& particles_;
  std::vector<Triangle> triangles_;
  double reach_;  // the longest bond, a diameter [m]
  protocol::Cells cells_;
};

}  // namespace adit::dem
