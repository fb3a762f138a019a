#include "coupler/stepping/statics.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "coupler/participants/constraint.hpp"
#include "coupler/participants/time_step.hpp"
#include "coupler/stepping/progress.hpp"
#include "coupler/stepping/unrest.hpp"
#include "protocol/errors.hpp"
#include "protocol/ground/imposed.hpp"
#include "protocol/ground/stages.hpp"

namespace adit::coupler {
namespace {

// Cundall's share, used by FLAC and PFC.
constexpr double kLocalDamping = 0.8;
// The share of the velocities that adaptive damping takes after n steps is this over this + n (Nesterov
// 1983).
constexpr double kSlowing = 3;
// Of the critical step, over √(1 + damping) (protocol/participant/local_damping.hpp).
constexpr double kStepShare = 0.95;
// Mean unbalanced ratio above which all parts take one step: parts that come down at different paces tear at
// each other in the overlap, by as much of their settlement as is still to come. Strengths forgive a fiftieth
// of it.
constexpr double kOnePaceAbove = 0.02;
// Stops in succession after three steps, until one of them waits.
constexpr std::uint64_t kReturns = 10;
// Steps that imposed displacements may be late by, because a stop takes a step of them away.
constexpr std::uint64_t kStopsAtTheEnd = 10;
// Steps before a model that nothing holds is told: by then it has moved.
constexpr std::uint64_t kFirstLookAtFall = 1000;

bool may_touch(const Model& model) {
  return std::ranges::any_of(model.participants, [](const Participant& participant) {
    return participant.member.role == Role::kParticles && !participant.model.engine().starts_with("lattice");
  });
}

void require_slowing(const Model& model) {
  for (const Participant& participant : model.participants)
    if (!participant.model.slows())
      throw protocol::UserError(
          "statics.damping",
          fmt::format("is adaptive, which the program of `{}` does not know; state local or kinetic",
                      participant.member.name));
}

// The mass of all; 0 where one does not say its own.
double known_mass_of(const std::vector<Participant>& participants) {
  double sum = 0;
  for (const Participant& participant : participants) {
    if (participant.counts.mass() <= 0) return 0;
    sum += participant.counts.mass();
  }
  return sum;
}

// What the scene states, else by what it holds (statics.hpp).
scene::Statics::Damping damping_of(const Model& model) {
  const scene::Statics& statics = model.scene.statics();
  if (!statics.has_damping()) return may_touch(model) ? scene::Statics::LOCAL : scene::Statics::KINETIC;
  if (statics.damping() == scene::Statics::ADAPTIVE) require_slowing(model);
  return statics.damping();
}

}  // namespace

// Statics with masses of their own, which end with this object: the constraint of time is kept meanwhile.
class StaticMasses {
 public:
  // `of_elements`: where participants know such masses, each zone and bond shares the step of its model.
  StaticMasses(Model& model, double step_share, bool own_steps, bool of_elements)
      : model_(model),
        of_time_(std::move(model.constraint)),
        dt_(choose_static_steps(model, step_share, own_steps)) {
    for (Participant& participant : model.participants)
      take_masses_of(participant, of_elements && participant.model.scales_masses() ? MassesOf::kScaledStatics
                                                                                   : MassesOf::kStatics);
    if (of_time_)
      model.constraint =
          std::make_unique<Constraint>(model.participants, model.interfaces, model.coupling_points, dt_);
  }
  StaticMasses(const StaticMasses&) = delete;
  StaticMasses& operator=(const StaticMasses&) = delete;
  ~StaticMasses() {
    for (Participant& participant : model_.participants) {
      participant.step_ratio = 1;
      take_masses_of(participant, MassesOf::kTime);
    }
    model_.constraint = std::move(of_time_);
  }
  double dt() const { return dt_; }

