// What a lining consists of, from the ground inwards.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "protocol/messages/scene.pb.h"

namespace adit::coupler {

struct LiningLayer {
  std::string path;                         // in the scene
  std::string name;                         // the tunnel's, or with several layers `<tunnel>_<layer>`
  double thickness;                         // [m]
  scene::Material material;                 // with a section, of its concrete; of cells with `fracture`
  const scene::ReinforcedSection* section;  // none: nullptr; belongs to the tunnel
  const scene::InterfaceLaw* interface;     // to what lies outside it; likewise
  std::uint32_t stage;
};

// Whether thrust and moment can be compared with it: plain concrete of zones has a stiffness only.
bool resists(const scene::ReinforcedSection* section);

// One for a lining without `layers`. Throws protocol::UserError where a layer is stated twice or not at all,
// and for what linings of this model cannot have. `path`: of the tunnel.
std::vector<LiningLayer> layers_of(const scene::LinedTunnel& tunnel, const std::string& path);

}  // namespace adit::coupler
