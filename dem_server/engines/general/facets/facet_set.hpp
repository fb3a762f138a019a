// Facets of a model as structure of arrays, and what their cells are to them.
//
// Facets ascend by their first cell, then by their second. Those whose first cell is in a block of
// consecutive cells (pairs/pairs.hpp) belong to it.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/laws/facet.hpp"
#include "protocol/state/archive.hpp"

namespace adit::dem {

struct Model;

// A facet that has been beyond its strength.
struct WornFacet {
  std::uint32_t facet;
  bool begun = false;                    // its tractions are known
  bool cracked = false, opened = false;  // opened: it was open when it cracked
  bool parted = false;                   // its faces no longer lie opposite each other: it bears nothing
  double added_n = 0, added_t = 0;       // traction by the cells' areas and at rest, at the last step [Pa]
  double difference = 0;                 // of the cells' pressures, at the last step [Pa]
  struct End {
    FacetPoint point;
    double normal = 0, shear = 0;   // traction at the last step [Pa]
    double lost_n = 0, lost_t = 0;  // jump that is not elastic [m]
    // Twice what it stores of what it has lost: an open point unloads towards its origin [J/m^2].
    double kept() const { return std::max(normal, 0.0) * (lost_n + point.closing); }
  };
  std::array<End, 2> ends{};  // towards the left of n, towards the right

  // s, the share that it does not bear of what the cells' pressures add: a closed point bears all, an open
  // one as much as is whole of it.
  double released() const {
    if (parted) return 1;
    double share = 0;
    for (const End& end : ends) share += end.normal < 0 ? 0 : 0.5 * (1 - end.point.whole);
    return share;
  }
};

struct FacetSet {
  std::vector<std::uint32_t> first, second;
  std::vector<double> nx, ny;         // from the first nucleus to the second, at rest
  std::vector<double> half_distance;  // of the nuclei [m]
  std::vector<double> skew;    // of the facet's middle along the left normal, over the distance of the nuclei
  std::vector<double> length;  // [m]
  std::vector<double> stiffness;  // k [Pa/m]
  std::vector<double> weight;     // energy weight
  std::vector<std::uint32_t> law;
  // Of strain-free facets that were made later: jump and turn at that time [m], [1]. Traction at rest [Pa].
  std::vector<double> start_n, start_t, start_turn, rest_n, rest_t;
  std::vector<double> share_1, share_2;  // of the jump, which each cell takes, times two
  std::vector<FacetLaw> laws;
  double steps_per_second = 0;  // 0 where motion has no rate, as in statics

  // Facets that are worn, of each block, ascending; and of each facet its place there, from 1; 0: none.
  std::vector<std::vector<WornFacet>> worn;
  std::vector<std::uint32_t> worn_place;
  bool any_worn = false;

  // Of each cell: its turn since rest [rad], sin and 1 - cos of it; what a sum of its facets' spreads
  // (facet_kernel.hpp) gives of pressure, weighted [Pa/m^2], 0 where there is none of it; that pressure at
  // the last step [Pa].
  std::vector<double> turn, sine, versine, bulk, pressure;

  std::size_t size() const { return first.size(); }
  std::size_t cells() const { return turn.size(); }
  std::uint32_t block_of(std::uint32_t facet) const;
  // Null where it is as it was made.
  const WornFacet* worn_facet(std::uint32_t facet) const {
    return worn_place[facet] == 0 ? nullptr : &worn[block_of(facet)][worn_place[facet] - 1];
  }

  // Of the facets of a block, ascending.
  void set_worn(std::uint32_t block, std::vector<WornFacet>&& facets);
  void exchange(state::Archive& archive);
};

// Of those bonds of a model that are facets.
FacetSet facets_of(const Model& model);

}  // namespace adit::dem
