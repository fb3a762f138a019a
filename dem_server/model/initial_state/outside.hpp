// What acts on the discs of a model from outside at t = 0, before anything moves.
#pragma once

#include <functional>
#include <vector>

#include "dem_server/model/model.hpp"
#include "protocol/ground/stated_stress.hpp"

namespace adit::dem {

using StressAtHeight = std::function<protocol::GroundStress(double y)>;

// Force x, force y [N] and moment [N m] on each disc, of loads and springs: three values a disc.
std::vector<double> external_forces(const Model& model);

// Whether x, y and the rotation of each disc are held: as far as the scene prescribes them; x and y on quiet
// edges; else all three at the border, where neither a force acts nor the stated stress vanishes.
std::vector<bool> held_motions(const Model& model, const std::vector<bool>& border,
                               const StressAtHeight& stated);

}  // namespace adit::dem
