#include "dem_server/observe/branches.hpp"

#include <cmath>
#include <numeric>

#include "dem_server/laws/pair_kinematics.hpp"
#include "dem_server/observe/fragments.hpp"
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

Branch branch_of(const Particles& p, const SpringForce& spring) {
  if (spring.direction)
    return between(p, spring.first, spring.second, spring.force * spring.direction->x,
                   spring.force * spring.direction->y);
  Branch b = between(p, spring.first, spring.second, 0, 0);
  const double length = std::hypot(b.x_2 - b.x_1, b.y_2 - b.y_1);
  b.fx = spring.force * (b.x_2 - b.x_1) / length;
  b.fy = spring.force * (b.y_2 - b.y_1) / length;
  return b;
}

PlaneVector force_of(const ObservedBar& bar) {
  return vector_of(bar.nx, bar.ny, bar.pull, bar.dowel);
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

std::vector<Pair> firm_bonds(const Observable& observed) {
  std::vector<HoldingPair> holding;
  observed.for_each_bond([&](const ObservedPair& bond) {
    if (bond.state == BondState::kIntact)
      holding.push_back({{bond.first, bond.second}, bond.resists_turning});
  });
  return without_rolling(observed.particles().size(), holding);
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
  for (const SpringForce& spring : observed.springs()) found.push_back(branch_of(p, spring));
  for (const ObservedBar& bar : observed.bars()) {
    const auto [fx, fy] = force_of(bar);
    found.push_back(between(p, bar.first, bar.second, fx, fy));
  }
  for (const auto& [i, x, y, fx, fy] : observed.wall_touches())
    found.push_back({p.x[i] + p.ux[i], p.y[i] + p.uy[i], x, y, fx, fy});
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
    if (s.place)
      found.push_back({s.first, s.second, s.place->x, s.place->y, force.x, force.y, s.moment});
    else
      add(s.first, s.second, force.x, force.y, s.moment);
  };
  observed.see_bonds(bonds, add_pair);
  observed.for_each_contact(add_pair);
  for (const JointForce& joint : observed.joints()) add(joint.first, joint.second, joint.fx, joint.fy, 0);
  for (const SpringForce& spring : observed.springs()) {
    const Branch b = branch_of(observed.particles(), spring);
    add(spring.first, spring.second, b.fx, b.fy, 0);
  }
  for (const ObservedBar& bar : observed.bars()) {
    const auto [fx, fy] = force_of(bar);
    found.push_back({bar.first, bar.second, bar.middle_x, bar.middle_y, fx, fy, 0});
  }
  return found;
}

std::vector<Tensor> particle_stress(const Observable& observed) {
  const PlacesNow now = places_now(observed.particles());
  std::vector<Tensor> moments(now.x.size());
  const auto add = [&](std::uint32_t i, double x, double y, double fx, double fy) {
    const double arm_x = x - now.x[i], arm_y = y - now.y[i];
    moments[i].xx += arm_x * fx;
    moments[i].yy += arm_y * fy;
    moments[i].xy += (arm_x * fy + arm_y * fx) / 2;
  };
  std::vector<std::uint32_t> bonds(all_bonds(observed).size());
  std::iota(bonds.begin(), bonds.end(), 0u);
  for (const PairForce& pair : pair_forces_of(observed, bonds)) {
    add(pair.first, pair.x, pair.y, pair.fx, pair.fy);
    add(pair.second, pair.x, pair.y, -pair.fx, -pair.fy);
  }
  for (const auto& [i, x, y, fx, fy] : observed.wall_touches()) add(i, x, y, fx, fy);
  const std::vector<double> areas = observed.cell_areas();
  for (std::size_t i = 0; i < moments.size(); ++i)
    if (areas[i] > 0)  // the particle was not taken away
      for (double* component : {&moments[i].xx, &moments[i].yy, &moments[i].xy}) *component /= areas[i];
  return moments;
}

std::vector<SectionForces> section_forces(const Observable& observed, const Sections& sections) {
  return sections.forces(observed.particles(), pair_forces_of(observed, sections.cut_bonds()));
}

}  // namespace adit::dem
