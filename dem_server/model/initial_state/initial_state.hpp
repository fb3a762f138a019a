// The stress of the ground before anything acts, as forces of bonds and contacts that balance.
//
// 1. A uniform strain loads every link (network.hpp) as if all discs followed it. Three unit strains, each
//    brought to balance with the border of the packing held, give the stiffness C of the fabric: their mean
//    stresses over the faces inside (faces.hpp). The strain C^-1 sigma(x, y), sigma being the stated stress
//    at the middle of a link, is what the forces start from.
// 2. The least that lacks for balance is added (equilibrium.hpp), under the loads and springs of t = 0. What
//    the scene moves is held as far as it is prescribed, and quiet edges are; else the border of the packing
//    is held, because ground or supports beyond bear the rest there (outside.hpp). A uniform strain, balanced
//    too, then makes the mean stress the stated one.
// 3. What a link cannot bear is cut - tension of a contact, shear beyond friction, more than a strength -
//    and the others balance what is left. The user is told how many were cut.
//
// Where step 1 leaves nothing out of balance, its forces stay: in a hexagonal lattice, where the border is
// held and the stress is uniform or grows by the weight.
#pragma once

#include <span>

#include "dem_server/model/initial_state/outside.hpp"
#include "dem_server/model/model.hpp"

namespace adit::dem {

// Sets the forces at rest of the model's bonds, and the pairs that touch with theirs; overlaps of its discs
// bear nothing else. UserError at initial_stress for what no forces can give.
void set_initial_state(const StressAt& stated, Model& model);

// Makes the forces at rest balance again where an overlap has weighed the model, which the other one then
// bears a share of (outside.hpp). `weights` are those at the centres. Forces that balance as they are stated
// stay: what weights of them leave on a disc, the other model's share of the same stress leaves, too.
void balance_in_overlap(const StressAt& stated, std::span<const double> weights, Model& model);

}  // namespace adit::dem
