// What observers see of the general engine (observe/observable.hpp).
#include <cmath>

#include "dem_server/engines/general/general_engine.hpp"

namespace adit::dem {
namespace {

PairForces forces_of(std::uint32_t pair, const Solver& solver, const Pairs& pairs) {
  const PairState s = state_of(pair, solver.laws(), solver.particles(), pairs);
  return {pairs.first[pair],
          pairs.second[pair],
          s.nx,
          s.ny,
          s.cement_normal + s.contact_normal,
          s.shear,
          s.moment,
          pairs.weight[pair],
          pairs.cemented() ? pairs.state[pair] : BondState::kIntact,
          s.touches};
}

}  // namespace

void GeneralEngine::for_each_bond(const SeePair& see) const {
  for (std::uint32_t k = 0; k < solver_.bonds().size(); ++k) see(forces_of(k, solver_, solver_.bonds()));
}

void GeneralEngine::for_each_contact(const SeePair& see) const {
  for (std::uint32_t k = 0; k < solver_.contacts().size(); ++k)
    if (const PairForces contact = forces_of(k, solver_, solver_.contacts()); contact.touches) see(contact);
}

std::vector<Branch> GeneralEngine::branches_of_joints() const {
  const Particles& p = particles();
  std::vector<Branch> branches;
  for (const Joints::Joint& j : solver_.joints().joints())
    branches.push_back({p.x[j.first] + p.ux[j.first], p.y[j.first] + p.uy[j.first],
                        p.x[j.second] + p.ux[j.second], p.y[j.second] + p.uy[j.second],
                        j.normal * j.nx - j.springs.shear * j.ny, j.normal * j.ny + j.springs.shear * j.nx});
  return branches;
}

std::vector<Branch> GeneralEngine::branches_of_walls() const {
  const Particles& p = particles();
  std::vector<Branch> branches;
  for (const WallContacts::Touch& touch : solver_.walls().touches()) {
    const Encounter e = solver_.walls().meet_wall(touch.wall, touch.disc, p);
    const double normal = touch.normal - touch.normal_dashpot, shear = touch.springs.shear_force;
    const double x = p.x[touch.disc] + p.ux[touch.disc], y = p.y[touch.disc] + p.uy[touch.disc];
    branches.push_back({x, y, x + e.length * e.nx, y + e.length * e.ny, normal * e.nx - shear * e.ny,
                        normal * e.ny + shear * e.nx});
  }
  return branches;
}

std::vector<SpringForce> GeneralEngine::springs() const {
  std::vector<SpringForce> springs;
  for (const Spring& spring : solver_.springs().springs())
    springs.push_back({spring.first, spring.second, solver_.springs().forces()[springs.size()]});
  return springs;
}

std::vector<WallForce> GeneralEngine::walls() const {
  std::vector<WallForce> walls;
  for (const MovingWall& wall : solver_.walls().walls()) {
    const auto [x, y] = solver_.walls().force(walls.size());
    walls.push_back({wall.name, x, y});
  }
  return walls;
}

}  // namespace adit::dem
