#include "fdm_server/zones/laws/compacting_law.hpp"

#include "protocol/threads/vector_clones.hpp"

namespace adit::fdm {
namespace {

using Flags = std::array<std::int64_t, kBatch>;

// From one zone on: HalfCycle, ev at the last reversal, d(ev)/dW, ev.
struct Memory {
  double *t, *s, *from_t, *from_s, *far_t, *far_s, *distance, *largest, *before, *settled, *by_way,
      *compaction;

  [[gnu::always_inline]] HalfCycle half_cycle(std::uint32_t i) const {
    return {t[i], s[i], from_t[i], from_s[i], far_t[i], far_s[i], distance[i], largest[i], before[i]};
  }
};

[[gnu::always_inline]] inline bool any(const Flags& flags, std::uint32_t count) {
  std::int64_t all = 0;
  for (std::uint32_t i = 0; i < count; ++i) all |= flags[i];
  return all != 0;
}

// Says which strains are larger than any before, or reverse.
[[gnu::always_inline]] inline bool strain(const LawStep& step, const Memory& memory, Flags& turns) {
  const auto& [a0, a1, a2, a3] = step.areas;
  const auto& [t0, t1, t2, t3] = step.strains.difference;
  const auto& [s0, s1, s2, s3] = step.strains.shear;
  const Memory m = memory;
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < step.count; ++i) {
    const double by_area = 1 / ((a0[i] + a1[i]) + (a2[i] + a3[i]));
    m.t[i] += by_area * ((a0[i] * t0[i] + a1[i] * t1[i]) + (a2[i] * t2[i] + a3[i] * t3[i]));
    m.s[i] += by_area * ((a0[i] * s0[i] + a1[i] * s1[i]) + (a2[i] * s2[i] + a3[i] * s3[i]));
    const HalfCycle h = m.half_cycle(i);
    turns[i] = larger(h) | reverses(h);
  }
  return any(turns, step.count);
}

[[gnu::always_inline]] inline void reverse(std::uint32_t count, const Memory& memory, Flags& reversed) {
  const Memory m = memory;
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < count; ++i) {
    HalfCycle h = m.half_cycle(i), next = h;
    const bool turns = reverses(h);
    fdm::reverse(next);
    m.from_t[i] = turns ? next.from_t : h.from_t;
    m.from_s[i] = turns ? next.from_s : h.from_s;
    m.distance[i] = turns ? next.distance : h.distance;
    m.before[i] = turns ? next.before : h.before;
    m.settled[i] = turns ? m.compaction[i] : m.settled[i];
    m.largest[i] = larger(h) ? shear_size(h.t, h.s) : h.largest;
    reversed[i] = turns;
  }
}

// Says whether any amplitude grows.
[[gnu::always_inline]] inline bool advance(std::uint32_t count, const Memory& memory, BatchValues& lengths) {
  const Memory m = memory;
  Flags widens;
  double* length = lengths.data();
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < count; ++i) {
    HalfCycle h = m.half_cycle(i);
    const Way way = fdm::advance(h);
    m.far_t[i] = h.far_t;
    m.far_s[i] = h.far_s;
    m.distance[i] = h.distance;
    length[i] = way.length;
    widens[i] = way.widens;
  }
  return any(widens, count);
}

[[gnu::always_inline]] inline void find_compaction_by_way(std::uint32_t count, const Compaction& compaction,
                                                          const Memory& memory) {
  const Compaction law = compaction;
  const Memory m = memory;
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < count; ++i)
    m.by_way[i] = compaction_by_way(law, m.half_cycle(i), m.settled[i]);
}

// Memory of what seldom changes is written only where it does, for it costs as much to write as to read.
ADIT_VECTOR_CLONES void follow_batch(const LawStep& step, const Compaction& law, const Memory& memory,
                                     BatchValues& lengths) {
  Flags turns, reversed;
  bool changes = false;
  if (strain(step, memory, turns)) {
    reverse(step.count, memory, reversed);
    changes = any(reversed, step.count);
  }
  changes |= advance(step.count, memory, lengths);
  if (changes) find_compaction_by_way(step.count, law, memory);
}

ADIT_VECTOR_CLONES void compact_batch(const LawStep& step, double bulk, const BatchValues& lengths,
                                      const Memory& memory) {
  const auto& [a0, a1, a2, a3] = step.areas;
  const double *volume = step.strains.volume.data(), *length = lengths.data(), *by_way = memory.by_way;
  double *mean = step.stresses.mean, *across = step.stresses.across, *dissipated = step.dissipated,
         *compaction = memory.compaction;
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < step.count; ++i) {
    const double p = (2 * mean[i] + across[i]) * (1.0 / 3);
    const double dv = volume[i], expands = dv > 0 ? dv : 0;
    const double room = -(p + bulk * expands) / bulk,
                 most = room > 0 ? room : 0;  // until no pressure is left
    const double wanted = by_way[i] * length[i], growth = wanted < most ? wanted : most;
    compaction[i] += growth;
    mean[i] += bulk * growth;
    across[i] += bulk * growth;
    dissipated[i] -= ((a0[i] + a1[i]) + (a2[i] + a3[i])) * (p + 0.5 * bulk * (growth + dv)) * growth;
  }
}

}  // namespace

void CompactingLaw::advance(const LawStep& step) {
  if (counts_) {
    const auto of = [&](Field which) { return field(which, step.first); };
    const Memory memory{of(kT),        of(kS),       of(kFromT),  of(kFromS),   of(kFarT),  of(kFarS),
                        of(kDistance), of(kLargest), of(kBefore), of(kSettled), of(kByWay), of(kCompaction)};
    BatchValues lengths;
    follow_batch(step, compaction_, memory, lengths);
    compact_batch(step, elasticity_.bulk, lengths, memory);
  }
  law_->advance(step);
}

// Strains turn as stresses do (zone_kernels.hpp).
void CompactingLaw::turn(std::size_t first, std::uint32_t count, const HalfTurns& turns) {
  for (const auto& [of_t, of_s] : {std::pair{kT, kS}, std::pair{kFromT, kFromS}, std::pair{kFarT, kFarS}}) {
    double *t = field(of_t, first), *s = field(of_s, first);
    for (std::uint32_t i = 0; i < count; ++i) {
      const double before = t[i];
      t[i] = turns.cosine[i] * before - turns.sine[i] * s[i];
      s[i] = turns.sine[i] * before + turns.cosine[i] * s[i];
    }
  }
}

}  // namespace adit::fdm
