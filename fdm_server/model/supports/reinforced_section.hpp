// The reinforced section of a lining as the scene states it.
// Errors: UserError with the scene's path where bars do not fit, materials are unknown, given twice or not at
// all, or classes and numbers are mixed.
#pragma once

#include <memory>
#include <string>

#include "fdm_server/structures/beam.hpp"
#include "fdm_server/supports/lining_section.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

std::shared_ptr<const LiningSection> read_reinforced_section(const scene::ReinforcedSection& section,
                                                             const std::string& path);

// Its beams at first.
Section elastic_section(const LiningSection& section, const scene::Lining& lining);

}  // namespace adit::fdm