 private:
  static void take_masses_of(Participant& participant, MassesOf masses) {
    participant.scaled_masses = masses == MassesOf::kScaledStatics;
    if (participant.interpolation) participant.interpolation->take_masses_of(masses);
  }

  Model& model_;
  std::unique_ptr<Constraint> of_time_;
  double dt_;
};

// One model on its way to rest.
class Statics::Relaxer {
 public:
  Relaxer(Model& model, Stepper& stepper)
      : model_(model),
        stepper_(stepper),
        statics_(model.scene.statics()),
        mass_(known_mass_of(model.participants)),
        damping_(damping_of(model)),
        how_{.dt = 0, .local_damping = damping_ == scene::Statics::LOCAL ? kLocalDamping : 0},
        stall_(statics_.unbalanced_ratio(), statics_.max_steps()) {
    const auto stages = protocol::stages_of(model.scene);
    stages_.assign(stages.begin(), stages.end());
  }

  void run(const BetweenSteps& between_steps);
  bool done() const { return stage_ == stages_.size(); }
  const Rest& rest() const { return rest_; }
  void exchange(state::Archive& archive);

 private:
  void begin_stage();
  bool step();
  void take(const Unrest& unrest);
  void brake(const Unrest& unrest);
  bool stops(bool peaked);
  void pace(bool near_rest);
  void weigh();
  std::string place() const;
  std::string name_of_stage() const { return how_.stage > 0 ? fmt::format(", stage {}", how_.stage) : ""; }
  std::string farthest() const;
  void end_what_does_not_rest(std::uint64_t n, const Unrest& unrest);
  [[noreturn]] void tell_motion(std::uint64_t steps, const std::string& why) const;
  [[noreturn]] void give_up(std::uint64_t steps, bool stalled) const;

