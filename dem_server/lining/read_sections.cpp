#include "dem_server/lining/read_sections.hpp"

#include <fmt/format.h>

#include <utility>

#include "protocol/errors.hpp"
#include "protocol/text.hpp"

namespace adit::dem {
namespace {

using protocol::UserError;

std::string path_of(std::size_t section) {
  return fmt::format("particles.sections[{}]", section);
}

Cut read_cut(const scene::ParticleSection& section, const std::vector<Cut>& before) {
  const std::string path = path_of(before.size());
  const Cut cut{
      section.name(), {section.from().x(), section.from().y()}, {section.to().x(), section.to().y()}};
  if (cut.from.x == cut.to.x && cut.from.y == cut.to.y)
    throw UserError(path + ".to", "is the same place as `from`; give a section two ends");
  for (const Cut& other : before)
    if (other.name == cut.name)
      throw UserError(path + ".name", fmt::format("is {}, like that of an earlier section; give each its own",
                                                  protocol::quote(cut.name)));
  return cut;
}

}  // namespace

Sections read_sections(const scene::Particles& scene, const Particles& particles,
                       std::span<const Pair> bonds) {
  std::vector<Cut> cuts;
  for (const auto& section : scene.sections()) cuts.push_back(read_cut(section, cuts));
  Sections sections(std::move(cuts), particles, bonds);
  for (std::size_t k = 0; k < sections.cuts().size(); ++k)
    if (sections.beside(k).empty())
      throw UserError(path_of(k),
                      "crosses no bond between particles; lay it through the lining, from its inner to its "
                      "outer side");
  return sections;
}

}  // namespace adit::dem
