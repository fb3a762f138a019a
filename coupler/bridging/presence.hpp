// Where a model is, known by its sample points alone: an overlap then follows the true shape of zones and
// particles, free faces and holes included, whichever program computes them.
//
// The local spacing s at a sample is the distance to its eighth nearest one: 0.7 zones in a grid of squares
// that is sampled at points, edges and middles; 1.7 radii in a hexagonal lattice that is sampled at centres
// and bonds. The model is taken to reach 1.5 s beyond each of its samples: a packing fills a box up to 1.8
// radii before its sides, and the middle of a zone reaches its corners, whatever lies beside it.
#pragma once

#include <memory>
#include <span>

namespace adit::coupler {

class Presence {
 public:
  explicit Presence(std::span<const double> samples);  // x0 y0 x1 y1 … [m]
  ~Presence();

  bool is_nowhere() const;

  // How far (x, y) lies from where the model is [m]: 0 within 1.5 s of a sample or `slack` of the nearest,
  // otherwise the distance to that; infinite for a model that is nowhere.
  double gap(double x, double y, double slack) const;

  // Whether the model lies to the left and right of (x, y), and above and below: a place without it is then a
  // hole in it.
  bool surrounds(double x, double y) const;

  // The local spacing at the sample nearest to (x, y) [m].
  double spacing(double x, double y) const;
  // The size there of a zone, of which that is half a diagonal, or of a particle, about [m].
  double size(double x, double y) const;

 private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

}  // namespace adit::coupler
