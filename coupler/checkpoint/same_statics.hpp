// What may differ between a scene and another that begins from its state at rest.
#pragma once

#include "protocol/messages/scene.pb.h"

namespace adit::coupler {

// Throws protocol::UserError at the first field by which statics would have led to another state, or to
// another model: all but names, `time` (its `substeps` excepted), `output` and the acceleration of a base.
void require_same_statics(scene::Scene before, scene::Scene now);

}  // namespace adit::coupler
