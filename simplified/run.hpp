// A whole run, from the scene to the results in a directory.
#pragma once

#include <filesystem>
#include <string>

#include "protocol/messages/scene.pb.h"
#include "protocol/scene/origin.hpp"
#include "simplified/models/solve.hpp"
#include "simplified/output/response.hpp"
#include "simplified/scene/excitation.hpp"

namespace adit::simplified {

// Checks the whole scene and prepares its ground motion; throws UserError.
Setup set_up(const scene::Scene& scene);

// The ground along the tunnel; throws UserError.
GroundField shake(const Setup& setup);

// Computes the response to the ground's motion; throws UserError and Unstable.
Response solve(const Setup& setup, const GroundField& ground);

// Sets the model up, solves it, writes the results into `directory`, which must exist, and prints the main
// figures. `zoom`: a place for a coupled scene (zoom/write.hpp), or empty.
void run(const scene::Scene& scene, const std::string& case_name, const protocol::Origin& origin,
         const std::filesystem::path& directory, const std::string& zoom);

// Only sets the model up, and prints the notes on its motion.
void check(const scene::Scene& scene);

}  // namespace adit::simplified
