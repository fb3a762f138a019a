#include "coupler/check/warnings.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <utility>

#include "coupler/bridging/overlap_notes.hpp"
#include "coupler/check/text.hpp"
#include "coupler/exchange/round_trip.hpp"
#include "protocol/motion/excitation/ground_motion.hpp"

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

// Zones by their centres; none where the participant does not draw their materials.
std::vector<GroundHere> drawn_ground(const wire::Snapshot& snapshot, const Side& side,
                                     const StatedGround& stated) {
  std::vector<GroundHere> zones;
  const double materials = side.part.continuum().materials_size();
  for (const wire::Piece& piece : snapshot.pieces()) {
    const auto& fields = piece.cell_fields();
    const auto material = std::ranges::find(fields, "material", &wire::Field::name);
    if (piece.shape() != wire::Piece::QUADS || material == fields.end()) continue;
    for (int zone = 0; 4 * zone < piece.connectivity_size(); ++zone) {
      const double number = material->values(zone);
      if (!(number >= 0 && number <= materials)) continue;
      GroundHere here{0, 0, ground_of_zones(side.part, side.path, static_cast<std::size_t>(number))};
      for (int corner = 4 * zone; corner < 4 * zone + 4; ++corner) {
        const int point = static_cast<int>(piece.connectivity(corner));
        here.x += piece.points(2 * point) / 4;
        here.y += piece.points(2 * point + 1) / 4;
      }
      here.ground = stated.scattered(here.ground, here.x, here.y);
      zones.push_back(std::move(here));
    }
  }
  return zones;
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

void compare_ground(Model& model) {
  std::vector<wire::Snapshot> snapshots;
  for (const Interface& interface : model.interfaces) {
    const Side outer = side_of(model.scene, model.participants[interface.outer]);
    const Side inner = side_of(model.scene, model.participants[interface.inner]);
    const StatedGround stated(outer.part, outer.path);
    const bool is_known = stated.is_known();
    if (!is_known && snapshots.empty()) snapshots = take_snapshots(model.participants);
    const auto warning = ground_warning(
        interface.overlap, outer, inner,
        is_known ? std::vector<GroundHere>{} : drawn_ground(snapshots[interface.outer], outer, stated));
    if (warning) model.warnings.push_back(*warning);
  }
}

void compare_motions(Model& model) {
  for (const Participant& participant : model.participants) {
    if (participant.member.role != Role::kContinuum) continue;
    const scene::GroundMotion& stated = continuum_of(model.scene, participant.member).base().acceleration();
    if (!stated.has_peak()) continue;
    const std::string path = participant.member.path + ".base.acceleration";
    add_where_it_differs(model.stated,
                         {.key = path + ".peak",
                          .stated = stated.peak(),
                          .acted = motion::ground_motion(stated, path, model.scene.time().duration()).peak,
                          .unit = "m/s^2",
                          .why = "the run takes a part of the motion"});
  }
}

}  // namespace adit::coupler
