#include "simplified/chain/joints/integrator.hpp"

#include <fmt/format.h>

#include <cmath>

#include "protocol/errors.hpp"

namespace adit::simplified::chain {

using protocol::UserError;

void check(const Method& method, double dt) {
  if (!(dt > 0 && std::isfinite(dt)))
    throw UserError("dt", fmt::format("{} s is not a finite time above 0", dt));
  if (const auto* newmark = std::get_if<Newmark>(&method)) {
    // The condition of unconditional stability: an implicit run needs no other limit to its step.
    if (!(newmark->gamma >= 0.5 && std::isfinite(newmark->gamma)))
      throw UserError("integrator.gamma",
                      fmt::format("{} is below 0.5: the motion would grow", newmark->gamma));
    if (!(newmark->beta >= 0.5 * newmark->gamma && std::isfinite(newmark->beta)))
      throw UserError("integrator.beta",
                      fmt::format("{} is below gamma / 2 = {}: large steps would be unstable", newmark->beta,
                                  0.5 * newmark->gamma));
  } else if (const auto* wilson = std::get_if<WilsonTheta>(&method)) {
    // Unconditional stability needs theta >= (1 + sqrt(3)) / 2 = 1.366.
    if (!(wilson->theta >= 1.37 && std::isfinite(wilson->theta)))
      throw UserError(
          "integrator.theta",
          fmt::format("{} is below 1.37: large steps would be unstable; 1.4 is usual", wilson->theta));
  }
}

Track::Track(std::size_t size, const Method& method) : x(size), v(size), a(size), p(size), q(size) {
  if (!std::holds_alternative<Houbolt>(method)) return;
  x1.resize(size);
  x2.resize(size);
}

Integrator::Integrator(const Method& method, double dt, long step) : dt_(dt) {
  if (std::holds_alternative<Houbolt>(method) && step >= kHouboltStart) {
    kind_ = Kind::kHoubolt;
    A_ = 2 / (dt * dt);
    C_ = 11 / (6 * dt);
    return;
  }
  kind_ = Kind::kNewmark;
  Newmark newmark;
  if (const auto* given = std::get_if<Newmark>(&method)) newmark = *given;
  if (const auto* wilson = std::get_if<WilsonTheta>(&method)) {
    kind_ = Kind::kWilson;
    newmark = {1.0 / 6, 0.5};
    theta_ = wilson->theta;
  }
  beta_ = newmark.beta;
  gamma_ = newmark.gamma;
  const double ahead = theta_ * dt;
  A_ = 1 / (beta_ * ahead * ahead);
  C_ = gamma_ * ahead * A_;
}

void Integrator::predict(Track& track, std::size_t begin, std::size_t end) const {
  const double *x = track.x.data(), *v = track.v.data(), *a = track.a.data();
  double *p = track.p.data(), *q = track.q.data();
  if (kind_ == Kind::kHoubolt) {
    const double *x1 = track.x1.data(), *x2 = track.x2.data();
    const double per_six_dt = 1 / (6 * dt_);
#pragma GCC ivdep
    for (std::size_t i = begin; i < end; ++i) {
      p[i] = 0.5 * (5 * x[i] - 4 * x1[i] + x2[i]);
      q[i] = per_six_dt * (11 * p[i] - 18 * x[i] + 9 * x1[i] - 2 * x2[i]);
    }
    return;
  }
  const double ahead = theta_ * dt_;
  const double x_from_a = (0.5 - beta_) * ahead * ahead, v_from_a = (1 - gamma_) * ahead;
#pragma GCC ivdep
  for (std::size_t i = begin; i < end; ++i) {
    p[i] = x[i] + ahead * v[i] + x_from_a * a[i];
    q[i] = v[i] + v_from_a * a[i];
  }
}

void Integrator::correct(Track& track, std::span<const double> corrections, std::size_t begin,
                         std::size_t end) const {
  const double *y = corrections.data(), *p = track.p.data(), *q = track.q.data();
  double *x = track.x.data(), *v = track.v.data(), *a = track.a.data();
  // The history is moved before x is overwritten. It is kept during the first steps of Newmark's method, too,
  // because Houbolt's method begins with the displacements of those steps.
  if (!track.x1.empty()) {
    std::copy(track.x1.begin() + begin, track.x1.begin() + end, track.x2.begin() + begin);
    std::copy(track.x.begin() + begin, track.x.begin() + end, track.x1.begin() + begin);
  }
  if (kind_ == Kind::kWilson) {
    const double per_theta = 1 / theta_, x_from_a = dt_ * dt_ / 6, v_from_a = 0.5 * dt_;
#pragma GCC ivdep
    for (std::size_t i = begin; i < end; ++i) {
      // A y is the acceleration theta dt ahead. The one at dt lies on the straight line to it, and the motion
      // is integrated from there exactly for this linear acceleration.
      const double after = a[i] + per_theta * (A_ * y[i] - a[i]);
      x[i] += dt_ * v[i] + x_from_a * (after + 2 * a[i]);
      v[i] += v_from_a * (a[i] + after);
      a[i] = after;
    }
    return;
  }
#pragma GCC ivdep
  for (std::size_t i = begin; i < end; ++i) {
    x[i] = p[i] + y[i];
    v[i] = q[i] + C_ * y[i];
    a[i] = A_ * y[i];
  }
}

}  // namespace adit::simplified::chain
