#include "coupler/check/counts.hpp"

#include <spdlog/fmt/fmt.h>

#include "coupler/check/text.hpp"
#include "protocol/ground/stages.hpp"
#include "protocol/text.hpp"

namespace adit::coupler {
namespace {

using Table = std::vector<std::vector<std::string>>;

// The laws of contacts that the scene states: of the particles and of their groups.
std::string contacts_of(const scene::Particles& particles) {
  std::vector<scene::ParticleContacts> laws;
  if (particles.has_contacts()) laws.push_back(particles.contacts());
  for (const auto& group : particles.groups())
    if (group.has_contacts()) laws.push_back(group.contacts());
  if (laws.empty()) return "none";
  return laws.size() == 1 ? fmt::format("friction {:g}", laws[0].friction())
                          : fmt::format("{} laws", laws.size());
}

// Those after the beginning.
template <class Part>
std::string stages_in(const Part& part) {
  return grouped(protocol::stages_of(part).size() - 1);
}

std::vector<std::string> particles_row(const Participant& participant, const scene::Particles& particles) {
  const wire::Interface& counts = participant.counts;
  return {participant.member.name,
          grouped(counts.particles()),
          grouped(counts.bonds()),
          grouped(counts.breakable_bonds()),
          contacts_of(particles),
          grouped(static_cast<std::uint64_t>(particles.joints_size())),
          grouped(static_cast<std::uint64_t>(particles.springs_size())),
          stages_in(particles)};
}

std::vector<std::string> grid_row(const Participant& participant, const scene::Continuum& continuum) {
  return {participant.member.name,
          grouped(participant.counts.zones()),
          grouped(participant.counts.grid_points()),
          grouped(static_cast<std::uint64_t>(continuum.linings_size())),
          grouped(static_cast<std::uint64_t>(continuum.bolts_size())),
          stages_in(continuum)};
}

void print_if_any(const Table& table) {
  if (table.size() > 1) print_table(table);
}

}  // namespace

void print_counts(const Model& model) {
  Table particles{
      {"particles of", "particles", "bonds", "breakable", "contacts", "joints", "springs", "stages"}};
  Table grids{{"grid of", "zones", "grid points", "linings", "bolts", "stages"}};
  for (const Participant& participant : model.participants) {
    const scene::Scene part = part_of(model.scene, participant.member);
    if (participant.member.role == Role::kParticles)
      particles.push_back(particles_row(participant, part.particles()));
    else
      grids.push_back(grid_row(participant, part.continuum()));
  }
  Table interfaces{{"interface of", "coupling points", "solve"}};
  for (const Interface& interface : model.interfaces)
    interfaces.push_back({model.participants[interface.outer].member.name + ", " +
                              model.participants[interface.inner].member.name,
                          grouped(interface.end - interface.begin),
                          protocol::lower_case(scene::Solve_Name(interface.given.solve()))});
  print_if_any(particles);
  print_if_any(grids);
  print_if_any(interfaces);
  for (const Participant& participant : model.participants)
    if (!participant.model.engine().empty())
      print_line("engine", participant.member.name + ": " + participant.model.engine());
}

}  // namespace adit::coupler
