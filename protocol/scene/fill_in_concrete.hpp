// Numbers of materials that are stated by a class of concrete.
#pragma once

#include "protocol/messages/scene.pb.h"

namespace adit::protocol {

// Replaces `concrete` of every material of the scene by the mean values of the class, as far as the material
// does not state them; `fracture` only where cells or zones take it. Throws UserError for a class that is not
// known, or that would state nothing.
void fill_in_concrete(scene::Scene& scene);

}  // namespace adit::protocol
