// A force of a lining or member at one place, for histories.
#pragma once

#include <optional>
#include <string>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/supports/supports.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

struct LiningProbe {
  scene::Quantity quantity;
  bool of_member;  // instead of a lining
  std::size_t number, node;
  std::optional<LiningJoint> joint{};    // at the node, of what joints do
  std::optional<std::uint32_t> dowel{};  // its number in the structures
};

bool is_of_lining(scene::Quantity quantity);
bool is_of_reinforced_section(scene::Quantity quantity);  // one of these
bool is_of_segments(scene::Quantity quantity);            // likewise
bool is_of_dowels(scene::Quantity quantity);              // likewise

// UserError at `path`, the history's, where it names no lining or member of the scene, a place off it or off
// its joints, or what an elastic one, a joint without bolts, gasket or water, or a ring without dowels does
// not have.
LiningProbe resolve_lining_probe(const scene::History& history, const Supports& supports, const Grid& grid,
                                 const std::string& path);

// `structures`: those in motion.
double value(const LiningProbe& probe, const Supports& supports, const Structures& structures);

}  // namespace adit::fdm
