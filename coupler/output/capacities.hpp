// What the sections of reinforced concrete of a scene resist, for those who draw or check forces against it.
#pragma once

#include <filesystem>

#include "protocol/messages/scene.pb.h"

namespace adit::coupler {

// The limit states of thrust and moment (protocol/sections/capacity.hpp), in order around the origin: a row
// of kind (lining, member, section), name, thrust_N, moment_Nm for each; per metre, of a member for the whole
// of it. Writes no file where the scene has no such section.
void write_capacities(const scene::Scene& scene, const std::filesystem::path& path);

}  // namespace adit::coupler
