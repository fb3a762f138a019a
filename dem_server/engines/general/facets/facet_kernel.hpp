// What facets do in a step, pass by pass (laws/facet.hpp has the law).
//
// Cells are rigid and may turn far. The middle of a facet, at r_i of one nucleus and r_j of the other, is
// moved by u + (R - 1) r with each cell; D is the difference, in the frame of n turned by the mean of both
// turns, and both ends of the facet part by
// -+ A sin(turn / 2) along n. Force and reaction act in the middle between the two places: linear and angular
// momentum are kept.
//
// Volume. Springs of the stiffness k = E' / h, E' = E2 / (1 + nu2), give a body whose Poisson's ratio is 0
// (E2, nu2: the constants of the plane). The rest of the stress is lambda theta, lambda = E2 nu2 / (1 -
// nu2^2), theta the growth of a cell's area over it by its facets' elastic jumps De = D - lost:
//   theta_i = sum_f A / h (r_i . De) / (V_i (1 + beta_i)),     beta_i = lambda / E' (2 - sum_f A h / (2
//   V_i)).
// beta stands for the faces without a facet: no stress acts on them, so that they part by -lambda theta h_b /
// E', h_b being their distance from the nucleus; and A h_b over all faces sums to 2 V. A facet's traction
// grows by
//   lambda / h (theta_i r_i - theta_j r_j):      lambda (theta_i + theta_j) / 2 along n, lambda skew (theta_i
//   - theta_j) across.
// Between cells of unlike stiffness, half springs in a row, each cell takes its share of the jump, E' / E'_i
// of the mean, and of what is added. These are the gradient of sum lambda V (1 + beta) theta^2 / 2. Bodies
// under uniform strain have the stress of the solid exactly, whatever their cells (in purpose the auxiliary
// stress of Asahina et al. 2017, Comput. Struct. 180, 21).
//
// The strength sees k D with that traction and the one at rest, as if the jump were larger by them over k.
// The elastic jump of a facet beyond its strength is what it then bears, less what was added, over k: an open
// facet turns into a free face by itself. It takes the addition of the step before.
//
// A cracked facet whose faces have moved past each other by half of its length, or as far apart, has parted:
// it bears nothing any more, and its cells touch as discs do.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/engines/general/facets/facet_set.hpp"

namespace adit::dem {

// Results of the passes, of use within a step and to observers after it.
struct FacetMotion {
  std::vector<double> jump_n, jump_t,
      turn;                            // D [m]; 2 sin of half the turn of the second cell against the first
  std::vector<double> nx, ny, cosine;  // n now; of half that turn
  std::vector<double> spread;          // two a facet: A / h (r . De), for the first and the second cell [m^2]
  std::vector<double> pressure;        // of each cell: lambda theta, weighted [Pa]
  // Four a facet: the force on the first cell [N] and the moments on both [N m], weighted.
  std::vector<double> actions;
};

// What one block of facets did in a step.
struct FacetResult {
  double max_normal = 0;                       // largest |N|, unweighted [N]; not finite where any is not
  double fracture = 0;                         // dissipated, weighted [J]
  std::vector<std::uint32_t> cracked, parted;  // ascending
};

// Turns the cells begin … end - 1 by dt times their spin.
void turn_cells(double dt, std::uint32_t begin, std::uint32_t end, std::span<const double> spin,
                FacetSet& set);
void find_jumps(std::uint32_t block, std::span<const double> ux, std::span<const double> uy,
                const FacetSet& set, FacetMotion& motion);
void find_pressures(std::uint32_t begin, std::uint32_t end, const FacetSet& set, FacetMotion& motion);
void find_actions(std::uint32_t block, FacetSet& set, FacetMotion& motion, FacetResult& result);
// Of the last step, unweighted, tension positive [N].
double normal_force(std::uint32_t facet, const FacetSet& set, const FacetMotion& motion);
// Adds to the resultants of the cells.
void gather_actions(std::uint32_t begin, std::uint32_t end, const FacetSet& set, const FacetMotion& motion,
                    double* fx, double* fy, double* moment);

}  // namespace adit::dem
