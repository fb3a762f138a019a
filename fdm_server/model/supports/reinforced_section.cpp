#include "fdm_server/model/supports/reinforced_section.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "protocol/errors.hpp"
#include "protocol/sections/read_section.hpp"

namespace adit::fdm {
namespace {

const char* name_of(scene::ReinforcedSection::Values values) {
  return values == scene::ReinforcedSection::DESIGN ? "design" : "mean";
}

}  // namespace

std::shared_ptr<const LiningSection> read_reinforced_section(const scene::ReinforcedSection& section,
                                                             double width, double core,
                                                             const std::string& path) {
  const sections::StatedSection read = sections::read_section(section, width, path);
  const auto& [shape, concrete, steel, residual, stirrups, confined, states] = read;
  const double yields = shape.bars.empty() ? 0 : steel.yield / steel.young_modulus;
  sections::ConcreteLaw law = sections::concrete_law(concrete, yields, residual);
  if (section.elastic()) law.modulus = concrete.young_modulus;
  if (!section.concrete().tension_stiffening()) law.tensile_strength = 0;
  std::optional<sections::ConfinedCore> within;
  if (confined)
    within = {sections::confined(law, steel, *confined), shape.thickness - 2 * section.cover(), core};
  return std::make_shared<const LiningSection>(LiningSection{
      std::make_shared<const sections::FibreSection>(shape, law, steel_law(steel), within), section.elastic(),
      sections::strength_of(read), section.cover(), concrete.young_modulus, concrete.tensile});
}

void require_same_values(const scene::Continuum& continuum) {
  std::optional<std::pair<scene::ReinforcedSection::Values, std::string>> first;
  const auto compare = [&first](const auto& supports, const char* kind) {
    for (int i = 0; i < supports.size(); ++i) {
      if (!supports[i].has_section()) continue;
      const std::string path = fmt::format("continuum.{}[{}].section.values", kind, i);
      const auto values = supports[i].section().values();
      if (!first) first = {values, path};
      protocol::require(values == first->first, path,
                        fmt::format("is {}, but {} is {}; state the same for all sections of a scene",
                                    name_of(values), first->second, name_of(first->first)));
    }
  };
  compare(continuum.linings(), "linings");
  compare(continuum.members(), "members");
}

}  // namespace adit::fdm
