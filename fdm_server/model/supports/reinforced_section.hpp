// The reinforced section of a lining as the scene states it.
// Errors: UserError with the scene's path where bars do not fit, materials are unknown, given twice or not at
// all, or classes and numbers are mixed.
#pragma once

#include <memory>
#include <string>

#include "fdm_server/supports/lining_section.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

// So wide in each metre of the plane [m]; `core`: the share of it inside the cover of its sides.
std::shared_ptr<const LiningSection> read_reinforced_section(const scene::ReinforcedSection& section,
                                                             double width, double core,
                                                             const std::string& path);

// All sections of linings and members take the same values of their classes: forces at capacities by mean
// values beside one by design values would not be those of one structure. UserError at the first that
// differs.
void require_same_values(const scene::Continuum& continuum);

}  // namespace adit::fdm
