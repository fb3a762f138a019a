// A force of a lining at one place, for histories.
#pragma once

#include <string>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/supports/supports.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

struct LiningProbe {
  scene::Quantity quantity;
  std::size_t lining, node;
};

bool is_of_lining(scene::Quantity quantity);
bool is_of_reinforced_section(scene::Quantity quantity);  // one of these

// UserError at `path`, the history's, where it names no lining of the scene, a place off it, or what an
// elastic lining does not have.
LiningProbe resolve_lining_probe(const scene::History& history, const Supports& supports, const Grid& grid,
                                 const std::string& path);

// `structures`: those in motion.
double value(const LiningProbe& probe, const Supports& supports, const Structures& structures);

}  // namespace adit::fdm
