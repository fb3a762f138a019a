#include "dem_server/engines/general/facets/facet_kernel.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "dem_server/engines/general/pairs/lanes.hpp"
#include "protocol/threads/vector_clones.hpp"

namespace adit::dem {
namespace {

constexpr double kSmallTurn = 0.5;  // [rad] up to which the series below have all digits

// x - x^3 / 3! + …, and x^2 / 2! - x^4 / 4! + …, by reciprocals because divisions are slow.
inline double small_sine(double x) {
  constexpr double k3 = 1.0 / 6, k5 = 1.0 / 20, k7 = 1.0 / 42, k9 = 1.0 / 72, k11 = 1.0 / 110,
                   k13 = 1.0 / 156;
  const double q = x * x;
  return x * (1 - q * k3 * (1 - q * k5 * (1 - q * k7 * (1 - q * k9 * (1 - q * k11 * (1 - q * k13))))));
}
inline double small_versine(double x) {
  constexpr double k2 = 0.5, k4 = 1.0 / 12, k6 = 1.0 / 30, k8 = 1.0 / 56, k10 = 1.0 / 90, k12 = 1.0 / 132,
                   k14 = 1.0 / 182;
  const double q = x * x;
  return q * k2 * (1 - q * k4 * (1 - q * k6 * (1 - q * k8 * (1 - q * k10 * (1 - q * k12 * (1 - q * k14))))));
}

ADIT_VECTOR_CLONES bool turn_slightly(double dt, std::uint32_t begin, std::uint32_t end, const double* spin,
                                      double* turn, double* sine, double* versine) {
  std::int64_t far = 0;
#pragma GCC ivdep
  for (std::uint32_t i = begin; i < end; ++i) {
    turn[i] += dt * spin[i];
    far |= static_cast<std::int64_t>(!(std::abs(turn[i]) <= kSmallTurn));
    sine[i] = small_sine(turn[i]);
    versine[i] = small_versine(turn[i]);
  }
  return far == 0;
}

std::uint32_t end_of(std::uint32_t block, const FacetSet& set) {
  return static_cast<std::uint32_t>(std::min<std::size_t>((block + 1) * kFacetBlock, set.size()));
}

// The spreads of a facet's elastic jump in both cells.
struct Spread {
  double first, second;
};
[[gnu::always_inline]] inline Spread spread_of(double length, double skew, double n, double t) {
  const double straight = 0.5 * length * n, across = length * skew * t;
  return {straight + across, straight - across};
}

template <bool kPlain>
ADIT_VECTOR_CLONES void find_elastic_jumps(std::uint32_t begin, std::uint32_t end, const double* ux,
                                           const double* uy, const FacetSet& set, FacetMotion& motion) {
  const std::uint32_t *first = set.first.data(), *second = set.second.data();
  const double *sine = set.sine.data(), *versine = set.versine.data();
  const double *rest_nx = set.nx.data(), *rest_ny = set.ny.data(), *half = set.half_distance.data(),
               *skew = set.skew.data(), *length = set.length.data();
  const double *start_n = set.start_n.data(), *start_t = set.start_t.data(),
               *start_turn = set.start_turn.data();
  const double *share_1 = set.share_1.data(), *share_2 = set.share_2.data();
  double *jump_n = motion.jump_n.data(), *jump_t = motion.jump_t.data(), *turn = motion.turn.data();
  double *nx_now = motion.nx.data(), *ny_now = motion.ny.data(), *cosine = motion.cosine.data(),
         *spread = motion.spread.data();
#pragma GCC ivdep
  for (std::uint32_t k = begin; k < end; ++k) {
    const std::uint32_t i = first[k], j = second[k];
    const double s_1 = sine[i], v_1 = versine[i], s_2 = sine[j], v_2 = versine[j];
    const double nx = rest_nx[k], ny = rest_ny[k], h = half[k], e = 2 * h * skew[k];
    const double x_1 = h * nx - e * ny, y_1 = h * ny + e * nx, x_2 = -h * nx - e * ny, y_2 = -h * ny + e * nx;
    const double dx = (ux[j] - ux[i]) + ((v_1 * x_1 + s_1 * y_1) - (v_2 * x_2 + s_2 * y_2));
    const double dy = (uy[j] - uy[i]) + ((v_1 * y_1 - s_1 * x_1) - (v_2 * y_2 - s_2 * x_2));
    // The sum of both turned unit vectors is 2 cos(turn / 2) long.
    const double c = 2 - v_1 - v_2, s = s_1 + s_2, inverse = 1 / std::sqrt(c * c + s * s);
    const double mean_c = c * inverse, mean_s = s * inverse;
    const double mx = mean_c * nx - mean_s * ny, my = mean_c * ny + mean_s * nx;
    double n = dx * mx + dy * my, t = dy * mx - dx * my;
    double turned = 2 * inverse * (s_2 * (1 - v_1) - s_1 * (1 - v_2));
    if constexpr (!kPlain) {
      n -= start_n[k];
      t -= start_t[k];
      turned -= start_turn[k];
    }
    jump_n[k] = n;
    jump_t[k] = t;
    nx_now[k] = mx;
    ny_now[k] = my;
    turn[k] = turned;
    cosine[k] = 0.5 * (c * c + s * s) * inverse;
    const auto [spread_1, spread_2] = spread_of(length[k], skew[k], n, t);
    spread[2 * k] = kPlain ? spread_1 : share_1[k] * spread_1;
    spread[2 * k + 1] = kPlain ? spread_2 : share_2[k] * spread_2;
  }
}

// What a facet's forces do in the frame of n: on lever arms to the middle between where both cells have
// brought its middle.
struct Action {
  double x, y, moment_1, moment_2;
};
[[gnu::always_inline]] inline Action action_of(double half_distance, double skew, double cosine, double sine,
                                               double jump_n, double jump_t, double normal, double shear,
                                               double moment, double nx, double ny) {
  const double h = half_distance, e = 2 * h * skew;
  const double n_1 = cosine * h + sine * e + 0.5 * jump_n, t_1 = cosine * e - sine * h + 0.5 * jump_t;
  const double n_2 = -cosine * h - sine * e - 0.5 * jump_n, t_2 = cosine * e - sine * h - 0.5 * jump_t;
  return {normal * nx - shear * ny, normal * ny + shear * nx, n_1 * shear - t_1 * normal + moment,
          t_2 * normal - n_2 * shear - moment};
}

inline constexpr double kBeyond = 1 + 1e-12;  // rounding of a traction that was scaled back

// The strengths of a law as the loop below asks for them.
struct Strengths {
  double tensile, inverse_tensile, cohesion_beyond, friction;  // c - f_t
};
[[gnu::always_inline]] inline Strengths strengths_of(const FacetLaw& law) {
  return {law.tensile_strength, 1 / law.tensile_strength, law.cohesion - law.tensile_strength, law.friction};
}

// Whether a point that was never beyond its strength is now (laws/facet.hpp with chi = 1).
[[gnu::always_inline]] inline bool exceeds(const Strengths& law, double sigma, double shear) {
  const double pressure = -sigma, closed = std::min(1.0, pressure * law.inverse_tensile);
  const double limit = law.tensile + law.cohesion_beyond * closed + pressure * law.friction;
  const bool open = sigma > 0;
  const double found = open ? sigma * sigma + shear * shear : shear;
  const double most = open ? law.tensile * law.tensile : limit;
  return found > most * kBeyond;
}

template <bool kPlain, bool kOneLaw>
ADIT_VECTOR_CLONES std::int64_t find_elastic_actions(std::uint32_t begin, std::uint32_t end,
                                                     const FacetSet& set, const Strengths* strengths,
                                                     FacetMotion& motion, double* beyond) {
  const std::uint32_t *first = set.first.data(), *second = set.second.data();
  const double *half = set.half_distance.data(), *skew = set.skew.data(), *length = set.length.data(),
               *stiffness = set.stiffness.data(), *weight = set.weight.data(), *rest_n = set.rest_n.data(),
               *rest_t = set.rest_t.data();
  const double *start_n = set.start_n.data(), *start_t = set.start_t.data(),
               *start_turn = set.start_turn.data();
  const double *jump_n = motion.jump_n.data(), *jump_t = motion.jump_t.data(), *turn = motion.turn.data(),
               *nx = motion.nx.data(), *ny = motion.ny.data(), *cosine = motion.cosine.data(),
               *pressure = motion.pressure.data();
  const double *share_1 = set.share_1.data(), *share_2 = set.share_2.data();
  double* actions = motion.actions.data();
  const Strengths only = strengths[0];
  std::int64_t largest = 0;
#pragma GCC ivdep
  for (std::uint32_t k = begin; k < end; ++k) {
    const Strengths law = kOneLaw ? only : strengths[k - begin];
    const double p_1 = kPlain ? pressure[first[k]] : share_1[k] * pressure[first[k]],
                 p_2 = kPlain ? pressure[second[k]] : share_2[k] * pressure[second[k]];
    const double w = kPlain ? 1 : weight[k], share = kPlain ? 1 : 1 / w;
    double n = jump_n[k], t = jump_t[k], half_turn = 0.5 * turn[k];
    double sigma = stiffness[k] * n + 0.5 * share * (p_1 + p_2),
           tau = stiffness[k] * t + share * skew[k] * (p_1 - p_2);
    const double bending =
        stiffness[k] * turn[k] * length[k] * kFacetPoint;  // between the middle and a point
    if constexpr (!kPlain) {
      sigma += rest_n[k];
      tau += rest_t[k];
      n += start_n[k];
      t += start_t[k];
      half_turn += 0.5 * start_turn[k];
    }
    const double size = std::abs(bending), shear_size = std::abs(tau);
    const bool one = exceeds(law, sigma + size, shear_size), other = exceeds(law, sigma - size, shear_size);
    beyond[k - begin] = (one ? 1.0 : 0.0) + (other ? 1.0 : 0.0);
    const double normal = length[k] * sigma, shear = length[k] * tau,
                 moment = kFacetPoint * length[k] * length[k] * bending;
    const Action a =
        action_of(half[k], skew[k], cosine[k], half_turn, n, t, normal, shear, moment, nx[k], ny[k]);
    actions[4 * k] = w * a.x;
    actions[4 * k + 1] = w * a.y;
    actions[4 * k + 2] = w * a.moment_1;
    actions[4 * k + 3] = w * a.moment_2;
    largest = std::max(largest, std::bit_cast<std::int64_t>(std::abs(normal)));
  }
  return largest;
}

// By the laws of a block's facets.
template <bool kPlain>
std::int64_t find_elastic_actions(std::uint32_t begin, std::uint32_t end, const FacetSet& set,
                                  FacetMotion& motion, double* beyond) {
  std::array<Strengths, kFacetBlock> strengths;
  strengths[0] = strengths_of(set.laws[set.law[begin]]);
  if (set.laws.size() == 1)
    return find_elastic_actions<kPlain, true>(begin, end, set, strengths.data(), motion, beyond);
  for (std::uint32_t k = begin; k < end; ++k) strengths[k - begin] = strengths_of(set.laws[set.law[k]]);
  return find_elastic_actions<kPlain, false>(begin, end, set, strengths.data(), motion, beyond);
}

// The whole law of a facet that is worn.
class WornStep {
 public:
  WornStep(std::uint32_t facet, const FacetSet& set, FacetMotion& motion)
      : set_(set),
        motion_(motion),
        k_(facet),
        law_(set.laws[set.law[facet]]),
        stiffness_(set.stiffness[facet]) {}

