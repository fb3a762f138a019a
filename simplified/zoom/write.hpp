// The files from which detailed models of the worst places begin.
#pragma once

#include <filesystem>
#include <string>

#include "simplified/models/solve.hpp"
#include "simplified/output/response.hpp"
#include "simplified/scene/excitation.hpp"

namespace adit::simplified {

// Whether a scene in plan can be written for the place `worst-opening`, `worst-moment`, `worst-shear` or
// `worst-strain`; throws UserError where not, before anything is computed.
void check_zoom(const Setup& setup, const std::string& place);

// Writes into `directory`, which is created, for each of the largest responses: the motions of the window's
// edges with the scene that applies them (window.hpp), and the ground at the place (site.hpp). For `place`,
// where it is not empty, also `<place>.yaml`: the joint nearest to it as a coupled scene in plan
// (plan_scene.hpp).
void write_zoom(const std::filesystem::path& directory, const Setup& setup, const GroundField& ground,
                const Response& response, double duration, const std::string& place);

}  // namespace adit::simplified
