// What an interface does at one place, for histories.
#pragma once

#include <string>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/supports/supports.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

struct InterfaceProbe {
  scene::Quantity quantity;
  std::uint32_t contact;
};

bool is_of_interface(scene::Quantity quantity);

// The contact nearest to the place. UserError at `path`, the history's, where it names no interface of the
// scene or a place off it.
InterfaceProbe resolve_interface_probe(const scene::History& history, const Supports& supports,
                                       const Grid& grid, const std::string& path);

// `contacts`: those in motion.
double value(const InterfaceProbe& probe, const Contacts& contacts);

}  // namespace adit::fdm
