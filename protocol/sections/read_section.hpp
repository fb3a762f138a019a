// A section of reinforced concrete as scenes state it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "protocol/messages/reinforced_section.pb.h"
#include "protocol/sections/confined_concrete.hpp"
#include "protocol/sections/section_materials.hpp"
#include "protocol/sections/section_shape.hpp"
#include "protocol/sections/strength.hpp"

namespace adit::sections {

struct StatedSection {
  SectionShape shape;
  ConcreteValues concrete;
  SteelValues steel;  // without bars nothing of it is used
  ResidualTension residual;
  double stirrups;  // A_sw/s over the section's width [m^2/m]
  std::optional<Confinement> confined;
  std::vector<double> damage_states;
};

// `width`: [m]. UserError below `path`, that of the section, for bars outside it, for what is missing, and
// for materials whose strength is stated twice or not at all.
StatedSection read_section(const scene::ReinforcedSection& section, double width, const std::string& path);

Strength strength_of(const StatedSection& section);

}  // namespace adit::sections
