#include "dem_server/packing/random/pressed_discs.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace adit::dem {
namespace {

// All discs have mass 1. A disc of six neighbours has a frequency of at most sqrt(2 · 6 kn / m): the longest
// step keeps well below 2 / sqrt(12).
constexpr double kFirstStep = 0.1, kLongestStep = 0.4;
// The published settings of the relaxation.
constexpr double kGrowth = 1.1, kShrink = 0.5, kMixing = 0.1, kMixingShrink = 0.99;
constexpr int kPatience = 5;
// Contacts whose mean overlap is this share of the smallest radius carry nothing: the discs are loose.
constexpr double kLoose = 1e-10;

// Of the smallest radius: neighbours are listed anew when discs have moved by half of it.
constexpr double kSkin = 0.7;

constexpr std::uint32_t kBlock = 1024;  // discs that a thread computes at a time

// The values of a block's discs.
template <class Values>
auto of_block(std::uint32_t block, Values& values) {
  const std::size_t begin = std::size_t{block} * kBlock;
  return std::span(values).subspan(begin, std::min<std::size_t>(kBlock, values.size() - begin));
}

// The sum of what of(block) gives, computed by all threads and added in the order of the blocks.
template <class Sum, class OfBlock>
Sum sum_over_blocks(std::size_t discs, protocol::Team& team, OfBlock&& of) {
  std::vector<Sum> sums((discs + kBlock - 1) / kBlock);
  team.run(sums.size(),
           [&](std::size_t block, std::size_t) { sums[block] = of(static_cast<std::uint32_t>(block)); });
  Sum sum;
  for (const Sum& one : sums) sum.add(one);
  return sum;
}

// Square of a way; the sum of several is the longest one.
struct Farthest {
  double square = 0;
  void add(const Farthest& other) { square = std::max(square, other.square); }
};

}  // namespace

PressedDiscs::PressedDiscs(const Discs& discs, const geometry::BoundingBox& box, protocol::Team& team)
    : radius_(discs.radius),
      velocity_(discs.size()),
      force_(discs.size()),
      box_(box),
      skin_(kSkin * *std::ranges::min_element(discs.radius)),
      team_(&team) {
  for (std::size_t i = 0; i < discs.size(); ++i) place_.push_back({discs.x[i], discs.y[i]});
  list_neighbours();
}

Discs PressedDiscs::discs() const {
  Discs discs{{}, {}, radius_};
  for (const auto [x, y] : place_) {
    discs.x.push_back(x);
    discs.y.push_back(y);
  }
  return discs;
}

void PressedDiscs::scale_radii(double factor) {
  for (double& radius : radius_) radius *= factor;
  skin_ *= factor;
  list_neighbours();
}

void PressedDiscs::list_neighbours() {
  neighbours_ = pairs_within(discs(), skin_);
  const auto across = std::stable_partition(neighbours_.begin(), neighbours_.end(), [](const Pair& pair) {
    return pair.first / kBlock == pair.second / kBlock;
  });
  pair_starts_.assign(1, 0);
  wall_starts_.assign(1, 0);
  at_walls_.clear();
  auto pair = neighbours_.begin();
  for (std::uint32_t i = 0; i < size(); ++i) {
    if (overlaps_of(place_[i], radius_[i] + skin_, box_).count() > 0) at_walls_.push_back(i);
    if ((i + 1) % kBlock != 0 && i + 1 < size()) continue;
    pair = std::find_if(pair, across, [=](const Pair& p) { return p.first > i; });
    pair_starts_.push_back(static_cast<std::uint32_t>(pair - neighbours_.begin()));
    wall_starts_.push_back(static_cast<std::uint32_t>(at_walls_.size()));
  }
  touch_.clear();
  for (const auto [i, j] : neighbours_) touch_.push_back(radius_[i] + radius_[j]);
  listed_ = place_;
  farthest_ = 0;
}

// Two discs that approach each other close the skin when each has moved by half of it.
bool PressedDiscs::neighbours_are_stale() const {
  return farthest_ > skin_ * skin_ / 4;
}

// Returns the mean of the contact forces.
double PressedDiscs::find_forces() {
  const auto push = [this](std::uint32_t begin, std::size_t end) {
    return push_each_other(std::span(neighbours_).subspan(begin, end - begin), touch_.data() + begin,
                           place_.data(), force_.data());
  };
  Pushes pushes = sum_over_blocks<Pushes>(size(), *team_, [&](std::uint32_t b) {
    std::ranges::fill(of_block(b, force_), Vector{});
    Pushes sum;
    for (std::uint32_t at = wall_starts_[b]; at < wall_starts_[b + 1]; ++at) {
      const std::uint32_t i = at_walls_[at];
      const Overlaps by = overlaps_of(place_[i], radius_[i], box_);
      force_[i] = {by.left - by.right, by.below - by.above};
      sum.add({by.sum(), static_cast<double>(by.count())});
    }
    sum.add(push(pair_starts_[b], pair_starts_[b + 1]));
    return sum;
  });
  pushes.add(push(pair_starts_.back(), neighbours_.size()));
  return pushes.count > 0 ? pushes.sum / pushes.count : 0;
}

bool PressedDiscs::relax(double tolerance, std::uint32_t most_steps) {
  const double radius = *std::ranges::min_element(radius_);
  double dt = kFirstStep, mixing = kMixing;
  int downhill = 0;
  std::ranges::fill(velocity_, Vector{});
  for (std::uint32_t step = 0; step < most_steps; ++step) {
    if (neighbours_are_stale()) list_neighbours();
    const double contact = find_forces();
    const auto descent = sum_over_blocks<Descent>(size(), *team_, [&](std::uint32_t b) {
      return descent_of(of_block(b, force_), of_block(b, velocity_));
    });
    const double unbalanced = descent.unbalanced / static_cast<double>(size());
    if (unbalanced <= tolerance * contact || contact <= kLoose * radius) return true;

    // While the discs move downhill, velocities turn towards the forces; as soon as they move uphill, all
    // stop.
    double keep = 0, turn = 0;
    if (descent.power > 0) {
      keep = 1 - mixing;
      turn = mixing * std::sqrt(descent.speed / descent.force);
      if (++downhill > kPatience) {
        dt = std::min(dt * kGrowth, kLongestStep);
        mixing *= kMixingShrink;
      }
    } else {
      dt *= kShrink;
      mixing = kMixing;
      downhill = 0;
    }
    const auto moved = sum_over_blocks<Farthest>(size(), *team_, [&](std::uint32_t b) {
      return Farthest{move({keep, turn, dt}, of_block(b, force_), of_block(b, listed_),
                           of_block(b, velocity_), of_block(b, place_))};
    });
    farthest_ = moved.square;
  }
  return false;
}

std::array<double, 2> PressedDiscs::wall_stress() const {
  double across = 0, up = 0;
  for (std::size_t i = 0; i < size(); ++i) {
    const Overlaps by = overlaps_of(place_[i], radius_[i], box_);
    across += by.left + by.right;
    up += by.below + by.above;
  }
  return {across / (2 * (box_.y_max - box_.y_min)), up / (2 * (box_.x_max - box_.x_min))};
}

std::vector<Pair> PressedDiscs::contacts() const {
  return pairs_within(discs(), 0);
}

std::vector<std::uint32_t> PressedDiscs::wall_contacts() const {
  std::vector<std::uint32_t> count;
  for (std::size_t i = 0; i < size(); ++i) count.push_back(overlaps_of(place_[i], radius_[i], box_).count());
  return count;
}

}  // namespace adit::dem