  // What the cells' areas add now.
  void add(WornFacet& worn) const {
    const double p_1 = set_.share_1[k_] * motion_.pressure[set_.first[k_]],
                 p_2 = set_.share_2[k_] * motion_.pressure[set_.second[k_]], share = 1 / set_.weight[k_];
    worn.added_n = 0.5 * share * (p_1 + p_2) + set_.rest_n[k_];
    worn.added_t = share * set_.skew[k_] * (p_1 - p_2) + set_.rest_t[k_];
  }

  // Tractions at both points; returns what was dissipated [J].
  double find(WornFacet& worn) const {
    const double jump_n = motion_.jump_n[k_] + worn.added_n / stiffness_,
                 jump_t = motion_.jump_t[k_] + worn.added_t / stiffness_;
    const double half = set_.length[k_] / 2;
    double dissipated = 0;
    for (int e = 0; e < 2; ++e) {
      WornFacet::End& end = worn.ends[e];
      const double at = (e == 0 ? 1 : -1) * kFacetPoint * set_.length[k_];
      const double n = jump_n - at * motion_.turn[k_];
      const auto [sigma, tau] =
          worn.parted ? FacetTraction{0, 0} : facet_traction(law_, stiffness_, n, jump_t, end.point);
      if (!worn.begun) {
        end.normal = sigma;
        end.shear = tau;
      }
      const double lost_n = n - sigma / stiffness_, lost_t = jump_t - tau / stiffness_;
      // The work on what is lost, less what an open point stores of it because it unloads towards its origin.
      dissipated +=
          half * 0.5 *
          ((end.normal + sigma) * (lost_n - end.lost_n) + (end.shear + tau) * (lost_t - end.lost_t) -
           (std::max(sigma, 0.0) * lost_n - std::max(end.normal, 0.0) * end.lost_n));
      end.normal = sigma;
      end.shear = tau;
      end.lost_n = lost_n;
      end.lost_t = lost_t;
    }
    worn.begun = true;
    return dissipated;
  }

