#include <algorithm>
#include <set>

#include "fdm_server/solver/continuum.hpp"

namespace adit::fdm {

// The shares of the zones' forces that stay, as a steady load. Zones at rest answer with the forces that they
// have.
Load Continuum::held_forces(std::span<const Excavated> zones) {
  Load held{{}, std::vector<double>(points_.size(), 0.0), std::vector<double>(points_.size(), 0.0), {}};
  for (std::uint32_t i = 0; i < points_.size(); ++i) held.points.push_back(i);
  const std::vector<double> rest(points_.size(), 0.0);
  std::set<double> shares;
  for (const Excavated& one : zones) shares.insert(one.held);
  for (const double share : shares) {
    std::vector<bool> sharing(zones_.count(), false);
    for (const Excavated& one : zones) sharing[one.zone] = one.held == share;
    std::vector<double> fx(points_.size(), 0.0), fy = fx;
    zones_.add_forces_of(sharing, 1, {rest.data(), rest.data(), fx.data(), fy.data()});
    for (std::size_t i = 0; i < points_.size(); ++i) {
      held.fx[i] += share * fx[i];
      held.fy[i] += share * fy[i];
    }
  }
  std::vector<double> share_of(zones_.count(), 0.0);
  for (const Excavated& one : zones) share_of[one.zone] = one.held;
  contacts_.add_held([&](std::uint32_t zone) { return share_of[zone]; }, held.fx, held.fy);
  return held;
}

// A component without inverse mass stays held, unless the point had no mass and no motion holds it. What a
// point was moved before it lost its mass is no motion of what it belongs to now.
void Continuum::take_masses(std::span<const double> masses) {
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const bool had_mass = points_[kMass][i] > 0;
    points_[kMass][i] = masses[i];
    for (const Field inverse : {kInverseMassX, kInverseMassY})
      if (points_[inverse][i] != 0 || !had_mass) points_[inverse][i] = masses[i] > 0 ? 1 / masses[i] : 0;
    if (masses[i] == 0) points_[kVx][i] = points_[kVy][i] = 0;
    if (!had_mass) points_[kUx][i] = points_[kUy][i] = 0;
  }
  for (const Part* part : {&interface_, &interior_})
    for (const Prescribed& one : part->motions)
      for (const auto point : one.motion.points)
        points_[one.motion.axis == Axis::kX ? kInverseMassX : kInverseMassY][point] = 0;
}

void Continuum::set_masses(std::span<const double> masses, double structures_step) {
  take_masses(masses);
  structures_.scale_masses(structures_step);
  average_.reset();
}

void Continuum::excavate(std::span<const Excavated> zones, std::span<const double> masses,
                         std::vector<Load> loads, std::uint32_t stage) {
  const Load held = held_forces(zones);
  std::vector<bool> gone(zones_.count(), false);
  for (const Excavated& one : zones) gone[one.zone] = true;
  zones_.remove(gone);
  set_masses(masses, 0);
  for (Part* part : {&interface_, &interior_}) {
    part->loads.clear();
    leave_out(gone, part->dashpots);
    for (auto& one : part->motions) one.mass = prescribed(one.motion).mass;
  }
  for (const Field steady : {kSteadyX, kSteadyY}) std::ranges::fill(points_[steady], 0.0);
  structures_.install(stage);
  contacts_.install(stage, gone);
  stage_ = stage;
  step_of_stage_ = 0;
  if (std::ranges::any_of(zones, [](const Excavated& one) { return one.held > 0; })) add_steady(held);
  place(std::move(loads));
  plan(of_interface());
}

void Continuum::renew(ZoneKind kind, const Grid& grid, const Ground& ground,
                      std::span<const std::uint32_t> zones) {
  zones_.renew(kind, grid, ground, zones, points_[kUx].data(), points_[kUy].data());
  plan(of_interface());
}

}  // namespace adit::fdm
