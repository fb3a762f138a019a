// What a participant says in its hello that it computes, against what its part of the scene asks for.
#pragma once

#include <google/protobuf/repeated_field.h>

#include <string>

#include "protocol/messages/scene.pb.h"

namespace adit::protocol {

using Computed = google::protobuf::RepeatedPtrField<std::string>;  // paths of keys, see Hello in wire.proto

// Throws UserError at the first key of a participant's part of the scene that its `program` does not compute:
// a run that left it out would be that of another model. `model` is `continuum` or `particles`, which the
// user wrote at `path`.
void require_computed(const scene::Scene& part, const std::string& model, const std::string& path,
                      const Computed& computed, const std::string& program);

}  // namespace adit::protocol
