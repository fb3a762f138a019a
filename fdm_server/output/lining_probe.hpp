// A force of a lining or member at one place, for histories.
#pragma once

#include <string>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/supports/supports.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

struct LiningProbe {
  scene::Quantity quantity;
  bool of_member;  // instead of a lining
  std::size_t number, node;
};

bool is_of_lining(scene::Quantity quantity);
bool is_of_reinforced_section(scene::Quantity quantity);  // one of these

// UserError at `path`, the history's, where it names no lining or member of the scene, a place off it, or
// what an elastic one does not have.
LiningProbe resolve_lining_probe(const scene::History& history, const Supports& supports, const Grid& grid,
                                 const std::string& path);

// `structures`: those in motion.
double value(const LiningProbe& probe, const Supports& supports, const Structures& structures);

}  // namespace adit::fdm
