// The reinforced section of a lining or member: its fibres and what it resists, in a metre of the plane.
#pragma once

#include <memory>

#include "protocol/sections/fibre_section.hpp"
#include "protocol/sections/strength.hpp"

namespace adit::fdm {

struct LiningSection {
  std::shared_ptr<const sections::FibreSection> fibres;
  bool elastic;  // fibres only state the stiffness
  sections::Strength strength;
  // For the width of cracks: of the bars [m]; E_cm, f_ctm [Pa].
  double cover, concrete_modulus, tensile_strength;
};

}  // namespace adit::fdm
