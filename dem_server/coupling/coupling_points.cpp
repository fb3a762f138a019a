#include "dem_server/coupling/coupling_points.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "dem_server/coupling/triangulation.hpp"
#include "protocol/errors.hpp"

namespace adit::dem {
namespace {

struct Key {
  std::uint64_t x, y;
  bool operator==(const Key&) const = default;
};

struct Hash {
  std::size_t operator()(const Key& key) const { return key.x * 0x9e3779b97f4a7c15ull ^ key.y; }
};

Key key_of(double x, double y) {
  // The coupler sends the offered centres back unchanged, so equal bits mean the same centre and no tolerance
  // is needed.
  return {std::bit_cast<std::uint64_t>(x), std::bit_cast<std::uint64_t>(y)};
}

protocol::OperatorRow between_particles(const Triangulation& triangulation, double x, double y) {
  const auto place = triangulation.locate(x, y);
  if (!place)
    throw protocol::UserError(
        "interface.overlap",
        fmt::format("holds the coupling point ({}, {}) m, which lies more than a particle's diameter outside "
                    "the bonded particles; let the packing cover the overlap",
                    x, y));
  const auto& [particles, shares] = *place;
  return {{particles[0], particles[1], particles[2], 0}, {shares[0], shares[1], shares[2], 0}};
}

}  // namespace

std::vector<double> CouplingPoints::offer(const Particles& p, const geometry::BoundingBox& box) {
  offered_.clear();
  std::vector<double> centres;
  for (std::uint32_t i = 0; i < p.size(); ++i) {
    if (p.x[i] < box.x_min || p.x[i] > box.x_max || p.y[i] < box.y_min || p.y[i] > box.y_max) continue;
    offered_.push_back(i);
    centres.push_back(p.x[i]);
    centres.push_back(p.y[i]);
  }
  return centres;
}

void CouplingPoints::tie(std::span<const double> places, const Particles& p, const BondEnds& bonds,
                         const PrescribedMotions& motions) {
  if (places.size() % 2 != 0)
    throw protocol::RequestError("couple: the coupling points are not pairs of x and y");
  std::unordered_map<Key, std::uint32_t, Hash> centres;
  for (const std::uint32_t i : offered_) centres.emplace(key_of(p.x[i], p.y[i]), i);
  std::optional<Triangulation> triangulation;  // made where a place needs it
  std::vector<protocol::OperatorRow> rows;
  rows.reserve(places.size() / 2);
  for (std::size_t k = 0; k < places.size(); k += 2) {
    const double x = places[k], y = places[k + 1];
    if (const auto found = centres.find(key_of(x, y)); found != centres.end()) {
      rows.push_back({{found->second}, {1.0}});
      continue;
    }
    if (!std::isfinite(x) || !std::isfinite(y))
      throw protocol::RequestError("couple: a coupling point is not finite");
    if (!triangulation) triangulation.emplace(p, bonds);
    rows.push_back(between_particles(*triangulation, x, y));
  }
  operator_ = protocol::InterfaceOperator(rows);
  inverse_masses_.clear();
  for (const std::uint32_t i : operator_.points()) {
    inverse_masses_.push_back(motions.prescribes(Component::kX, i) ? 0.0 : p.inverse_mass[i]);
    inverse_masses_.push_back(motions.prescribes(Component::kY, i) ? 0.0 : p.inverse_mass[i]);
  }
}

void CouplingPoints::take_masses(const Particles& p) {
  for (std::size_t k = 0; k < inverse_masses_.size(); ++k)
    if (inverse_masses_[k] > 0) inverse_masses_[k] = p.inverse_mass[operator_.points()[k / 2]];
}

void CouplingPoints::push(std::span<const double> impulses, double kick, Particles& p,
                          PrescribedMotions& motions) {
  const auto own = operator_.gather(impulses);
  for (std::size_t j = 0; j < operator_.points().size(); ++j) {
    const std::uint32_t i = operator_.points()[j];
    p.vx[i] += own[2 * j] * inverse_masses_[2 * j];
    p.vy[i] += own[2 * j + 1] * inverse_masses_[2 * j + 1];
    if (!p.tie_x.empty()) {
      p.tie_x[i] = own[2 * j] / kick;
      p.tie_y[i] = own[2 * j + 1] / kick;
    }
    if (inverse_masses_[2 * j] == 0) motions.hold(Component::kX, i, own[2 * j]);
    if (inverse_masses_[2 * j + 1] == 0) motions.hold(Component::kY, i, own[2 * j + 1]);
  }
}

void CouplingPoints::read_velocities(const Particles& p, std::span<double> velocities) const {
  operator_.velocities(p.vx, p.vy, velocities);
}

}  // namespace adit::dem
