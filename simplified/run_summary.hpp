// The summary of a run: summary.json, and its main figures on standard output.
#pragma once

#include <filesystem>
#include <string>

#include "simplified/run.hpp"

namespace adit::simplified {

// `wall_s` is the time of the whole computation [s], with the excitation but without writing files.
void summarize(const scene::Scene& scene, const std::string& case_name, const protocol::Origin& origin,
               const Setup& setup, const Response& response, double wall_s,
               const std::filesystem::path& directory);

// Of a run that ended before its model was solved, by this error.
void summarize_end(const scene::Scene& scene, const std::string& case_name, const protocol::Origin& origin,
                   const Setup& setup, const std::string& error, double wall_s,
                   const std::filesystem::path& directory);

}  // namespace adit::simplified
