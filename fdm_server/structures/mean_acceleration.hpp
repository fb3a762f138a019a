// Structures that are stiffer than the step allows: mean acceleration (Newmark 1959, beta = 1/4), beside the
// central differences of the ground (Hughes and Liu 1978, J. Appl. Mech. 45).
//
// The structures act with the mean of their forces at three steps instead of those at step n,
//   -K (u(n-1) + 2 u(n) + u(n+1))/4 = -K u(n) - dt^2/4 K a,   a = (v(n+1/2) - v(n-1/2))/dt,
// so that what the central differences get besides is the force -dt^2/4 K a, with a from
//   (M + dt^2/4 K) a = f,   f all forces at step n.
// K is that of structures which do not yield; it is factored once. Prescribed components have their a.
//
// Stable at every step that the ground allows: the condition of the energy M - dt^2/4 K_all >= 0 reads
//   M + dt^2/4 K - dt^2/4 (K_ground + K_tangent) >= 0
// and K >= K_tangent, so that the structures take nothing of the ground's share (zones/critical_step.hpp).
// Kinetic energy: 1/2 v(n-1/2) (M + dt^2/4 K) v(n+1/2) keeps the ledger of continuum.hpp to rounding.
// Accuracy: a mode of frequency w turns with (2/dt) atan(w dt/2), slower by the share (w dt)^2/12: at the
// ground's highest frequency, ten zones to the wave, by less than 1 %, as its zones are.
#pragma once

#include <Eigen/SparseCholesky>
#include <functional>
#include <span>
#include <vector>

#include "fdm_server/structures/strain_form.hpp"

namespace adit::fdm {

class MeanAcceleration {
 public:
  // `inverse_mass`: of a freedom [1/kg or 1/(kg m^2)]; 0 where its motion is prescribed.
  MeanAcceleration(std::span<const StrainForm> strains, double dt,
                   const std::function<double(const Freedom&)>& inverse_mass);

  double dt() const { return dt_; }
  // The freedoms whose motion is prescribed, and their accelerations, 0 until set.
  std::span<const Freedom> prescribed() const { return std::span(freedoms_).subspan(free_); }
  void prescribe(std::size_t number, double acceleration) { acceleration_[free_ + number] = acceleration; }

  // Adds -dt^2/4 K a to the forces, which hold all others.
  void add_forces(const Actions& forces);

  // before . dt^2/4 K . after [J].
  double twice_kinetic_energy(const Motions& before, const Motions& after) const;

 private:
  struct Share {
    std::uint32_t freedom;  // of freedoms_
    double factor;
  };
  struct Form {
    double inertia;            // dt^2/4 of the stiffness
    std::uint32_t begin, end;  // of shares_
  };
  std::span<const Share> shares(const Form& form) const {
    return std::span(shares_).subspan(form.begin, form.end - form.begin);
  }
  void factor(const std::function<double(const Freedom&)>& inverse_mass);
  double rate(const Form& form, const Motions& motions) const;
  void solve(const Actions& forces);  // for a of the free ones
  // force -= dt^2/4 K a.
  void subtract_inertia();

  double dt_;
  std::vector<Freedom> freedoms_;  // the free ones first
  std::size_t free_ = 0;
  std::vector<Form> forms_;
  std::vector<Share> shares_;
  std::vector<double> acceleration_, force_;  // of freedoms_
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> factor_;
  Eigen::VectorXd ordered_;  // the free ones in the order of the factor
};

}  // namespace adit::fdm
