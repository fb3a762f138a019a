#include "dem_server/engines/general/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "dem_server/model/group_pairs.hpp"

namespace adit::dem {
namespace {

constexpr double kSkin = 0.25;  // of the mean radius

bool before(const Pair& a, const Pair& b) {
  return std::tie(a.first, a.second) < std::tie(b.first, b.second);
}

// What both lists hold keeps its springs and its slack. Both ascend. Returns which pairs of `to` these are.
std::vector<bool> keep_springs(const Pairs& from, Pairs& to) {
  std::vector<bool> kept(to.size(), false);
  for (std::uint32_t k = 0, old = 0; k < to.size(); ++k) {
    const Pair pair{to.first[k], to.second[k]};
    while (old < from.size() && before({from.first[old], from.second[old]}, pair)) ++old;
    if (old == from.size()) break;
    if (Pair{from.first[old], from.second[old]} != pair) continue;
    kept[k] = true;
    to.slack[k] = from.slack[old];
    to.slide[k] = from.slide[old];
    if (to.normal_dashpot.empty()) continue;
    to.normal_dashpot[k] = from.normal_dashpot[old];
    to.shear_dashpot[k] = from.shear_dashpot[old];
  }
  return kept;
}

}  // namespace

Neighbours::Neighbours(const Particles& particles, std::vector<double> radius, std::vector<Pair> joined,
                       std::vector<std::uint32_t> group, std::uint32_t groups, std::uint32_t first_law,
                       bool dashpots, bool overlaps_free, std::span<const TouchingPair> touching,
                       std::span<const PairLaw> laws)
    : radius_(std::move(radius)),
      joined_(std::move(joined)),
      group_(std::move(group)),
      groups_(groups),
      first_law_(first_law),
      dashpots_(dashpots),
      skin_(kSkin * std::accumulate(radius_.begin(), radius_.end(), 0.0) /
            static_cast<double>(radius_.size())) {
  list(particles);
  if (overlaps_free)
    for (std::size_t k = 0; k < pairs_.size(); ++k)
      pairs_.slack[k] = std::max(0.0, pairs_.rest_length[k] - std::hypot(pairs_.rest_x[k], pairs_.rest_y[k]));
  press(touching, laws);
  pairs_.sort_chunks({});
}

// Both lists ascend.
void Neighbours::press(std::span<const TouchingPair> touching, std::span<const PairLaw> laws) {
  std::size_t k = 0;
  for (const TouchingPair& touch : touching) {
    const Pair pair{touch.first, touch.second};
    while (k < pairs_.size() && before({pairs_.first[k], pairs_.second[k]}, pair)) ++k;
    if (!(touch.normal < 0)) continue;
    const double gap = std::hypot(pairs_.rest_x[k], pairs_.rest_y[k]) - pairs_.rest_length[k];
    pairs_.slack[k] = touch.normal / laws[pairs_.law[k]].contact.normal_stiffness - gap;
    pairs_.slide[k] = touch.shear;
  }
}

bool Neighbours::update(const Particles& particles) {
  if (moved_.most() > skin_ / 2) moved_.measure(particles);
  if (moved_.most() + std::max(moved_.most(), walls_travelled_) <= skin_) return false;
  list(particles);
  pairs_.sort_chunks({});
  return true;
}

std::vector<bool> Neighbours::list(const Particles& p) {
  Pairs fresh;
  auto joined = joined_.begin();
  for (const Pair& pair : pairs_within(moved_.start(p, radius_), skin_)) {
    while (joined != joined_.end() && before(*joined, pair)) ++joined;
    if (joined != joined_.end() && *joined == pair) continue;
    if (!p.is_there(pair.first) || !p.is_there(pair.second)) continue;
    fresh.first.push_back(pair.first);
    fresh.second.push_back(pair.second);
  }
  fresh.finish(p.size(), false, dashpots_);
  for (std::size_t k = 0; k < fresh.size(); ++k) {
    const std::uint32_t i = fresh.first[k], j = fresh.second[k];
    fresh.rest_x[k] = p.x[j] - p.x[i];
    fresh.rest_y[k] = p.y[j] - p.y[i];
    fresh.rest_length[k] = radius_[i] + radius_[j];
    fresh.half_difference[k] = (radius_[i] - radius_[j]) / 2;
    fresh.weight[k] = (p.weight[i] + p.weight[j]) / 2;
    fresh.law[k] = first_law_ + group_pair_number(groups_, group_[i], group_[j]);
  }
  auto kept = keep_springs(pairs_, fresh);
  pairs_ = std::move(fresh);
  walls_travelled_ = 0;
  ++lists_;
  return kept;
}

void Neighbours::begin_stage(const Particles& p, std::vector<Pair> joined, std::vector<std::uint32_t> group,
                             std::uint32_t first_law, const std::vector<bool>& fresh) {
  joined_ = std::move(joined);
  group_ = std::move(group);
  first_law_ = first_law;
  const auto kept = list(p);
  for (std::uint32_t k = 0; k < pairs_.size(); ++k) {
    const std::uint32_t i = pairs_.first[k], j = pairs_.second[k];
    if (kept[k] && !fresh[i] && !fresh[j]) continue;
    const double distance =
        std::hypot(pairs_.rest_x[k] + p.ux[j] - p.ux[i], pairs_.rest_y[k] + p.uy[j] - p.uy[i]);
    pairs_.slack[k] = std::max(0.0, pairs_.rest_length[k] - distance);
    pairs_.slide[k] = 0;
  }
  pairs_.sort_chunks({});
}

}  // namespace adit::dem
