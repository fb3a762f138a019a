// Rings cut from a hexagonal lattice that stretch and bend like the solid annulus that they stand for.
//
// The circles that select the centres leave ragged faces. Particles there lack some of their six bonds, and
// the cells of those that are left do not fill the annulus, or reach beyond it: as cut, a ring is as soft as
// one thinner by about a radius, and varies around. Both are mended by one rule, without a parameter: the
// bonds of a particle together have the stiffness of what it stands for. Particle i has n_i neighbours in the
// ring; of the annulus, the area A_i lies nearer to it than to any other particle of the ring; the area of a
// whole cell is A = 2 sqrt(3) R^2. Half of a bond belongs to either of its ends, so its factor is the mean of
// those of its ends,
//   c_i = (6 / n_i) (A_i / A).
// The areas A_i make up the annulus, so its thickness is right on all sides, whatever the places of the rows.
// The rule takes a face for one of any direction: where the rows run along it, it is too stiff, where they
// stand across it too soft, around a ring it is right (docs/particles.md has the figures).
//
// Strengths in tension have the same factors: bonds break at the strain at which those within break.
#pragma once

#include <vector>

#include "dem_server/model/model.hpp"
#include "dem_server/model/placement/groups.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::dem {

// The factors c_i of the discs, equal ones in a hexagonal lattice, that lie in the ring; 1 for all others and
// for those with six neighbours in it.
std::vector<double> face_factors(const scene::Annulus& ring, const Discs& discs,
                                 const std::vector<bool>& in_ring);

// Puts the factors on the bonds of the groups with `bends_as_solid`, in the stages in which they are there.
// UserError for such a group that is no annulus of contact bonds in a hexagonal packing.
void stiffen_ring_faces(const scene::Particles& particles, const std::vector<Group>& groups, Model& model);

}  // namespace adit::dem
