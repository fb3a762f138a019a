// The engine of lattices (model/lattice.hpp): equal discs on a hexagonal lattice, contact bonds of one law,
// and contacts without friction. It divides each step between the interface and the interior.
#pragma once

#include <cstdint>
#include <vector>

#include "dem_server/engines/lattice/assembly.hpp"
#include "dem_server/engines/lattice/bond_forces.hpp"
#include "dem_server/engines/lattice/contacts.hpp"
#include "dem_server/engines/lattice/sweep.hpp"
#include "dem_server/engines/local_engine.hpp"
#include "dem_server/particles/loads.hpp"
#include "dem_server/particles/prescribed_motions.hpp"
#include "protocol/threads/team.hpp"

namespace adit::dem {

class LatticeEngine final : public LocalEngine {
 public:
  // Threads that share the computing, 0: as many as pay. Results do not depend on their number.
  LatticeEngine(const Model& model, std::size_t threads);

  const Particles& particles() const override { return assembly_.particles; }
  Particles& particles() override { return assembly_.particles; }
  void for_each_bond(const SeePair& see) const override;
  void see_bonds(std::span<const std::uint32_t> bonds, const SeePair& see) const override;
  void for_each_contact(const SeePair& see) const override;

  Counts counts() const override { return {assembly_.particles.size(), assembly_.bonds.size()}; }
  CriticalElement critical_element() const override;
  const protocol::InterfaceOperator& tie(std::span<const double> places) override;
  void correct(std::span<const double> impulses) override { push(impulses, interface_.motions); }
  void step_interface(const protocol::Step& step) override;
  void step_interior(const protocol::Step& step) override;
  std::size_t threads() const override { return team_.threads(); }
  void took(double seconds) override { team_.took(seconds); }
  std::span<const Crack> broken() const override { return cracks_; }
  Strongest strongest() const override;
  Energies energies(const protocol::Step& step) override;
  void start_over(const protocol::Drift& drift) override;
  void exchange(state::Archive& archive) override;

 private:
  // What is computed together. The bonds of a tied particle are the interface's, and so are the moves of all
  // particles at their ends: the kicks of the tied ones then need nothing of the interior.
  struct Part {
    Sweep sweep;
    std::vector<Pair> pairs;
    Loads loads;
    PrescribedMotions motions;
  };

  double internal_force() const override;
  std::size_t elements() const override { return assembly_.bonds.size(); }

  // Divides bonds and contacts between the parts.
  void plan();
  // Moves and resultants of step n; velocities of n + 1/2 where only bonds pull.
  void pull(const protocol::Step& step, Part& part);
  // The other velocities of n + 1/2.
  void predict(const protocol::Step& step, Part& part);
  double strain_of_bonds();
  double work_of_gravity() const;  // since displacements were 0 [J]
  std::vector<double> normal_forces() const;

  protocol::Team team_;
  ContactBond law_;
  Assembly assembly_;
  Contacts contacts_;
  Part interface_, interior_;
  std::vector<bool> tied_;             // of each particle: the interface acts on it
  BondResult result_;                  // of this step, as far as computed
  double speed_ = 0;                   // largest of this step, likewise [m/s]
  std::vector<std::uint32_t> broken_;  // bonds that broke in this step
  std::vector<Crack> cracks_;          // of the last whole step
  double released_ = 0;                // up to the last whole step [J]
  double gravity_in_statics_ = 0;      // its work before time began [J]
};

}  // namespace adit::dem
