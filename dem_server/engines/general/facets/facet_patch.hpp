// What the forces on a block of cells depend on: the block's cells and their neighbours, all facets of these,
// and the cells at which the facets end.
//
// The forces that two cells exchange depend on how much the areas of both have grown, and so on all facets of
// both. A thread that knows a patch therefore finds all forces on the block's cells at once, in its cache.
// Facets near the border of a block are computed by both sides, a sixth more than once at 1,024 cells a
// block, which costs less than to store jumps and areas and to read them again. All patches compute them in
// the same order, so that both sides find the same bits.
#pragma once

#include <cstdint>
#include <vector>

#include "dem_server/engines/general/facets/facet_set.hpp"

namespace adit::dem {

struct FacetPatch {
  std::uint32_t begin = 0, cells = 0;  // those of the block
  std::vector<std::uint32_t>
      reached;               // cells of other blocks: their places come after those of a whole block
  std::vector<double> bulk;  // of the cells, by place

  std::vector<std::uint32_t> facets;         // numbers, ascending
  std::uint32_t own_begin = 0, own_end = 0;  // places of those that belong to the block: consecutive
  std::vector<std::uint32_t> incoming;       // places of those of which only the second cell is of the block
  std::vector<std::uint32_t> first, second;  // places of cells
  // As in FacetSet.
  std::vector<double> nx, ny, half_distance, skew, length, stiffness;
  // Plain: these are zeros, and ones for weights and shares. Else as in FacetSet.
  bool plain = true;
  std::vector<double> start_n, start_t, start_turn, rest_n, rest_t, share_1, share_2, weight;
  std::uint32_t first_law = 0;  // of the first facet
  bool one_law = true;          // of all

  std::size_t size() const { return facets.size(); }
  // Of all cells, with a gap where the block is not whole.
  std::size_t places() const;
};

// Of each block.
std::vector<FacetPatch> patches_of(const FacetSet& set);

}  // namespace adit::dem
