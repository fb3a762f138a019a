// The ground's springs and dashpots at three Gauss points of every element, in three directions.
//
// Spring forces enter the equations through the element's shape functions, ∫ Nᵀ f dx (a consistent
// foundation). The errors of nodal displacements then decrease as h² along the axis and as h⁴ across it.
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

// The energies of the ground springs in one step; see energy.hpp.
struct SoilWork {
  double stored = 0, slip = 0, dashpots = 0, input = 0;
};

class SoilSprings {
 public:
  SoilSprings(const Tunnel& tunnel, const Mesh& mesh, std::span<const Element> elements);

  std::span<const double> chainages() const {
    return chainages_;
  }  // chainages of the Gauss points, ascending

  // Computes the forces at the end of the step from nodal displacements u and velocities v, with the weights
  // of the scheme, and adds Nᵀ f to `forces`. In `ground` the points begin at number `first_support`.
  void evaluate(const Scheme& scheme, std::span<const double> u, std::span<const double> v,
                const GroundState& ground, std::span<double> forces);
  // Updates the tangents Σ Nᵀ k_t N in a matrix by adding their changes. Returns the first link that changed,
  // or links.size() if none did.
  std::size_t update_tangents(BlockTridiagonal& matrix);
  void forget_tangents();  // the next update starts from a matrix without them
  void add_dashpots(BlockTridiagonal& matrix, double factor) const;  // factor Σ Nᵀ c N
  SoilWork commit(const Scheme& scheme);                             // ends the step; returns its work

  static constexpr std::size_t first_support = 1;  // the first support is the portal

 private:
  struct Point {  // interpolation at a Gauss point
    std::array<double, 2> axial;
    std::array<double, 4> lateral, vertical;
  };
  struct Spring {
    double elastic, slider, slider_limit, dashpot;                  // integrated over the point's weight
    double elongation[2] = {}, slider_force[2] = {}, rate[2] = {};  // at the step's start and end
    double ground[2] = {};                                          // displacement of the ground end
    double force[2] = {}, mean_force = 0, slip = 0;
    double tangent = 0, assembled_tangent = 0;
  };
  static void respond(const Scheme& scheme, Spring& spring);

  std::vector<int> links_;  // the link of each element
  std::size_t link_count_;
  std::vector<double> chainages_;
  std::vector<Point> points_;
  std::vector<Spring> springs_;  // by point, direction
};

}  // namespace adit::simplified::beam
