// The overlap of two models, the outer and the inner one, and the energy weights that share it between them.
//
// The inner model alone fills a shape, the core: half the plane behind a strip, or what a ring lies around.
// The overlap is what lies outside the core, up to `width` away from it; beyond, the outer model is alone.
// With d the distance from the core, the weight of the outer model is a ramp of the depth s = d / width: s
// (linear), 3 s^2 - 2 s^3 (cubic) or one half (constant); the inner model has the rest. Distances are
// Euclidean: a ring's outer edge is rounded at the corners of its core.
//
// A linear ramp passes uniform strain exactly where a strip's edges are lines of the grid and of the lattice.
// Edges that cut zones and bonds, corners and curves cost a strain error of the order of zone size over width
// (tests/verification/bridging/patch_test.cpp): prefer edges on grid lines and wide overlaps.
//
// Where a grid is the outer model, a zone whose samples of the weight are all 0 does not exist
// (fdm_server/grid/samples.hpp). If the core is convex, nothing is lost with it: its corners lie in the core,
// hence all of it, and each point of the overlap lies in a zone that is left, or on its edge. It is so for a
// strip, a box, a circle. A polygon's notch or hole between the samples, half a zone apart, is not seen: the
// zones around it vanish, and a coupling point in it is refused as lying outside the grid. Take zones so
// small that notches and holes are at least one zone wide, or fill them.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "protocol/geometry/shape.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::coupler {

using geometry::BoundingBox;

class Overlap {
 public:
  // `path`: of the interface in the scene, for messages. Throws protocol::UserError for an overlap that is
  // not exactly one of strip and ring, has no width, or lies around what encloses no area.
  Overlap(const scene::Interface& interface, const std::string& path);

  // Weight of the outer model at (x, y), in [0, 1]; 0 on the line where it ends.
  double outer_weight(double x, double y) const;

  // The rest, which the inner model has. On the line where that ends it is not 0 but very small: a particle
  // there exists and is coupled, else a lattice plane on the line would leave a gap of half a bond.
  double inner_weight(double x, double y) const;

  // In the overlap, edges included: both models exist and are coupled.
  bool contains(double x, double y) const;

  // 0 where the outer model ends, 1 where the inner one does, linear in the distance between, whatever the
  // ramp; 0 and 1 beyond.
  double depth(double x, double y) const;

  // Weights at points x0 y0 x1 y1 …
  std::vector<double> outer_weights(std::span<const double> points) const;
  std::vector<double> inner_weights(std::span<const double> points) const;

  // Box around the part of the overlap that lies in `model`.
  BoundingBox bounds(const BoundingBox& model) const;

  const scene::Interface& interface() const { return interface_; }
  const std::string& path() const { return path_; }
  bool is_ring() const { return interface_.overlap().has_around(); }
  const geometry::Shape& core() const { return *core_; }
  double width() const { return width_; }  // [m]

 private:
  double share(double x, double y) const;  // depth, not clamped
  double edge(double x, double y) const;   // half the thickness of an edge, in depths

  scene::Interface interface_;
  std::string path_;
  std::shared_ptr<const geometry::Shape> core_;
  double width_;
};

}  // namespace adit::coupler
