// What acts on the discs of a model from outside at t = 0, before anything moves.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "dem_server/model/initial_state/faces.hpp"
#include "dem_server/model/model.hpp"
#include "protocol/ground/stated_stress.hpp"

namespace adit::dem {

using StressAt = std::function<protocol::GroundStress(double x, double y)>;

// Less than the weight of what no overlap shares, but for rounding.
inline constexpr double kShared = 1 - 1e-9;

// Force x, force y [N] and moment [N m] on each disc that is there, of loads and springs, with the discs'
// weights: three values a disc.
std::vector<double> external_forces(const Model& model);

// The same, by which the other model of an overlap holds the discs where both are at rest under the stated
// stress s. There the discs bear the share w s of it, and all forces on disc i, but that of the other model,
// leave
//   T_i = integral of phi_i grad w . s = - integral of (w - w_i) s grad phi_i,
// phi_i being linear on each triangle of a face's middle and two of its discs. Discs that carry single
// forces of their own would leave sums that scatter from zone to zone of the other model; these leave what
// its own stress (1 - w) s leaves there. At the outermost discs, beyond which w goes on to 0, the second form
// without w_i leaves out least. `weights` are those at the centres.
std::vector<double> forces_of_overlap(const Discs& discs, const Faces& faces, std::span<const double> weights,
                                      const StressAt& stated);

// Whether x, y and the rotation of each disc are held: as far as the scene prescribes them; x and y on quiet
// edges; else all three at the border, where neither a force acts nor the stated stress vanishes.
std::vector<bool> held_motions(const Model& model, const std::vector<bool>& border, const StressAt& stated);

}  // namespace adit::dem
