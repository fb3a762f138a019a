#include "dem_server/packing/random/pushes.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "protocol/kernels/sums.hpp"
#include "protocol/threads/vector_clones.hpp"

namespace adit::dem {
namespace {

constexpr std::size_t kAtATime = 256;  // discs or pairs that are read several times while in the cache

[[gnu::always_inline]] inline double dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y;
}

// At most kAtATime pairs. What lies anywhere is read and written one by one, between is vector code.
ADIT_VECTOR_CLONES Pushes push_some(std::span<const Pair> pairs, const double* touch, const Vector* place,
                                    Vector* force) {
  // From the first centres to the second, then the forces on the second.
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

}  // namespace

Overlaps overlaps_of(const Vector& place, double radius, const geometry::BoundingBox& box) {
  return {std::max(0.0, radius - (place.x - box.x_min)), std::max(0.0, radius - (box.x_max - place.x)),
          std::max(0.0, radius - (place.y - box.y_min)), std::max(0.0, radius - (box.y_max - place.y))};
}

Pushes push_each_other(std::span<const Pair> pairs, const double* touch, const Vector* place, Vector* force) {
  Pushes sum;
  for (std::size_t at = 0; at < pairs.size(); at += kAtATime)
    sum.add(push_some(pairs.subspan(at, std::min(kAtATime, pairs.size() - at)), touch + at, place, force));
  return sum;
}

ADIT_VECTOR_CLONES Descent descent_of(std::span<const Vector> force, std::span<const Vector> velocity) {
  const Vector *f = force.data(), *v = velocity.data();
  Descent sum;
  for (std::size_t begin = 0; begin < force.size(); begin += kAtATime) {
    const std::size_t end = std::min(begin + kAtATime, force.size());
    sum.power += protocol::eight_sums(begin, end, [=](std::size_t i) { return dot(f[i], v[i]); });
    sum.speed += protocol::eight_sums(begin, end, [=](std::size_t i) { return dot(v[i], v[i]); });
    sum.force += protocol::eight_sums(begin, end, [=](std::size_t i) { return dot(f[i], f[i]); });
    sum.unbalanced +=
        protocol::eight_sums(begin, end, [=](std::size_t i) { return std::sqrt(dot(f[i], f[i])); });
  }
  return sum;
}

ADIT_VECTOR_CLONES double move(const Motion& motion, std::span<const Vector> force,
                               std::span<const Vector> listed, std::span<Vector> velocity,
                               std::span<Vector> place) {
  const auto [keep, turn, dt] = motion;
  const Vector *f = force.data(), *from = listed.data();
  Vector *v = velocity.data(), *to = place.data();
  std::int64_t farthest = 0;  // the order of non-negative doubles is that of their bits
#pragma GCC ivdep
  for (std::size_t i = 0; i < force.size(); ++i) {
    v[i] = {keep * v[i].x + (turn + dt) * f[i].x, keep * v[i].y + (turn + dt) * f[i].y};
    to[i] = {to[i].x + dt * v[i].x, to[i].y + dt * v[i].y};
    const double x = to[i].x - from[i].x, y = to[i].y - from[i].y;
    farthest = std::max(farthest, std::bit_cast<std::int64_t>(x * x + y * y));
  }
  return std::bit_cast<double>(farthest);
}

}  // namespace adit::dem
