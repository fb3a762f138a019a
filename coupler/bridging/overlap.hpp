// The overlap of a continuum and a particle model, and the energy weights that share it out between them.
#pragma once

#include <span>
#include <vector>

#include "protocol/scene.pb.h"

namespace adit::coupler {

struct BoundingBox {
  double x_min, x_max, y_min, y_max;  // [m]
};

// A strip across the model: the weight of the continuum falls linearly from 1 on the line through
// `particles_begin` to 0 on the line through `continuum_ends`; both lines stand at right angles to the
// segment between the two points.
class Overlap {
 public:
  // Throws protocol::UserError where the two points coincide.
  explicit Overlap(const scene::Overlap& overlap);

  // Weight of the continuum at (x, y), in [0, 1].
  double continuum_weight(double x, double y) const;

  // The rest, which the particles have. On the edge where they begin it is not 0 but very small: a particle
  // there exists and is coupled, else a lattice plane on the edge would leave a gap of half a bond.
  double particle_weight(double x, double y) const;

  // In the strip, edges included: both models exist and are coupled.
  bool contains(double x, double y) const;

  // Whether the edge where the particles begin, or that where the continuum ends, runs through the box.
  bool begins_in(const BoundingBox& model) const;
  bool ends_in(const BoundingBox& model) const;

  // The weight changes along x only, along y only.
  bool follows_x() const { return gradient_y_ == 0.0; }
  bool follows_y() const { return gradient_x_ == 0.0; }

  // Weights at points x0 y0 x1 y1 …
  std::vector<double> continuum_weights(std::span<const double> points) const;
  std::vector<double> particle_weights(std::span<const double> points) const;

  // Box around the part of the strip that lies in `model`.
  BoundingBox bounds(const BoundingBox& model) const;

 private:
  double across(double x, double y) const;  // 0 where the particles begin, 1 where the continuum ends
  bool meets(const BoundingBox& model, double across) const;

  double begin_x_, begin_y_;        // where the particles begin
  double gradient_x_, gradient_y_;  // of the distance across the strip, 0 … 1 [1/m]
};

}  // namespace adit::coupler
