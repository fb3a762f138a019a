#include "dem_server/engines/relaxation.hpp"

#include "protocol/kernels/sums.hpp"
#include "protocol/participant/local_damping.hpp"
#include "protocol/threads/vector_clones.hpp"

namespace adit::dem {

ADIT_VECTOR_CLONES double kinetic_energy(const Particles& p) {
  const double *vx = p.vx.data(), *vy = p.vy.data(), *spin = p.spin.data();
  const double *inverse_mass = p.inverse_mass.data(), *inverse_inertia = p.inverse_inertia.data();
  const double twice = protocol::eight_sums(0, p.size(), [=](std::size_t i) {
    const double energy =
        (vx[i] * vx[i] + vy[i] * vy[i]) / inverse_mass[i] + spin[i] * spin[i] / inverse_inertia[i];
    return inverse_mass[i] > 0 ? energy : 0;  // nothing was taken away
  });
  return twice / 2;
}

namespace {

// The forces that changed one component of the velocities in a kick, on discs that are there [N].
ADIT_VECTOR_CLONES void find_forces(std::span<const double> after, std::span<const double> before,
                                    std::span<const double> inverse_mass, double kick, double local_damping,
                                    std::span<double> force) {
#pragma GCC ivdep
  for (std::size_t i = 0; i < force.size(); ++i) {
    const double change = protocol::undamped_change(after[i] - before[i], before[i], local_damping);
    force[i] = inverse_mass[i] > 0 ? change / (inverse_mass[i] * kick) : 0;
  }
}

}  // namespace

Unrest Relaxation::measure(const Particles& p, double kick, double local_damping,
                           std::span<const EdgeDashpot> edges) {
  for (auto* force : {&force_x_, &force_y_}) force->resize(p.size());
  find_forces(p.vx, before_.x, p.inverse_mass, kick, local_damping, force_x_);
  find_forces(p.vy, before_.y, p.inverse_mass, kick, local_damping, force_y_);
  const protocol::VectorSizes sizes = protocol::sizes_of(force_x_, force_y_);
  Unrest unrest;
  unrest.particles = p.size();
  unrest.unbalanced_force = sizes.sum;
  unrest.net_x = protocol::sum_of(force_x_);
  unrest.net_y = protocol::sum_of(force_y_);
  unrest.largest = sizes.largest;
  unrest.x = p.x[sizes.at];
  unrest.y = p.y[sizes.at];
  for (const EdgeDashpot& edge : edges) {  // which statics hold: their velocities are 0
    unrest.drag_x += edge.damping_x * p.weight[edge.disc];
    unrest.drag_y += edge.damping_y * p.weight[edge.disc];
  }
  remember(p, before_);
  return unrest;
}

}  // namespace adit::dem
