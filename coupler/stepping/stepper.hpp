// The steps of a model: those of statics, then those of time by the scheme that the scene asks for.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "coupler/exchange/round_trip.hpp"
#include "coupler/participants/set_up.hpp"
#include "coupler/stepping/condensed_regions.hpp"
#include "coupler/stepping/ledger.hpp"
#include "protocol/state/archive.hpp"

namespace adit::coupler {

// How the participants come from one step of the model to the next: all take the same step, or
// particles take several in one of the continuum (shared_kick.hpp).
class TimeScheme {
 public:
  virtual ~TimeScheme() = default;
  // To step n = 0, 1, 2 …; the ledger takes energies that are wanted, but does not compare them.
  virtual void step(std::uint64_t n, Wanted wanted) = 0;
  // Particles waited until the last step, and begin with the next (condensed_regions.hpp).
  virtual void take_over(const GridMotion& motion) = 0;
  // What passes from one step to the next, besides what the participants and the ledger know.
  virtual void exchange(state::Archive& archive) = 0;
};

class Stepper {
 public:
  explicit Stepper(Model& model);
  Stepper(const Stepper&) = delete;
  Stepper& operator=(const Stepper&) = delete;

  // To step n = 0, 1, 2 …
  void step(std::uint64_t n, Wanted wanted);

  // A step of statics (wire.proto, Advance), without substeps: all velocities are stopped first where `stop`
  // says so. Afterwards step(0, …) starts from the state at rest.
  struct Relaxing {
    double dt;  // of the model [s]
    double local_damping;
    std::uint32_t stage = 0;
    bool stop = false;
    double slowing = 0;  // share of all velocities that is lost
  };
  void relax(std::uint64_t n, const Relaxing& how);

  // The state at the step reached, of every participant in turn.
  std::vector<wire::Snapshot> snapshots() {
    regions_.tell();
    return take_snapshots(model_.participants);
  }

  void exchange(state::Archive& archive) {
    ledger_.exchange(archive);
    archive("cost", cost_);
    regions_.exchange(archive);
    archive("just_began", just_began_);
    scheme_->exchange(archive);
  }

  // Complete up to the last step that wanted energies.
  const Ledger& ledger() const { return ledger_; }
  const StepCost& cost() const { return cost_; }
  const CondensedRegions& regions() const { return regions_; }

 private:
  Model& model_;
  Ledger ledger_;
  StepCost cost_;
  RoundTrip round_trip_;
  CondensedRegions regions_;
  bool just_began_ = false;  // with the last step
  std::unique_ptr<TimeScheme> scheme_;
  wire::Advance request_;  // of statics
};

}  // namespace adit::coupler
