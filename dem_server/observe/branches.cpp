#include "dem_server/observe/branches.hpp"

#include <cmath>

#include "dem_server/laws/pair_kinematics.hpp"
#include "dem_server/packing/meeting_place.hpp"

namespace adit::dem {
namespace {

// A force on the first of two particles.
Branch between(const Particles& p, std::uint32_t first, std::uint32_t second, double fx, double fy) {
  return {p.x[first] + p.ux[first],
          p.y[first] + p.uy[first],
          p.x[second] + p.ux[second],
          p.y[second] + p.uy[second],
          fx,
          fy};
}

Branch along(const Particles& p, const SpringForce& spring) {
  Branch b = between(p, spring.first, spring.second, 0, 0);
  const double length = std::hypot(b.x_2 - b.x_1, b.y_2 - b.y_1);
  b.fx = spring.force * (b.x_2 - b.x_1) / length;
  b.fy = spring.force * (b.y_2 - b.y_1) / length;
  return b;
}

// Discs where they are now.
struct PlacesNow {
  std::vector<double> x, y;
  const std::vector<double>& radius;
};
PlacesNow places_now(const Particles& p) {
  PlacesNow now{p.x, p.y, p.radius};
  for (std::size_t i = 0; i < p.size(); ++i) {
    now.x[i] += p.ux[i];
    now.y[i] += p.uy[i];
  }
  return now;
}

}  // namespace

std::vector<Pair> all_bonds(const Observable& observed) {
  std::vector<Pair> found;
  observed.for_each_bond([&](const ObservedPair& bond) { found.push_back({bond.first, bond.second}); });
  return found;
}

std::vector<Pair> whole_bonds(const Observable& observed) {
  std::vector<Pair> found;
  observed.for_each_bond([&](const ObservedPair& bond) {
    if (bond.state == BondState::kIntact) found.push_back({bond.first, bond.second});
  });
  return found;
}

std::vector<Pair> touching_particles(const Observable& observed) {
  std::vector<Pair> found;
  observed.for_each_bond([&](const ObservedPair& bond) {
    if (bond.state == BondState::kIntact || bond.touches) found.push_back({bond.first, bond.second});
  });
  observed.for_each_contact([&](const ObservedPair& contact) {
    found.push_back({contact.first, contact.second});
  });
  return found;
}

std::vector<Branch> branches_of(const Observable& observed) {
  const Particles& p = observed.particles();
  std::vector<Branch> found;
  const auto add = [&](const ObservedPair& s) {
    const PlaneVector force = vector_of(s.nx, s.ny, s.normal, s.shear);
    found.push_back(between(p, s.first, s.second, force.x, force.y));
  };
  observed.for_each_bond(add);
  observed.for_each_contact(add);
  for (const JointForce& j : observed.joints()) found.push_back(between(p, j.first, j.second, j.fx, j.fy));
  for (const SpringForce& spring : observed.springs()) found.push_back(along(p, spring));
  for (const Branch& wall : observed.branches_of_walls()) found.push_back(wall);
  return found;
}

std::vector<PairForce> pair_forces_of(const Observable& observed, std::span<const std::uint32_t> bonds) {
  const PlacesNow now = places_now(observed.particles());
  std::vector<PairForce> found;
  const auto add = [&](std::uint32_t first, std::uint32_t second, double fx, double fy, double moment) {
    const auto [x, y] = meeting_place(now, first, second);
    found.push_back({first, second, x, y, fx, fy, moment});
  };
  const auto add_pair = [&](const ObservedPair& s) {
    const PlaneVector force = vector_of(s.nx, s.ny, s.normal, s.shear);
    add(s.first, s.second, force.x, force.y, s.moment);
  };
  observed.see_bonds(bonds, add_pair);
  observed.for_each_contact(add_pair);
  for (const JointForce& joint : observed.joints()) add(joint.first, joint.second, joint.fx, joint.fy, 0);
  for (const SpringForce& spring : observed.springs()) {
    const Branch b = along(observed.particles(), spring);
    add(spring.first, spring.second, b.fx, b.fy, 0);
  }
  return found;
}

std::vector<SectionForces> section_forces(const Observable& observed, const Sections& sections) {
  return sections.forces(observed.particles(), pair_forces_of(observed, sections.cut_bonds()));
}

}  // namespace adit::dem
