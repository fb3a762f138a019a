#include "dem_server/engines/general/pairs/pair_kernel.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "dem_server/laws/linear_contact.hpp"
#include "dem_server/laws/pair_kinematics.hpp"
#include "dem_server/laws/parallel_bond.hpp"
#include "protocol/threads/vector_clones.hpp"

namespace adit::dem {
namespace {

// Plain, varied and intact bonds: Pairs::Kind. Intact contact bonds load no moment, which they do not
// transmit, and no contact, which does not act.
enum class Kind {
  kPlainContactBonds,
  kContactBonds,
  kPlainParallelBonds,
  kVariedParallelBonds,
  kParallelBonds,
  kBonds,
  kPlainContacts,
  kVariedContacts,
  kContacts
};

// The loop over a chunk. It becomes vector code only where all that it calls is inlined.
template <Kind kKind, bool kOneLaw, bool kDashpots>
struct Kernel {
  static constexpr bool kPlain = kKind == Kind::kPlainContactBonds || kKind == Kind::kPlainParallelBonds ||
                                 kKind == Kind::kPlainContacts;
  static constexpr bool kWeighted =
      !kPlain && kKind != Kind::kVariedParallelBonds && kKind != Kind::kVariedContacts;
  static constexpr bool kBond = kKind < Kind::kPlainContacts, kSomeBroken = kKind == Kind::kBonds;
  static constexpr bool kContact = kKind != Kind::kPlainContactBonds && kKind != Kind::kContactBonds;
  static constexpr bool kMoment = kBond && kContact;

  const double dt;
  const ChunkDiscs& discs;
  const ChunkLaws& laws;
  ChunkForces& out;
  const double *rest_length, *half_difference, *slack, *weight, *initial, *width;
  double *shear, *moment, *slide, *normal_dashpot, *shear_dashpot;
  std::int64_t breaks = 0, slides = 0;

  Kernel(std::uint32_t begin, double dt, const ChunkDiscs& discs, const ChunkLaws& laws, Pairs& pairs,
         ChunkForces& out)
      : dt(dt),
        discs(discs),
        laws(laws),
        out(out),
        rest_length(&pairs.rest_length[begin]),
        half_difference(&pairs.half_difference[begin]),
        slack(&pairs.slack[begin]),
        weight(&pairs.weight[begin]),
        initial(kBond ? &pairs.initial[begin] : nullptr),
        width(kBond ? &pairs.width[begin] : nullptr),
        shear(kBond ? &pairs.shear[begin] : nullptr),
        moment(kBond ? &pairs.moment[begin] : nullptr),
        slide(&pairs.slide[begin]),
        normal_dashpot(kDashpots ? &pairs.normal_dashpot[begin] : nullptr),
        shear_dashpot(kDashpots ? &pairs.shear_dashpot[begin] : nullptr) {}

  static double of_pair(const ChunkColumn& column, std::uint32_t k) { return column[kOneLaw ? 0 : k]; }

  [[gnu::always_inline]] PairKinematics kinematics(std::uint32_t k) const {
    const PairShape s = kBond ? bond_shape<Division::kShared>(discs.rest_x[k], discs.rest_y[k],
                                                              rest_length[k], discs.ux[k], discs.uy[k])
                              : contact_shape<Division::kShared>(discs.rest_x[k], discs.rest_y[k],
                                                                 rest_length[k], discs.ux[k], discs.uy[k]);
    const Arms arms = arms_of(s.length, half_difference[k]);
    const double stretch_rate = along(s.nx, s.ny, discs.vx[k], discs.vy[k]), half = 0.5 * dt * stretch_rate;
    const double slip_rate =
        mid_step_slip_rate(across(s.nx, s.ny, discs.vx[k], discs.vy[k]), half, half * s.inverse_length,
                           s.length, half_difference[k], discs.spin_sum[k], discs.turn_rate[k]);
    return {s.nx,        s.ny,         s.length,  s.elongation,      arms.first,
            arms.second, stretch_rate, slip_rate, discs.turn_rate[k]};
  }

