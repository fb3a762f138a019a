// The files from which detailed models of the worst places begin.
#pragma once

#include <filesystem>

#include "simplified/output/response.hpp"
#include "simplified/run.hpp"
#include "simplified/scene/excitation.hpp"

namespace adit::simplified {

// Writes into `directory`, which is created, for each of the largest responses: the motions of the window's
// edges with the scene that applies them (window.hpp), and the ground at the place (site.hpp).
void write_zoom(const std::filesystem::path& directory, const Setup& setup, const GroundField& ground,
                const Response& response, double duration);

}  // namespace adit::simplified
