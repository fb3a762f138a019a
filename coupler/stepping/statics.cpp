#include "coupler/stepping/statics.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "coupler/participants/constraint.hpp"
#include "coupler/participants/time_step.hpp"
#include "coupler/stepping/progress.hpp"
#include "coupler/stepping/unrest.hpp"
#include "protocol/errors.hpp"
#include "protocol/ground/stages.hpp"

namespace adit::coupler {
namespace {

// Cundall's share, used by FLAC and PFC.
constexpr double kLocalDamping = 0.8;
// Of the critical step, over √(1 + damping) (protocol/participant/local_damping.hpp).
constexpr double kStepShare = 0.95;
// Mean unbalanced ratio above which all parts take one step: parts that come down at different paces tear at
// each other in the overlap, by as much of their settlement as is still to come. Strengths forgive a fiftieth
// of it.
constexpr double kOnePaceAbove = 0.02;

// What the scene states, else what is faster: continua and lattices, whose particles are bonded, come down
// mode by mode, which kinetic damping ends within a fraction of a period; where contacts open, close and
// slide, the kinetic energy has peaks all the time, and stopping at each leads nowhere.
scene::Statics::Damping damping_of(const Model& model) {
  if (model.scene.statics().has_damping()) return model.scene.statics().damping();
  const bool may_touch = std::ranges::any_of(model.participants, [](const Participant& participant) {
    return participant.member.role == Role::kParticles && !participant.model.engine().starts_with("lattice");
  });
  return may_touch ? scene::Statics::LOCAL : scene::Statics::KINETIC;
}

// Statics with masses of their own, which end with this object: the constraint of time is kept meanwhile.
class StaticMasses {
 public:
  StaticMasses(Model& model, double step_share, bool own_steps)
      : model_(model),
        of_time_(std::move(model.constraint)),
        dt_(choose_static_steps(model, step_share, own_steps)) {
    if (of_time_)
      model.constraint =
          std::make_unique<Constraint>(model.participants, model.interfaces, model.coupling_points, dt_);
  }
  StaticMasses(const StaticMasses&) = delete;
  StaticMasses& operator=(const StaticMasses&) = delete;
  ~StaticMasses() {
    for (Participant& participant : model_.participants) participant.step_ratio = 1;
    model_.constraint = std::move(of_time_);
  }
  double dt() const { return dt_; }

 private:
  Model& model_;
  std::unique_ptr<Constraint> of_time_;
  double dt_;
};

// One model on its way to rest.
class Relaxer {
 public:
  Relaxer(Model& model, Stepper& stepper)
      : model_(model),
        stepper_(stepper),
        statics_(model.scene.statics()),
        local_damping_(damping_of(model) == scene::Statics::LOCAL ? kLocalDamping : 0),
        step_share_(kStepShare / std::sqrt(1 + local_damping_)) {}

  void relax(std::uint32_t stage);
  const Rest& rest() const { return rest_; }

 private:
  void take(const Unrest& unrest, double internal_at_first);
  bool passed_a_peak(const Unrest& unrest);
  void pace(bool own_steps, Stepper::Relaxing& how);
  std::string place() const;
  [[noreturn]] void give_up(const std::string& stage, std::uint64_t steps, bool stalled) const;

  Model& model_;
  Stepper& stepper_;
  const scene::Statics& statics_;
  double local_damping_;
  double step_share_;
  std::optional<StaticMasses> masses_;
  bool own_steps_ = false;
  ProgressLine line_;
  Rest rest_;
  std::uint64_t step_ = 0;
  double kinetic_energy_ = 0;  // a step before, since the last stop
};

void Relaxer::relax(std::uint32_t stage) {
  const std::string name = stage > 0 ? fmt::format(", stage {}", stage) : "";
  Stepper::Relaxing how{.dt = 0, .local_damping = local_damping_, .stage = stage};
  pace(false, how);
  how.stop = stage > 0;
  Stall stall(statics_.unbalanced_ratio(), statics_.max_steps());
  double internal_at_first = 0;
  kinetic_energy_ = 0;
  for (std::uint64_t n = 0; n <= statics_.max_steps(); ++n) {
    stepper_.relax(step_, how);
    const Unrest unrest(model_.participants);
    rest_.steps = step_++;
    if (n == 0) internal_at_first = unrest.internal_force;
    take(unrest, internal_at_first);
    if (line_.due())
      line_.print(fmt::format("statics{}: step {}, unbalanced ratio {:.2e}, {:.1e} wanted; {}", name, n,
                              rest_.mean_ratio, statics_.unbalanced_ratio(), place()));
    if (n > 0 && rest_.mean_ratio <= statics_.unbalanced_ratio()) return;
    if (n > 0 && stall.noticed(rest_.mean_ratio)) give_up(name, n, true);
    how.stop = local_damping_ == 0 && passed_a_peak(unrest);
    if (!own_steps_ && statics_.scale_masses() && n > 0 && rest_.mean_ratio <= kOnePaceAbove) pace(true, how);
  }
  give_up(name, statics_.max_steps(), false);
}

// Every participant at its own step from now on, or all at one. Velocities of another clock mean nothing.
void Relaxer::pace(bool own_steps, Stepper::Relaxing& how) {
  own_steps_ = own_steps;
  kinetic_energy_ = 0;
  masses_.emplace(model_, step_share_, own_steps);
  how.dt = masses_->dt();
  how.stop = true;
}

void Relaxer::take(const Unrest& unrest, double internal_at_first) {
  rest_.mean_ratio = unrest.mean_ratio(internal_at_first);
  rest_.largest_ratio = unrest.largest_ratio(internal_at_first);
  rest_.x = unrest.x;
  rest_.y = unrest.y;
  rest_.of = unrest.largest_of;
  rest_.drift = unrest.drift();
}

bool Relaxer::passed_a_peak(const Unrest& unrest) {
  const bool passed = unrest.kinetic_energy < kinetic_energy_;
  kinetic_energy_ = passed ? 0 : unrest.kinetic_energy;
  if (passed) ++rest_.stops;
  return passed;
}

std::string Relaxer::place() const {
  return fmt::format("largest {:.2e} at ({:.4g}, {:.4g}) m of `{}`", rest_.largest_ratio, rest_.x, rest_.y,
                     rest_.of);
}

void Relaxer::give_up(const std::string& stage, std::uint64_t steps, bool stalled) const {
  throw protocol::Unstable(
      fmt::format("statics{}: after {} steps the unbalanced force ratio is {:g}, {:g} were asked for{}; {}; "
                  "look there for loose "
                  "particles (particles.remove_floaters), a body that nothing holds, or ground that fails "
                  "under its weight; or "
                  "allow more statics.max_steps, or a larger statics.unbalanced_ratio",
                  stage, steps, rest_.mean_ratio, statics_.unbalanced_ratio(),
                  stalled ? ", and it falls no more" : "", place()));
}

}  // namespace

Rest relax(Model& model, Stepper& stepper) {
  Relaxer relaxer(model, stepper);
  for (const std::uint32_t stage : protocol::stages_of(model.scene)) relaxer.relax(stage);
  for (Participant& participant : model.participants) participant.drift = relaxer.rest().drift;
  return relaxer.rest();
}

}  // namespace adit::coupler
