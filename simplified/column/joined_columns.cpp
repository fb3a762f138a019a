#include "simplified/column/joined_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "protocol/errors.hpp"
#include "simplified/column/longitudinal_springs.hpp"

namespace adit::simplified::column {

using Eigen::Index;
using Eigen::MatrixXd;
using protocol::UserError;

namespace {

std::vector<ModalColumn> checked_columns(std::span<const Column> columns, double dt,
                                         const std::string& path) {
  if (!(dt > 0 && std::isfinite(dt)))
    throw UserError("", fmt::format("the time step of the soil columns is {} s: give one above 0", dt));
  if (columns.empty()) throw UserError(path, "no soil column: give at least one");
  std::vector<ModalColumn> result;
  for (std::size_t j = 0; j < columns.size(); ++j) {
    const Column& column = columns[j];
    const std::string where = fmt::format("{}[{}]", path, j);
    if (!std::isfinite(column.chainage) || (j > 0 && !(column.chainage > columns[j - 1].chainage)))
      throw UserError(
          where + ".chainage",
          fmt::format("the column's chainage is {} m{}: give chainages that increase", column.chainage,
                      j > 0 ? fmt::format(" after {} m", columns[j - 1].chainage) : ""));
    if (column.modes == 0) throw UserError(where + ".modes", "the column has no mode: give at least 1");
    check(column.deposit, where);
    result.push_back(modal_column(column.deposit, column.modes));
  }
  return result;
}

std::vector<std::size_t> coordinates_of(const std::vector<ModalColumn>& columns) {
  std::vector<std::size_t> counts;
  for (const ModalColumn& column : columns) counts.push_back(column.modes.size() + 1);
  return counts;
}

// The length of the axis that column j represents; 1 m if there is only one column.
double share(std::span<const Column> columns, std::size_t j) {
  if (columns.size() == 1) return 1;
  const std::size_t before = j > 0 ? j - 1 : 0, after = std::min(j + 1, columns.size() - 1);
  return (columns[after].chainage - columns[before].chainage) / 2;
}

// The integrals of rho psi_m psi_n: the shapes of the oscillators are orthogonal, but not to that of the
// base, 1.
MatrixXd mass_of(const ModalColumn& column) {
  const auto n = static_cast<Index>(column.modes.size() + 1);
  MatrixXd mass = MatrixXd::Zero(n, n);
  mass(0, 0) = column.deposit.mass();
  for (Index i = 1; i < n; ++i)
    // With psi = Gamma phi and Gamma = int rho phi / int rho phi^2, both int rho psi and int rho psi^2 are
    // the effective mass.
    mass(i, i) = mass(0, i) = mass(i, 0) = column.modes[static_cast<std::size_t>(i - 1)].effective_mass;
  return mass;
}

MatrixXd stiffness_of(const ModalColumn& column) {
  const auto n = static_cast<Index>(column.modes.size() + 1);
  MatrixXd stiffness = MatrixXd::Zero(n, n);
  for (Index i = 1; i < n; ++i) {
    const Mode& mode = column.modes[static_cast<std::size_t>(i - 1)];
    stiffness(i, i) = mode.effective_mass * mode.frequency * mode.frequency;
  }
  return stiffness;
}

MatrixXd dashpots_of(const ModalColumn& column) {
  MatrixXd dashpots = stiffness_of(column);
  for (Index i = 1; i < dashpots.rows(); ++i) {
    const Mode& mode = column.modes[static_cast<std::size_t>(i - 1)];
    dashpots(i, i) *= 2 * mode.damping / mode.frequency;
  }
  return dashpots;
}

void add_coupling(const CouplingBlocks& blocks, std::size_t j, BlockTridiagonal& matrix) {
  matrix.add_diagonal(j, blocks.aa);
  matrix.add_upper(j, blocks.ab);
  matrix.add_diagonal(j + 1, blocks.bb);
}

}  // namespace

JoinedColumns::JoinedColumns(std::span<const Column> columns, bool joined, double dt, const std::string& path)
    : columns_(checked_columns(columns, dt, path)), dt_(dt) {
  BlockTridiagonal mass(coordinates_of(columns_));
  stiffness_ = damping_ = mass;
  for (std::size_t j = 0; j < columns_.size(); ++j) add_column(j, share(columns, j), mass);
  for (std::size_t j = 0; joined && j + 1 < columns_.size(); ++j)
    add_springs(j, columns[j + 1].chainage - columns[j].chainage);
  // Apart from M e the mass is needed in the factored matrix only, so it is not kept.
  factor(std::move(mass));
  for (auto* coordinates :
       {&displacement_, &velocity_, &acceleration_, &force_, &total_displacement_, &total_velocity_})
    coordinates->resize(ground_mass_.size());
  for (auto* ground : {&ground_displacement_, &ground_velocity_, &ground_acceleration_})
    ground->resize(columns_.size());
}

void JoinedColumns::add_column(std::size_t j, double length, BlockTridiagonal& mass) {
  const ModalColumn& column = columns_[j];
  const MatrixXd own_mass = length * mass_of(column);
  mass.add_diagonal(j, own_mass);
  stiffness_.add_diagonal(j, length * stiffness_of(column));
  damping_.add_diagonal(j, length * dashpots_of(column));
  first_.push_back(ground_mass_.size());
  // Springs and dashpots alone join neighbours, so M e needs the first column of the own block only.
  ground_mass_.insert(ground_mass_.end(), own_mass.col(0).begin(), own_mass.col(0).end());
  rock_dashpot_.push_back(column.deposit.rock ? length * column.deposit.rock->impedance() : 0);
}

void JoinedColumns::add_springs(std::size_t j, double distance) {
  const LongitudinalSprings springs = longitudinal_springs(columns_[j], columns_[j + 1], distance);
  add_coupling(springs.stiffness, j, stiffness_);
  add_coupling(springs.dashpots, j, damping_);
}

// Factors M + dt/2 C + dt^2/4 K. On rigid rock the base does not move relative to the given motion.
void JoinedColumns::factor(BlockTridiagonal mass) {
  mass.add_scaled(damping_, dt_ / 2);
  mass.add_scaled(stiffness_, dt_ * dt_ / 4);
  for (std::size_t j = 0; j < columns_.size(); ++j) {
    if (!columns_[j].deposit.rock) {
      mass.hold(j, 0);
      continue;
    }
    MatrixXd rock = MatrixXd::Zero(columns_[j].modes.size() + 1, columns_[j].modes.size() + 1);
    rock(0, 0) = dt_ / 2 * rock_dashpot_[j];
    mass.add_diagonal(j, rock);
  }
  factor_ = BlockTridiagonalFactor(std::move(mass));
}

// One step of M x'' + C (x' + e v_g) + K (x + e u_g) + c_rock x_0' = -M e a_g, where x is relative to the
// given motion and e is 1 for the coordinates of the bases and 0 for all others.
void JoinedColumns::step(std::span<const double> acceleration) {
  move_ground(acceleration);
  predict();
  load();
  factor_.solve(force_, acceleration_);
  correct();
}

// Integrates the given motion, exactly for an acceleration that varies linearly over the step.
void JoinedColumns::move_ground(std::span<const double> acceleration) {
  for (std::size_t j = 0; j < columns_.size(); ++j) {
    const double start = ground_acceleration_[j], end = acceleration[j];
    ground_displacement_[j] += dt_ * (ground_velocity_[j] + dt_ * (start / 3 + end / 6));
    ground_velocity_[j] += dt_ / 2 * (start + end);
    ground_acceleration_[j] = end;
  }
}

// Predicts displacement and velocity at the end of the step, without the contribution of the new
// acceleration.
void JoinedColumns::predict() {
  for (std::size_t i = 0; i < displacement_.size(); ++i) {
    displacement_[i] += dt_ * (velocity_[i] + dt_ / 4 * acceleration_[i]);
    velocity_[i] += dt_ / 2 * acceleration_[i];
  }
}

void JoinedColumns::load() {
  // The bases of neighbours may move differently, and the springs between the columns feel that, so they act
  // on the total motion. The dashpot of the rock acts on the motion relative to the given one.
  total_displacement_ = displacement_;
  total_velocity_ = velocity_;
  for (std::size_t j = 0; j < columns_.size(); ++j) {
    const std::size_t base = first_[j], end = j + 1 < columns_.size() ? first_[j + 1] : force_.size();
    total_displacement_[base] += ground_displacement_[j];
    total_velocity_[base] += ground_velocity_[j];
    for (std::size_t i = base; i < end; ++i) force_[i] = -ground_mass_[i] * ground_acceleration_[j];
    force_[base] -= rock_dashpot_[j] * velocity_[base];
  }
  stiffness_.subtract_product(total_displacement_, force_);
  damping_.subtract_product(total_velocity_, force_);
  for (std::size_t j = 0; j < columns_.size(); ++j)
    // The base on rigid rock is held (factor()): its relative acceleration is 0.
    if (!columns_[j].deposit.rock) force_[first_[j]] = 0;
}

void JoinedColumns::correct() {
  for (std::size_t i = 0; i < displacement_.size(); ++i) {
    displacement_[i] += dt_ * dt_ / 4 * acceleration_[i];
    velocity_[i] += dt_ / 2 * acceleration_[i];
  }
}

JoinedColumns::Place JoinedColumns::place(std::size_t column, double depth) const {
  const auto with_base = [](double of_base, std::vector<double> of_oscillators) {
    of_oscillators.insert(of_oscillators.begin(), of_base);
    return of_oscillators;
  };
  return {column, with_base(1, shapes_at(columns_[column], depth)),
          with_base(0, stresses_at(columns_[column], depth))};
}

double JoinedColumns::sum(std::size_t column, const std::vector<double>& factors,
                          const std::vector<double>& coordinates) const {
  const double* own = coordinates.data() + first_[column];
  double sum = 0;
  for (std::size_t n = 0; n < factors.size(); ++n) sum += factors[n] * own[n];
  return sum;
}

double JoinedColumns::displacement(const Place& place) const {
  return ground_displacement_[place.column] + sum(place.column, place.shapes, displacement_);
}

double JoinedColumns::velocity(const Place& place) const {
  return ground_velocity_[place.column] + sum(place.column, place.shapes, velocity_);
}

double JoinedColumns::acceleration(const Place& place) const {
  return ground_acceleration_[place.column] + sum(place.column, place.shapes, acceleration_);
}

double JoinedColumns::stress(const Place& place) const {
  return sum(place.column, place.stresses, displacement_);
}

}  // namespace adit::simplified::column
