// The ground's springs and dashpots at three Gauss points of every element, in three directions.
//
// Spring forces enter the equations through the element's shape functions, ∫ Nᵀ f dx (a consistent
// foundation). The errors of nodal displacements then decrease as h² along the axis and as h⁴ across it.
//
// One spring: f = m (h k e + s), where the slider s follows (1−h) k Δe and stays within ±(1−h) f_slip.
//
// The multiplier m = 1 − r_u (1 − liquefied) belongs to the ground's pressure ratio r_u, which is given. It
// weakens the force that a spring bears, not only what comes to it: f falls with m while e stands still. With
// Ψ the energy that the sound spring would store, a step then does the work
//     ½(m₀+m₁) (ΔΨ + slip) = Δ(m Ψ) − ½(Ψ₀+Ψ₁) Δm + ½(m₀+m₁) slip,
// so that weakening loses ½(Ψ₀+Ψ₁)(−Δm) ≥ 0. If only the stiffness of increments fell, a spring would bear
// its force further and give back more, f²/(2 m k), than it took.
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
  double stored = 0, slip = 0, weakening = 0, dashpots = 0, input = 0, uplift = 0;
};

class SoilSprings {
 public:
  SoilSprings(const Tunnel& tunnel, const Mesh& mesh, std::span<const Element> elements);

  std::span<const double> chainages() const {
    return chainages_;
  }  // chainages of the Gauss points, ascending

  // Computes the forces at the end of the step from nodal displacements u and velocities v, with the weights
  // of the scheme, and adds Nᵀ f, less the uplift, to `forces`. In `ground` the points begin at number
  // `first_support`.
  void evaluate(const Scheme& scheme, std::span<const double> u, std::span<const double> v,
                const GroundState& ground, std::span<double> forces);
  // Updates the tangents Σ Nᵀ k_t N in a matrix by adding their changes. Returns the first link that changed,
  // or links.size() if none did.
  std::size_t update_tangents(BlockTridiagonal& matrix);
  void forget_tangents();  // the next update starts from a matrix without them
  // Adds factor Σ Nᵀ c N for sound ground; with weaker ground it changes with the tangents.
  void add_dashpots(BlockTridiagonal& matrix, double factor);
  SoilWork commit(const Scheme& scheme);  // ends the step; returns its work

  // In the middle of an element, at the end of the last step.
  double pressure_ratio(std::size_t element) const {
    return points_[kThreePoints.size() * element + 1].pressure_ratio[0];
  }

  static constexpr std::size_t first_support = 1;  // the first support is the portal

 private:
  struct Point {  // interpolation at a Gauss point, and its ground
    std::array<double, 2> axial;
    std::array<double, 4> lateral, vertical;
    double liquefied = 1, uplift = 0;  // as of SoilStation; uplift integrated over the point's weight
    // At the step's start and end; multipliers follow from the ratios.
    double pressure_ratio[2] = {}, multiplier[2] = {1, 1};
  };
  struct Spring {
    double elastic, slider, slider_limit, dashpot;                  // integrated over the point's weight
    double elongation[2] = {}, slider_force[2] = {}, rate[2] = {};  // at the step's start and end
    double ground[2] = {};                                          // displacement of the ground end
    double force[2] = {}, mean_force = 0, slip = 0;
    double tangent = 0, assembled_tangent = 0;
  };
  void respond(const Scheme& scheme, const Point& point, Spring& spring) const;
  static double stored(const Spring& spring, int end);  // Ψ

  std::vector<int> links_;  // the link of each element
  std::size_t link_count_;
  std::vector<double> chainages_;
  std::vector<Point> points_;
  std::vector<Spring> springs_;  // by point, direction
  double dashpot_tangent_ = 0;   // of the matrix, for c = 1
};

}  // namespace adit::simplified::beam
