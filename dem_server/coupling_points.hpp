// Particles whose velocities are tied to the continuum: every coupling point is the centre of one of them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/assembly.hpp"
#include "dem_server/motions.hpp"

namespace adit::dem {

class CouplingPoints {
 public:
  // Offers the particles with their centre (at rest) inside or on the box; returns their centres, x0 y0 x1 y1
  // …
  std::vector<double> offer(const Particles& particles, const Rectangle& box);

  // Ties the particles with these centres, which must be among those offered, bit by bit and each once;
  // anything else is the caller's bug, std::logic_error.
  void tie(std::span<const double> points, const Particles& particles, const Motions& motions);

  std::size_t size() const { return particles_.size(); }

  // Inverse weighted masses for x and for y of each tied particle, 0 where the motion is prescribed [1/kg].
  std::span<const double> inverse_masses() const { return inverse_masses_; }

  // v += impulse / m; the impulses [N s] stand x0 y0 x1 y1 …
  void push(std::span<const double> impulses, Particles& particles) const;

  // Velocities of the tied particles, x0 y0 x1 y1 … [m/s]
  void read_velocities(const Particles& particles, std::span<double> velocities) const;

 private:
  std::vector<std::uint32_t> offered_;
  std::vector<std::uint32_t> particles_;
  std::vector<double> inverse_masses_;
};

}  // namespace adit::dem
