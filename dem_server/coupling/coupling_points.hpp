// How the particles follow the coupling points: each is a particle's centre, or lies between three particles.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/particles/bonded_neighbours.hpp"
#include "dem_server/particles/particles.hpp"
#include "dem_server/particles/prescribed_motions.hpp"
#include "protocol/geometry/bounding_box.hpp"
#include "protocol/participant/interface/interface_operator.hpp"

namespace adit::dem {

class CouplingPoints {
 public:
  // Offers the particles with their centre (at rest) inside or on the box; returns their centres, x0 y0 x1 y1
  // …
  std::vector<double> offer(const Particles& particles, const geometry::BoundingBox& box);

  // Ties the particles to these places: to an offered centre, bit by bit, that particle alone, elsewhere the
  // triangle of particles around (triangulation.hpp). UserError where the particles do not reach.
  void tie(std::span<const double> places, const Particles& particles, const BondEnds& bonds,
           const PrescribedMotions& motions);

  std::size_t size() const { return operator_.rows(); }
  std::span<const std::uint32_t> particles() const { return operator_.points(); }  // tied, ascending

  const protocol::InterfaceOperator& interpolation() const { return operator_; }  // N
  // Weighted, for x and for y of each tied particle [1/kg]; 0 where the motion is prescribed.
  std::span<const double> inverse_masses() const { return inverse_masses_; }
  // The particles have other masses from now on.
  void take_masses(const Particles& particles);

  // v += N^T impulse / m; the impulses [N s] stand x0 y0 x1 y1 … A prescribed component does not yield: the
  // reaction of its motion takes the impulse up. The kick that they correct lasted `kick` seconds.
  void push(std::span<const double> impulses, double kick, Particles& particles, PrescribedMotions& motions);

  // Velocities at the coupling points, x0 y0 x1 y1 … [m/s]
  void read_velocities(const Particles& particles, std::span<double> velocities) const;

 private:
  std::vector<std::uint32_t> offered_;
  protocol::InterfaceOperator operator_;
  std::vector<double> inverse_masses_;
};

}  // namespace adit::dem
