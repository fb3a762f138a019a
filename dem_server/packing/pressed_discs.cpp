#include "dem_server/packing/pressed_discs.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#include "protocol/kernels/eight_sums.hpp"
#include "protocol/threads/vector_clones.hpp"

namespace adit::dem {
namespace {

using Vector = PressedDiscs::Vector;

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
constexpr std::size_t kAtATime = 256;  // discs or pairs that are looked at several times while in the cache

// Of those that push: sum of the pushes, number.
struct Contacts {
  double push = 0, count = 0;
  void add(const Contacts& others) {
    push += others.push;
    count += others.count;
  }
};

// How far a disc sticks out of each wall.
struct Overlaps {
  double left, right, below, above;
  double sum() const { return left + right + below + above; }
  std::uint32_t count() const { return (left > 0) + (right > 0) + (below > 0) + (above > 0); }
};
Overlaps overlaps_of(const Vector& place, double radius, const geometry::BoundingBox& box) {
  return {std::max(0.0, radius - (place.x - box.x_min)), std::max(0.0, radius - (box.x_max - place.x)),
          std::max(0.0, radius - (place.y - box.y_min)), std::max(0.0, radius - (box.y_max - place.y))};
}

// Adds the forces of some pairs, which touch at the distances `touch`.
ADIT_VECTOR_CLONES Contacts push_each_other(std::span<const Pair> pairs, const double* touch,
                                            const Vector* place, Vector* force) {
  // Columns, for vector code: from the first centres to the second, which become the forces on the second.
  alignas(64) std::array<double, kAtATime> x, y, pushes;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto [i, j] = pairs[k];
    x[k] = place[j].x - place[i].x;
    y[k] = place[j].y - place[i].y;
  }
#pragma GCC ivdep
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const double distance = std::sqrt(x[k] * x[k] + y[k] * y[k]);
    const double push = std::max(0.0, touch[k] - distance), share = push / distance;
    // discs at one point part along x
    x[k] = distance > 0 ? share * x[k] : push;
    y[k] = distance > 0 ? share * y[k] : 0;
    pushes[k] = push;
  }
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto [i, j] = pairs[k];
    force[i] = {force[i].x - x[k], force[i].y - y[k]};
    force[j] = {force[j].x + x[k], force[j].y + y[k]};
  }
  return {protocol::eight_sums(0, pairs.size(), [&](std::size_t k) { return pushes[k]; }),
          protocol::eight_sums(0, pairs.size(), [&](std::size_t k) { return pushes[k] > 0 ? 1.0 : 0.0; })};
}

double dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y;
}

// Power of the forces, squares of all velocities and of all forces, sum of their sizes.
struct Descent {
  double power = 0, speed = 0, force = 0, unbalanced = 0;
};
ADIT_VECTOR_CLONES Descent descent_of(std::span<const Vector> force, std::span<const Vector> velocity) {
  Descent sum;
  for (std::size_t begin = 0; begin < force.size(); begin += kAtATime) {
    const std::size_t end = std::min(begin + kAtATime, force.size());
    sum.power += protocol::eight_sums(begin, end, [&](std::size_t i) { return dot(force[i], velocity[i]); });
    sum.speed +=
        protocol::eight_sums(begin, end, [&](std::size_t i) { return dot(velocity[i], velocity[i]); });
    sum.force += protocol::eight_sums(begin, end, [&](std::size_t i) { return dot(force[i], force[i]); });
    sum.unbalanced +=
        protocol::eight_sums(begin, end, [&](std::size_t i) { return std::sqrt(dot(force[i], force[i])); });
  }
  return sum;
}

// The new velocity moves the discs (semi-implicit Euler), which stays stable where the explicit rule gains
// energy. Returns the square of the longest way from where they were listed.
ADIT_VECTOR_CLONES double move(double keep, double turn, double dt, std::span<const Vector> force,
                               const Vector* listed, Vector* velocity, Vector* place) {
  std::int64_t farthest = 0;  // the order of non-negative doubles is that of their bits
#pragma GCC ivdep
  for (std::size_t i = 0; i < force.size(); ++i) {
    velocity[i] = {keep * velocity[i].x + (turn + dt) * force[i].x,
                   keep * velocity[i].y + (turn + dt) * force[i].y};
    place[i] = {place[i].x + dt * velocity[i].x, place[i].y + dt * velocity[i].y};
    const Vector way{place[i].x - listed[i].x, place[i].y - listed[i].y};
    farthest = std::max(farthest, std::bit_cast<std::int64_t>(way.x * way.x + way.y * way.y));
  }
  return std::bit_cast<double>(farthest);
}

}  // namespace

PressedDiscs::PressedDiscs(const Discs& discs, const geometry::BoundingBox& box)
    : radius_(discs.radius),
      velocity_(discs.size()),
      force_(discs.size()),
      box_(box),
      skin_(kSkin * *std::ranges::min_element(discs.radius)) {
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
  touch_.clear();
  for (const auto [i, j] : neighbours_) touch_.push_back(radius_[i] + radius_[j]);
  at_walls_.clear();
  for (std::uint32_t i = 0; i < size(); ++i)
    if (overlaps_of(place_[i], radius_[i] + skin_, box_).count() > 0) at_walls_.push_back(i);
  listed_ = place_;
  farthest_ = 0;
}

// Two discs that approach each other close the skin when each has moved by half of it.
bool PressedDiscs::neighbours_are_stale() const {
  return farthest_ > skin_ * skin_ / 4;
}

// Returns the mean of the contact forces.
double PressedDiscs::find_forces() {
  std::ranges::fill(force_, Vector{});
  Contacts contacts;
  for (const std::uint32_t i : at_walls_) {
    const Overlaps by = overlaps_of(place_[i], radius_[i], box_);
    force_[i] = {by.left - by.right, by.below - by.above};
    contacts.add({by.sum(), static_cast<double>(by.count())});
  }
  for (std::size_t at = 0; at < neighbours_.size(); at += kAtATime)
    contacts.add(
        push_each_other(std::span(neighbours_).subspan(at, std::min(kAtATime, neighbours_.size() - at)),
                        &touch_[at], place_.data(), force_.data()));
  return contacts.count > 0 ? contacts.push / contacts.count : 0;
}

bool PressedDiscs::relax(double tolerance, std::uint32_t most_steps) {
  const double radius = *std::ranges::min_element(radius_);
  double dt = kFirstStep, mixing = kMixing;
  int downhill = 0;
  std::ranges::fill(velocity_, Vector{});
  for (std::uint32_t step = 0; step < most_steps; ++step) {
    if (neighbours_are_stale()) list_neighbours();
    const double contact = find_forces();
    const Descent descent = descent_of(force_, velocity_);
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
    farthest_ = move(keep, turn, dt, force_, listed_.data(), velocity_.data(), place_.data());
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