  // As far as it is elastic, of tractions that are known.
  Spread spread(const WornFacet& worn) const {
    const double n = 0.5 * (worn.ends[0].normal + worn.ends[1].normal) - worn.added_n,
                 t = 0.5 * (worn.ends[0].shear + worn.ends[1].shear) - worn.added_t;
    const auto [first, second] = spread_of(set_.length[k_], set_.skew[k_], n / stiffness_, t / stiffness_);
    return {set_.share_1[k_] * first, set_.share_2[k_] * second};
  }

  bool parts(const WornFacet& worn) const {
    return worn.cracked && !worn.parted &&
           std::max(std::abs(motion_.jump_t[k_]), motion_.jump_n[k_]) > set_.length[k_] / 2;
  }

  void act(const WornFacet& worn) const {
    const double length = set_.length[k_], half = length / 2, w = set_.weight[k_];
    const double normal = half * (worn.ends[0].normal + worn.ends[1].normal),
                 shear = half * (worn.ends[0].shear + worn.ends[1].shear),
                 moment = half * kFacetPoint * length * (worn.ends[1].normal - worn.ends[0].normal);
    const Action a = action_of(set_.half_distance[k_], set_.skew[k_], motion_.cosine[k_],
                               0.5 * (motion_.turn[k_] + set_.start_turn[k_]),
                               motion_.jump_n[k_] + set_.start_n[k_], motion_.jump_t[k_] + set_.start_t[k_],
                               normal, shear, moment, motion_.nx[k_], motion_.ny[k_]);
    double* to = &motion_.actions[4 * std::size_t{k_}];
    to[0] = w * a.x;
    to[1] = w * a.y;
    to[2] = w * a.moment_1;
    to[3] = w * a.moment_2;
  }

