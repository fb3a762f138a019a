// An interface's law from the scene.
#pragma once

#include <string>

#include "fdm_server/interfaces/contact.hpp"
#include "protocol/messages/interfaces.pb.h"

namespace adit::fdm {

// Stiffnesses that the scene leaves open are 0. UserError at `path`, the law's field, where strengths
// contradict each other.
ContactLaw read_law(const scene::InterfaceLaw& law, const std::string& path);

// The law with an open stiffness in the place of those that are 0 [Pa/m].
ContactLaw with_stiffness(ContactLaw law, double open);

}  // namespace adit::fdm
