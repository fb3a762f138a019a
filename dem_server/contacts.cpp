#include "dem_server/contacts.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace adit::dem {
namespace {

constexpr double kSkin = 0.5;  // of a radius

// The plane in square cells, wrapped round a torus of about as many cells as there are particles: it needs no
// limits, and neighbours in the plane stay neighbours in memory. A cell of the torus holds what lies in
// several of the plane, which are told apart by their true numbers.
class Torus {
 public:
  struct Cell {
    std::int32_t x, y;
    bool operator==(const Cell&) const = default;
  };

  Torus(double side, const Particles& p) : side_(side), cells_(p.size()) {
    const auto bits = static_cast<std::uint32_t>(std::bit_width(p.size()));
    width_ = std::uint32_t{1} << (bits + 1) / 2;
    height_ = std::uint32_t{1} << bits / 2;
    starts_.assign(std::size_t{width_} * height_ + 1, 0);
    for (std::size_t i = 0; i < p.size(); ++i)
      cells_[i] = {number(p.x[i] + p.ux[i]), number(p.y[i] + p.uy[i])};
    for (const Cell& cell : cells_) ++starts_[place(cell) + 1];
    for (std::size_t k = 1; k < starts_.size(); ++k) starts_[k] += starts_[k - 1];
    auto next = starts_;
    held_.resize(p.size());
    for (std::uint32_t i = 0; i < p.size(); ++i) held_[next[place(cells_[i])]++] = i;
  }

  // visit(other) for what lies in the particle's cell and the eight around.
  template <class Visit>
  void visit_around(std::uint32_t particle, Visit&& visit) const {
    const Cell own = cells_[particle];
    for (std::int32_t y = own.y - 1; y <= own.y + 1; ++y)
      for (std::int32_t x = own.x - 1; x <= own.x + 1; ++x) {
        const std::size_t k = place({x, y});
        for (std::uint32_t at = starts_[k]; at < starts_[k + 1]; ++at)
          if (cells_[held_[at]] == Cell{x, y}) visit(held_[at]);
      }
  }

 private:
  std::int32_t number(double value) const {
    constexpr double kFar = 1 << 30;
    const double cell = std::floor(value / side_);
    return static_cast<std::int32_t>(cell > -kFar ? std::min(cell, kFar) : -kFar);
  }
  std::size_t place(const Cell& cell) const {
    const auto x = static_cast<std::uint32_t>(cell.x) & (width_ - 1);
    const auto y = static_cast<std::uint32_t>(cell.y) & (height_ - 1);
    return std::size_t{y} * width_ + x;
  }

  double side_;
  std::uint32_t width_, height_;  // powers of two
  std::vector<Cell> cells_;       // of each particle, in the plane
  std::vector<std::uint32_t> starts_, held_;
};

struct Gap {
  double x, y, squared;  // from the first to the second centre
};

Gap gap_of(const Pair& pair, const Particles& p) {
  const double x = (p.x[pair.second] - p.x[pair.first]) + (p.ux[pair.second] - p.ux[pair.first]);
  const double y = (p.y[pair.second] - p.y[pair.first]) + (p.uy[pair.second] - p.uy[pair.first]);
  return {x, y, x * x + y * y};
}

double weight_of(const Pair& pair, const Particles& p) {
  return 0.5 * (p.weight[pair.first] + p.weight[pair.second]);
}

}  // namespace

std::vector<Pair> pairs_within(double reach, const Particles& particles) {
  const Torus torus(reach, particles);
  std::vector<Pair> pairs;
  for (std::uint32_t i = 0; i < particles.size(); ++i) {
    const std::size_t begin = pairs.size();
    torus.visit_around(i, [&](std::uint32_t j) {
      if (i < j && gap_of({i, j}, particles).squared < reach * reach) pairs.push_back({i, j});
    });
    std::sort(pairs.begin() + static_cast<std::ptrdiff_t>(begin), pairs.end(),
              [](const Pair& a, const Pair& b) { return a.second < b.second; });
  }
  return pairs;
}

Contacts::Contacts(const Assembly& assembly)
    : partners_(assembly.bonds, assembly.particles.size()), skin_(kSkin * assembly.bonds.rest_length / 2) {
  list(assembly);
}

bool Contacts::update(double dt, const Assembly& assembly) {
  // The next step will hardly be twice as fast as the last one.
  const double allowed = skin_ / 2 - 2 * dt * speed_;
  if (travelled_ <= allowed) return false;
  travelled_ = farthest(assembly.particles);
  if (travelled_ <= allowed) return false;
  list(assembly);
  return true;
}

void Contacts::list(const Assembly& assembly) {
  pairs_ = pairs_within(assembly.bonds.rest_length + skin_, assembly.particles);
  std::erase_if(pairs_, [&](const Pair& pair) { return partners_.joined(pair.first, pair.second); });
  listed_ux_ = assembly.particles.ux;
  listed_uy_ = assembly.particles.uy;
  travelled_ = 0;
  ++lists_;
}

double Contacts::farthest(const Particles& p) const {
  double squared = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double x = p.ux[i] - listed_ux_[i], y = p.uy[i] - listed_uy_[i];
    squared = std::max(squared, x * x + y * y);
  }
  return std::sqrt(squared);
}

void add_contacts(double normal_stiffness, double diameter, std::span<const Pair> pairs,
                  const Particles& particles, const Resultants& resultants) {
  for (const Pair& pair : pairs) {
    const Gap gap = gap_of(pair, particles);
    if (!(gap.squared < diameter * diameter)) continue;
    const double length = std::sqrt(gap.squared);
    const double pull = weight_of(pair, particles) * normal_stiffness * (length - diameter) / length;
    resultants.fx[pair.first] += pull * gap.x;
    resultants.fy[pair.first] += pull * gap.y;
    resultants.fx[pair.second] -= pull * gap.x;
    resultants.fy[pair.second] -= pull * gap.y;
  }
}

double contact_energy(double normal_stiffness, double diameter, std::span<const Pair> pairs,
                      const Particles& particles) {
  double twice = 0;
  for (const Pair& pair : pairs) {
    const Gap gap = gap_of(pair, particles);
    if (!(gap.squared < diameter * diameter)) continue;
    const double overlap = diameter - std::sqrt(gap.squared);
    twice += weight_of(pair, particles) * normal_stiffness * overlap * overlap;
  }
  return twice / 2;
}

}  // namespace adit::dem
