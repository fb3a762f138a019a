#include "dem_server/contact_forces.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace adit::dem {
namespace {

// What the bonds of one run do to their first particles, weighted; the second ones feel the opposite force
// and the same moment.
struct RunForces {
  std::array<double, kLongestRun> x, y, moment;
};

struct RunOutcome {
  std::int64_t max_bits;  // of |Fn|: the order of non-negative doubles is that of their bits, NaN above all
  bool breaks;            // some bond exceeds a strength
};

// One pass over a run, written so that the compiler turns it into vector code. Most models have no initial
// forces, and need not load any.
template <bool kPrestressed>
RunOutcome pull_run(const BondLaw& law, double dt, const Run& run, double rest_length, const Particles& p,
                    Bonds& b, RunForces& out) {
  const double *ux1 = &p.ux[run.first], *uy1 = &p.uy[run.first], *ux2 = &p.ux[run.second],
               *uy2 = &p.uy[run.second], *vx1 = &p.vx[run.first], *vy1 = &p.vy[run.first],
               *vx2 = &p.vx[run.second], *vy2 = &p.vy[run.second], *w1 = &p.spin[run.first],
               *w2 = &p.spin[run.second], *weight = &b.weight[run.begin], *intact = &b.intact[run.begin];
  const double* initial = kPrestressed ? &b.initial_normal_force[run.begin] : nullptr;
  double *normal = &b.normal_force[run.begin], *shear = &b.shear_force[run.begin];
  double *fx = out.x.data(), *fy = out.y.data(), *moment = out.moment.data();
  const double kn = law.stiffness.normal, ks_dt = law.stiffness.shear * dt;
  const double tensile_strength = law.tensile_strength, shear_strength = law.shear_strength;
  const double rest_x = run.rest_x, rest_y = run.rest_y;
  std::int64_t max_bits = 0, exceeded = 0;
#pragma GCC ivdep  // no bond writes what another one reads
  for (std::uint32_t k = 0; k < run.count; ++k) {
    const double du_x = ux2[k] - ux1[k], du_y = uy2[k] - uy1[k];
    const double dx = rest_x + du_x, dy = rest_y + du_y;
    const double length = std::sqrt(dx * dx + dy * dy);
    // L - L0 = (L^2 - L0^2) / (L + L0), and L^2 - L0^2 = du.(2 d0 + du): no digits are lost. One division
    // serves both this and 1 / L.
    const double sum = length + rest_length;
    const double quotient = 1 / (length * sum);
    const double inverse_length = quotient * sum;
    const double elongation = (du_x * (rest_x + dx) + du_y * (rest_y + dy)) * (quotient * length);
    const double nx = dx * inverse_length, ny = dy * inverse_length;

    double elastic = kn * elongation;
    if constexpr (kPrestressed) elastic += initial[k];
    const double fn = elastic > 0 ? intact[k] * elastic : elastic;
    const double arm = 0.5 * length;
    const double slip = (vy2[k] - vy1[k]) * nx - (vx2[k] - vx1[k]) * ny - (w1[k] + w2[k]) * arm;
    const double fs = intact[k] * (shear[k] + ks_dt * slip);
    normal[k] = fn;
    shear[k] = fs;
    exceeded |= static_cast<std::int64_t>(fn > tensile_strength) |
                static_cast<std::int64_t>(std::abs(fs) > shear_strength);
    max_bits = std::max(max_bits, std::bit_cast<std::int64_t>(std::abs(fn)));
    fx[k] = weight[k] * (fn * nx - fs * ny);
    fy[k] = weight[k] * (fn * ny + fs * nx);
    moment[k] = weight[k] * (fs * arm);
  }
  return {max_bits, exceeded != 0};
}

// Breaks one bond whose forces exceed a strength. Returns the energy that it loses [J].
double break_bond(const BondLaw& law, double dt, const Run& run, std::uint32_t k, const Particles& p,
                  Bonds& b, RunForces& forces) {
  const std::uint32_t bond = run.begin + k, i = run.first + k, j = run.second + k;
  const double dx = run.rest_x + (p.ux[j] - p.ux[i]), dy = run.rest_y + (p.uy[j] - p.uy[i]);
  const double length = std::sqrt(dx * dx + dy * dy), nx = dx / length, ny = dy / length;
  const double dvx = p.vx[j] - p.vx[i], dvy = p.vy[j] - p.vy[i];
  const double stretch = dt * (dvx * nx + dvy * ny);
  const double slip = dt * (dvy * nx - dvx * ny - 0.5 * length * (p.spin[i] + p.spin[j]));
  const double fn = b.normal_force[bond], fs = b.shear_force[bond];
  // F(n-1) F(n) / 2k with F(n-1) = F(n) - k (motion of this step); compression survives the break.
  double lost = 0.5 * fs * (law.stiffness.shear > 0 ? fs / law.stiffness.shear - slip : 0.0);
  if (fn > 0) lost += 0.5 * fn * (fn / law.stiffness.normal - stretch);

  b.state[bond] = fn > law.tensile_strength ? BondState::kTensileCrack : BondState::kShearCrack;
  b.intact[bond] = 0;
  b.normal_force[bond] = std::min(fn, 0.0);
  b.shear_force[bond] = 0;
  forces.x[k] = b.weight[bond] * b.normal_force[bond] * nx;
  forces.y[k] = b.weight[bond] * b.normal_force[bond] * ny;
  forces.moment[k] = 0;
  return b.weight[bond] * lost;
}

// Breaks every bond of the run that exceeds a strength; returns the energy lost [J].
double break_bonds(const BondLaw& law, double dt, const Run& run, const Particles& p, Bonds& b,
                   RunForces& forces, std::vector<std::uint32_t>& broken) {
  double lost = 0;
  for (std::uint32_t k = 0; k < run.count; ++k) {
    const std::uint32_t bond = run.begin + k;
    if (b.normal_force[bond] > law.tensile_strength || std::abs(b.shear_force[bond]) > law.shear_strength) {
      lost += break_bond(law, dt, run, k, p, b, forces);
      broken.push_back(bond);
    }
  }
  return lost;
}

void add(const double* __restrict from, std::uint32_t count, double* __restrict to) {
  for (std::uint32_t k = 0; k < count; ++k) to[k] += from[k];
}

void subtract(const double* __restrict from, std::uint32_t count, double* __restrict to) {
  for (std::uint32_t k = 0; k < count; ++k) to[k] -= from[k];
}

void apply_to_particles(const Run& run, const RunForces& forces, Particles& p) {
  add(forces.x.data(), run.count, &p.fx[run.first]);
  add(forces.y.data(), run.count, &p.fy[run.first]);
  add(forces.moment.data(), run.count, &p.moment[run.first]);
  subtract(forces.x.data(), run.count, &p.fx[run.second]);
  subtract(forces.y.data(), run.count, &p.fy[run.second]);
  add(forces.moment.data(), run.count, &p.moment[run.second]);
}

std::int64_t strongest(const Run& run, const Bonds& b) {
  std::int64_t max_bits = 0;
  for (std::uint32_t k = 0; k < run.count; ++k)
    max_bits = std::max(max_bits, std::bit_cast<std::int64_t>(std::abs(b.normal_force[run.begin + k])));
  return max_bits;
}

std::uint32_t find_bond(const Run& run, const Bonds& b, std::int64_t bits) {
  std::uint32_t bond = run.begin;
  while (std::bit_cast<std::int64_t>(std::abs(b.normal_force[bond])) != bits) ++bond;
  return bond;
}

}  // namespace