  [[gnu::always_inline]] PairForces bond(std::uint32_t k, const PairKinematics& pair) {
    const double w = kMoment ? width[kPlain ? 0 : k] : 1.0;  // contact bonds have this width
    const BondSprings springs =
        springs_of_width(of_pair(laws.kn, k), of_pair(laws.ks, k), kMoment ? of_pair(laws.km, k) : 0, w);
    PairForces f = bond_forces(springs, pair, dt, shear[k], kMoment ? moment[k] : 0);
    if constexpr (!kMoment) f.moment = 0;
    if constexpr (kWeighted) f.normal += initial[k];
    if constexpr (kSomeBroken) {
      f.normal *= laws.intact[k];
      f.shear *= laws.intact[k];
      f.moment *= laws.intact[k];
    }
    shear[k] = f.shear;
    if constexpr (kMoment) moment[k] = f.moment;
    breaks |= static_cast<std::int64_t>(breaks_in_tension(f, w, kMoment ? of_pair(laws.moment_factor, k) : 0,
                                                          of_pair(laws.tensile_strength, k))) |
              static_cast<std::int64_t>(breaks_in_shear(f, w, of_pair(laws.cohesion, k),
                                                        kMoment ? of_pair(laws.tan_friction_angle, k) : 0.0));
    return f;
  }

  [[gnu::always_inline]] ContactForces contact(std::uint32_t k, const PairKinematics& pair) {
    const double gap = kPlain ? pair.elongation : pair.elongation + slack[k];
    const double acts = kSomeBroken ? laws.contact_acts[k] : 1.0;
    const LinearContact law{acts * of_pair(laws.contact_kn, k), of_pair(laws.contact_ks, k),
                            of_pair(laws.friction, k), of_pair(laws.normal_beta, k),
                            of_pair(laws.shear_beta, k)};
    const double before = slide[k];
    const ContactSprings springs = contact_springs(law, gap, pair.slip_rate, dt, before);
    slide[k] = springs.shear;
    const double friction =
        stiffness_times_friction_work(springs, before) * of_pair(laws.contact_compliance, k);
    slides |= static_cast<std::int64_t>(friction != 0);
    const double w = kWeighted ? weight[k] : 1.0;
    out.friction[k] = w * friction;
    ContactForces f{springs.normal, springs.shear};
    if constexpr (kDashpots) {
      const ContactForces by_dashpots = dashpots(k, pair, law, springs, acts * gap < 0);
      f.normal += by_dashpots.normal;
      f.shear += by_dashpots.shear;
    }
    return f;
  }

  [[gnu::always_inline]] ContactForces dashpots(std::uint32_t k, const PairKinematics& pair,
                                                const LinearContact& law, const ContactSprings& springs,
                                                bool touches) {
    const double inverse_mass = discs.inverse_mass[k];
    const double inverse_mass_t = inverse_slip_mass(inverse_mass, {pair.arm_1, pair.arm_2},
                                                    discs.inverse_inertia_1[k], discs.inverse_inertia_2[k]);
    const ContactForces both = with_dashpots(law, springs, touches, inverse_mass, inverse_mass_t,
                                             pair.stretch_rate, pair.slip_rate, dt);
    const ContactForces before{normal_dashpot[k], shear_dashpot[k]},
        now{both.normal - springs.normal, both.shear - springs.shear};
    const double w = kWeighted ? weight[k] : 1.0;
    out.dashpot[k] = w * dashpot_work(dt, before, now, pair.stretch_rate, pair.slip_rate);
    normal_dashpot[k] = now.normal;
    shear_dashpot[k] = now.shear;
    return now;
  }

