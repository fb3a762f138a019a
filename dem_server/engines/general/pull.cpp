#include "dem_server/engines/general/pull.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "dem_server/engines/general/pair_state.hpp"
#include "protocol/threads/vector_clones.hpp"

namespace adit::dem {
namespace {

using Column = std::array<double, kChunk>;

// What a chunk needs of its discs: differences of displacement and velocity (second less first), spins, and
// where dashpots act inverse masses and moments of inertia.
struct Near {
  alignas(64) Column ux, uy, vx, vy, spin_1, spin_2, by_mass, by_spin_1, by_spin_2;
};

// The laws of a chunk's pairs, one value each, or the first for all where there is one law. `whole` and
// `open`, of each pair, are 1 where the cement and where the contact acts, else 0.
struct Laws {
  alignas(64) Column kn, ks, km, tensile_strength, bending, cohesion, tan_friction_angle;
  Column contact_kn, contact_ks, contact_compliance, friction, normal_beta, shear_beta;
  Column whole, open;
};

struct Forces {
  alignas(64) Column x, y, moment_1, moment_2, normal, friction, dashpot;
};

struct Outcome {
  std::int64_t max_bits;  // of |N|: the order of non-negative doubles is that of their bits, NaN above all
  bool breaks, slides;
};

enum class Kind { kPlainContactBonds, kPlainParallelBonds, kVariedParallelBonds, kBonds, kContacts };

template <bool kDashpots>
ADIT_VECTOR_CLONES void look_up(const Pairs::Chunk& chunk, const Particles& p, const Pairs& pairs,
                                Near& near) {
  const std::uint32_t *first = &pairs.first[chunk.begin], *second = &pairs.second[chunk.begin];
  const double *ux = p.ux.data(), *uy = p.uy.data(), *vx = p.vx.data(), *vy = p.vy.data(),
               *spin = p.spin.data();
  const double *inverse_mass = p.inverse_mass.data(), *inverse_inertia = p.inverse_inertia.data();
  const double* weight = &pairs.weight[chunk.begin];
  const std::uint32_t count = chunk.end - chunk.begin;
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::uint32_t i = first[k], j = second[k];
    near.ux[k] = ux[j] - ux[i];
    near.uy[k] = uy[j] - uy[i];
    near.vx[k] = vx[j] - vx[i];
    near.vy[k] = vy[j] - vy[i];
    near.spin_1[k] = spin[i];
    near.spin_2[k] = spin[j];
    if constexpr (kDashpots) {
      near.by_mass[k] = weight[k] * (inverse_mass[i] + inverse_mass[j]);
      near.by_spin_1[k] = weight[k] * inverse_inertia[i];
      near.by_spin_2[k] = weight[k] * inverse_inertia[j];
    }
  }
}

void look_up(std::span<const PairLaw> laws, const Pairs::Chunk& chunk, bool dashpots, const Pairs& pairs,
             Laws& out) {
  const std::uint32_t count = chunk.end - chunk.begin;
  for (std::uint32_t k = 0; k < (chunk.one_law ? 1 : count); ++k) {
    const PairLaw& law = laws[pairs.law[chunk.begin + k]];
    out.kn[k] = law.kn;
    out.ks[k] = law.ks;
    out.km[k] = law.km;
    out.tensile_strength[k] = law.tensile_strength;
    out.bending[k] = law.bending;
    out.cohesion[k] = law.cohesion;
    out.tan_friction_angle[k] = law.tan_friction_angle;
    out.contact_kn[k] = law.contact.normal_stiffness;
    out.contact_ks[k] = law.contact.shear_stiffness;
    out.contact_compliance[k] = law.contact.shear_stiffness > 0 ? 1 / law.contact.shear_stiffness : 0;
    out.friction[k] = law.contact.friction;
    out.normal_beta[k] = law.contact.normal_damping;
    out.shear_beta[k] = law.contact.shear_damping;
  }
  if (!pairs.cemented() || (chunk.kind != Pairs::Kind::kGeneral && !dashpots)) return;
  for (std::uint32_t k = 0; k < count; ++k) {
    const bool whole = pairs.state[chunk.begin + k] == BondState::kIntact;
    out.whole[k] = whole ? 1 : 0;
    out.open[k] = !whole || laws[pairs.law[chunk.begin + k]].beside ? 1 : 0;
  }
}

// (spring + c r) / (1 + c dt / 2 m), see laws/linear_contact.hpp
inline double with_dashpot(double spring, double stiffness, double beta, double by_mass, double rate,
                           double dt) {
  const double mass = 1 / by_mass, c = 2 * beta * std::sqrt(mass * stiffness);
  return (spring + c * rate) / (1 + c * dt / (2 * mass));
}

// One pass over a chunk, written so that the compiler turns it into vector code. Contacts have no cement,
// plain bonds one law; L - L0 of bonds keeps all its digits, (L^2 - L0^2) / (L + L0) with L^2 - L0^2 = du.(2
// d0 + du).
template <Kind kKind, bool kOneLaw, bool kDashpots>
ADIT_VECTOR_CLONES Outcome pull_chunk(const Pairs::Chunk& chunk, double dt, const Near& near,
                                      const Laws& laws, Pairs& pairs, Forces& out) {
  constexpr bool kCement = kKind != Kind::kContacts, kContact = kKind != Kind::kPlainContactBonds;
  constexpr bool kPlain = kKind == Kind::kPlainContactBonds || kKind == Kind::kPlainParallelBonds;
  constexpr bool kGeneral = kKind == Kind::kBonds || kKind == Kind::kContacts;
  const auto at = [](const Column& column, std::uint32_t k) { return column[kOneLaw ? 0 : k]; };
  const double *rest_x = &pairs.rest_x[chunk.begin], *rest_y = &pairs.rest_y[chunk.begin],
               *rest_length = &pairs.rest_length[chunk.begin],
               *half_difference = &pairs.half_difference[chunk.begin], *slack = &pairs.slack[chunk.begin],
               *weight = &pairs.weight[chunk.begin];
  const double *initial = kCement ? &pairs.initial[chunk.begin] : nullptr,
               *widths = kCement ? &pairs.width[chunk.begin] : nullptr;
  double *shear = kCement ? &pairs.shear[chunk.begin] : nullptr,
         *moment = kCement ? &pairs.moment[chunk.begin] : nullptr, *slide = &pairs.slide[chunk.begin];
  double *normal_dashpot = kDashpots ? &pairs.normal_dashpot[chunk.begin] : nullptr,
         *shear_dashpot = kDashpots ? &pairs.shear_dashpot[chunk.begin] : nullptr;
  const std::uint32_t count = chunk.end - chunk.begin;
  std::int64_t max_bits = 0, breaks = 0, slides = 0;
#pragma GCC ivdep  // no pair writes what another one reads
  for (std::uint32_t k = 0; k < count; ++k) {
    const double ux = near.ux[k], uy = near.uy[k], dx = rest_x[k] + ux, dy = rest_y[k] + uy;
    const double length = std::sqrt(dx * dx + dy * dy);
    double inverse_length, elongation;
    if constexpr (kCement) {
      const double sum = length + rest_length[k], quotient = 1 / (length * sum);
      inverse_length = quotient * sum;
      elongation = (ux * (rest_x[k] + dx) + uy * (rest_y[k] + dy)) * (quotient * length);
    } else {
      inverse_length = 1 / length;
      elongation = length - rest_length[k];
    }
    const double nx = dx * inverse_length, ny = dy * inverse_length;
    const double arm_1 = 0.5 * length + half_difference[k], arm_2 = 0.5 * length - half_difference[k];
    const double spin_1 = near.spin_1[k], spin_2 = near.spin_2[k];
    // By the length in the middle of the step, see laws/encounter.hpp.
    const double stretch_rate = near.vx[k] * nx + near.vy[k] * ny, half = 0.5 * dt * stretch_rate;
    const double slip_rate = (near.vy[k] * nx - near.vx[k] * ny) * (1 + half * inverse_length) -
                             ((arm_1 - 0.5 * half) * spin_1 + (arm_2 - 0.5 * half) * spin_2);

    double pull_n = 0, pull_t = 0, turn = 0, friction = 0, dashpot = 0;
    if constexpr (kCement) {
      const double width = widths[kPlain ? 0 : k];
      pull_n = at(laws.kn, k) * width * elongation;
      pull_t = shear[k] + at(laws.ks, k) * width * dt * slip_rate;
      turn = moment[k] + at(laws.km, k) * (width * width * width) * dt * (spin_2 - spin_1);
      if constexpr (kGeneral) {
        pull_n = (pull_n + initial[k]) * laws.whole[k];
        pull_t *= laws.whole[k];
        turn *= laws.whole[k];
      }
      shear[k] = pull_t;
      moment[k] = turn;
      breaks |= static_cast<std::int64_t>(pull_n * width + std::abs(turn) * at(laws.bending, k) >
                                          at(laws.tensile_strength, k) * (width * width)) |
                static_cast<std::int64_t>(std::abs(pull_t) > at(laws.cohesion, k) * width -
                                                                 pull_n * at(laws.tan_friction_angle, k));
    }
    if constexpr (kContact) {
      const double overlap = kPlain ? elongation : elongation + slack[k];
      const double open = kKind == Kind::kBonds ? laws.open[k] : 1.0;
      const double spring = open * at(laws.contact_kn, k) * std::min(overlap, 0.0);
      const double limit = -at(laws.friction, k) * spring, before = slide[k];
      const double trial = before + at(laws.contact_ks, k) * dt * slip_rate;
      const double elastic = std::min(std::max(trial, -limit), limit);
      slide[k] = elastic;
      friction = 0.5 * (elastic + before) * (trial - elastic) * at(laws.contact_compliance, k);
      slides |= static_cast<std::int64_t>(friction != 0);
      double contact_n = spring, contact_t = elastic;
      if constexpr (kDashpots) {
        const bool touches = open * overlap < 0, sticks = touches && trial == elastic;
        const double by_mass = near.by_mass[k];
        const double by_shear =
            by_mass + (arm_1 * arm_1 * near.by_spin_1[k] + arm_2 * arm_2 * near.by_spin_2[k]);
        const double damped_n = std::min(
            0.0,
            with_dashpot(spring, at(laws.contact_kn, k), at(laws.normal_beta, k), by_mass, stretch_rate, dt));
        const double damped_t =
            with_dashpot(elastic, at(laws.contact_ks, k), at(laws.shear_beta, k), by_shear, slip_rate, dt);
        const double dash_n = touches ? damped_n - spring : 0.0, dash_t = sticks ? damped_t - elastic : 0.0;
        dashpot = 0.5 * dt *
                  ((dash_n + normal_dashpot[k]) * stretch_rate + (dash_t + shear_dashpot[k]) * slip_rate);
        normal_dashpot[k] = dash_n;
        shear_dashpot[k] = dash_t;
        contact_n += dash_n;
        contact_t += dash_t;
      }
      pull_n += contact_n;
      pull_t += contact_t;
    }
    out.normal[k] = pull_n;
    max_bits = std::max(max_bits, std::bit_cast<std::int64_t>(std::abs(pull_n)));
    const double w = kGeneral ? weight[k] : 1.0;
    out.x[k] = w * (pull_n * nx - pull_t * ny);
    out.y[k] = w * (pull_n * ny + pull_t * nx);
    out.moment_1[k] = w * (pull_t * arm_1 + turn);
    out.moment_2[k] = w * (pull_t * arm_2 - turn);
    if constexpr (kContact) out.friction[k] = w * friction;
    if constexpr (kDashpots) out.dashpot[k] = w * dashpot;
  }
  return {max_bits, breaks != 0, slides != 0};
}

template <Kind kKind>
Outcome pull_general(const Pairs::Chunk& chunk, double dt, const Near& near, const Laws& laws, bool dashpots,
                     Pairs& pairs, Forces& out) {
  const auto pull = chunk.one_law
                        ? (dashpots ? pull_chunk<kKind, true, true> : pull_chunk<kKind, true, false>)
                        : (dashpots ? pull_chunk<kKind, false, true> : pull_chunk<kKind, false, false>);
  return pull(chunk, dt, near, laws, pairs, out);
}

Outcome pull_any(const Pairs::Chunk& chunk, double dt, const Near& near, const Laws& laws, bool beside,
                 bool dashpots, Pairs& pairs, Forces& out) {
  if (!pairs.cemented()) return pull_general<Kind::kContacts>(chunk, dt, near, laws, dashpots, pairs, out);
  if (!dashpots && chunk.kind == Pairs::Kind::kPlain && !beside)
    return pull_chunk<Kind::kPlainContactBonds, true, false>(chunk, dt, near, laws, pairs, out);
  if (!dashpots && chunk.kind == Pairs::Kind::kPlain)
    return pull_chunk<Kind::kPlainParallelBonds, true, false>(chunk, dt, near, laws, pairs, out);
  if (!dashpots && chunk.kind == Pairs::Kind::kVaried && beside)
    return pull_chunk<Kind::kVariedParallelBonds, true, false>(chunk, dt, near, laws, pairs, out);
  return pull_general<Kind::kBonds>(chunk, dt, near, laws, dashpots, pairs, out);
}

// 1/2 F (F / k - motion): F(n-1) F(n) / 2k, what a spring of force F(n) gives up where it breaks, in the
// scheme's own form (contact_forces.hpp).
double given_up(double force, double stiffness, double motion) {
  return stiffness > 0 ? 0.5 * force * (force / stiffness - motion) : 0.0;
}

// Breaks the cement of pair chunk.begin + k where it exceeds a strength; the contact takes over what it can.
// Returns whether it broke.
bool break_pair(const PairLaw& law, std::uint32_t pair, std::uint32_t k, double dt, const Near& near,
                Pairs& pairs, Forces& forces, double& released) {
  if (pairs.state[pair] != BondState::kIntact) return false;
  const PairShape s = shape_of(pairs, pair, near.ux[k], near.uy[k]);
  const auto [kn, ks, km] = cement_of(law, pairs, pair);
  const double normal = kn * s.elongation + pairs.initial[pair], shear = pairs.shear[pair],
               turn = pairs.moment[pair], width = pairs.width[pair];
  const bool tensile = normal * width + std::abs(turn) * law.bending > law.tensile_strength * (width * width);
  if (!tensile && !(std::abs(shear) > law.cohesion * width - normal * law.tan_friction_angle)) return false;

  const double stretch = dt * (near.vx[k] * s.nx + near.vy[k] * s.ny);
  const double slip =
      dt * (near.vy[k] * s.nx - near.vx[k] * s.ny - (s.arm_1 * near.spin_1[k] + s.arm_2 * near.spin_2[k]));
  const double contact = law.contact.normal_stiffness * std::min(s.elongation + pairs.slack[pair], 0.0);
  const double w = pairs.weight[pair];
  released += w * (given_up(normal, kn, stretch) + given_up(shear, ks, slip) +
                   given_up(turn, km, dt * (near.spin_2[k] - near.spin_1[k])) -
                   (law.beside ? 0 : given_up(contact, law.contact.normal_stiffness, stretch)));
  pairs.state[pair] = tensile ? BondState::kTensileCrack : BondState::kShearCrack;
  pairs.shear[pair] = pairs.moment[pair] = 0;

  double left_n = contact, left_t = pairs.slide[pair];
  if (!pairs.normal_dashpot.empty()) {
    left_n += pairs.normal_dashpot[pair];
    left_t += pairs.shear_dashpot[pair];
  }
  forces.normal[k] = left_n;
  forces.x[k] = w * (left_n * s.nx - left_t * s.ny);
  forces.y[k] = w * (left_n * s.ny + left_t * s.nx);
  forces.moment_1[k] = w * left_t * s.arm_1;
  forces.moment_2[k] = w * left_t * s.arm_2;
  return true;
}

std::int64_t bits_of_size(double force) {
  return std::bit_cast<std::int64_t>(std::abs(force));
}

void apply(const Pairs::Chunk& chunk, std::uint32_t end, const Forces& forces, Particles& p, Pairs& pairs,
           std::uint32_t& slot) {
  double *fx = p.fx.data(), *fy = p.fy.data(), *moment = p.moment.data();
  const std::uint32_t *first = &pairs.first[chunk.begin], *second = &pairs.second[chunk.begin];
  const std::uint32_t count = chunk.end - chunk.begin;
  for (std::uint32_t k = 0; k < count;) {
    const std::uint32_t i = first[k];
    double x = fx[i], y = fy[i], m = moment[i];
    for (; k < count && first[k] == i; ++k) {
      x += forces.x[k];
      y += forces.y[k];
      m += forces.moment_1[k];
      const std::uint32_t j = second[k];
      if (j < end) {
        fx[j] -= forces.x[k];
        fy[j] -= forces.y[k];
        moment[j] += forces.moment_2[k];
      } else {
        pairs.away_x[slot] = forces.x[k];
        pairs.away_y[slot] = forces.y[k];
        pairs.away_moment[slot] = forces.moment_2[k];
        ++slot;
      }
    }
    fx[i] = x;
    fy[i] = y;
    moment[i] = m;
  }
}

}  // namespace