 private:
  const FacetSet& set_;
  FacetMotion& motion_;
  std::uint32_t k_;
  const FacetLaw& law_;
  double stiffness_;
};

// Adds those that are beyond their strength for the first time, in their order.
void wear(std::uint32_t begin, std::span<const double> beyond, std::vector<WornFacet>& worn) {
  if (worn.empty() && std::ranges::all_of(beyond, [](double points) { return points == 0; })) return;
  const auto before = static_cast<std::ptrdiff_t>(worn.size());
  std::ptrdiff_t next = 0;
  for (std::uint32_t m = 0; m < beyond.size(); ++m) {
    if (next < before && worn[static_cast<std::size_t>(next)].facet == begin + m)
      ++next;
    else if (beyond[m] != 0)
      worn.push_back({.facet = begin + m});
  }
  std::ranges::inplace_merge(worn, worn.begin() + before, {}, &WornFacet::facet);
}

bool cracks(const WornFacet& worn) {
  return !worn.cracked && std::min(worn.ends[0].point.wear, worn.ends[1].point.wear) >= kCracked;
}

bool has_opened(const WornFacet& worn) {
  const auto& [left, right] = worn.ends;
  return left.point.opening + right.point.opening > std::abs(left.point.slip) + std::abs(right.point.slip);
}

double largest_normal(std::uint32_t begin, std::uint32_t end, const FacetSet& set,
                      const FacetMotion& motion) {
  double largest = 0;
  for (std::uint32_t k = begin; k < end; ++k)
    if (const double normal = std::abs(normal_force(k, set, motion)); !(normal <= largest)) largest = normal;
  return largest;
}

}  // namespace

double normal_force(std::uint32_t facet, const FacetSet& set, const FacetMotion& motion) {
  const double* action = &motion.actions[4 * std::size_t{facet}];
  return (action[0] * motion.nx[facet] + action[1] * motion.ny[facet]) / set.weight[facet];
}

void turn_cells(double dt, std::uint32_t begin, std::uint32_t end, std::span<const double> spin,
                FacetSet& set) {
  if (turn_slightly(dt, begin, end, spin.data(), set.turn.data(), set.sine.data(), set.versine.data()))
    return;
  for (std::uint32_t i = begin; i < end; ++i) {
    const double half = std::sin(set.turn[i] / 2);
    set.sine[i] = std::sin(set.turn[i]);
    set.versine[i] = 2 * half * half;
  }
}

void find_jumps(std::uint32_t block, std::span<const double> ux, std::span<const double> uy,
                const FacetSet& set, FacetMotion& motion) {
  const auto find = set.plain ? find_elastic_jumps<true> : find_elastic_jumps<false>;
  find(block * kFacetBlock, end_of(block, set), ux.data(), uy.data(), set, motion);
  for (WornFacet worn : set.worn[block]) {  // copies: the law is asked again once the cells' areas are known
    const WornStep step(worn.facet, set, motion);
    step.find(worn);
    const auto [first, second] = step.spread(worn);
    motion.spread[2 * std::size_t{worn.facet}] = first;
    motion.spread[2 * std::size_t{worn.facet} + 1] = second;
  }
}

void find_pressures(std::uint32_t begin, std::uint32_t end, const FacetSet& set, FacetMotion& motion) {
  for (std::uint32_t i = begin; i < end; ++i) {
    double sum = 0;
    for (std::uint32_t k = set.first_starts[i]; k < set.first_starts[i + 1]; ++k) sum += motion.spread[2 * k];
    for (std::uint32_t m = set.second_starts[i]; m < set.second_starts[i + 1]; ++m)
      sum += motion.spread[2 * set.as_second[m] + 1];
    motion.pressure[i] = set.bulk[i] * sum;
  }
}

void find_actions(std::uint32_t block, FacetSet& set, FacetMotion& motion, FacetResult& result) {
  const std::uint32_t begin = block * kFacetBlock, end = end_of(block, set);
  std::array<double, kFacetBlock> beyond;
  const auto find = set.plain ? find_elastic_actions<true> : find_elastic_actions<false>;
  const std::int64_t largest = find(begin, end, set, motion, beyond.data());
  result.fracture = 0;
  result.cracked.clear();
  result.parted.clear();
  std::vector<WornFacet>& worn = set.worn[block];
  wear(begin, std::span(beyond).first(end - begin), worn);
  for (WornFacet& one : worn) {
    const WornStep step(one.facet, set, motion);
    step.add(one);
    if (step.parts(one)) {
      one.parted = true;
      result.parted.push_back(one.facet);
    }
    result.fracture += set.weight[one.facet] * step.find(one);
    step.act(one);
    if (!cracks(one)) continue;
    one.cracked = true;
    one.opened = has_opened(one);
    if (set.laws[set.law[one.facet]].joined) result.cracked.push_back(one.facet);
  }
  result.max_normal = worn.empty() ? std::bit_cast<double>(largest) : largest_normal(begin, end, set, motion);
}

void gather_actions(std::uint32_t begin, std::uint32_t end, const FacetSet& set, const FacetMotion& motion,
                    double* fx, double* fy, double* moment) {
  const double* actions = motion.actions.data();
  for (std::uint32_t i = begin; i < end; ++i) {
    Four as_first{}, as_second{};
    for (std::uint32_t k = set.first_starts[i]; k < set.first_starts[i + 1]; ++k)
      as_first += four(&actions[4 * k]);
    for (std::uint32_t m = set.second_starts[i]; m < set.second_starts[i + 1]; ++m)
      as_second += four(&actions[4 * std::size_t{set.as_second[m]}]);
    fx[i] += as_first[0] - as_second[0];
    fy[i] += as_first[1] - as_second[1];
    moment[i] += as_first[2] + as_second[3];
  }
}

}  // namespace adit::dem
