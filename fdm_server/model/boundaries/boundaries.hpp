// The scene's quiet boundaries, free field and base. Errors: UserError with the scene's path.
#pragma once

#include <span>
#include <vector>

#include "fdm_server/boundaries/edge_set.hpp"
#include "fdm_server/boundaries/free_field.hpp"
#include "fdm_server/materials/material.hpp"
#include "fdm_server/model/boundaries/base_motion.hpp"
#include "fdm_server/solver/dashpots.hpp"
#include "fdm_server/solver/loads.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

// The columns that the scene wants, added to the grid's end.
std::vector<FreeFieldColumn> add_columns(const scene::Continuum& scene, std::span<const BoundaryEdge> outline,
                                         Grid& grid);

struct Boundaries {
  std::vector<Dashpot> dashpots;          // for Continuum::set_dashpots
  std::vector<Load> loads;                // of a compliant base
  std::vector<PrescribedMotion> motions;  // of a rigid base
};

// On what is left of the grid. An edge has one condition at most; a column ends as the grid does beside it.
// `accelerations` are those of the base (base_motion.hpp). No component is prescribed by the base and by one
// of `motions`.
Boundaries resolve_boundaries(const scene::Continuum& scene, const BaseAccelerations& accelerations,
                              const Grid& grid, std::span<const BoundaryEdge> outline,
                              std::span<const FreeFieldColumn> columns, const ImpedanceOf& impedance,
                              std::span<const PrescribedMotion> motions);

// The most that the springs of quiet edges add to the stiffness of a zone per area [N/m^3] (dashpots.hpp), of
// a grid that has no columns yet; 0 without springs.
double spring_stiffness(const scene::Continuum& scene, const Grid& grid, const Ground& ground);

// Whether each point will bear on dashpots, of a grid that has no columns yet.
std::vector<bool> find_bearing_points(const scene::Continuum& scene, const BaseAccelerations& accelerations,
                                      const Grid& grid);

}  // namespace adit::fdm
