// Tunnels as engineers state them (tunnel.proto), expanded to the scene as the programs compute it.
//
// Linings of beams and zones become parts of the continuum (grid_tunnels.hpp). Each tunnel with a lining of
// particles becomes a particle region: a hexagonal lattice around it, its lining as a group that touches
// the ground, joints, springs, sections and histories named `<tunnel>_joint_1` …, and an overlap around it
// with the solve `split`. One tunnel becomes `particles` and `interface`; several, or one beside these,
// become `regions` and `interfaces`. A tunnel that was always there is a hole in its particles; the continuum
// has nothing there, because the hole lies in the core of the overlap. Otherwise the particles fill it until
// its stage.
#pragma once

#include <string>
#include <vector>

#include "protocol/errors.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::coupler {

struct Expansion {
  scene::Scene scene;              // without `tunnels`
  std::vector<std::string> notes;  // what the user should know of the tunnels, one sentence each

  // What was refused of a part of the scene that a tunnel became, at that tunnel; other errors as they are.
  protocol::UserError at_tunnel(const protocol::UserError& error) const;

  struct Origin {
    std::string part;        // path in the expanded scene
    std::string tunnel;      // path of the tunnel that it came from
    std::string zones = {};  // path of the zones' material that it was taken from, if any
  };
  std::vector<Origin> origins;  // parts of others before these
};

// Takes a scene that fulfils its rules. Throws protocol::UserError below `tunnels[i]` for a tunnel that
// cannot be expanded. A scene without tunnels stays as it is.
Expansion expand_tunnels(const scene::Scene& scene);

}  // namespace adit::coupler
