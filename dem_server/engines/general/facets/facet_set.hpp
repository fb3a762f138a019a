// Facets of a model as structure of arrays, and what their cells are to them.
//
// Facets ascend by their first cell, then by their second; blocks of consecutive facets and blocks of
// consecutive cells are shared by threads. Nothing that a block writes is read in the same pass by another
// one, and a cell sums what its facets do in their order: results do not depend on the number of threads.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "dem_server/laws/facet.hpp"
#include "protocol/state/archive.hpp"

namespace adit::dem {

struct Model;

inline constexpr std::uint32_t kFacetBlock = 512;  // facets or cells

// A facet that has been beyond its strength.
struct WornFacet {
  std::uint32_t facet;
  bool begun = false;                    // its tractions are known
  bool cracked = false, opened = false;  // opened: it was open when it cracked
  bool parted = false;                   // its faces no longer lie opposite each other: it bears nothing
  double added_n = 0, added_t = 0;       // traction by the cells' areas and at rest, at the last step [Pa]
  struct End {
    FacetPoint point;
    double normal = 0, shear = 0;   // traction at the last step [Pa]
    double lost_n = 0, lost_t = 0;  // jump that is not elastic [m]
  };
  std::array<End, 2> ends{};  // towards the left of n, towards the right
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
  std::vector<double> share_1, share_2;      // of the jump, which each cell takes, times two
  std::vector<std::vector<WornFacet>> worn;  // of each block, ascending
  std::vector<FacetLaw> laws;

  // Of each cell: its turn since rest [rad], sin and 1 - cos of it, and the pressure per sum of its facets'
  // spreads (facet_kernel.hpp), weighted [Pa/m^2]; 0 where there is none of it.
  std::vector<double> turn, sine, versine, bulk;
  bool any_bulk = false;
  bool plain = false;  // no start, no stress at rest, no weights, cells of one stiffness

  // Facets whose second cell a cell is: one list, and where each cell's begins. Facets whose first it is are
  // consecutive.
  std::vector<std::uint32_t> first_starts, second_starts, as_second;

  std::size_t size() const { return first.size(); }
  std::size_t blocks() const { return (size() + kFacetBlock - 1) / kFacetBlock; }
  std::size_t cells() const { return turn.size(); }
  std::size_t cell_blocks() const { return (cells() + kFacetBlock - 1) / kFacetBlock; }

  void find_plain();
  void exchange(state::Archive& archive);
};

// Of those bonds of a model that are facets.
FacetSet facets_of(const Model& model);

}  // namespace adit::dem
