#include "simplified/chain/joints/integrator.hpp"

#include <fmt/format.h>

#include <cmath>

#include "protocol/errors.hpp"

namespace adit::simplified::chain {

using protocol::UserError;

void check(const Newmark& newmark, double dt) {
  if (!(dt > 0 && std::isfinite(dt)))
    throw UserError("dt", fmt::format("{} s is not a finite time above 0", dt));
  // The condition of unconditional stability: an implicit run needs no other limit to its step.
  if (!(newmark.gamma >= 0.5 && std::isfinite(newmark.gamma)))
    throw UserError("integrator.gamma", fmt::format("{} is below 0.5: the motion would grow", newmark.gamma));
  if (!(newmark.beta >= 0.5 * newmark.gamma && std::isfinite(newmark.beta)))
    throw UserError("integrator.beta",
                    fmt::format("{} is below gamma / 2 = {}: large steps would be unstable", newmark.beta,
                                0.5 * newmark.gamma));
}

Integrator::Integrator(const Newmark& newmark, double dt)
    : dt_(dt), beta_(newmark.beta), gamma_(newmark.gamma), A_(1 / (beta_ * dt * dt)), C_(gamma_ * dt * A_) {}

void Integrator::predict(Track& track, std::size_t begin, std::size_t end) const {
  const double *x = track.x.data(), *v = track.v.data(), *a = track.a.data();
  double *p = track.p.data(), *q = track.q.data();
  const double x_from_a = (0.5 - beta_) * dt_ * dt_, v_from_a = (1 - gamma_) * dt_;
#pragma GCC ivdep
  for (std::size_t i = begin; i < end; ++i) {
    p[i] = x[i] + dt_ * v[i] + x_from_a * a[i];
    q[i] = v[i] + v_from_a * a[i];
  }
}

void Integrator::correct(Track& track, std::span<const double> corrections, std::size_t begin,
                         std::size_t end) const {
  const double *y = corrections.data(), *p = track.p.data(), *q = track.q.data();
  double *x = track.x.data(), *v = track.v.data(), *a = track.a.data();
#pragma GCC ivdep
  for (std::size_t i = begin; i < end; ++i) {
    x[i] = p[i] + y[i];
    v[i] = q[i] + C_ * y[i];
    a[i] = A_ * y[i];
  }
}

}  // namespace adit::simplified::chain
