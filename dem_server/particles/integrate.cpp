#include "dem_server/particles/integrate.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "protocol/participant/local_damping.hpp"
#include "protocol/threads/vector_clones.hpp"

namespace adit::dem {

ADIT_VECTOR_CLONES double move(double dt, std::span<const protocol::IndexRange> some, Particles& p) {
  const double *vx = p.vx.data(), *vy = p.vy.data();
  double *ux = p.ux.data(), *uy = p.uy.data();
  // A maximum of integers is vectorized by the compiler, that of doubles is not because of NaN.
  std::int64_t fastest = 0;  // the order of non-negative doubles is that of their bits
  for (const auto [begin, end] : some)
#pragma GCC ivdep
    for (std::size_t i = begin; i < end; ++i) {
      ux[i] += dt * vx[i];
      uy[i] += dt * vy[i];
      fastest = std::max(fastest, std::bit_cast<std::int64_t>(vx[i] * vx[i] + vy[i] * vy[i]));
    }
  return std::bit_cast<double>(fastest);
}

namespace {

ADIT_VECTOR_CLONES void kick_freely(double dt, std::span<const protocol::IndexRange> some,
                                    const Resultants& resultants, Particles& p, const Acceleration& gravity) {
  const auto [fx, fy, moment] = resultants;
  const double *inverse_mass = p.inverse_mass.data(), *inverse_inertia = p.inverse_inertia.data();
  double *vx = p.vx.data(), *vy = p.vy.data(), *spin = p.spin.data();
  const double gx = dt * gravity.x, gy = dt * gravity.y;
  for (const auto [begin, end] : some)
#pragma GCC ivdep
    for (std::size_t i = begin; i < end; ++i) {
      vx[i] += dt * fx[i] * inverse_mass[i] + gx;
      vy[i] += dt * fy[i] * inverse_mass[i] + gy;
      spin[i] += dt * moment[i] * inverse_inertia[i];
    }
}

void kick_damped(const protocol::Step& step, std::span<const protocol::IndexRange> some, const Resultants& f,
                 Particles& p, const Acceleration& gravity) {
  const double dt = step.kick(), share = step.local_damping;
  for (const auto [begin, end] : some)
    for (std::size_t i = begin; i < end; ++i) {
      const double x = f.fx[i] + p.mass[i] * gravity.x, y = f.fy[i] + p.mass[i] * gravity.y;
      p.vx[i] += dt * protocol::damped(x, p.tie_x[i], p.vx[i], share) * p.inverse_mass[i];
      p.vy[i] += dt * protocol::damped(y, p.tie_y[i], p.vy[i], share) * p.inverse_mass[i];
      p.spin[i] += dt * protocol::damped(f.moment[i], 0, p.spin[i], share) * p.inverse_inertia[i];
    }
}

}  // namespace

void kick(const protocol::Step& step, std::span<const protocol::IndexRange> some,
          const Resultants& resultants, Particles& particles, const Acceleration& gravity) {
  if (step.local_damping > 0)
    kick_damped(step, some, resultants, particles, gravity);
  else
    kick_freely(step.kick(), some, resultants, particles, gravity);
}

}  // namespace adit::dem
