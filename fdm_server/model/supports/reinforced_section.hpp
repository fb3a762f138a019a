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

}  // namespace adit::fdm
