#include "protocol/ground/statics_notes.hpp"

#include <fmt/format.h>

#include "protocol/participant/time_function.hpp"

namespace adit::protocol {
namespace {

bool starts_at_once(const scene::Velocity& velocity, const scene::TimeFunction& time) {
  return (velocity.x() != 0 || velocity.y() != 0) && evaluate(time, 0) != 0;
}

template <class Motions>
void note_motions(const Motions& motions, const std::string& path, std::vector<std::string>& notes) {
  for (int i = 0; i < motions.size(); ++i)
    if (starts_at_once(motions[i].velocity(), motions[i].time()))
      notes.push_back(fmt::format(
          "{}.motions[{}]: statics hold these points, which start at once with their velocity when time "
          "begins; let its `time` begin at 0, or in a continuum give a `displacement`, by which statics "
          "move them",
          path, i));
}

template <class Loads>
void note_loads(const Loads& loads, const std::string& path, std::vector<std::string>& notes) {
  for (int i = 0; i < loads.size(); ++i) {
    if (!loads[i].time().has_table()) continue;
    const auto& values = loads[i].time().table().value();
    const double at_first = evaluate(loads[i].time(), 0), later = *values.rbegin();
    if (at_first != later)
      notes.push_back(fmt::format(
          "{}[{}]: statics bear {:g} times this load, its value of t = 0; the change to {:g} times comes in "
          "time, with inertia",
          path, i, at_first, later));
  }
}

}  // namespace

std::vector<std::string> notes_on_statics(const scene::Continuum& continuum, const std::string& path) {
  std::vector<std::string> notes;
  note_motions(continuum.motions(), path, notes);
  note_loads(continuum.point_loads(), path + ".point_loads", notes);
  note_loads(continuum.edge_loads(), path + ".edge_loads", notes);
  note_loads(continuum.body_loads(), path + ".body_loads", notes);
  return notes;
}

std::vector<std::string> notes_on_statics(const scene::Particles& particles, const std::string& path) {
  std::vector<std::string> notes;
  note_motions(particles.motions(), path, notes);
  note_loads(particles.loads(), path + ".loads", notes);
  note_loads(particles.body_loads(), path + ".body_loads", notes);
  return notes;
}

}  // namespace adit::protocol
