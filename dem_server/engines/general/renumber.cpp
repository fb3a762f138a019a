#include "dem_server/engines/general/renumber.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "dem_server/packing/extent.hpp"

namespace adit::dem {
namespace {

constexpr double kDiscsInCell = 4;

// The bits of a number, with a 0 between each two.
std::uint64_t spread(std::uint32_t value) {
  std::uint64_t bits = value;
  bits = (bits | bits << 16) & 0x0000ffff0000ffff;
  bits = (bits | bits << 8) & 0x00ff00ff00ff00ff;
  bits = (bits | bits << 4) & 0x0f0f0f0f0f0f0f0f;
  bits = (bits | bits << 2) & 0x3333333333333333;
  return (bits | bits << 1) & 0x5555555555555555;
}

std::vector<std::uint32_t> morton_order(const Discs& discs) {
  const geometry::BoundingBox box = extent_of(discs);
  const double area = (box.x_max - box.x_min) * (box.y_max - box.y_min);
  const double side = std::sqrt(kDiscsInCell * area / static_cast<double>(discs.size()));
  const auto cell = [side](double from, double value) {
    return static_cast<std::uint32_t>((value - from) / side);
  };
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
  for (std::uint32_t i = 0; i < discs.size(); ++i)
    keys.emplace_back(spread(cell(box.x_min, discs.x[i])) | spread(cell(box.y_min, discs.y[i])) << 1, i);
  std::ranges::sort(keys);
  std::vector<std::uint32_t> order;
  for (const auto& [key, disc] : keys) order.push_back(disc);
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

void renumber(const std::vector<std::uint32_t>& place, std::vector<Bond>& bonds) {
  for (Bond& bond : bonds) {
    bond.first = place[bond.first];
    bond.second = place[bond.second];
    if (bond.first < bond.second) continue;
    std::swap(bond.first, bond.second);
    bond.nx = -bond.nx;
    bond.ny = -bond.ny;
    bond.at_rest.moment = -bond.at_rest.moment;
  }
  std::ranges::sort(bonds, {}, by_discs<Bond>);
}

}  // namespace

void renumber(Model& model) {
  const auto order = morton_order(model.discs);
  for (auto* column : {&model.discs.x, &model.discs.y, &model.discs.radius, &model.mass, &model.weight})
    take_in_order(order, *column);
  for (auto* column : {&model.id, &model.group}) take_in_order(order, *column);
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
  renumber(place, model.bonds);
  for (ParticleStage& stage : model.stages) renumber(place, stage.bonds);
  for (Spring& spring : model.springs) {
    spring.first = place[spring.first];
    spring.second = place[spring.second];
  }
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
