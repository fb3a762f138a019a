// The bars of a reinforced lining of particles.
#pragma once

#include <string>

#include "coupler/tunnel/contour.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::coupler {

// From the lining's `section`: bars along both faces, which end before joints of segments by their cover, and
// stirrups across. `path`: of the tunnel. Throws protocol::UserError.
void add_bars(const scene::LinedTunnel& tunnel, const Contour& contour, const std::string& path,
              scene::Particles& particles);

}  // namespace adit::coupler