  Model& model_;
  Stepper& stepper_;
  const scene::Statics& statics_;
  const double mass_;  // of all that moves, 0 where it is not known [kg]
  const scene::Statics::Damping damping_;
  Stepper::Relaxing how_;
  std::optional<StaticMasses> masses_;
  std::vector<std::uint32_t> stages_;
  std::size_t stage_ = 0;  // that is relaxing, or is the next to
  bool begun_ = false;
  bool near_rest_ = false;
  ProgressLine line_;
  Rest rest_;
  std::uint64_t step_ = 0, step_of_stage_ = 0;  // the next
  double internal_at_first_ = 0;                // of the stage [N]
  double kinetic_energy_ = 0;                   // a step before, since the last stop
  std::uint64_t imposing_steps_ = 0;            // of the stage, in which its displacements come
  Stall stall_;
  Moved moved_;                   // as told last, in this stage
  std::uint64_t free_steps_ = 0;  // since the last stop
  std::uint64_t returns_ = 0;     // stops in succession after three steps
};

void Statics::Relaxer::run(const BetweenSteps& between_steps) {
  while (!done()) {
    if (!begun_) begin_stage();
    const bool at_rest = step();
    if (at_rest) {
      ++stage_;
      begun_ = false;
    }
    between_steps(at_rest);
  }
  masses_.reset();
  for (Participant& participant : model_.participants) participant.drift = rest_.drift;
}

void Statics::Relaxer::begin_stage() {
  begun_ = true;
  how_.stage = stages_[stage_];
  pace(false);
  how_.stop = how_.stage > 0;
  stall_ = Stall(statics_.unbalanced_ratio(), statics_.max_steps());
  const bool imposes = protocol::imposes_displacement(model_.scene, how_.stage);
  imposing_steps_ = imposes ? protocol::kImposingSteps + kStopsAtTheEnd : 0;
  moved_ = {};
  step_of_stage_ = 0;
}

// Whether the model is at rest by it.
bool Statics::Relaxer::step() {
  const std::uint64_t n = step_of_stage_++;
  if (n > statics_.max_steps()) give_up(statics_.max_steps(), false);
  stepper_.relax(step_, how_);
  const Unrest unrest(model_.participants);
  rest_.steps = step_++;
  if (n == 0) internal_at_first_ = unrest.internal_force;
  take(unrest);
  if (line_.due())
    line_.print(fmt::format("statics{}: step {}, unbalanced ratio {:.2e}, {:.1e} wanted; {}; {}",
                            name_of_stage(), n, rest_.mean_ratio, statics_.unbalanced_ratio(), place(),
                            farthest()));
  const bool judges = n > imposing_steps_;
  if (judges && rest_.mean_ratio <= statics_.unbalanced_ratio()) return true;
  if (judges) end_what_does_not_rest(n, unrest);
  brake(unrest);
  if (!near_rest_ && n > 0 && rest_.mean_ratio <= kOnePaceAbove) pace(true);
  return false;
}

// From now on. Velocities of another clock mean nothing.
void Statics::Relaxer::pace(bool near_rest) {
  near_rest_ = near_rest;
  how_.slowing = 0;
  how_.stop = true;
  kinetic_energy_ = 0;
  free_steps_ = 0;
  weigh();
}

// Local damping keeps the true masses of elements: ties that it damps were unstable with others.
void Statics::Relaxer::weigh() {
  const bool own_steps = near_rest_ && statics_.scale_masses();
  masses_.emplace(model_, kStepShare / std::sqrt(1 + how_.local_damping), own_steps,
                  own_steps && damping_ != scene::Statics::LOCAL);
  how_.dt = masses_->dt();
}

void Statics::Relaxer::take(const Unrest& unrest) {
  rest_.mean_ratio = unrest.mean_ratio(internal_at_first_);
  rest_.largest_ratio = unrest.largest_ratio(internal_at_first_);
  rest_.x = unrest.x;
  rest_.y = unrest.y;
  rest_.of = unrest.largest_of;
  rest_.drift = unrest.drift();
  rest_.acceleration = mass_ > 0 ? unrest.unbalanced_force / mass_ : 0;
  if (unrest.moved.distance > 0) moved_ = unrest.moved;
}

void Statics::Relaxer::end_what_does_not_rest(std::uint64_t n, const Unrest& unrest) {
  if (std::isnan(rest_.mean_ratio)) give_up(n, true);
  if (n >= kFirstLookAtFall && unrest.falls(internal_at_first_)) tell_motion(n, "nothing holds the model");
  const Stall::Kind kind = stall_.noticed(rest_.mean_ratio, moved_);
  if (kind == Stall::kFlows)
    tell_motion(n, "it does not slow down: nothing holds it, or the ground there yields without end");
  if (kind == Stall::kStalls && !(std::isinf(rest_.mean_ratio) && unrest.may_land())) give_up(n, true);
}

// Before the next step: stops where the forces of this one took kinetic energy away, of what the slowing had
// left.
void Statics::Relaxer::brake(const Unrest& unrest) {
  how_.stop = false;
  if (how_.local_damping > 0) return;
  const double left = 1 - how_.slowing;
  how_.stop = stops(unrest.kinetic_energy < left * left * kinetic_energy_);
  if (how_.stop) ++rest_.stops;
  free_steps_ = how_.stop ? 0 : free_steps_ + 1;
  kinetic_energy_ = how_.stop ? 0 : unrest.kinetic_energy;
  how_.slowing =
      damping_ == scene::Statics::ADAPTIVE ? kSlowing / (kSlowing + static_cast<double>(free_steps_)) : 0;
}

// Motions of three steps a period are where they began when the third step ends. Where most of what moves has
// this period, stops every three steps would take nothing away: in their turn one comes a step later.
bool Statics::Relaxer::stops(bool peaked) {
  if (free_steps_ == 3 && returns_ == kReturns) {
    returns_ = 0;
    return true;
  }
  if (!peaked || free_steps_ != 2) {
    if (peaked) returns_ = 0;
    return peaked;
  }
  if (returns_ == kReturns) return false;
  ++returns_;
  return true;
}

std::string Statics::Relaxer::place() const {
  return fmt::format("largest {:.2e} at ({:.4g}, {:.4g}) m of `{}`", rest_.largest_ratio, rest_.x, rest_.y,
                     rest_.of);
}

std::string Statics::Relaxer::farthest() const {
  if (moved_.distance == 0) return "nothing is known to have moved";
  return fmt::format("the farthest has moved {:.3g} m: {} of `{}`, from ({:.4g}, {:.4g}) m", moved_.distance,
                     moved_.what.empty() ? "a point" : moved_.what, moved_.of, moved_.x, moved_.y);
}

void Statics::Relaxer::tell_motion(std::uint64_t steps, const std::string& why) const {
  throw protocol::UserError(
      "statics",
      fmt::format("cannot come to rest{}: after {} steps {}, and {}; hold it (motions, walls, a lining or "
                  "bolts of this "
                  "stage), give the ground more strength, let an excavation release less, or leave loose "
                  "particles out "
                  "(particles.remove_floaters); the unbalanced force ratio is {:.2e}, {:.1e} wanted",
                  name_of_stage(), steps, farthest(), why, rest_.mean_ratio, statics_.unbalanced_ratio()));
}

void Statics::Relaxer::give_up(std::uint64_t steps, bool stalled) const {
  throw protocol::UserError(
      "statics",
      fmt::format(
          "do not come to rest{}: after {} steps the unbalanced force ratio is {:g}, {:g} were asked for{}; "
          "{}; {}; look there for loose particles (particles.remove_floaters), a body that nothing holds, or "
          "ground that fails under its weight; or allow more statics.max_steps, or a larger "
          "statics.unbalanced_ratio",
          name_of_stage(), steps, rest_.mean_ratio, statics_.unbalanced_ratio(),
          stalled ? ", and it no longer decreases" : "", place(), farthest()));
}

void Statics::Relaxer::exchange(state::Archive& archive) {
  archive("stage", stage_);
  archive("stage_begun", begun_);
  archive("near_rest", near_rest_);
  archive("relaxing", how_);
  archive("rest_steps", rest_.steps);
  archive("rest_stops", rest_.stops);
  archive("rest_mean_ratio", rest_.mean_ratio);
  archive("rest_largest_ratio", rest_.largest_ratio);
  archive("rest_x", rest_.x);
  archive("rest_y", rest_.y);
  archive("rest_of", rest_.of);
  archive("rest_drift", rest_.drift);
  archive("rest_acceleration", rest_.acceleration);
  archive("statics_step", step_);
  archive("statics_step_of_stage", step_of_stage_);
  archive("internal_at_first", internal_at_first_);
  archive("kinetic_energy", kinetic_energy_);
  stall_.exchange(archive);
  archive("moved_distance", moved_.distance);
  archive("moved_x", moved_.x);
  archive("moved_y", moved_.y);
  archive("moved_extent", moved_.extent);
  archive("moved_of", moved_.of);
  archive("moved_what", moved_.what);
  archive("free_steps", free_steps_);
  archive("returns", returns_);
  archive("imposing_steps", imposing_steps_);
  if (archive.reads() && begun_) weigh();
}

Statics::Statics(Model& model, Stepper& stepper) : relaxer_(std::make_unique<Relaxer>(model, stepper)) {}

Statics::~Statics() = default;

void Statics::run(const BetweenSteps& between_steps) {
  relaxer_->run(between_steps);
}

bool Statics::done() const {
  return relaxer_->done();
}

const Rest& Statics::rest() const {
  return relaxer_->rest();
}

void Statics::exchange(state::Archive& archive) {
  relaxer_->exchange(archive);
}

Rest relax(Model& model, Stepper& stepper) {
  Statics statics(model, stepper);
  statics.run([](bool) {});
  return statics.rest();
}

}  // namespace adit::coupler
