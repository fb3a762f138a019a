#include "fdm_server/zones/laws/element_kernels.hpp"

#include <cmath>
#include <limits>

#include "protocol/threads/vector_clones.hpp"

namespace adit::fdm {
namespace {

[[gnu::always_inline]] inline double inner(double t1, double s1, double z1, double t2, double s2, double z2) {
  return (t1 * t2 + s1 * s2) + 0.75 * (z1 * z2);
}

// t, s and z of the four points: strain before and now, what the elements flow in the step.
struct Flowing {
  alignas(64) std::array<GroupValues, kElementValues> before, now, flow;
};

// For von Mises the way back to the yield surface is radial.
[[gnu::always_inline]] inline void flow_at(std::size_t begin, std::size_t end, double stiffness, double limit,
                                           const GroupValues* before, const GroupValues* now, GroupValues* q,
                                           GroupValues* flow, GroupValues& twice, GroupValues& slack) {
#pragma GCC ivdep
  for (std::size_t l = begin; l < end; ++l) {
    const double qt = q[0][l], qs = q[4][l], qz = q[8][l];
    const double t = now[0][l] - qt, s = now[4][l] - qs, z = now[8][l] - qz;
    const double size = std::sqrt(inner(t, s, z, t, s, z));
    const bool yields = size > limit;
    const double ratio = yields ? limit / size : 1, rest = 1 - ratio;
    const double lt = rest * t, ls = rest * s, lz = rest * z;
    const double work = stiffness * inner((before[0][l] - qt) + ratio * t, (before[4][l] - qs) + ratio * s,
                                          (before[8][l] - qz) + ratio * z, lt, ls, lz);
    twice[l] += work > 0 ? work : 0;
    const double way = yields ? 0 : limit - size;
    slack[l] = way < slack[l] ? way : slack[l];
    q[0][l] = qt + lt;
    q[4][l] = qs + ls;
    q[8][l] = qz + lz;
    flow[0][l] += stiffness * lt;
    flow[4][l] += stiffness * ls;
    flow[8][l] += stiffness * lz;
  }
}

template <bool kWhole>
[[gnu::always_inline]] inline void advance_lanes(const ElementTable& elements, const GroupState& state,
                                                 GroupStep& step) {
  const std::size_t begin = kWhole ? 0 : step.begin, end = kWhole ? kGroup : step.end;
  GroupValues& path = *state.path;
  Flowing f;
  for (auto& values : f.flow) values.fill(0);
  for (auto& values : step.twice) values.fill(0);
  for (std::size_t c = 0; c < kElementValues; ++c) {
    const std::size_t of = c < 8 ? c : 8;  // points share z
    for (std::size_t l = begin; l < end; ++l) {
      f.before[c][l] = state.strain[of][l];
      f.now[c][l] = f.before[c][l] + step.growth[of][l];
    }
  }
  for (std::size_t c = 0; c < 9; ++c)
    for (std::size_t l = begin; l < end; ++l) state.strain[c][l] = f.now[c][l];
#pragma GCC ivdep
  for (std::size_t l = begin; l < end; ++l) {
    const auto squared = [&](std::size_t k) {
      return step.growth[k][l] * step.growth[k][l] + step.growth[4 + k][l] * step.growth[4 + k][l];
    };
    const auto larger = [](double a, double b) { return a > b ? a : b; };
    const double most = larger(larger(squared(0), squared(1)), larger(squared(2), squared(3)));
    path[l] += std::sqrt(most + 0.75 * (step.growth[8][l] * step.growth[8][l]));
  }
  const std::size_t next_group = kElementValues * kElementBlock * elements.blocks;
  for (std::size_t b = 0; b < elements.blocks; ++b) {
    GroupValues& wakes = state.wakes[b];
    bool sleeps = true;
    for (std::size_t l = begin; l < end; ++l) sleeps = sleeps & (wakes[l] > path[l]);
    if (sleeps) continue;
    GroupValues slack;
    slack.fill(std::numeric_limits<double>::infinity());
    for (std::size_t i = kElementBlock * b; i < kElementBlock * (b + 1); ++i)
      for (std::size_t k = 0; k < 4; ++k) {
        GroupValues* q = state.flows + kElementValues * i + k;
        // The next group will need the same elements, which lie too far away for the processor to guess.
        for (std::size_t c = 0; c < 3; ++c) __builtin_prefetch(q + 4 * c + next_group, 1);
        flow_at(begin, end, elements.stiffness[i], elements.limit[i], &f.before[k], &f.now[k], q, &f.flow[k],
                step.twice[k], slack);
      }
    for (std::size_t l = begin; l < end; ++l) wakes[l] = path[l] + slack[l];
  }
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t l = begin; l < end; ++l) {
      step.across[k][l] = step.growth[8][l] - f.flow[8 + k][l];
      step.growth[k][l] -= f.flow[k][l];
      step.growth[4 + k][l] -= f.flow[4 + k][l];
    }
}

}  // namespace

ADIT_VECTOR_CLONES void advance_group(const ElementTable& elements, const GroupState& state,
                                      GroupStep& step) {
  if (step.begin == 0 && step.end == kGroup)
    advance_lanes<true>(elements, state, step);
  else
    advance_lanes<false>(elements, state, step);
}

ADIT_VECTOR_CLONES void find_held(const ElementTable& elements, const GroupValues* strain,
                                  const GroupValues* flows, GroupHeld& held) {
  for (auto& values : held.stress) values.fill(0);
  for (auto& values : held.twice) values.fill(0);
  for (std::size_t i = 0; i < kElementBlock * elements.blocks; ++i) {
    const double g = elements.stiffness[i];
    for (std::size_t k = 0; k < 4; ++k) {
      const double *qt = flows[kElementValues * i + k].data(), *qs = flows[kElementValues * i + 4 + k].data(),
                   *qz = flows[kElementValues * i + 8 + k].data();
      const double *et = strain[k].data(), *es = strain[4 + k].data(), *ez = strain[8].data();
      double *of_t = held.stress[k].data(), *of_s = held.stress[4 + k].data(),
             *of_z = held.stress[8 + k].data(), *twice = held.twice[k].data();
#pragma GCC ivdep
      for (std::size_t l = 0; l < kGroup; ++l) {
        const double t = et[l] - qt[l], s = es[l] - qs[l], z = ez[l] - qz[l];
        of_t[l] += g * t;
        of_s[l] += g * s;
        of_z[l] += g * z;
        twice[l] += g * (t * t + s * s + 0.75 * (z * z));
      }
    }
  }
}

}  // namespace adit::fdm