void clear_resultants(std::span<const protocol::Stretch> some, Particles& particles) {
  for (auto* resultant : {&particles.fx, &particles.fy, &particles.moment})
    for (const auto [begin, end] : some) std::fill(resultant->begin() + begin, resultant->begin() + end, 0.0);
}

void add_contact_forces(const BondLaw& law, double dt, std::span<const Run> runs, Particles& particles,
                        Bonds& bonds, ContactResult& result, std::vector<std::uint32_t>& broken) {
  RunForces forces;
  const auto pull = bonds.initial_normal_force.empty() ? pull_run<false> : pull_run<true>;
  auto max_bits = std::bit_cast<std::int64_t>(result.max_normal_force);
  const Run* strongest_run = nullptr;
  for (const Run& run : runs) {
    RunOutcome outcome = pull(law, dt, run, bonds.rest_length, particles, bonds, forces);
    if (outcome.breaks) {
      result.released += break_bonds(law, dt, run, particles, bonds, forces, broken);
      outcome.max_bits = strongest(run, bonds);
    }
    apply_to_particles(run, forces, particles);
    if (outcome.max_bits > max_bits) {
      max_bits = outcome.max_bits;
      strongest_run = &run;
    }
  }
  if (strongest_run) {
    result.max_normal_force = std::bit_cast<double>(max_bits);
    result.strongest_bond = find_bond(*strongest_run, bonds, max_bits);
  }
}

ContactResult compute_contact_forces(const BondLaw& law, double dt, Particles& particles, Bonds& bonds,
                                     std::vector<std::uint32_t>& broken) {
  const protocol::Stretch all{0, static_cast<std::uint32_t>(particles.size())};
  clear_resultants({&all, 1}, particles);
  ContactResult result;
  add_contact_forces(law, dt, bonds.runs, particles, bonds, result, broken);
  return result;
}

}  // namespace adit::dem
