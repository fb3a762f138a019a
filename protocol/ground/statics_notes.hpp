// What of a scene begins with a jolt because statics leave it out.
#pragma once

#include <string>
#include <vector>

#include "protocol/messages/scene.pb.h"

namespace adit::protocol {

// Of a model, whose place in the scene is `path`, that begins with statics: velocities that are not 0 when
// time begins, at which statics hold their points; loads that go on with another value than that of t = 0,
// which is the one of statics.
std::vector<std::string> notes_on_statics(const scene::Continuum& continuum, const std::string& path);
std::vector<std::string> notes_on_statics(const scene::Particles& particles, const std::string& path);

}  // namespace adit::protocol
