#include "dem_server/observe/branches.hpp"

#include <cmath>

#include "dem_server/laws/pair_kinematics.hpp"

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

}  // namespace

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
  for (const Branch& joint : observed.branches_of_joints()) found.push_back(joint);
  for (const SpringForce& spring : observed.springs()) found.push_back(along(p, spring));
  for (const Branch& wall : observed.branches_of_walls()) found.push_back(wall);
  return found;
}

}  // namespace adit::dem
