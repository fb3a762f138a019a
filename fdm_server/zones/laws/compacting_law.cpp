#include "fdm_server/zones/laws/compacting_law.hpp"

#include "protocol/threads/vector_clones.hpp"

namespace adit::fdm {
namespace {

// From one zone on.
struct HalfCycleView {
  double *t, *s, *from_t, *from_s, *far_t, *far_s, *largest, *before;
};

struct WayBatch {
  BatchValues& length;
  alignas(64) std::array<std::int64_t, kBatch> reverses, changes;  // changes: the compaction by way
};

// Says whether any changes.
ADIT_VECTOR_CLONES bool follow_batch(const LawStep& step, const HalfCycleView& cycles, WayBatch& way) {
  const auto& [a0, a1, a2, a3] = step.areas;
  const auto& [t0, t1, t2, t3] = step.strains.difference;
  const auto& [s0, s1, s2, s3] = step.strains.shear;
  double* length = way.length.data();
  const auto [t, s, from_t, from_s, far_t, far_s, largest, before] = cycles;
  std::int64_t *reverses = way.reverses.data(), *changes = way.changes.data();
  const std::uint32_t count = step.count;
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < count; ++i) {
    const double by_area = 1 / ((a0[i] + a1[i]) + (a2[i] + a3[i]));
    HalfCycle h{t[i], s[i], from_t[i], from_s[i], far_t[i], far_s[i], largest[i], before[i]};
    const Way of_zone =
        follow(by_area * ((a0[i] * t0[i] + a1[i] * t1[i]) + (a2[i] * t2[i] + a3[i] * t3[i])),
               by_area * ((a0[i] * s0[i] + a1[i] * s1[i]) + (a2[i] * s2[i] + a3[i] * s3[i])), h);
    t[i] = h.t;
    s[i] = h.s;
    from_t[i] = h.from_t;
    from_s[i] = h.from_s;
    far_t[i] = h.far_t;
    far_s[i] = h.far_s;
    largest[i] = h.largest;
    before[i] = h.before;
    length[i] = of_zone.length;
    reverses[i] = of_zone.reverses;
    changes[i] = of_zone.reverses | of_zone.widens;
  }
  std::int64_t any = 0;
  for (std::uint32_t i = 0; i < count; ++i) any |= changes[i];
  return any != 0;
}

ADIT_VECTOR_CLONES void compact_batch(const LawStep& step, double bulk, const BatchValues& way,
                                      const double* by_way, double* compaction) {
  const auto& [a0, a1, a2, a3] = step.areas;
  const double *volume = step.strains.volume.data(), *length = way.data();
  double *mean = step.stresses.mean, *across = step.stresses.across, *dissipated = step.dissipated;
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
    BatchValues way;
    follow_strains(step, way);
    compact(step, way);
  }
  law_->advance(step);
}

HalfCycle CompactingLaw::half_cycle(std::size_t zone) const {
  return {memory_.at(kT, zone),       memory_.at(kS, zone),     memory_.at(kFromT, zone),
          memory_.at(kFromS, zone),   memory_.at(kFarT, zone),  memory_.at(kFarS, zone),
          memory_.at(kLargest, zone), memory_.at(kBefore, zone)};
}

void CompactingLaw::follow_strains(const LawStep& step, BatchValues& length) {
  WayBatch way{length, {}, {}};
  const std::size_t first = step.first;
  if (!follow_batch(step,
                    {field(kT, first), field(kS, first), field(kFromT, first), field(kFromS, first),
                     field(kFarT, first), field(kFarS, first), field(kLargest, first), field(kBefore, first)},
                    way))
    return;
  for (std::uint32_t i = 0; i < step.count; ++i) {
    if (!way.changes[i]) continue;
    const std::size_t zone = first + i;
    if (way.reverses[i]) memory_.at(kSettled, zone) = memory_.at(kCompaction, zone);
    memory_.at(kByWay, zone) = compaction_by_way(compaction_, half_cycle(zone), memory_.at(kSettled, zone));
  }
}

void CompactingLaw::compact(const LawStep& step, const BatchValues& way) {
  compact_batch(step, elasticity_.bulk, way, field(kByWay, step.first), field(kCompaction, step.first));
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