  // Returns |N|, as bits.
  [[gnu::always_inline]] std::int64_t find(std::uint32_t k) {
    const PairKinematics pair = kinematics(k);
    PairForces f{0, 0, 0};
    if constexpr (kBond) f = bond(k, pair);
    if constexpr (kContact) {
      const ContactForces surfaces = contact(k, pair);
      f.normal += surfaces.normal;
      f.shear += surfaces.shear;
    }
    const double w = kWeighted ? weight[k] : 1.0;
    const PlaneVector force = vector_of(pair.nx, pair.ny, f.normal, f.shear);
    out.normal[k] = f.normal;
    out.x[k] = w * force.x;
    out.y[k] = w * force.y;
    out.moment_1[k] = w * (f.shear * pair.arm_1 + f.moment);
    out.moment_2[k] = w * (f.shear * pair.arm_2 - f.moment);
    return std::bit_cast<std::int64_t>(std::abs(f.normal));
  }
};

template <Kind kKind, bool kOneLaw, bool kDashpots>
ADIT_VECTOR_CLONES ChunkOutcome find_chunk(const Pairs::Chunk& chunk, double dt, const ChunkDiscs& discs,
                                           const ChunkLaws& laws, Pairs& pairs, ChunkForces& out) {
  Kernel<kKind, kOneLaw, kDashpots> kernel(chunk.begin, dt, discs, laws, pairs, out);
  const std::uint32_t count = chunk.end - chunk.begin;
  std::int64_t max_bits = 0;
#pragma GCC ivdep  // no pair writes what another one reads
  for (std::uint32_t k = 0; k < count; ++k) max_bits = std::max(max_bits, kernel.find(k));
  return {max_bits, kernel.breaks != 0, kernel.slides != 0};
}

template <Kind kKind, bool kDashpots>
ChunkOutcome find_of(const Pairs::Chunk& chunk, double dt, const ChunkDiscs& discs, const ChunkLaws& laws,
                     Pairs& pairs, ChunkForces& out) {
  const auto find = chunk.one_law ? find_chunk<kKind, true, kDashpots> : find_chunk<kKind, false, kDashpots>;
  return find(chunk, dt, discs, laws, pairs, out);
}

using Find = ChunkOutcome (*)(const Pairs::Chunk&, double, const ChunkDiscs&, const ChunkLaws&, Pairs&,
                              ChunkForces&);

template <bool kDashpots>
Find find_contacts_by(const Pairs::Chunk& chunk) {
  using Of = Pairs::Kind;
  if (chunk.kind == Of::kPlain) return find_chunk<Kind::kPlainContacts, true, kDashpots>;
  if (chunk.kind == Of::kVaried) return find_chunk<Kind::kVariedContacts, true, kDashpots>;
  return find_of<Kind::kContacts, kDashpots>;
}

Find find_by(const Pairs::Chunk& chunk, bool bonded, bool dashpots) {
  using Of = Pairs::Kind;
  if (!bonded) return dashpots ? find_contacts_by<true>(chunk) : find_contacts_by<false>(chunk);
  if (chunk.kind == Of::kGeneral)
    return dashpots ? find_of<Kind::kBonds, true> : find_of<Kind::kBonds, false>;
  if (!chunk.contacts_beside_bonds)
    return chunk.kind == Of::kPlain ? find_chunk<Kind::kPlainContactBonds, true, false>
                                    : find_of<Kind::kContactBonds, false>;
  if (dashpots) return find_of<Kind::kParallelBonds, true>;
  if (chunk.kind == Of::kPlain) return find_chunk<Kind::kPlainParallelBonds, true, false>;
  if (chunk.kind == Of::kVaried) return find_chunk<Kind::kVariedParallelBonds, true, false>;
  return find_of<Kind::kParallelBonds, false>;
}

}  // namespace

ChunkOutcome find_forces(const Pairs::Chunk& chunk, double dt, const ChunkDiscs& discs, const ChunkLaws& laws,
                         bool dashpots, Pairs& pairs, ChunkForces& out) {
  return find_by(chunk, pairs.bonded(), dashpots)(chunk, dt, discs, laws, pairs, out);
}

}  // namespace adit::dem
