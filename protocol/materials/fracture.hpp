// Strengths between cells as scenes state them.
#pragma once

#include <string>

#include "protocol/messages/materials.pb.h"

namespace adit::protocol {

// As stated, or by Mohr and Coulomb from the compressive strength, c = f_c (1 - sin phi) / (2 cos phi) [Pa].
// UserError at `path` where neither or both are stated, and where it is below the tensile strength.
double cohesion_of(const scene::Fracture& fracture, const std::string& path);

}  // namespace adit::protocol
