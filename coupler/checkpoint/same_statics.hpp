// What may differ between a scene and another that begins from its state at rest.
#pragma once

#include <string>

#include "protocol/messages/scene.pb.h"

namespace adit::coupler {

// Throws protocol::UserError at the first field by which statics would have led to another state, or to
// another model: all but names, what is asked, `time` (its `substeps` excepted), `output` and accelerations
// of a base.
void require_same_statics(scene::Scene before, scene::Scene now);

// The same for scenes between which that function finds no difference (hash.hpp).
std::string statics_hash(scene::Scene scene);

}  // namespace adit::coupler
