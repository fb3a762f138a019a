// Files that a scene names. Their contents are sent with the scene, because the server that needs them may
// run on another machine.
#pragma once

#include <functional>
#include <string>

#include "protocol/scene/reader.hpp"

namespace adit::protocol {

// Fills every field that holds the content of a file (rule.proto: content_of). The field beside it names the
// file, relative to the scene file in which it is written. The name becomes absolute, so that a copy of the
// scene in another folder means the same file. Throws UserError at the name's place if the file cannot be
// read, or if the files are longer than kMaxAttachedBytes together.
void attach_files(SceneFile& file);

// Calls visit(path, content) for every attached file.
void for_each_attached_file(
    const scene::Scene& scene,
    const std::function<void(const std::string& path, const std::string& content)>& visit);

// Removes the names of the files, which do not change what is computed.
void forget_file_names(scene::Scene& scene);

}  // namespace adit::protocol
