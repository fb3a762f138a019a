#include "dem_server/particles/particles.hpp"

#include <algorithm>

#include "dem_server/model/model.hpp"

namespace adit::dem {

Particles at_rest(const Model& model) {
  Particles p;
  p.id = model.id;
  p.x = model.discs.x;
  p.y = model.discs.y;
  p.radius = model.discs.radius;
  p.weight = model.weight;
  for (auto* zeroed :
       {&p.ux, &p.uy, &p.settled_x, &p.settled_y, &p.vx, &p.vy, &p.spin, &p.fx, &p.fy, &p.moment})
    zeroed->assign(p.size(), 0.0);
  set_masses(model, p);
  return p;
}

void set_masses(const Model& model, Particles& p) {
  for (auto* column : {&p.mass, &p.inertia, &p.inverse_mass, &p.inverse_inertia})
    column->assign(p.size(), 0.0);
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!model.present.empty() && !model.present[i]) continue;
    p.mass[i] = p.weight[i] * model.mass[i];
    p.inertia[i] = model.inertia(i, p.mass[i]);
    p.inverse_mass[i] = 1 / p.mass[i];
    p.inverse_inertia[i] = 1 / p.inertia[i];
  }
}

void set_moved_masses(const Masses& masses, Particles& p) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!p.is_there(i)) continue;
    p.inverse_mass[i] = 1 / (p.weight[i] * masses.mass[i]);
    p.inverse_inertia[i] = 1 / (p.weight[i] * masses.inertia[i]);
  }
}

void stop(Particles& p) {
  for (auto* velocity : {&p.vx, &p.vy, &p.spin}) std::ranges::fill(*velocity, 0.0);
}

}  // namespace adit::dem
