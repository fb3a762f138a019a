// What all programs that compute a scene have in common: they read it, and say why they ended.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "protocol/scene/reader.hpp"

namespace adit::protocol {

// Does `work`, whose value is the exit code. Every way in which it ends early becomes one sentence on
// standard error and an exit code.
int with_errors_told(const std::function<int()>& work);

// Reads the scene over its bases, applies the `--set` texts, and does `work` on it. Errors are told as above.
// Returns the exit code of the program.
int with_scene(const std::string& path, const std::vector<std::string>& sets,
               const std::function<void(const SceneFile&)>& work);

}  // namespace adit::protocol
