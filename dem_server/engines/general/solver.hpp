// Discs of any size under all their laws, step by step: leap-frog, displacements at n, velocities at n + 1/2.
//
// A step moves the discs, sums the forces of bonds, contacts, joints, springs, bars and walls, adds loads,
// and kicks: discs on which only pairs pull at once, block by block, the others at the end (swept_discs.hpp).
// Blocks of discs are shared by threads (pairs.hpp); results do not depend on their number.
//
// Energies are accounted in the form that the scheme keeps, T(n) = 1/2 sum m v(n-1/2) v(n+1/2): every force
// does the trapezoidal work dt v(n-1/2) (f(n-1) + f(n)) / 2 on its disc, and the sum of all is the change of
// T to rounding. Springs store F^2 / 2k. What the trapezoid gives to all pairs and they neither store
// nor lose by friction, dashpots or breaking is the share of the time step: of second order in dt, by springs
// that turn, close and open.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "dem_server/engines/answers.hpp"
#include "dem_server/engines/general/bars/bars.hpp"
#include "dem_server/engines/general/facets/facets.hpp"
#include "dem_server/engines/general/forces/cell_contacts.hpp"
#include "dem_server/engines/general/forces/damping.hpp"
#include "dem_server/engines/general/forces/joints.hpp"
#include "dem_server/engines/general/forces/spring_forces.hpp"
#include "dem_server/engines/general/forces/wall_contacts.hpp"
#include "dem_server/engines/general/neighbours.hpp"
#include "dem_server/engines/general/pairs/pair_forces.hpp"
#include "dem_server/engines/general/pairs/pair_state.hpp"
#include "dem_server/engines/general/swept_discs.hpp"
#include "dem_server/model/model.hpp"
#include "dem_server/particles/energy.hpp"
#include "dem_server/particles/loads.hpp"
#include "dem_server/particles/particles.hpp"
#include "dem_server/particles/prescribed_motions.hpp"
#include "protocol/participant/step.hpp"
#include "protocol/threads/team.hpp"

namespace adit::dem {

// Since the start [J]. `pairs`: work of all pairs, facets, joints, springs, bars and walls on the discs.
struct DiscLedger {
  double pairs = 0, friction = 0, dashpots = 0, released = 0;
  Damping::Loss damping;
  double support = 0;  // work of what held quiet edges in statics
  double ground = 0;   // work of the ground of foundations, and what their slip and dashpots took
  double foundations = 0;
};

class Solver {
 public:
  Solver(const Model& model, std::size_t threads);

  // The motion of these discs is that of another model; local damping leaves them out.
  void tie(std::span<const std::uint32_t> discs);
  // One whole step.
  void step(const protocol::Step& step, Loads& loads, PrescribedMotions& motions);
  // Moves the discs by what their velocities make of a second, all loads steady, and finds the forces there.
  // Neither dashpots nor damping act; the velocities afterwards mean nothing.
  void displace(Loads& loads, PrescribedMotions& motions);
  std::size_t threads() const { return team_->threads(); }
  void took(double seconds) { team_->took(seconds); }
  // The particles were stopped: so are the walls.
  void stop() { walls_.stop(); }
  // The particles were stopped, and the first step that does not relax is next: ledgers start from 0; quiet
  // edges are let go and carry what held them, and hold the model against the drift beside: this is what the
  // model lacks of equilibrium, shared between the dashpots (fdm_server/solver/dashpots.hpp has the reasons).
  void start_over(const protocol::Drift& drift = {});
  // The particles were stopped, and the first step of a stage is next: `model` is that of the stage, `before`
  // the stage before. What bonds, joints and contacts of before still stand keep their forces.
  void begin_stage(std::uint32_t before, const ParticleStage& stage, const Model& model);

  void exchange(state::Archive& archive);

