// What a run says of itself: summary.json, and its essence on standard output.
#pragma once

#include <filesystem>
#include <string>

#include "simplified/run.hpp"

namespace adit::simplified {

// `wall_s`: of the whole computation, excitation included, files not.
void summarize(const scene::Scene& scene, const std::string& case_name, const Setup& setup,
               const Response& response, double wall_s, const std::filesystem::path& directory);

}  // namespace adit::simplified
