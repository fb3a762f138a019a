// A whole run: from the scene to the results in a directory.
#pragma once

#include <filesystem>
#include <string>

#include "protocol/messages/scene.pb.h"
#include "simplified/models/solve.hpp"
#include "simplified/scene/excitation.hpp"

namespace adit::simplified {

// A scene that can be computed, with all that does not depend on time.
struct Setup {
  const scene::Simplified* scene = nullptr;
  Line line;                  // empty for the column
  double begin = 0, end = 0;  // of the tunnel, or of the profiles [m]
  Clock clock{};
  motion::Motion motion;
};

// Checks all of the scene, prepares its motion; throws UserError.
Setup set_up(const scene::Scene& scene);

// The response to the ground's motion; throws UserError and Unstable.
Response solve(const Setup& setup);

// Sets up, solves, writes the results into `directory`, which exists, and says what they are.
void run(const scene::Scene& scene, const std::string& case_name, const std::filesystem::path& directory);

// Sets up alone.
void check(const scene::Scene& scene);

}  // namespace adit::simplified
