#include "dem_server/engines/general/forces/damping.hpp"

#include <cmath>

#include "dem_server/particles/integrate.hpp"
#include "protocol/participant/local_damping.hpp"

namespace adit::dem {

Damping::Damping(double local_share, double viscous_rate, std::span<const EdgeDashpot> edges,
                 const Particles& p, std::span<const std::uint32_t> tied)
    : local_share_(local_share), viscous_(viscous_rate > 0), drags_(viscous_ || !edges.empty()) {
  for (Component* c : {&x_, &y_, &spin_}) {
    c->edge.assign(drags_ ? p.size() : 0, 0.0);
    c->viscous = c->edge;
    c->drag_force = c->edge;
    c->local.assign(local_share_ > 0 ? p.size() : 0, local_share_);
    c->local_force.assign(c->local.size(), 0.0);
  }
  for (Component* c : {&x_, &y_})
    for (const std::uint32_t i : tied)
      if (!c->local.empty()) c->local[i] = 0;
  if (!drags_) return;
  for (std::size_t i = 0; i < p.size(); ++i) {
    x_.viscous[i] = y_.viscous[i] = viscous_rate * p.mass[i];
    spin_.viscous[i] = viscous_rate * p.inertia[i];
  }
  for (const EdgeDashpot& edge : edges) {
    x_.edge[edge.disc] += edge.damping_x * p.weight[edge.disc];
    y_.edge[edge.disc] += edge.damping_y * p.weight[edge.disc];
  }
}

Damping::Loss Damping::kick(const protocol::Step& step, std::uint32_t begin, std::uint32_t end,
                            const double* inverse_inertia, const double* tie, double* force, double* velocity,
                            Component& c) const {
  Loss loss;
  const double h = step.kick(), half = step.from_rest() ? 0 : step.dt / 2;
  for (std::uint32_t i = begin; i < end; ++i) {
    const double before = velocity[i];
    if (step.local_damping > 0) {
      force[i] = protocol::damped(force[i], tie ? tie[i] : 0, before, step.local_damping);
    } else if (local_share_ > 0) {
      const double damping = -c.local[i] * std::abs(force[i]) * protocol::sign(before);
      loss.local -= half * before * (c.local_force[i] + damping);
      c.local_force[i] = damping;
      force[i] += damping;
    }
    if (drags_) {
      const double drag = c.edge[i] + c.viscous[i], by_inertia = h * inverse_inertia[i];
      const double middle =
          step.from_rest() ? before : (before + by_inertia * force[i] / 2) / (1 + by_inertia * drag / 2);
      const double took = -half * before * (c.drag_force[i] - drag * middle);
      if (drag > 0) {
        loss.edges += took * (c.edge[i] / drag);
        loss.viscous += took * (c.viscous[i] / drag);
      }
      c.drag_force[i] = -drag * middle;
      force[i] -= drag * middle;
    }
    velocity[i] += h * force[i] * inverse_inertia[i];
  }
  return loss;
}

Damping::Loss Damping::kick(const protocol::Step& step, std::span<const protocol::IndexRange> some,
                            Particles& p) {
  Loss sum;
  if (!drags_ && !acts_everywhere(step)) {
    dem::kick(step, some, resultants_of(p), p);
    return sum;
  }
  for (const auto [begin, end] : some)
    for (const Loss& loss :
         {kick(step, begin, end, p.inverse_mass.data(), p.tie_x.data(), p.fx.data(), p.vx.data(), x_),
          kick(step, begin, end, p.inverse_mass.data(), p.tie_y.data(), p.fy.data(), p.vy.data(), y_),
          kick(step, begin, end, p.inverse_inertia.data(), nullptr, p.moment.data(), p.spin.data(), spin_)}) {
      sum.local += loss.local;
      sum.viscous += loss.viscous;
      sum.edges += loss.edges;
    }
  return sum;
}

}  // namespace adit::dem
