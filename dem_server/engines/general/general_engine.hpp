// The engine of discs of any size under all laws (solver.hpp). It computes the whole step with the
// interface's part; nothing is left to the interior.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "dem_server/engines/figures.hpp"
#include "dem_server/engines/general/solver.hpp"
#include "dem_server/engines/local_engine.hpp"
#include "dem_server/particles/loads.hpp"
#include "dem_server/particles/prescribed_motions.hpp"

namespace adit::dem {

class GeneralEngine final : public LocalEngine {
 public:
  // Threads that share the computing, 0: as many as pay. Results do not depend on their number.
  GeneralEngine(Model model, std::size_t threads);

  Solver& solver() { return solver_; }
  const Solver& solver() const { return solver_; }

  const Particles& particles() const override { return solver_.particles(); }
  Particles& particles() override { return solver_.particles(); }
  void for_each_bond(const SeePair& see) const override;
  void see_bonds(std::span<const std::uint32_t> bonds, const SeePair& see) const override;
  void for_each_contact(const SeePair& see) const override;
  std::span<const CellOutline> outlines() const override { return model_.outlines; }
  std::span<const double> turn() const override { return solver_.facets().set().turn; }
  std::vector<ObservedCrack> cracks() const override;
  std::vector<JointForce> joints() const override;
  std::vector<WallTouch> wall_touches() const override;
  std::vector<SpringForce> springs() const override;
  std::vector<WallForce> walls() const override;
  std::vector<ObservedBar> bars() const override;

  Counts counts() const override {
    return {solver_.particles().size(), model_.bonds.size() - solver_.facets().touching().size()};
  }
  CriticalElement critical_element() const override;
  const protocol::InterfaceOperator& tie(std::span<const double> places) override;
  void correct(std::span<const double> impulses) override { push(impulses, motions_); }
  void step_interface(const protocol::Step& step) override;
  void step_interior(const protocol::Step&) override {}
  std::size_t threads() const override { return solver_.threads(); }
  void took(double seconds) override { solver_.took(seconds); }
  std::span<const Crack> broken() const override { return cracks_; }
  Strongest strongest() const override { return solver_.strongest(); }
  Energies energies(const protocol::Step& step) override;
  std::vector<Figure> figures() const override;
  bool scales_masses() const override { return true; }
  void scale_masses(double mass_per_stiffness) override;
  void stop() override;
  void begin_stage(std::uint32_t stage) override;
  void start_over(const protocol::Drift& drift) override;
  std::variant<Condensed, std::string> condense(const protocol::SparseRows& ties, std::size_t masters,
                                                double share) override;
  void follow(const MastersMotion& masters, double dt) override;
  void arrive(const protocol::Step& step) override;
  void go_on() override;
  double demand() const override;
  std::vector<std::string> warnings() const override;
  void exchange(state::Archive& archive) override;

 private:
  explicit GeneralEngine(std::size_t threads, Model renumbered);

  double internal_force() const override { return solver_.internal_force(); }
  std::size_t elements() const override {
    return solver_.bonds().size() + solver_.facets().size() + solver_.contacts().size();
  }

  void see_facet(std::uint32_t facet, const SeePair& see) const;
  void exchange_mechanics(state::Archive& archive);
  void exchange_waiting(state::Archive& archive);
  void put_mechanics(const state::Parts& state);
  // Moves the particles that wait by so much [m], [rad] from where they are, and finds their forces.
  void displace(std::span<const double> motion);
  // Of which strength most is used, between the particles at whose middle it lies [m]; 1 and more where
  // something has cracked, slides or is open.
  struct Used {
    double share = 0;
    const char* what = "nothing";
    double x = 0, y = 0;
  };
  Used most_used() const;
  double breaking_speed() const;
  // Whether what the condensed particles miss of the motion matters.
  bool misses_motion() const;
  std::vector<double> forces() const;
  void set_velocities(std::span<const double> velocities);

  void require_finite(const protocol::Step& step) const;
  // Tells the user once of a particle that is far from where it stood.
  void warn_of_escapes(const protocol::Step& step);
  void note_cracks();
  void note_broken_springs(const protocol::Step& step);

  Model model_;
  Solver solver_;
  Loads loads_;
  PrescribedMotions motions_;
  std::vector<Crack> cracks_;  // of the last step
  std::uint64_t lists_;        // of neighbours when particles were last looked for far away
  bool escaped_ = false;
  std::uint32_t stage_ = 0;  // reached
  SpringBreaks spring_breaks_;
  // Of particles that wait: the state from which they follow, how they follow, and where they are to be.
  struct Waiting {
    state::Parts rest;
    std::vector<std::uint32_t> softened = {};     // facets that were beyond their strength there, ascending
    std::vector<std::size_t> spring_pieces = {};  // of the laws of all springs there
    double breaking_speed = 0;  // by which a wave strains the weakest facet to its strength [m/s]
    double largest_lag = 0, largest_kinetic = 0, fastest = 0;  // of all looks [J], [m/s]
    std::optional<Substructure> substructure = {};
    ParticlesMotion motion = {};
  };
  std::optional<Waiting> waiting_;
  bool waves_too_short_ = false;  // for the particles to wait any longer
};

}  // namespace adit::dem
