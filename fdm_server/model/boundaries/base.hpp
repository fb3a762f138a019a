// The earthquake at the base: motions of a rigid base, dashpots and loads of a compliant one.
//
// A compliant base is the head of a half-space. Of a wave that rises with the velocity v and of what comes
// down from the grid, u' - v, the stress at the base is rho c (v - (u' - v)) = 2 rho c v - rho c u':
// dashpots, and the load rho c times 2 v, which is the velocity of the half-space's outcrop.
#pragma once

#include <vector>

#include "fdm_server/boundaries/dashpot_set.hpp"
#include "fdm_server/boundaries/edge_set.hpp"
#include "fdm_server/model/boundaries/base_motion.hpp"
#include "fdm_server/solver/loads.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

struct BaseActions {
  std::vector<std::size_t> edges;  // of the base
  std::vector<Load> loads;
  std::vector<PrescribedMotion> motions;
};

// `accelerations` are those of the base.
BaseActions resolve_base(const scene::Base& base, const BaseAccelerations& accelerations, EdgeSet& edges,
                         const ImpedanceOf& impedance, DashpotSet& dashpots);

}  // namespace adit::fdm
