#include "fdm_server/model/supports/reinforced_section.hpp"

#include <optional>

#include "protocol/sections/read_section.hpp"

namespace adit::fdm {

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

}  // namespace adit::fdm
