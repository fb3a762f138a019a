#include "dem_server/engines/lattice/bond_forces.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "dem_server/laws/contact_bond.hpp"
#include "dem_server/laws/pair_kinematics.hpp"
#include "dem_server/laws/spring.hpp"
#include "protocol/kernels/sums.hpp"
#include "protocol/threads/vector_clones.hpp"

namespace adit::dem {
namespace {

// What the bonds of one run do to their first particles, weighted; the second ones feel the opposite force
// and the same moment. `normal` is unweighted.
struct RunForces {
  alignas(64) std::array<double, kLongestRun> x, y, moment, normal;
};

struct RunOutcome {
  std::int64_t max_bits;  // of |Fn|: the order of non-negative doubles is that of their bits, NaN above all
  bool breaks;            // some bond exceeds a strength
};

inline PairShape shape_of(const Run& run, double rest_length, double ux, double uy) {
  return bond_shape<Division::kShared>(run.rest_x, run.rest_y, rest_length, ux, uy);
}

// One pass over a run, written so that the compiler turns it into vector code. The bonds of most runs are
// plain: intact, of weight 1, and without initial forces; they need not load any of these.
template <bool kPlain, bool kPrestressed>
ADIT_VECTOR_CLONES RunOutcome find_run(const ContactBond& law, double dt, const Run& run, double rest_length,
                                       const Particles& p, Bonds& b, RunForces& out) {
  const double *ux1 = &p.ux[run.first], *uy1 = &p.uy[run.first], *ux2 = &p.ux[run.second],
               *uy2 = &p.uy[run.second], *vx1 = &p.vx[run.first], *vy1 = &p.vy[run.first],
               *vx2 = &p.vx[run.second], *vy2 = &p.vy[run.second], *w1 = &p.spin[run.first],
               *w2 = &p.spin[run.second];
  const double *weight = &b.weight[run.begin], *intact = &b.intact[run.begin];
  const double* initial = kPrestressed ? &b.initial_normal_force[run.begin] : nullptr;
  double* shear = &b.shear_force[run.begin];
  double *fx = out.x.data(), *fy = out.y.data(), *moment = out.moment.data(), *normal = out.normal.data();
  const double kn = law.stiffness.normal, ks_dt = law.stiffness.shear * dt;
  const double tensile_strength = law.tensile_strength, shear_strength = law.shear_strength;
  // A copy, because the compiler cannot know that the stores below leave `run` unchanged.
  const Run rest = run;
  std::int64_t max_bits = 0, exceeded = 0;
#pragma GCC ivdep  // no bond writes what another one reads
  for (std::uint32_t k = 0; k < rest.count; ++k) {
    const PairShape s = shape_of(rest, rest_length, ux2[k] - ux1[k], uy2[k] - uy1[k]);
    double fn = bond_normal_force(kn, s.elongation);
    if constexpr (kPrestressed) fn += initial[k];
    if constexpr (!kPlain) fn = without_lost_tension(fn, intact[k]);
    const double arm = 0.5 * s.length;
    const double slip = slip_rate(across(s.nx, s.ny, vx2[k] - vx1[k], vy2[k] - vy1[k]), arm, w1[k], w2[k]);
    double fs = bond_shear_force(shear[k], ks_dt, slip);
    if constexpr (!kPlain) fs *= intact[k];
    shear[k] = fs;
    normal[k] = fn;
    exceeded |= static_cast<std::int64_t>(breaks_in_tension(fn, tensile_strength)) |
                static_cast<std::int64_t>(breaks_in_shear(fs, shear_strength));
    max_bits = std::max(max_bits, std::bit_cast<std::int64_t>(std::abs(fn)));
    const double w = kPlain ? 1.0 : weight[k];
    const PlaneVector force = vector_of(s.nx, s.ny, fn, fs);
    fx[k] = w * force.x;
    fy[k] = w * force.y;
    moment[k] = w * (fs * arm);
  }
  return {max_bits, exceeded != 0};
}

// Breaks one bond whose forces exceed a strength. Returns the energy that it loses [J].
double break_bond(const ContactBond& law, double dt, const Run& run, std::uint32_t k, const Particles& p,
                  Bonds& b, RunForces& forces) {
  const std::uint32_t bond = run.begin + k, i = run.first + k, j = run.second + k;
  const PairShape s = shape_of(run, b.rest_length, p.ux[j] - p.ux[i], p.uy[j] - p.uy[i]);
  const double vx = p.vx[j] - p.vx[i], vy = p.vy[j] - p.vy[i];
  const double stretch = dt * along(s.nx, s.ny, vx, vy);
  const double slip = dt * slip_rate(across(s.nx, s.ny, vx, vy), 0.5 * s.length, p.spin[i], p.spin[j]);
  const double fn = forces.normal[k], fs = b.shear_force[bond];
  double lost = released_energy(fs, law.stiffness.shear, slip);
  if (fn > 0) lost += released_energy(fn, law.stiffness.normal, stretch);  // compression survives the break

  b.break_bond(
      bond, breaks_in_tension(fn, law.tensile_strength) ? BondState::kTensileCrack : BondState::kShearCrack);
  forces.normal[k] = std::min(fn, 0.0);
  forces.x[k] = b.weight[bond] * forces.normal[k] * s.nx;
  forces.y[k] = b.weight[bond] * forces.normal[k] * s.ny;
  forces.moment[k] = 0;
  return b.weight[bond] * lost;
}

// Breaks every bond of the run that exceeds a strength; returns the energy lost [J].
double break_bonds(const ContactBond& law, double dt, const Run& run, const Particles& p, Bonds& b,
                   RunForces& forces, std::vector<std::uint32_t>& broken) {
  double lost = 0;
  for (std::uint32_t k = 0; k < run.count; ++k) {
    const std::uint32_t bond = run.begin + k;
    if (breaks_in_tension(forces.normal[k], law.tensile_strength) ||
        breaks_in_shear(b.shear_force[bond], law.shear_strength)) {
      lost += break_bond(law, dt, run, k, p, b, forces);
      broken.push_back(bond);
    }
  }
  return lost;
}

std::int64_t bits_of_size(double force) {
  return std::bit_cast<std::int64_t>(std::abs(force));
}

std::int64_t largest(const Run& run, const RunForces& forces) {
  std::int64_t max_bits = 0;
  for (std::uint32_t k = 0; k < run.count; ++k) max_bits = std::max(max_bits, bits_of_size(forces.normal[k]));
  return max_bits;
}

std::uint32_t find_bond(const Run& run, const RunForces& forces, std::int64_t bits) {
  std::uint32_t k = 0;
  while (bits_of_size(forces.normal[k]) != bits) ++k;
  return run.begin + k;
}

ADIT_VECTOR_CLONES void apply_to_particles(const Run& run, const RunForces& forces, const Resultants& to) {
  const double *x = forces.x.data(), *y = forces.y.data(), *moment = forces.moment.data();
  double *fx1 = to.fx + run.first, *fy1 = to.fy + run.first, *moment1 = to.moment + run.first;
  double *fx2 = to.fx + run.second, *fy2 = to.fy + run.second, *moment2 = to.moment + run.second;
  // Two loops: in a row of the lattice the second particle of a bond is the first one of the next, so one
  // loop would read what it has just written.
  const std::uint32_t count = run.count;
#pragma GCC ivdep
  for (std::uint32_t k = 0; k < count; ++k) {
    fx1[k] += x[k];
    fy1[k] += y[k];
    moment1[k] += moment[k];
  }
#pragma GCC ivdep
  for (std::uint32_t k = 0; k < count; ++k) {
    fx2[k] -= x[k];
    fy2[k] -= y[k];
    moment2[k] += moment[k];
  }
}

ADIT_VECTOR_CLONES void find_normal_forces(const ContactBond& law, const Run& run, const Particles& p,
                                           const Bonds& b, double* normal) {
  const double *ux1 = &p.ux[run.first], *uy1 = &p.uy[run.first], *ux2 = &p.ux[run.second],
               *uy2 = &p.uy[run.second], *intact = &b.intact[run.begin];
  const double* initial = b.initial_normal_force.empty() ? nullptr : &b.initial_normal_force[run.begin];
  const double kn = scaled(law, run.factors).stiffness.normal, rest_length = b.rest_length;
  const Run rest = run;
#pragma GCC ivdep
  for (std::uint32_t k = 0; k < rest.count; ++k)
    normal[k] =
        bond_normal_force(kn, shape_of(rest, rest_length, ux2[k] - ux1[k], uy2[k] - uy1[k]).elongation);
  for (std::uint32_t k = 0; initial != nullptr && k < rest.count; ++k) normal[k] += initial[k];
  for (std::uint32_t k = 0; k < rest.count; ++k) normal[k] = without_lost_tension(normal[k], intact[k]);
}

}  // namespace

void clear(std::span<const protocol::IndexRange> some, const Resultants& resultants) {
  for (double* resultant : {resultants.fx, resultants.fy, resultants.moment})
    for (const auto [begin, end] : some) std::fill(resultant + begin, resultant + end, 0.0);
}

void BondResult::add(const BondResult& later) {
  released += later.released;
  // Of equal forces the earlier one stays, which is the same bond for any number of threads.
  if (bits_of_size(later.max_normal_force) <= bits_of_size(max_normal_force)) return;
  max_normal_force = later.max_normal_force;
  strongest_bond = later.strongest_bond;
}

void add_bond_forces(const ContactBond& law, double dt, std::span<const Run> runs, const Particles& particles,
                     Bonds& bonds, const Resultants& resultants, BondResult& result,
                     std::vector<std::uint32_t>& broken) {
  RunForces forces;
  const auto find_plain = bonds.initial_normal_force.empty() ? find_run<true, false> : find_run<true, true>;
  const auto find_any = bonds.initial_normal_force.empty() ? find_run<false, false> : find_run<false, true>;
  auto max_bits = std::bit_cast<std::int64_t>(result.max_normal_force);
  for (const Run& run : runs) {
    const auto find = bonds.plain(run) ? find_plain : find_any;
    const ContactBond own = scaled(law, run.factors);
    RunOutcome outcome = find(own, dt, run, bonds.rest_length, particles, bonds, forces);
    // Breaks are rare, so the vector pass only says that there is one, and a second pass finds it.
    if (outcome.breaks) {
      result.released += break_bonds(own, dt, run, particles, bonds, forces, broken);
      outcome.max_bits = largest(run, forces);
    }
    apply_to_particles(run, forces, resultants);
    if (outcome.max_bits > max_bits) {
      max_bits = outcome.max_bits;
      result.strongest_bond = find_bond(run, forces, max_bits);
    }
  }
  result.max_normal_force = std::bit_cast<double>(max_bits);
}

void find_normal_forces(const ContactBond& law, const Particles& particles, const Bonds& bonds,
                        std::span<double> normal) {
  for (const Run& run : bonds.runs) find_normal_forces(law, run, particles, bonds, &normal[run.begin]);
}

double strain_energy(const ContactBond& law, std::span<const Run> runs, const Particles& particles,
                     const Bonds& bonds) {
  const double shear_compliance = law.stiffness.shear > 0 ? 1 / law.stiffness.shear : 0.0;
  std::array<double, kLongestRun> normal;
  double twice = 0;
  for (const Run& run : runs) {
    find_normal_forces(law, run, particles, bonds, normal.data());
    const double normal_compliance = 1 / scaled(law, run.factors).stiffness.normal;
    const double *shear = &bonds.shear_force[run.begin], *weight = &bonds.weight[run.begin];
    twice += protocol::eight_sums(0, run.count, [&](std::size_t k) {
      return weight[k] * (normal[k] * normal[k] * normal_compliance + shear[k] * shear[k] * shear_compliance);
    });
  }
  return twice / 2;
}

double internal_force(const ContactBond& law, const Particles& particles, const Bonds& bonds) {
  std::array<double, kLongestRun> normal;
  double sum = 0;
  for (const Run& run : bonds.runs) {
    find_normal_forces(law, run, particles, bonds, normal.data());
    const double *shear = &bonds.shear_force[run.begin], *weight = &bonds.weight[run.begin];
    sum += protocol::eight_sums(0, run.count, [&](std::size_t k) {
      return weight[k] * std::sqrt(normal[k] * normal[k] + shear[k] * shear[k]);
    });
  }
  return sum;
}

}  // namespace adit::dem
