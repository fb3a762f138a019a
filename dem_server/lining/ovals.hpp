// How the diameters of a ring of particles change.
//
// The ring moves as a whole by the median of the displacements of all its particles, which is taken off
// first: in an earthquake it is much larger. The annulus is divided into K equal sectors. The median of the
// radial displacements in a sector stands for its middle direction t_k. Medians do not follow loose grains.
// With
//   u(t) = c + a cos 2t + b sin 2t + odd harmonics, which change no diameter, + even ones from the fourth on
// the sums over equal sectors give c = sum u_k / K, a = 2 sum u_k cos 2t_k / K, b = 2 sum u_k sin 2t_k / K.
// The diameter in the direction t changes by 2 u without the odd and higher harmonics: at most by 2 (c +
// sqrt(a^2 + b^2)), in the direction atan2(b, a) / 2, and least across it, by 2 (c - sqrt(a^2 + b^2)).
// Rotations are small.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "dem_server/particles/particles.hpp"
#include "protocol/geometry/shape.hpp"
#include "protocol/state/archive.hpp"

namespace adit::dem {

struct DiameterChange {
  double largest, smallest;  // [m], shortening is negative
  double direction;          // of the largest, from x, -pi/2 to pi/2
};

class Oval {
 public:
  // Particles whose centres lie between the radii, in sectors of about two diameters and more.
  Oval(std::string name, const geometry::Point& centre, double inner_radius, double outer_radius,
       const Particles& particles);

  const std::string& name() const { return name_; }
  const geometry::Point& centre() const { return centre_; }
  bool is_whole() const;  // every sector has particles

  // Since time began, or as displacements count. NaN while a sector has no particles.
  DiameterChange change(const Particles& particles) const;

 private:
  std::size_t sector_at(double place) const;
  double middle_of(std::size_t sector) const;  // direction, from x
  geometry::Point translation(const Particles& particles) const;
  // Median displacement of a sector, without the translation of the ring.
  double outwards(std::size_t sector, const geometry::Point& moved, const Particles& particles) const;

  std::string name_;
  geometry::Point centre_;
  std::vector<std::vector<std::uint32_t>> sectors_;
};

// The extremes of rings over the times that are looked at.
class OvalEnvelope {
 public:
  struct Extreme {
    double value, time, direction;  // [m], [s], of the diameter, from x
  };

  // The changes of all rings at a time [s], ascending.
  void take(std::span<const DiameterChange> changes, double time);

  // One of each ring; empty before anything was taken.
  std::span<const Extreme> largest() const { return largest_; }
  std::span<const Extreme> smallest() const { return smallest_; }

  void exchange(std::size_t ovals, state::Archive& archive) {
    archive.all_or_none("oval_extremes", {&largest_, &smallest_}, ovals);
  }

 private:
  std::vector<Extreme> largest_, smallest_;
};

}  // namespace adit::dem
