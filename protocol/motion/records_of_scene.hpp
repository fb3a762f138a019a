// Records that a scene names by their files: read where the files are, computed elsewhere.
#pragma once

#include "protocol/scene_reader.hpp"

namespace adit::motion {

// Every MotionFile of the scene gets the values of its file, which it does not hold yet; a path is relative
// to the file in which it is written. Afterwards the scene needs no file beside itself. Throws UserError.
void read_records(protocol::SceneFile& file);

}  // namespace adit::motion
