#include "dem_server/engines/general/observe/branches.hpp"

#include <cmath>

#include "dem_server/engines/general/pair_state.hpp"

namespace adit::dem {
namespace {

bool whole(const Pairs& pairs, std::uint32_t k) {
  return pairs.cemented() && pairs.state[k] == BondState::kIntact;
}

// N n + S t on the first of two discs.
Branch between(const Particles& p, std::uint32_t first, std::uint32_t second, double nx, double ny,
               double normal, double shear) {
  return {p.x[first] + p.ux[first],   p.y[first] + p.uy[first], p.x[second] + p.ux[second],
          p.y[second] + p.uy[second], normal * nx - shear * ny, normal * ny + shear * nx};
}

}  // namespace

std::vector<Pair> whole_bonds(const Solver& solver) {
  const Pairs& bonds = solver.bonds();
  std::vector<Pair> found;
  for (std::uint32_t k = 0; k < bonds.size(); ++k)
    if (whole(bonds, k)) found.push_back({bonds.first[k], bonds.second[k]});
  return found;
}

std::vector<Pair> touching_discs(const Solver& solver) {
  std::vector<Pair> found;
  for (const Pairs* pairs : {&solver.bonds(), &solver.contacts()})
    for (std::uint32_t k = 0; k < pairs->size(); ++k)
      if (whole(*pairs, k) || state_of(k, solver.laws(), solver.particles(), *pairs).touches)
        found.push_back({pairs->first[k], pairs->second[k]});
  return found;
}

std::vector<Branch> branches_of(const Solver& solver) {
  const Particles& p = solver.particles();
  std::vector<Branch> found;
  for (const Pairs* pairs : {&solver.bonds(), &solver.contacts()})
    for (std::uint32_t k = 0; k < pairs->size(); ++k) {
      const PairState s = state_of(k, solver.laws(), p, *pairs);
      found.push_back(between(p, pairs->first[k], pairs->second[k], s.nx, s.ny,
                              s.cement_normal + s.contact_normal, s.shear));
    }
  for (const Joints::Joint& j : solver.joints().joints())
    found.push_back(between(p, j.first, j.second, j.nx, j.ny, j.normal, j.springs.shear));
  const auto springs = solver.springs().springs();
  for (std::size_t k = 0; k < springs.size(); ++k) {
    Branch b = between(p, springs[k].first, springs[k].second, 0, 0, 0, 0);
    const double length = std::hypot(b.x_2 - b.x_1, b.y_2 - b.y_1), force = solver.springs().forces()[k];
    b.fx = force * (b.x_2 - b.x_1) / length;
    b.fy = force * (b.y_2 - b.y_1) / length;
    found.push_back(b);
  }
  for (const WallContacts::Touch& touch : solver.walls().touches()) {
    const Encounter e = solver.walls().meet_wall(touch.wall, touch.disc, p);
    const double normal = touch.normal - touch.normal_dashpot, shear = touch.springs.shear_force;
    const double x = p.x[touch.disc] + p.ux[touch.disc], y = p.y[touch.disc] + p.uy[touch.disc];
    found.push_back({x, y, x + e.length * e.nx, y + e.length * e.ny, normal * e.nx - shear * e.ny,
                     normal * e.ny + shear * e.nx});
  }
  return found;
}

}  // namespace adit::dem
