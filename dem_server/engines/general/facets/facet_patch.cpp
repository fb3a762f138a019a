#include "dem_server/engines/general/facets/facet_patch.hpp"

#include <algorithm>
#include <numeric>

#include "dem_server/engines/general/pairs/pairs.hpp"

namespace adit::dem {
namespace {

// Which facets end at a cell: those whose first it is are consecutive, the others are listed.
class FacetsOfCells {
 public:
  explicit FacetsOfCells(const FacetSet& set)
      : first_starts_(starts_of(set.first, set.cells())),
        second_starts_(starts_of(set.second, set.cells())),
        as_second_(set.size()) {
    std::vector<std::uint32_t> next(second_starts_.begin(), second_starts_.end() - 1);
    for (std::uint32_t k = 0; k < set.size(); ++k) as_second_[next[set.second[k]]++] = k;
  }

  // Facets that belong to the cells begin … end - 1.
  std::uint32_t first_of(std::uint32_t cell) const { return first_starts_[cell]; }

  void add(std::uint32_t cell, std::vector<std::uint32_t>& facets) const {
    for (std::uint32_t k = first_starts_[cell]; k < first_starts_[cell + 1]; ++k) facets.push_back(k);
    facets.insert(facets.end(), as_second_.begin() + second_starts_[cell],
                  as_second_.begin() + second_starts_[cell + 1]);
  }

 private:
  // Where each number begins in a list.
  static std::vector<std::uint32_t> starts_of(const std::vector<std::uint32_t>& numbers, std::size_t count) {
    std::vector<std::uint32_t> starts(count + 1, 0);
    for (const std::uint32_t i : numbers) ++starts[i + 1];
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    return starts;
  }

  std::vector<std::uint32_t> first_starts_, second_starts_, as_second_;
};

void sort_out(std::vector<std::uint32_t>& numbers) {
  std::ranges::sort(numbers);
  const auto [first, last] = std::ranges::unique(numbers);
  numbers.erase(first, last);
}

std::vector<double> values_at(const std::vector<std::uint32_t>& numbers, const std::vector<double>& values) {
  std::vector<double> found;
  found.reserve(numbers.size());
  for (const std::uint32_t k : numbers) found.push_back(values[k]);
  return found;
}

bool all_are(double value, const std::vector<double>& values) {
  return std::ranges::all_of(values, [value](double one) { return one == value; });
}

// What is plain is not read, and need not be held.
void take_columns(const FacetSet& set, FacetPatch& patch) {
  const auto take = [&](std::vector<double> FacetPatch::*to, const std::vector<double>& from) {
    patch.*to = values_at(patch.facets, from);
  };
  take(&FacetPatch::nx, set.nx);
  take(&FacetPatch::ny, set.ny);
  take(&FacetPatch::half_distance, set.half_distance);
  take(&FacetPatch::skew, set.skew);
  take(&FacetPatch::length, set.length);
  take(&FacetPatch::stiffness, set.stiffness);
  take(&FacetPatch::start_n, set.start_n);
  take(&FacetPatch::start_t, set.start_t);
  take(&FacetPatch::start_turn, set.start_turn);
  take(&FacetPatch::rest_n, set.rest_n);
  take(&FacetPatch::rest_t, set.rest_t);
  take(&FacetPatch::share_1, set.share_1);
  take(&FacetPatch::share_2, set.share_2);
  take(&FacetPatch::weight, set.weight);
  const auto zeros = {&patch.start_n, &patch.start_t, &patch.start_turn, &patch.rest_n, &patch.rest_t};
  const auto ones = {&patch.share_1, &patch.share_2, &patch.weight};
  patch.plain = std::ranges::all_of(zeros, [](const auto* column) { return all_are(0, *column); }) &&
                std::ranges::all_of(ones, [](const auto* column) { return all_are(1, *column); });
  if (!patch.plain) return;
  for (const auto& columns : {zeros, decltype(zeros)(ones)})
    for (std::vector<double>* column : columns) *column = {};
}

FacetPatch patch_of(std::uint32_t block, const FacetSet& set, const FacetsOfCells& of_cells) {
  FacetPatch patch;
  const std::uint32_t begin = block * kBlock,
                      end = static_cast<std::uint32_t>(std::min<std::size_t>(begin + kBlock, set.cells()));
  patch.begin = begin;
  patch.cells = end - begin;
  const auto is_own = [=](std::uint32_t cell) { return begin <= cell && cell < end; };

  std::vector<std::uint32_t> facets, near;
  for (std::uint32_t i = begin; i < end; ++i) of_cells.add(i, facets);
  for (const std::uint32_t k : facets)
    for (const std::uint32_t i : {set.first[k], set.second[k]})
      if (!is_own(i)) near.push_back(i);
  sort_out(near);
  for (const std::uint32_t i : near) of_cells.add(i, facets);
  sort_out(facets);
  for (const std::uint32_t k : facets)
    for (const std::uint32_t i : {set.first[k], set.second[k]})
      if (!is_own(i)) patch.reached.push_back(i);
  sort_out(patch.reached);

  const auto place_of = [&](std::uint32_t cell) {
    if (is_own(cell)) return cell - begin;
    const auto found = std::ranges::lower_bound(patch.reached, cell);
    return kBlock + static_cast<std::uint32_t>(found - patch.reached.begin());
  };
  if (!facets.empty()) patch.first_law = set.law[facets.front()];
  for (std::uint32_t place = 0; place < facets.size(); ++place) {
    const std::uint32_t i = set.first[facets[place]], j = set.second[facets[place]];
    patch.first.push_back(place_of(i));
    patch.second.push_back(place_of(j));
    if (!is_own(i) && is_own(j)) patch.incoming.push_back(place);
    patch.one_law = patch.one_law && set.law[facets[place]] == patch.first_law;
  }
  const auto place_in = [&](std::uint32_t facet) {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(facets, facet) - facets.begin());
  };
  patch.own_begin = place_in(of_cells.first_of(begin));
  patch.own_end = place_in(of_cells.first_of(end));
  patch.facets = std::move(facets);
  patch.bulk.assign(patch.places(), 0.0);
  std::copy_n(set.bulk.begin() + begin, patch.cells, patch.bulk.begin());
  std::ranges::copy(values_at(patch.reached, set.bulk), patch.bulk.begin() + kBlock);
  take_columns(set, patch);
  return patch;
}

}  // namespace

std::size_t FacetPatch::places() const {
  return kBlock + reached.size();
}

std::vector<FacetPatch> patches_of(const FacetSet& set) {
  std::vector<FacetPatch> patches;
  if (set.size() == 0) return patches;
  const FacetsOfCells of_cells(set);
  for (std::uint32_t block = 0; block < blocks_of(set.cells()); ++block)
    patches.push_back(patch_of(block, set, of_cells));
  return patches;
}

}  // namespace adit::dem
