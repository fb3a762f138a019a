// Structures and contacts that are stiffer than the step allows: mean acceleration (Newmark 1959, beta =
// 1/4), beside the central differences of the ground (Hughes and Liu 1978, J. Appl. Mech. 45).
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
//
// The strains of contacts follow those of the structures. Their forces at the mean of the three steps are
// known to their law only (solver/contact_balance.hpp): here are loads, and of those that resist the
// stiffness.
#pragma once

#include <Eigen/SparseCholesky>
#include <array>
#include <functional>
#include <span>
#include <vector>

#include "fdm_server/structures/skew_factor.hpp"
#include "fdm_server/structures/strain_form.hpp"

namespace adit::fdm {

class MeanAcceleration {
 public:
  // Of the strains the first `structures` are those of structures. `inverse_mass`: of a freedom [1/kg or
  // 1/(kg m^2)]; 0 where its motion is prescribed.
  MeanAcceleration(std::span<const StrainForm> strains, std::size_t structures, double dt,
                   const std::function<double(const Freedom&)>& inverse_mass);

  double dt() const { return dt_; }
  // The freedoms whose motion is prescribed, and their accelerations, 0 until set.
  std::span<const Freedom> prescribed() const { return std::span(freedoms_).subspan(free_); }
  void prescribe(std::size_t number, double acceleration) { acceleration_[free_ + number] = acceleration; }

  // What a contact bears along its two strains, the first of them the `strain`: forces at step n without
  // lead [N], and stiffnesses against the leads, along itself and along the other [N/m]; at first those of
  // the forms. Sliding faces have matrices that are not symmetric.
  struct Bears {
    std::array<double, 2> load, along, across;

    std::array<double, 2> at(const std::array<double, 2>& lead) const {
      return {load[0] + along[0] * lead[0] + across[0] * lead[1],
              load[1] + along[1] * lead[1] + across[1] * lead[0]};
    }
  };
  void bear(std::size_t strain, const Bears& contact);

  // The largest of these that acts on a freedom, by size [N], [N m].
  double largest(const Actions& forces) const;
  // Finds a from all other forces.
  void accelerate(const Actions& forces);
  // dt^2/4 of the acceleration of a strain: by how much its mean leads step n.
  double lead(std::size_t strain) const;
  // Adds -dt^2/4 K a of the structures to the forces.
  void add_forces(const Actions& forces);

  // before . dt^2/4 K . after of the structures [J].
  double twice_kinetic_energy(const Motions& before, const Motions& after) const;

 private:
  struct Share {
    std::uint32_t freedom;  // of freedoms_
    double factor;
  };
  struct Form {
    double stiff;              // dt^2/4 of the stiffness
    std::uint32_t begin, end;  // of shares_
    std::uint32_t entries;     // the first of entries_
    double across = 0;         // dt^2/4 of the stiffness against the other strain of a contact
  };
  std::span<const Share> shares(const Form& form) const {
    return std::span(shares_).subspan(form.begin, form.end - form.begin);
  }
  void find_pattern(const std::function<double(const Freedom&)>& inverse_mass);
  void factor();
  double acceleration_of(const Form& form) const;
  double rate(const Form& form, const Motions& motions) const;
  void solve(const Actions& forces);  // for a of the free ones
  // force -= dt^2/4 K a, of these strains.
  void subtract_inertia(std::span<const Form> forms);

  double dt_;
  std::size_t structures_;         // strains
  std::vector<double> load_;       // of contacts' strains
  std::vector<Freedom> freedoms_;  // the free ones first
  std::size_t free_ = 0;
  std::vector<Form> forms_;
  std::vector<Share> shares_;
  std::vector<double> acceleration_, force_;  // of freedoms_
  Eigen::SparseMatrix<double> matrix_;        // M + dt^2/4 K of the free ones
  std::vector<double> mass_;                  // of the free ones
  // Where the products of two free shares of a form go, and M: places in the values of the matrix.
  std::vector<std::uint32_t> entries_, diagonal_;
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> factor_;
  SkewFactor skew_factor_;  // of a matrix that is not symmetric
  bool skew_ = false;
  bool changed_ = false;     // the matrix, since it was factored
  Eigen::VectorXd ordered_;  // the free ones in the order of the factor
};

}  // namespace adit::fdm
