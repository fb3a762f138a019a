// A joint of an immersed tunnel and what lies around it as a coupled model in plan.
//
//   window's edge                       joint                          window's edge
//   |· · · · · · · · · · · ·(o o o o o o | o o o o o o)· · · · · · · · · · · · ·|
//     zones                  overlap      particles     overlap      zones
//
// The section becomes a solid slab (slab.hpp). The two bodies beside the joint are bonded particles, the
// joint between them has the springs of the beam's joint (plan_joint.hpp), and the rest of the window is
// zones, in which other joints are spread over the length: their flexibility at rest adds to that of the
// slab. Springs and dashpots hold all of it as they hold the beam, and the ground and the window's edges move
// as the beam's.
#pragma once

#include <string>

#include "protocol/messages/scene.pb.h"
#include "simplified/models/solve.hpp"
#include "simplified/output/response.hpp"
#include "simplified/scene/excitation.hpp"
#include "simplified/zoom/window.hpp"

namespace adit::simplified {

struct PlanScene {
  scene::Scene scene;
  std::string comment;  // lines that begin with `#`: what stands for what
};

// The joint of this number in `line`, which is of the model beam, in its window. `name` is that of the
// tables: those of the edges, and `<name>_along.csv`. Throws UserError at "simplified.zoom.width" where the
// window, or the next joint, leaves the particles no room.
PlanScene plan_scene(const Setup& setup, const Response& response, std::size_t joint, const Window& window,
                     const std::string& name, double duration);

// Writes `<name>_along.csv`: the motion of the ground along the window.
void write_ground_along(const std::filesystem::path& path, const GroundField& ground, double dt,
                        const Window& window);

// Writes `<name>_joint.csv`: what the joint does in the beam model, to compare with.
void write_joint(const std::filesystem::path& path, const Fields& fields, const JointCourse& course);

}  // namespace adit::simplified
