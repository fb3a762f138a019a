// The flow of water through the pores of the ground (Darcy), after each step of the mechanics, which changes
// the pressure as if no water flowed (undrained split; Armero & Simo 1992, Int. J. Numer. Meth. Eng. 35):
//   du/dt = M div(k grad u),   du = M zeta,
// with the excess pressure u over that of water at rest [Pa], M the bulk modulus of the water over the
// porosity [Pa], k the mobility (faces.hpp), and zeta the volume of water that flowed into a zone over the
// volume of the zone.
//
// Explicit up to the critical step. Beyond it backward Euler, for which no step is too long: it is L-stable,
// so that differences between neighbours die out instead of going on with alternating sign as by the
// trapezoidal rule, and no pressure leaves the range of those before. Its error of first order lies in what
// is over within a few steps; the flow of whole regions takes many. The forces of a step see what its own
// change of volume does before water has left, though: waves that drain within a few steps, of which
// M k over the square of their length times pi is near their frequency, are damped too much.
//
// The correction of skewed sides (faces.hpp) is that of the state before the step in both, so that the matrix
// stays symmetric, and a flow that is steady is exact. On a uniform grid of parallelograms, an angle theta
// away from rectangles, the correction is at most sin(theta) of the two-point part for any wave: with s, c
// and S, C the sines and cosines of half the phase from zone to zone both ways, both are in proportion to
//   2 tan(theta) s c S C   and   (1 + tan(theta)^2) s^2 + S^2.
// So steps of any length are stable there, and those up to the critical one. For other grids this is not
// proven; it was found true for zones distorted by a third of their size and sheared by 63 degrees,
// mobilities 100 to 1 and zones 10 to 1.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "fdm_server/grid/field_arrays.hpp"
#include "fdm_server/grid/grid.hpp"
#include "fdm_server/water/faces.hpp"
#include "fdm_server/zones/batch/batch.hpp"
#include "protocol/kernels/symmetric_factor.hpp"
#include "protocol/threads/index_ranges.hpp"
#include "protocol/threads/team.hpp"

namespace adit::fdm {

class Flow {
 public:
  // `stiffness`: M of each zone [Pa]; those of zones without passages are not used.
  Flow(const Grid& grid, Faces faces, std::span<const double> stiffness);

  // The longest step that is made explicitly [s]: 1 over the largest sum of magnitudes in a row of the
  // operator that gives -du/dt, which bounds its eigenvalues (Gershgorin). Without skewed sides the operator
  // is symmetric in the metric of the storage and semidefinite. So no pattern changes its sign from step to
  // step, as those of steps up to twice as long do before they die out, and each pressure becomes a mean of
  // those before, with weights that are not negative. Infinite where no water flows.
  double critical_step() const { return critical_step_; }

  // Finds the inflow zeta of each zone in a step [s] from its excess pressure at its beginning. One value for
  // each zone of the grid; those of zones without passages are neither read nor written.
  void step(protocol::Team& team, double dt, std::span<const double> excess, std::span<double> inflow);

  // Since the start: the water that left through open sides [m^3 per metre of thickness], and the energy of
  // the excess pressure, u^2/2M of each volume, that the flow took [J per metre]: dt times the sum of T (u_a
  // - u_b)^2 over all passages where steps are short.
  double left() const { return left_; }
  double dissipated() const { return dissipated_; }

 private:
  // A zone with an open side.
  struct Outlet {
    std::uint32_t zone;
    double transmissibility;
  };

  // Consecutive zones, at most kBatch, whose neighbours are consecutive, too.
  struct Run {
    std::uint32_t first, count;
    std::array<std::uint32_t, 4> beyond;  // the sides of the first zone, as of WaterPassage
  };

  static std::vector<Run> lay_out(const protocol::IndexRange& zones, std::span<const WaterPassages> passages);
  double storage(std::size_t zone) const { return 1 / (per_area_[zone] * stiffness_[zone]); }  // [m^2/Pa]
  double largest_row() const;
  void cross(protocol::Team& team, std::span<const double> excess);
  std::span<const double> end_of_step(double dt, std::span<const double> excess);
  void factor(double dt);
  void gather(protocol::Team& team, double dt, std::span<const double> flowing,
              std::span<const double> excess, std::span<double> inflow);

  // Of a run: adds up the inflow, and returns the energy that is lost.
  double gather(const Run& run, double dt, std::span<const double> flowing, std::span<const double> excess,
                std::span<double> inflow) const;

  Faces faces_;
  std::vector<Outlet> outlets_;
  std::vector<protocol::IndexRange> chunks_, skewed_chunks_;  // of zones with passages, of faces_.skewed
  std::vector<std::vector<Run>> runs_;                        // of each chunk
  FieldArrays<4> transmissibilities_;                         // of each zone's sides
  BatchValues zeros_{};
  std::vector<double> stiffness_, per_area_;  // of each zone: M [Pa], 1/area [1/m^2]
  double critical_step_;
  std::vector<Eigen::Vector2d> gradients_;  // of u in skewed zones [Pa/m]; none where no zone is skewed
  std::vector<double> crossing_;            // into each zone by the correction [m^2/s]; likewise
  std::vector<double> energies_;            // that each chunk took in a step
  std::vector<double> end_;                 // u at the end of an implicit step

  // Storage and dt times the two-point part, for the last long step.
  std::optional<protocol::SymmetricFactor> factor_;
  double factor_step_ = 0;
  Eigen::Array<double, 1, Eigen::Dynamic> solution_;

  double left_ = 0, dissipated_ = 0;
};

}  // namespace adit::fdm
