#include "dem_server/engines/general/renumber.hpp"

#include <algorithm>
#include <cmath>
#include <compare>
#include <numeric>
#include <tuple>
#include <utility>

#include "dem_server/engines/general/pairs/pairs.hpp"
#include "dem_server/packing/discs.hpp"

namespace adit::dem {
namespace {

constexpr double kAcross = 32;  // discs of a strip from side to side
static_assert(kAcross * kAcross == kBlock);

// A disc's strip and row in it, its x from the model's left side.
struct Place {
  double strip, row, x;
  std::uint32_t disc;
  auto operator<=>(const Place&) const = default;
};

std::vector<std::uint32_t> order_by_strips(const Discs& discs) {
  const std::size_t size = discs.size();
  const geometry::BoundingBox box = extent_of(discs);
  const double row = 2 * std::reduce(discs.radius.begin(), discs.radius.end()) / static_cast<double>(size);
  const double strip = kAcross * row;
  std::vector<Place> places;
  places.reserve(size);
  for (std::uint32_t i = 0; i < size; ++i) {
    const double x = discs.x[i] - box.x_min, y = discs.y[i] - box.y_min;
    places.push_back({std::floor(x / strip), std::floor(y / row), x, i});
  }
  std::ranges::sort(places);
  const auto at_left_side = [=](const Place& place) { return place.x < place.strip * strip + row; };
  for (std::size_t begin = 0; begin < size; begin += kBlock) {
    const auto block = places.begin() + static_cast<std::ptrdiff_t>(begin);
    const std::size_t count = std::min<std::size_t>(kBlock, size - begin);
    std::stable_partition(block, block + static_cast<std::ptrdiff_t>(count), at_left_side);
  }
  std::vector<std::uint32_t> order;
  order.reserve(size);
  for (const Place& place : places) order.push_back(place.disc);
  return order;
}

template <class Value>
void take_in_order(const std::vector<std::uint32_t>& order, std::vector<Value>& values) {
  std::vector<Value> taken;
  taken.reserve(order.size());
  for (const std::uint32_t i : order) taken.push_back(values[i]);
  values = std::move(taken);
}

template <class Joined>
std::pair<std::uint32_t, std::uint32_t> by_discs(const Joined& pair) {
  return {pair.first, pair.second};
}

void renumber(const std::vector<std::uint32_t>& place, std::vector<FacetBond>& facets,
              std::vector<Bond>& bonds) {
  for (Bond& bond : bonds) {
    bond.first = place[bond.first];
    bond.second = place[bond.second];
    if (bond.first < bond.second) continue;
    std::swap(bond.first, bond.second);
    bond.nx = -bond.nx;
    bond.ny = -bond.ny;
    bond.at_rest.moment = -bond.at_rest.moment;
    if (bond.law == Bond::Law::kFacet) facets[bond.number] = facets[bond.number].turned();
  }
  std::ranges::sort(bonds, {}, by_discs<Bond>);
}

}  // namespace

void renumber(Model& model) {
  const auto order = order_by_strips(model.discs);
  for (auto* column : {&model.discs.x, &model.discs.y, &model.discs.radius, &model.mass, &model.weight})
    take_in_order(order, *column);
  for (auto* column : {&model.id, &model.group}) take_in_order(order, *column);
  if (!model.gyration_square.empty()) take_in_order(order, model.gyration_square);
  if (!model.cell_stiffness.empty()) take_in_order(order, model.cell_stiffness);
  if (!model.outlines.empty()) take_in_order(order, model.outlines);
  if (!model.present.empty()) take_in_order(order, model.present);
  for (ParticleStage& stage : model.stages) {
    for (auto* column : {&stage.held, &stage.mass}) take_in_order(order, *column);
    for (auto* column : {&stage.present, &stage.fresh}) take_in_order(order, *column);
    take_in_order(order, stage.group);
  }

  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) place[order[k]] = k;
  for (TouchingPair& pair : model.touching)
    std::tie(pair.first, pair.second) = std::minmax({place[pair.first], place[pair.second]});
  std::ranges::sort(model.touching, {}, by_discs<TouchingPair>);
  renumber(place, model.facets, model.bonds);
  for (ParticleStage& stage : model.stages) renumber(place, model.facets, stage.bonds);
  for (Spring& spring : model.springs) {
    spring.first = place[spring.first];
    spring.second = place[spring.second];
  }
  for (Bar& bar : model.bars)
    for (BarNode& node : bar.nodes) node.disc = place[node.disc];
  for (EdgeDashpot& edge : model.edges) edge.disc = place[edge.disc];
  const auto take_all = [&place](auto& conditions) {
    for (auto& condition : conditions) {
      for (std::uint32_t& disc : condition.discs) disc = place[disc];
      std::ranges::sort(condition.discs);
    }
  };
  take_all(model.loads);
  take_all(model.motions);
  take_all(model.foundations);
}

}  // namespace adit::dem