  Particles& particles() { return particles_; }
  const Particles& particles() const { return particles_; }
  const Pairs& bonds() const { return bonds_; }
  Pairs& bonds() { return bonds_; }
  const Pairs& contacts() const { return neighbours_.pairs(); }
  const Neighbours& neighbours() const { return neighbours_; }
  Neighbours& neighbours() { return neighbours_; }
  // Lists of what may touch, made so far.
  std::uint64_t lists() const { return neighbours_.lists() + cells_.lists(); }
  const CellContacts& cells() const { return cells_; }
  const WallContacts& walls() const { return walls_; }
  const SpringForces& springs() const { return springs_; }
  const Bars& bars() const { return bars_; }
  const Joints& joints() const { return joints_; }
  const Facets& facets() const { return facets_; }
  std::span<const PairLaw> laws() const { return laws_; }
  // Which of model.bonds a pair is.
  std::span<const std::uint32_t> bond_of_pair() const { return bond_of_pair_; }

  // Bonds that broke in the last step, ascending.
  std::span<const std::uint32_t> broken() const { return broken_; }
  // In the last step.
  const Strongest& strongest() const { return strongest_; }

  // Sum over bonds, contacts, joints and springs of |force|, weighted [N].
  double internal_force() const;

  DiscLedger ledger() const;
  // Strain energy [J], of pairs with walls' contacts among the contacts; foundations are not among them.
  struct StrainEnergy {
    Stored pairs;
    double facets, joints, springs, bars;
    double sum() const { return pairs.sum() + facets + joints + springs + bars; }
  };
  StrainEnergy strain_energy() const;
  double foundation_energy() const;  // stored in their springs
  // The share of the time step (see above), since the start [J], of all that is stored now.
  double time_step_share(double strain_energy) const;

 private:
  struct BlockResult {
    PairResult bonds, contacts;
    double fastest = 0, work = 0;
    Damping::Loss loss;
  };
  void take_laws(std::vector<PairLaw> laws);
  void renew_damping();
  void plan(const protocol::Step& step, const Loads& loads, const PrescribedMotions& motions);
  void note_pulls();
  void note_pull(std::uint32_t disc);
  void move(const protocol::Step& step);
  // Returns whether other particles than before may touch.
  bool update_contacts(double dt, double farthest, double farthest_wall);
  void sweep(const protocol::Step& step);
  void gather(double dt);
  double power_of_kept(std::size_t block);
  foundation::PointMotion motion(const foundation::Springs& springs);
  void support_edges(bool relax, double dt);
  void support_held();
  struct PairLoad;
  void hold_what_vanishes(const ParticleStage& stage);
  void hold(const PairLoad& load, const ParticleStage& stage);
  void take_results(bool relax);
  Stored stored() const;
  double internal_force_of_pairs() const;
  Strongest find_strongest() const;

  Particles particles_;
  std::vector<PairLaw> laws_, static_laws_;  // of pairs; in statics, where no dashpots act
  Pairs bonds_;
  std::vector<std::uint32_t> bond_of_pair_;
  Neighbours neighbours_;
  Joints joints_;
  Facets facets_;
  CellContacts cells_;
  SpringForces springs_;
  Bars bars_;
  std::vector<foundation::Springs> foundations_;
  WallContacts walls_;
  Damping damping_;
  double local_damping_, viscous_damping_;
  std::vector<std::uint32_t> tied_;
  std::vector<EdgeDashpot> edges_;
  std::vector<double> support_x_, support_y_;  // of the edges [N]
  struct Held {
    std::uint32_t disc;
    double x, y, moment;  // weighted [N], [N m]
  };
  std::vector<Held> held_;  // of what vanished with this stage, until the next
  SweptDiscs discs_;
  bool planned_ = false, sweeps_ = false;  // the discs are divided; some are swept
  // By pairs at the last step, of kept discs; those of swept discs are their resultants.
  std::vector<double> pulled_x_, pulled_y_, pulled_moment_;
  std::unique_ptr<protocol::Team> team_;
  mutable std::vector<BlockDiscs> in_work_;  // of each thread, of no use between calls
  std::vector<BlockResult> results_;
  std::vector<std::uint32_t> broken_;
  Strongest strongest_;
  DiscLedger ledger_;
  // At the last step of statics [N]; none before the first.
  std::optional<double> internal_of_pairs_;
  double strain_at_start_ = 0;
};

}  // namespace adit::dem
