// Soil columns along a tunnel, joined by longitudinal springs into one plane mass-spring model. Each column
// has its own layers and its own base motion.
//
// Column j represents the ground over its share b_j of the axis (half-way to each neighbour), per metre of
// width. Its motion has N_j + 1 coordinates: x_0 of the base, with the shape 1, and q_n of the oscillators,
// with the shapes psi_n (modal_column.hpp):   u_j(z, t) = x_0 + sum psi_n(z) q_n. Lagrange's equations with
// these shapes give
//   mass         b_j int rho psi_m psi_n dz: M_n on the diagonal and between base and oscillator n, the
//                deposit's mass at the base
//   stiffness    b_j K_n for oscillator n, dashpot b_j c_n
//   neighbours   springs k(z) per depth between u_j(z) and u_j+1(z): longitudinal_springs.hpp
//   rock         rigid: x_0 is the given motion; elastic: dashpot b_j rho_r V_r from outcrop to base
// a block-tridiagonal system. The model converges to the continuum with the number of modes and, with second
// order, with the spacing of the columns.
//
// Integration in time is Newmark's average acceleration, which adds no damping and is stable for any step. It
// lengthens the period of a motion of circular frequency omega by a share of (omega dt)^2/12. The matrix is
// factored once, and the cost of a step is proportional to the number of columns.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "simplified/column/block_tridiagonal.hpp"
#include "simplified/column/modes/modal_column.hpp"

namespace adit::simplified::column {

struct Column {
  double chainage;    // [m]
  Deposit deposit;    // all surfaces lie at one level
  std::size_t modes;  // >= 1 (modes_needed)
};

// The modulus ratio of a layer or of the rock: the modulus that resists the difference between neighbouring
// columns, divided by that of the columns' own waves:
//   motion across the tunnel   1: both are shear
//   motion along the tunnel    axial_modulus_ratio(nu): compression beside shear
//   vertical motion            (V_s/V_p)^2: shear beside compression
// Along the tunnel the soil is free to move vertically and keeps its width (sigma_z = 0, eps_y = 0):
// sigma_x = 2 G/(1 - nu) du/dx (Wu and Finn 1997).
inline double axial_modulus_ratio(double poisson) {
  return 2 / (1 - poisson);
}

class JoinedColumns {
 public:
  // The columns are at rest at t = 0, without acceleration. Where `joined` is false, there are no springs
  // between them. Throws protocol::UserError, at path + "[j].chainage" and the like, if there is no column,
  // chainages do not increase, a column has no modes, or `check` refuses a deposit; with an empty path if dt
  // is impossible.
  JoinedColumns(std::span<const Column> columns, bool joined, double dt, const std::string& path = "columns");

  // `acceleration` holds the given motion at the end of the step, columns() values [m/s^2]. It varies
  // linearly over the step; velocity and displacement are integrated here, from zero.
  void step(std::span<const double> acceleration);

  // A place in a column, with the values of the shapes there.
  struct Place {
    std::size_t column;
    std::vector<double> shapes;    // 1, psi_1 ... psi_N
    std::vector<double> stresses;  // 0, G psi_1' ... G psi_N'
  };
  Place place(std::size_t column, double depth) const;

  // The absolute motion at a place [m], [m/s], [m/s^2].
  double displacement(const Place& place) const;
  double velocity(const Place& place) const;
  double acceleration(const Place& place) const;
  // The stress G du/dz there [Pa], of shear where the columns move horizontally.
  double stress(const Place& place) const;

  std::size_t columns() const { return columns_.size(); }
  const ModalColumn& modal(std::size_t column) const { return columns_[column]; }

 private:
  void add_column(std::size_t column, double length, BlockTridiagonal& mass);
  void add_springs(std::size_t column, double distance);
  void factor(BlockTridiagonal mass);
  void move_ground(std::span<const double> acceleration);
  void predict();
  void load();
  void correct();
  double sum(std::size_t column, const std::vector<double>& factors,
             const std::vector<double>& coordinates) const;

  std::vector<ModalColumn> columns_;
  std::vector<std::size_t> first_;  // coordinate of each column's base
  double dt_;
  BlockTridiagonal stiffness_, damping_;  // without the rock
  BlockTridiagonalFactor factor_;         // of M + dt/2 C + dt^2/4 K, with the rock
  std::vector<double> ground_mass_;       // M e, the load under a unit acceleration of the ground
  std::vector<double> rock_dashpot_;      // b_j rho_r V_r for each column; 0 on rigid rock

  // Coordinates relative to the given motion, and including it (`total`), as springs and dashpots need them.
  std::vector<double> displacement_, velocity_, acceleration_, force_, total_displacement_, total_velocity_;
  std::vector<double> ground_displacement_, ground_velocity_, ground_acceleration_;
};

}  // namespace adit::simplified::column
