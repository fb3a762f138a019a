// The overlap of two models, the outer and the inner one, and the weights by which they share its energy.
//
// The inner model alone fills a shape, the core: half the plane behind a strip, or the shape inside a ring.
// The overlap consists of the points outside the core, up to a distance `width` from it. Beyond the overlap
// there is the outer model alone. With d the distance from the core, the weight of the outer model is a ramp
// over the depth s = d / width: s (linear), 3 s^2 - 2 s^3 (cubic) or one half (constant). The inner model has
// the rest. Distances are Euclidean, so the outer edge of a ring is rounded at the corners of its core.
//
// A linear ramp passes uniform strain exactly if the edges of a strip are lines of the grid and of the
// lattice. Edges that cut zones and bonds, corners, and curves cause a strain error of the order of zone size
// over width (tests/verification/bridging/patch_test.cpp); so prefer edges on grid lines, and wide overlaps.
//
// If a grid is the outer model, a zone whose weights are 0 at all sampling points is left out, and so is one
// of which only a sliver is left, in which the next zone's motion goes on (fdm_server/grid/samples.hpp). With
// a convex core nothing is missing then: all corners of such a zone lie in the core, and so does the whole
// zone, so that each point of the overlap lies in a remaining zone or on its edge. Strips, boxes and circles
// have convex cores. A notch or a hole of a polygon that lies between the sampling points, half a zone apart,
// is not found: the zones around it are left out, and a coupling point in it is refused as lying outside the
// grid. Notches and holes must therefore be at least one zone wide.
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
  // `path` is the path of the interface in the scene, for messages. Throws protocol::UserError if the overlap
  // is not exactly one of strip and ring, has no width, or lies around a shape that encloses no area.
  Overlap(const scene::Interface& interface, const std::string& path);

  // Weight of the outer model at (x, y), in [0, 1]; 0 on the edge where it ends.
  double outer_weight(double x, double y) const;

  // Weight of the inner model, the rest. On the edge where the inner model ends it is not 0 but very small. A
  // particle on that edge therefore exists and is coupled; without it, a row of the lattice on the edge would
  // leave a gap of half a bond.
  double inner_weight(double x, double y) const;

  // Whether (x, y) lies in the overlap, edges included, where both models exist and are coupled.
  bool contains(double x, double y) const;

  // Depth s at (x, y): 0 where the outer model ends, 1 where the inner model ends, linear in the distance
  // between them for every ramp, constant beyond them.
  double depth(double x, double y) const;

  // Box around the part of the overlap that lies in `model`.
  BoundingBox bounds(const BoundingBox& model) const;

  const scene::Interface& interface() const { return interface_; }
  const std::string& path() const { return path_; }
  bool is_ring() const { return interface_.overlap().has_around(); }
  const geometry::Shape& core() const { return *core_; }
  double width() const { return width_; }  // [m]

 private:
  double share(double x, double y) const;  // depth, not clamped
  double edge(double x, double y) const;   // half the thickness of an edge, as a difference of depths

  scene::Interface interface_;
  std::string path_;
  std::shared_ptr<const geometry::Shape> core_;
  double width_;
};

}  // namespace adit::coupler
