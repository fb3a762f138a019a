#include "dem_server/engines/general/forces/damping.hpp"

#include <cmath>

#include "dem_server/particles/integrate.hpp"
#include "protocol/kernels/sums.hpp"
#include "protocol/participant/local_damping.hpp"
#include "protocol/threads/vector_clones.hpp"

namespace adit::dem {

Damping::Damping(double local_share, double viscous_rate, std::span<const EdgeDashpot> edges,
                 const Particles& p, std::span<const std::uint32_t> tied)
    : local_share_(local_share), viscous_(viscous_rate > 0), drags_(viscous_ || !edges.empty()) {
  for (Component* c : {&x_, &y_, &spin_}) {
    c->edge.assign(drags_ ? p.size() : 0, 0.0);
    c->viscous = c->middle = c->edge;
    c->free.assign(drags_ ? p.size() : 0, 1.0);
    c->local.assign(local_share_ > 0 ? p.size() : 0, local_share_);
    c->local_force.assign(c->local.size(), 0.0);
  }
  for (Component* c : {&x_, &y_})
    for (const std::uint32_t i : tied) {
      if (!c->local.empty()) c->local[i] = 0;
      if (drags_) c->free[i] = 0;
    }
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

// One component of the discs' motion; without `tie` none of it is tied.
struct Damping::Motion {
  const double *inverse_inertia, *tie;
  double *force, *velocity;
};

namespace {

ADIT_VECTOR_CLONES void damp_tied(std::uint32_t begin, std::uint32_t end, double share, const double* tie,
                                  const double* velocity, double* force) {
#pragma GCC ivdep
  for (std::size_t i = begin; i < end; ++i) force[i] = protocol::damped(force[i], tie[i], velocity[i], share);
}

ADIT_VECTOR_CLONES void damp_free(std::uint32_t begin, std::uint32_t end, double share,
                                  const double* velocity, double* force) {
#pragma GCC ivdep
  for (std::size_t i = begin; i < end; ++i) force[i] = protocol::damped(force[i], 0, velocity[i], share);
}

// The power of local damping before and now [W].
ADIT_VECTOR_CLONES double damp_locally(std::uint32_t begin, std::uint32_t end, const double* share,
                                       const double* velocity, double* force, double* before) {
  return protocol::eight_sums(begin, end, [=](std::size_t i) {
    const double damping = -share[i] * std::abs(force[i]) * protocol::sign(velocity[i]);
    const double both = before[i] + damping;
    before[i] = damping;
    force[i] += damping;
    return velocity[i] * both;
  });
}

// What drag by `edge` and by `viscous` takes from motion, before and now [W]. The mean velocity that it acts
// against follows from the force with `half_kick`, 0 in a step from rest.
struct DragPower {
  double edge, viscous;
};
ADIT_VECTOR_CLONES DragPower drag(std::uint32_t begin, std::uint32_t end, double half_kick,
                                  const double* inverse_inertia, const double* free, const double* edge,
                                  const double* viscous, const double* velocity, double* force,
                                  double* middle) {
  const auto middle_of = [=](std::size_t i) {
    const double by_inertia = half_kick * inverse_inertia[i];
    return (velocity[i] + free[i] * by_inertia * force[i]) / (1 + by_inertia * (edge[i] + viscous[i]));
  };
  const double by_edges = protocol::eight_sums(
      begin, end, [=](std::size_t i) { return velocity[i] * edge[i] * (middle[i] + middle_of(i)); });
  const double by_viscosity = protocol::eight_sums(begin, end, [=](std::size_t i) {
    const double now = middle_of(i), both = middle[i] + now;
    middle[i] = now;
    force[i] -= (edge[i] + viscous[i]) * now;
    return velocity[i] * viscous[i] * both;
  });
  return {by_edges, by_viscosity};
}

ADIT_VECTOR_CLONES void kick_by(std::uint32_t begin, std::uint32_t end, double kick,
                                const double* inverse_inertia, const double* force, double* velocity) {
#pragma GCC ivdep
  for (std::size_t i = begin; i < end; ++i) velocity[i] += kick * force[i] * inverse_inertia[i];
}

}  // namespace

Damping::Loss Damping::kick(const protocol::Step& step, std::uint32_t begin, std::uint32_t end,
                            const Motion& motion, Component& c) const {
  Loss loss;
  const auto [inverse_inertia, tie, force, velocity] = motion;
  const double half = step.from_rest() ? 0 : step.dt / 2, half_kick = step.from_rest() ? 0 : step.kick() / 2;
  if (step.local_damping > 0 && tie)
    damp_tied(begin, end, step.local_damping, tie, velocity, force);
  else if (step.local_damping > 0)
    damp_free(begin, end, step.local_damping, velocity, force);
  else if (local_share_ > 0)
    loss.local -= half * damp_locally(begin, end, c.local.data(), velocity, force, c.local_force.data());
  if (drags_) {
    const DragPower power = drag(begin, end, half_kick, inverse_inertia, c.free.data(), c.edge.data(),
                                 c.viscous.data(), velocity, force, c.middle.data());
    loss.edges += half * power.edge;
    loss.viscous += half * power.viscous;
  }
  kick_by(begin, end, step.kick(), inverse_inertia, force, velocity);
  return loss;
}

Damping::Loss Damping::kick(const protocol::Step& step, std::span<const protocol::IndexRange> some,
                            Particles& p) {
  Loss sum;
  if (!drags_ && !acts_everywhere(step)) {
    dem::kick(step, some, resultants_of(p), p);
    return sum;
  }
  const double *by_mass = p.inverse_mass.data(), *by_inertia = p.inverse_inertia.data();
  for (const auto [begin, end] : some)
    for (const Loss& loss :
         {kick(step, begin, end, {by_mass, p.tie_x.data(), p.fx.data(), p.vx.data()}, x_),
          kick(step, begin, end, {by_mass, p.tie_y.data(), p.fy.data(), p.vy.data()}, y_),
          kick(step, begin, end, {by_inertia, nullptr, p.moment.data(), p.spin.data()}, spin_)}) {
      sum.local += loss.local;
      sum.viscous += loss.viscous;
      sum.edges += loss.edges;
    }
  return sum;
}

}  // namespace adit::dem
