// What facets do in a step, patch by patch (facet_patch.hpp; laws/facet.hpp has the law).
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
// facet turns into a free face by itself. Of an addition, an open point bears as much as is whole of it, and
// a closed one all; with s, the share that a facet does not bear, and De without it,
//   p_i = bulk_i S_i / (1 + g_i),     g_i = bulk_i sum_f s A / 2k,
// where each cell takes for the part of others in the addition that of its own, as at a free face: neighbours
// mostly swell alike. These are the gradient of sum p^2 (1 + g) / (2 bulk), so that cells with worn facets
// make no energy. (The pressures of the step before in the place of p_j would be late by g steps, and a force
// that is late drives what vibrates.)
//
// A facet of which one end at least has lost its strength, and whose faces have moved past each other by half
// of its length, or apart at one end, has parted: it bears nothing any more, and its cells touch as polygons
// do (forces/cell_contacts.hpp).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/engines/general/facets/facet_motion.hpp"
#include "dem_server/engines/general/facets/facet_patch.hpp"
#include "dem_server/engines/general/facets/facet_set.hpp"
#include "dem_server/engines/general/pairs/block_discs.hpp"

namespace adit::dem {

// Room for a patch, of each thread; of no use between two patches.
struct FacetWork {
  struct CellMotion {
    double ux, uy, sine, versine;
  };
  std::vector<CellMotion> cells;
  // Of the cells: sums of A / h (r . De) over the facets whose first and whose second they are [m^2]; lambda
  // theta, weighted [Pa].
  std::vector<double> as_first, as_second, pressure;
  std::vector<double> released;                              // of worn facets: sums of s A / 2k [m^2/Pa]
  std::vector<double> jump_n, jump_t, turn, nx, ny, cosine;  // of the facets: FacetMotion
};

// What the facets of a block did in a step.
struct FacetResult {
  double max_normal = 0;               // largest |N|, unweighted [N]; not finite where any is not
  std::uint32_t strongest = 0;         // a facet that carries it
  double fracture = 0;                 // dissipated, weighted [J]
  double internal_force = 0;           // sum of |force|, weighted, where it is asked for [N]
  std::vector<std::uint32_t> cracked;  // ascending
  bool any_parted = false;
  std::vector<WornFacet> worn;  // those of FacetSet after the step
};

// Turns the cells begin … end - 1 by dt times their spin.
void turn_cells(double dt, std::uint32_t begin, std::uint32_t end, std::span<const double> spin,
                FacetSet& set);

// Adds what facets do to the cells of a patch to the sums of `discs`, which have taken the block, and finds
// the cells' pressures. Of worn facets, `set` still has what they were, which other patches read.
void add_facet_forces(const FacetPatch& patch, std::span<const double> ux, std::span<const double> uy,
                      bool internal_force, FacetSet& set, FacetWork& work, BlockDiscs& discs,
                      FacetResult& result);

// The same of a single facet, after a step; actions are weighted.
FacetMotion motion_of(std::uint32_t facet, std::span<const double> ux, std::span<const double> uy,
                      const FacetSet& set);
FacetAction action_of(std::uint32_t facet, const FacetMotion& motion, const FacetSet& set);

}  // namespace adit::dem