void pull_block(std::uint32_t block, std::span<const PairLaw> laws, double dt, Particles& particles,
                Pairs& pairs, PullResult& result) {
  Near near;
  Laws of_chunk;
  Forces forces;
  const bool dashpots = !pairs.normal_dashpot.empty();
  const std::uint32_t end = (block + 1) * kBlock;
  std::uint32_t slot = pairs.away_starts[block];
  std::int64_t max_bits = 0;
  result.friction = result.dashpots = result.released = 0;
  result.broken.clear();
  for (std::uint32_t c = pairs.chunk_starts[block]; c < pairs.chunk_starts[block + 1]; ++c) {
    Pairs::Chunk& chunk = pairs.chunks[c];
    const std::uint32_t count = chunk.end - chunk.begin;
    dashpots ? look_up<true>(chunk, particles, pairs, near) : look_up<false>(chunk, particles, pairs, near);
    look_up(laws, chunk, dashpots, pairs, of_chunk);
    const bool beside = laws[pairs.law[chunk.begin]].beside;
    Outcome outcome = pull_any(chunk, dt, near, of_chunk, beside, dashpots, pairs, forces);
    if (outcome.breaks) {
      chunk.kind = Pairs::Kind::kGeneral;
      outcome.max_bits = 0;
      for (std::uint32_t k = 0; k < count; ++k) {
        const std::uint32_t pair = chunk.begin + k;
        if (break_pair(laws[pairs.law[pair]], pair, k, dt, near, pairs, forces, result.released))
          result.broken.push_back(pair);
        outcome.max_bits = std::max(outcome.max_bits, bits_of_size(forces.normal[k]));
      }
    }
    if (outcome.slides)
      for (std::uint32_t k = 0; k < count; ++k) result.friction += forces.friction[k];
    if (dashpots)
      for (std::uint32_t k = 0; k < count; ++k) result.dashpots += forces.dashpot[k];
    apply(chunk, end, forces, particles, pairs, slot);
    if (outcome.max_bits > max_bits) {
      max_bits = outcome.max_bits;
      std::uint32_t k = 0;
      while (bits_of_size(forces.normal[k]) != max_bits) ++k;
      result.strongest = chunk.begin + k;
    }
  }
  result.max_normal_force = std::bit_cast<double>(max_bits);
}

void gather_block(std::uint32_t block, const Pairs& pairs, Particles& p) {
  for (std::uint32_t k = pairs.arrival_starts[block]; k < pairs.arrival_starts[block + 1]; ++k) {
    const auto [slot, disc] = pairs.arrivals[k];
    p.fx[disc] -= pairs.away_x[slot];
    p.fy[disc] -= pairs.away_y[slot];
    p.moment[disc] += pairs.away_moment[slot];
  }
}

}  // namespace adit::dem
