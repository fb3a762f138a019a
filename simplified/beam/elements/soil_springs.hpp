// The ground's springs and dashpots at three Gauss points of every element, in three directions.
//
// Spring forces enter the equations through the element's shape functions, ∫ Nᵀ f dx: a consistent
// foundation. Along the axis, nodal displacements then converge with h², across it with h⁴.
//
// One spring: f = h k e + s, where the slider s follows (1−h) k Δe and stays within ±(1−h) f_slip.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "simplified/beam/elements/element.hpp"
#include "simplified/beam/model/ground_motion.hpp"
#include "simplified/beam/model/mesh.hpp"
#include "simplified/beam/model/scheme.hpp"

namespace adit::simplified::beam {

// Ground springs have three kinds of energy; see energy.hpp.
struct SoilWork {
  double stored = 0, slip = 0, dashpots = 0, input = 0;
};

class SoilSprings {
 public:
  SoilSprings(const Tunnel& tunnel, const Mesh& mesh, std::span<const Element> elements);

  std::span<const double> chainages() const { return chainages_; }  // of the points, ascending

  // Forces at the end of the step for nodal displacements u and velocities v, weighted as the scheme wants;
  // adds Nᵀ f to `forces`. `ground` holds these points with an offset of `first_support`.
  void evaluate(const Scheme& scheme, std::span<const double> u, std::span<const double> v,
                const GroundState& ground, std::span<double> forces);
  // Brings the tangents Σ Nᵀ k_t N within a matrix up to date, by differences. Returns the first link that
  // changed; links.size() if none.
  std::size_t update_tangents(BlockTridiagonal& matrix);
  void forget_tangents();  // the next update starts from a matrix without them
  void add_dashpots(BlockTridiagonal& matrix, double factor) const;  // factor Σ Nᵀ c N
  SoilWork commit(const Scheme& scheme);                             // the step is done; its work

  static constexpr std::size_t first_support = 1;  // the first support is the portal

 private:
  struct Point {  // interpolation at a Gauss point
    std::array<double, 2> axial;
    std::array<double, 4> lateral, vertical;
  };
  struct Spring {
    double elastic, slider, slider_limit, dashpot;                  // integrated over the point's weight
    double elongation[2] = {}, slider_force[2] = {}, rate[2] = {};  // at the step's start and end
    double ground[2] = {};                                          // displacement of the far end
    double force[2] = {}, mean_force = 0, slip = 0;
    double tangent = 0, assembled_tangent = 0;
  };
  static void respond(const Scheme& scheme, Spring& spring);

  std::vector<int> links_;  // of the elements
  std::size_t link_count_;
  std::vector<double> chainages_;
  std::vector<Point> points_;
  std::vector<Spring> springs_;  // by point, direction
};

}  // namespace adit::simplified::beam
