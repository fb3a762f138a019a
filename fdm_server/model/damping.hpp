// The scene's damping of the ground. Errors: UserError with the scene's path.
#pragma once

#include "fdm_server/solver/damping.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

DampingLaw resolve_damping(const scene::Continuum& scene);

}  // namespace adit::fdm
