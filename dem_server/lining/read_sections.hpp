// Sections of a lining from the scene.
#pragma once

#include <span>

#include "dem_server/lining/sections.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::dem {

// protocol::UserError for a name that comes twice, a section without length, one that cuts no bond.
Sections read_sections(const scene::Particles& scene, const Particles& particles,
                       std::span<const Pair> bonds);

}  // namespace adit::dem
