#include "coupler/check/savings.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <set>

#include "coupler/check/text.hpp"
#include "coupler/stepping/condensed_regions.hpp"

namespace adit::coupler {
namespace {

constexpr double kShort = 60;        // nobody waits for such a run [s]
constexpr double kHalfAsFine = 8;    // a quarter of the points, half of the steps
constexpr double kWorthwhile = 0.7;  // of the time as it is
constexpr double kLook = 3.5e-6;     // at a cell, on a core of 2023 [s]

// Grid points that move this participant by the interface.
std::size_t masters_of(const Model& model, const Interface& interface) {
  const Participant& grid = model.participants[interface.coarse];
  const Segment& segment = grid.segment_from(interface.begin);
  std::set<std::uint32_t> masters;
  for (std::size_t row = segment.begin; row < segment.begin + segment.count; ++row)
    for (const std::uint32_t own : grid.interpolation->columns(row)) masters.insert(own);
  return masters.size();
}

bool changes(const auto& loads) {
  return std::ranges::any_of(loads, [](const auto& load) { return load.has_time(); });
}

// Whether its cells wait, or could as far as the scene says: they break, and nothing but the continuum moves
// them.
bool might_wait(const Model& model, std::size_t s) {
  const Participant& participant = model.participants[s];
  if (participant.member.role != Role::kParticles || participant.counts.breakable_bonds() == 0) return false;
  const scene::Particles& particles = particles_of(model.scene, participant.member);
  const bool moved = particles.walls_size() + particles.motions_size() + particles.bars_size() +
                         particles.quiet_size() + particles.foundations_size() >
                     0;
  return particles.has_cells() && !moved && !changes(particles.loads()) && !changes(particles.body_loads()) &&
         std::ranges::count(model.interfaces, s, &Interface::fine) == 1;
}

// Steps at which the particles are told how the grid has moved.
double looks(const Model& model, const Schedule& schedule) {
  return static_cast<double>(
      std::max(schedule.row_count() + schedule.peak_count(), model.steps / kLookInterval));
}

// Servers compute side by side, of which the slowest counts, and the coupler moves what waits after them.
void print_waiting(const Model& model, const Schedule& schedule, const Pace& pace) {
  double slowest = 0, moving = 0, looking = 0;  // [s]
  std::string names;
  for (std::size_t s = 0; s < model.participants.size(); ++s) {
    const Participant& participant = model.participants[s];
    if (!might_wait(model, s)) {
      slowest = std::max(slowest, pace.computed[s]);
      continue;
    }
    moving += seconds_to_move(masters_of(model, *std::ranges::find(model.interfaces, s, &Interface::fine)));
    looking += kLook * static_cast<double>(participant.counts.particles()) * looks(model, schedule);
    if (!particles_of(model.scene, participant.member).has_begin())
      names += (names.empty() ? "" : ", ") + participant.member.path;
  }
  const double steps = static_cast<double>(model.steps), waiting = (slowest + moving) * steps + looking;
  if (names.empty() || waiting > kWorthwhile * pace.step * steps) return;
  print_line("shorter", fmt::format("{} while nothing in {} uses 0.8 of its strength, by `begin: {{demand: "
                                    "0.8}}`, where that can wait",
                                    clock_time(waiting), names));
}

}  // namespace

void print_savings(const Model& model, const Schedule& schedule, const Pace& pace) {
  const double stepping = pace.step * static_cast<double>(model.steps);
  if (stepping < kShort) return;
  print_line("shorter",
             fmt::format("{} with zones and particles twice as large; adit trade says what that changes",
                         clock_time(stepping / kHalfAsFine + pace.set_up)));
  print_waiting(model, schedule, pace);
}

}  // namespace adit::coupler
