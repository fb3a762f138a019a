// Particles that are linear, condensed to the points that move them (static condensation: Guyan 1965, AIAA J.
// 3, 380; Irons 1965).
//
// The particles b at the coupling points follow the masters q: u_b = N q. All other freedoms i, the turns of
// b among them, follow in equilibrium, u_i = -K_ii^-1 K_ib N q, which is u = T q for all. What the masters
// feel of the particles is then
//     K_c = T' K T,   M_c = T' M T,   p = T' f,
// f being the forces in the state from which displacements count: half a (dq/dt)' M_c (dq/dt) and half a q'
// K_c q are the energies of the particles exactly, and their momentum is that of M_c. What T leaves out are
// the particles' own oscillations between held points. Waves that are long compared with the region hardly
// excite them; their first effect is the lag by inertia, which recover() adds:
//     u_i = (T q)_i - K_ii^-1 (M T a)_i.
// It stores no energy with T q, since T' K vanishes at i, and leaves the forces on each particle those of its
// acceleration: particles that go on from there oscillate by what is of fourth order in frequency over that
// of the first oscillation.
#pragma once

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dem_server/condensation/tangent.hpp"
#include "protocol/kernels/symmetric_factor.hpp"
#include "protocol/participant/interface/sparse_rows.hpp"

namespace adit::dem {

struct Condensed {
  Eigen::MatrixXd stiffness, mass;       // over x0 y0 x1 y1 … of the masters [N/m], [kg]
  Eigen::VectorXd force;                 // [N]
  double strain_energy = 0, demand = 0;  // of the state from which displacements count [J], [1]
};

// How the masters have moved: pairs (x, y) [m], [m/s].
struct MastersMotion {
  std::span<const double> displacements, velocities_before, velocities;  // of half a step before and later
};

// The same of all particles, as in kFreedoms; and energies of what T alone does not tell [J]: that of the
// lag, and the kinetic one. Their ratio is about (f / f_1)^2, f being the frequency of the motion and f_1 the
// lowest one of the particles between held points.
struct ParticlesMotion {
  std::vector<double> displacements, velocities_before, velocities;
  double lag_energy = 0, kinetic_energy = 0;
};

class Substructure {
 public:
  // `masses`: of each freedom, 0 of particles that are not there [kg], [kg m^2]. `tied`: the particle at each
  // coupling point; `ties`: N. Throws NotHeld where nothing holds a particle that is there.
  struct NotHeld {};
  Substructure(const Tangent& tangent, std::vector<double> masses, std::span<const std::uint32_t> tied,
               const protocol::SparseRows& ties, std::size_t masters);

  Condensed condense() const;
  // `dt`: between both velocities [s].
  ParticlesMotion recover(const MastersMotion& masters, double dt) const;

 private:
  using Columns = Eigen::MatrixXd;               // of freedoms, or of masters
  Columns follow(const Columns& masters) const;  // T
  Columns gather(const Columns& forces) const;   // T'
  template <int kSides>
  void solve_inside(const Columns& rows, Eigen::Index begin, Columns& solution) const;
  Columns inside(const Columns& rows) const;  // K_ii^-1, of rows of all freedoms; 0 at those that are tied

  Eigen::SparseMatrix<double> stiffness_, held_;  // K; its columns of the freedoms at coupling points
  Eigen::VectorXd masses_, forces_;
  std::vector<std::uint32_t> tied_;
  Eigen::SparseMatrix<double> ties_;  // N for x and y
  std::size_t masters_;
  std::vector<Eigen::Index> free_;  // freedoms i
  std::optional<protocol::SymmetricFactor> factor_;
};

}  // namespace adit::dem
