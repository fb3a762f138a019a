// Files that a scene names: their contents travel with it, because the server that needs them may run
// elsewhere.
#pragma once

#include "protocol/scene/reader.hpp"

namespace adit::protocol {

constexpr std::uintmax_t kLargestAttachedBytes = 500 << 20;

// Fills every field that is the content of a file (rule.proto) which the field beside it names, relative to
// the scene file in which it is written; the name becomes absolute, so that the scene reads the same wherever
// it is written to. Throws UserError at the name's place for a file that cannot be read.
void attach_files(SceneFile& file);

// Wherever the files lie, the scene computes the same.
void forget_file_names(scene::Scene& scene);

}  // namespace adit::protocol
