#include "coupler/check/warnings.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <utility>

#include "coupler/check/text.hpp"

namespace adit::coupler {
namespace {

// The critical step counts what touches where a bond broke, but neither friction nor the speed of what flies
// apart. Crushed packings keep their energy up to 0.95 of it (DiscsLedger, StaysClosedNearTheCriticalStep).
constexpr double kSafeShareForCracks = 0.9;

// Weight that acts from the beginning and for ever.
bool has_gravity(const scene::Scene& part) {
  const auto constant = [](const scene::BodyLoad& load) {
    return !load.has_time() && (load.acceleration().x() != 0 || load.acceleration().y() != 0);
  };
  return std::ranges::any_of(part.continuum().body_loads(), constant) ||
         std::ranges::any_of(part.particles().body_loads(), constant);
}

void warn_of_cracks(const Model& model, std::vector<std::string>& warnings) {
  const double step = model.dt / model.substeps;
  for (const Participant& participant : model.participants) {
    const double share = step / participant.model.critical_dt();
    if (participant.counts.breakable_bonds() == 0 || share <= kSafeShareForCracks * (1 + 1e-9)) continue;
    warnings.push_back(fmt::format(
        "{} has {} bonds that can break, and the time step is {:.2g} of its critical "
        "one; a time.dt_factor of at most {:g} is safe when they do",
        participant.member.name, grouped(participant.counts.breakable_bonds()), share, kSafeShareForCracks));
  }
}

void warn_of_absent_statics(const Model& model, std::vector<std::string>& warnings) {
  if (model.scene.has_statics()) return;
  if (model.scene.has_initial_stress())
    warnings.push_back(
        "initial_stress is given without `statics`: what the stress does not balance moves when time begins");
  for (const Participant& participant : model.participants)
    if (has_gravity(part_of(model.scene, participant.member)))
      warnings.push_back(
          fmt::format("gravity acts on the {} without `statics`: it is not at rest when time begins",
                      participant.member.name));
}

}  // namespace

std::vector<std::string> warnings_before(const Model& model) {
  std::vector<std::string> warnings = model.warnings;
  warn_of_cracks(model, warnings);
  warn_of_absent_statics(model, warnings);
  for (std::string& warning : warnings_of(model.stated)) warnings.push_back(std::move(warning));
  return warnings;
}

void print_notes_and_warnings(const Model& model, const Pace& pace) {
  for (const std::string& note : model.notes) print_line("note", note);
  for (const std::string& warning : warnings_before(model)) print_line("warning", warning);
  if (!pace.stable())
    print_line("warning", "the first steps, without the statics before them, failed: " + pace.unstable);
}

}  // namespace adit::coupler
