// A shape as the scene states it.
#pragma once

#include <memory>
#include <string>

#include "coupler/bridging/shape.hpp"
#include "protocol/scene.pb.h"

namespace adit::coupler {

// `path`: of the shape in the scene. Throws protocol::UserError for what encloses no area, crosses itself or
// has holes that are not its own.
std::shared_ptr<const Shape> read_shape(const scene::Shape& shape, const std::string& path);

}  // namespace adit::coupler
