// The engine whose particles lie in the ranks of LAMMPS, as the participant on rank 0 drives it.
//
// Rank 0 also has a picture of the whole model: dem_server's general engine, which makes no step. It knows
// the model at rest (critical step, coupling points, laws) and is what histories and snapshots look at, once
// the ranks have told their particles and pairs. Between these, only the tied particles of the picture move.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "adapters/lammps/ranks/orders.hpp"
#include "dem_server/engines/engine.hpp"
#include "dem_server/engines/general/general_engine.hpp"

namespace adit::lammps {

class LammpsEngine final : public dem::Engine {
 public:
  LammpsEngine(const dem::Model& model, Orders& orders);

  dem::Counts counts() const override { return picture_.counts(); }
  dem::CriticalElement critical_element() const override { return picture_.critical_element(); }
  void watch(const scene::Particles& scene) override;
  std::vector<double> offer(const geometry::BoundingBox& box) override { return picture_.offer(box); }
  const protocol::InterfaceOperator& tie(std::span<const double> places) override;
  std::span<const double> tied_inverse_masses() const override { return picture_.tied_inverse_masses(); }
  void correct(std::span<const double> impulses) override;

  void prepare(bool energies) override;
  void step_interface(const protocol::Step& step) override;
  void step_interior(const protocol::Step&) override {}
  void read_velocities(std::span<double> velocities) const override { picture_.read_velocities(velocities); }
  std::span<const dem::Crack> broken() const override { return cracks_; }
  dem::Strongest strongest() const override { return strongest_; }
  dem::Energies energies(const protocol::Step& step) override;
  void read_histories(const protocol::Step& step, std::vector<double>& values) override;
  void snapshot(wire::Snapshot& snapshot) const override;
  std::uint64_t fragments() const override;
  std::vector<dem::Figure> figures() const override { return picture_.figures(); }

  // A participant need not keep peaks (wire.proto).
  void remember_for_peaks() override {}
  void take_peaks(const protocol::Step&) override {}

  // Statics and states are not computed: RequestError.
  double kinetic_energy() const override;
  dem::Unrest unrest(const protocol::Step& step) override;
  void stop() override;
  void count_displacements() override;
  void start_over(const protocol::Drift& drift) override;
  void exchange(state::Archive& archive) override;

 private:
  void begin();
  void tell_particles();
  void tell_pairs(Order order, const dem::Pairs& pairs);
  // What the ranks do not know yet; empty where they know all. Told before anything is asked of them.
  Values corrected_velocities() const;
  std::vector<Values> ask(Order order) const;
  void take_answer(const Values& answer, const protocol::Step& step);
  void note_cracks(std::vector<std::uint32_t> broken);
  // The picture becomes what the ranks have.
  void fetch_motion() const;
  void fetch_bonds() const;
  void fetch_contacts() const;
  void fetch() const;

  Orders& orders_;
  dem::Model model_;  // as the picture numbers it
  mutable dem::GeneralEngine picture_;
  bool watched_ = false, remembers_ = false;  // by histories: at rows; velocities, before every step
  mutable bool corrected_ = false;
  std::vector<dem::Crack> cracks_;  // of the last step
  dem::Strongest strongest_;
};

}  // namespace adit::lammps
