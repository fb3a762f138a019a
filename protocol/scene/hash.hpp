// A short identifier of what a run computes.
#pragma once

#include <string>
#include <string_view>

#include "protocol/messages/scene.pb.h"

namespace adit::protocol {

// 16 hexadecimal digits: the 64-bit FNV-1a hash of the serialized scene without name, base, description,
// questions and the paths of meshes, which change nothing of what is computed. The same on every machine.
std::string scene_hash(const scene::Scene& scene);

// The same hash of any bytes.
std::string hash_of_bytes(std::string_view bytes);

}  // namespace adit::protocol
