// The scene's damping of the ground. Errors: UserError with the scene's path.
#pragma once

#include <optional>
#include <string>

#include "fdm_server/materials/damping_law.hpp"
#include "protocol/messages/scene.pb.h"
#include "protocol/motion/motion.hpp"

namespace adit::fdm {

DampingLaw resolve_damping(const scene::Continuum& scene);

// What Rayleigh damping gives between the frequencies for which its ratio is stated, if it is much less.
std::optional<std::string> note_on_ratio(const scene::Continuum& scene, const DampingLaw& law);

// What Maxwell damping does to the stiffness in waves, if the scene has it.
std::optional<std::string> note_on_stiffening(const scene::Continuum& scene, const DampingLaw& law);

// What alpha M takes from the motion that the base and all ground share: alpha v beside the acceleration of
// the base, if it is much.
std::optional<std::string> note_on_shared_motion(const DampingLaw& law, const motion::Motion& base);

}  // namespace adit::fdm
