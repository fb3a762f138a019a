#include "coupler/stepping/statics.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <set>

#include "coupler/exchange/exchange.hpp"
#include "coupler/stepping/progress.hpp"
#include "protocol/errors.hpp"
#include "protocol/ground/stages.hpp"

namespace adit::coupler {
namespace {

// What the multipliers' impulses add to a participant's predicted kinetic energy, from both velocities at the
// coupling points: the change of m v^2 / 2.
double kinetic_energy_of_correction(Participant& participant) {
  if (!participant.interpolation) return 0;
  correct_velocities(participant);
  double twice = 0;
  const std::span<const double> impulses = participant.correction.impulses();
  for (std::size_t i = 0; i < impulses.size(); ++i)
    twice += impulses[i] * (participant.predicted[i] + participant.corrected[i]);
  return twice / 2;
}

// State of all participants together: kinetic energy of this step, forces of the step before.
struct State {
  double kinetic_energy = 0, unbalanced_force = 0, internal_force = 0;
  std::uint64_t points = 0, elements = 0;

  explicit State(std::vector<Participant>& participants) {
    for (Participant& participant : participants) {
      const wire::Relaxation& r = participant.prediction().relaxation();
      kinetic_energy += r.kinetic_energy() + kinetic_energy_of_correction(participant);
      unbalanced_force += r.unbalanced_force();
      internal_force += r.internal_force();
      points += r.points();
      elements += r.elements();
    }
  }
  // Against the internal force of now, or of the beginning where it was larger: ground that is free to expand
  // has none left in the end.
  double unbalanced_ratio(double internal_at_first) const {
    if (unbalanced_force == 0) return 0;
    return (unbalanced_force / static_cast<double>(points)) /
           (std::max(internal_force, internal_at_first) / static_cast<double>(elements));
  }
};

// 0, the ground as it is in the beginning, and the stages of excavation and of what is installed.
std::set<std::uint32_t> stages(const scene::Scene& scene) {
  std::set<std::uint32_t> found;
  const auto add = [&found](const auto& model) { found.merge(protocol::stages_of(model)); };
  add(scene.continuum());
  add(scene.particles());
  for (const scene::Region& region : scene.regions()) {
    add(region.continuum());
    add(region.particles());
  }
  return found;
}

}  // namespace

Rest relax(Model& model, Stepper& stepper) {
  const scene::Statics& statics = model.scene.statics();
  ProgressLine line;
  Rest rest;
  std::uint64_t step = 0;
  const auto relax_stage = [&](std::uint32_t stage) {
    bool stop = stage > 0;
    double kinetic_energy = 0;     // a step before, since the last stop
    double internal_at_first = 0;  // force
    for (std::uint64_t n = 0; n <= statics.max_steps(); ++n) {
      stepper.relax(step, stop, stage);
      const State state(model.participants);
      rest.steps = step++;
      if (n == 0) internal_at_first = state.internal_force;
      rest.unbalanced_ratio = state.unbalanced_ratio(internal_at_first);
      if (line.due())
        line.print(fmt::format("statics{}: step {}, unbalanced ratio {:.2e}, {:.1e} wanted",
                               stage > 0 ? fmt::format(", stage {}", stage) : "", n, rest.unbalanced_ratio,
                               statics.unbalanced_ratio()));
      if (n > 0 && rest.unbalanced_ratio <= statics.unbalanced_ratio()) return;
      stop = state.kinetic_energy < kinetic_energy;
      kinetic_energy = stop ? 0 : state.kinetic_energy;
      if (stop) ++rest.stops;
    }
    throw protocol::Unstable(fmt::format(
        "statics{}: after {} steps the unbalanced force ratio is {:g}, {:g} were asked for; allow more "
        "statics.max_steps, or a larger statics.unbalanced_ratio",
        stage > 0 ? fmt::format(", stage {}", stage) : "", statics.max_steps(), rest.unbalanced_ratio,
        statics.unbalanced_ratio()));
  };
  for (const std::uint32_t stage : stages(model.scene)) relax_stage(stage);
  return rest;
}

}  // namespace adit::coupler
