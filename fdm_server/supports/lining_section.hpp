// The reinforced section of a lining or member: its fibres and what it resists, in a metre of the plane.
#pragma once

#include <memory>

#include "fdm_server/sections/capacity.hpp"
#include "fdm_server/sections/fibre_section.hpp"
#include "fdm_server/sections/shear_capacity.hpp"

namespace adit::fdm {

struct LiningSection {
  std::shared_ptr<const FibreSection> fibres;
  Capacity capacity;
  ShearMaterials shear;
  // For the width of cracks: of the bars [m]; E_cm, f_ctm [Pa].
  double cover, concrete_modulus, tensile_strength;
};

}  // namespace adit::fdm
