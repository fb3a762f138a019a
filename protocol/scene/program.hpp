// What every program that computes a scene does alike: reading it, and saying why it ended.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "protocol/scene/reader.hpp"

namespace adit::protocol {

// Reads the scene over its bases, applies the `--set` texts, and does `work` on it. Every way in which this
// ends early becomes one sentence on standard error. Returns the exit code of the program.
int with_scene(const std::string& path, const std::vector<std::string>& sets,
               const std::function<void(const SceneFile&)>& work);

}  // namespace adit::protocol
