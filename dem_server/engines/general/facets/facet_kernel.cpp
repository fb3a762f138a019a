#include "dem_server/engines/general/facets/facet_kernel.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "dem_server/engines/general/facets/worn_step.hpp"
#include "dem_server/engines/general/pairs/lanes.hpp"
#include "protocol/kernels/sums.hpp"
#include "protocol/threads/vector_clones.hpp"

namespace adit::dem {
namespace {

constexpr double kSmallTurn = 0.1;  // [rad] up to which the series below have all digits

// x - x^3 / 3! + …, and x^2 / 2! - x^4 / 4! + …, by reciprocals because divisions are slow.
inline double small_sine(double x) {
  constexpr double k3 = 1.0 / 6, k5 = 1.0 / 20, k7 = 1.0 / 42, k9 = 1.0 / 72;
  const double q = x * x;
  return x * (1 - q * k3 * (1 - q * k5 * (1 - q * k7 * (1 - q * k9))));
}
inline double small_versine(double x) {
  constexpr double k2 = 0.5, k4 = 1.0 / 12, k6 = 1.0 / 30, k8 = 1.0 / 56, k10 = 1.0 / 90;
  const double q = x * x;
  return q * k2 * (1 - q * k4 * (1 - q * k6 * (1 - q * k8 * (1 - q * k10))));
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

constexpr std::uint32_t kAtATime = 128;  // facets: what is known of them stays in the first cache
using Column = std::array<double, kAtATime>;

// Consecutive ones.
ADIT_VECTOR_CLONES void look_up_cells(std::size_t begin, std::size_t count, const double* ux,
                                      const double* uy, const double* sine, const double* versine,
                                      FacetWork::CellMotion* to) {
  std::size_t k = 0;
  for (; k + 4 <= count; k += 4) {
    const std::size_t i = begin + k;
    Four rows[4] = {four(ux + i), four(uy + i), four(sine + i), four(versine + i)};
    turn(rows);
    for (std::size_t lane = 0; lane < 4; ++lane) store(rows[lane], &to[k + lane].ux);
  }
  for (; k < count; ++k) to[k] = {ux[begin + k], uy[begin + k], sine[begin + k], versine[begin + k]};
}

// What the loop over facets wants of their cells (Turns).
struct TurnColumns {
  alignas(64) Column dx, dy, sine_1, versine_1, sine_2, versine_2;
};

// The last few facets may be fewer than four, and any cell stands for the others.
ADIT_VECTOR_CLONES void look_up(const std::uint32_t* first, const std::uint32_t* second, std::uint32_t count,
                                const FacetWork::CellMotion* cells, TurnColumns& out) {
  const auto look_up_four = [&](std::uint32_t k, const std::uint32_t* of_first,
                                const std::uint32_t* of_second) __attribute__((always_inline)) {
    Four a[4], b[4];
    for (std::uint32_t lane = 0; lane < 4; ++lane) {
      a[lane] = four(&cells[of_first[lane]].ux);
      b[lane] = four(&cells[of_second[lane]].ux);
    }
    turn(a);
    turn(b);
    store(b[0] - a[0], &out.dx[k]);
    store(b[1] - a[1], &out.dy[k]);
    store(a[2], &out.sine_1[k]);
    store(a[3], &out.versine_1[k]);
    store(b[2], &out.sine_2[k]);
    store(b[3], &out.versine_2[k]);
  };
  std::uint32_t k = 0;
  for (; k + 4 <= count; k += 4) look_up_four(k, first + k, second + k);
  if (k == count) return;
  std::array<std::uint32_t, 4> last_first{}, last_second{};
  std::copy(first + k, first + count, last_first.begin());
  std::copy(second + k, second + count, last_second.begin());
  look_up_four(k, last_first.data(), last_second.data());
}

// A / h (r . De) of facets for both of their cells.
struct SpreadColumns {
  alignas(64) Column first, second;
};

// Of the places begin … begin + count - 1.
template <bool kPlain>
ADIT_VECTOR_CLONES void find_jumps(std::uint32_t begin, std::uint32_t count, const TurnColumns& of,
                                   const FacetPatch& patch, FacetWork& work, SpreadColumns& spreads) {
  const double *rest_nx = &patch.nx[begin], *rest_ny = &patch.ny[begin], *half = &patch.half_distance[begin],
               *skew = &patch.skew[begin], *length = &patch.length[begin];
  const auto column = [begin](const std::vector<double>& values) {
    return kPlain ? nullptr : values.data() + begin;
  };
  const double *start_n = column(patch.start_n), *start_t = column(patch.start_t),
               *start_turn = column(patch.start_turn), *share_1 = column(patch.share_1),
               *share_2 = column(patch.share_2);
  double *jump_n = &work.jump_n[begin], *jump_t = &work.jump_t[begin], *turn = &work.turn[begin],
         *nx = &work.nx[begin], *ny = &work.ny[begin], *cosine = &work.cosine[begin];
  const auto turns_at = [&](std::uint32_t k) __attribute__((always_inline)) {
    return Turns{of.dx[k], of.dy[k], of.sine_1[k], of.versine_1[k], of.sine_2[k], of.versine_2[k]};
  };
  const auto keep = [&](std::uint32_t k, FacetMotion m) __attribute__((always_inline)) {
    if constexpr (!kPlain) {
      m.jump_n -= start_n[k];
      m.jump_t -= start_t[k];
      m.turn -= start_turn[k];
    }
    jump_n[k] = m.jump_n;
    jump_t[k] = m.jump_t;
    turn[k] = m.turn;
    nx[k] = m.nx;
    ny[k] = m.ny;
    cosine[k] = m.cosine;
    const auto [first, second] = spread_of(length[k], skew[k], m.jump_n, m.jump_t);
    spreads.first[k] = kPlain ? first : share_1[k] * first;
    spreads.second[k] = kPlain ? second : share_2[k] * second;
  };
  std::int64_t far = 0;
#pragma GCC ivdep
  for (std::uint32_t k = 0; k < count; ++k) {
    const Turns turns = turns_at(k);
    const double square = square_of_sum(turns);
    far |= static_cast<std::int64_t>(is_far_turned(square));
    keep(k, motion_of(rest_nx[k], rest_ny[k], half[k], skew[k], turns, square, inverse_if_near(square)));
  }
  if (far == 0) return;
  for (std::uint32_t k = 0; k < count; ++k)
    if (const Turns turns = turns_at(k); is_far_turned(square_of_sum(turns)))
      keep(k, motion_of(rest_nx[k], rest_ny[k], half[k], skew[k], turns));
}

inline constexpr double kBeyond = 1 + 1e-12;  // rounding of a traction that was scaled back

// The strengths of a law as the loop below asks for them.
struct Strengths {
  double tensile, inverse_full, cohesion_beyond, friction;  // 1 / (kFullCohesion f_t), c - f_t
};
[[gnu::always_inline]] inline Strengths strengths_of(const FacetLaw& law) {
  return {law.tensile_strength, 1 / (kFullCohesion * law.tensile_strength),
          law.cohesion - law.tensile_strength, law.friction};
}

// Whether a point that was never beyond its strength is now (laws/facet.hpp with chi = 1).
[[gnu::always_inline]] inline bool exceeds(const Strengths& law, double sigma, double shear) {
  const double pressure = -sigma, closed = std::min(1.0, pressure * law.inverse_full);
  const double limit = law.tensile + law.cohesion_beyond * closed + pressure * law.friction;
  const bool open = sigma > 0;
  const double found = open ? sigma * sigma + shear * shear : shear;
  const double most = open ? law.tensile * law.tensile : limit;
  return found > most * kBeyond;
}

// Some facets side by side: columns of a patch and of what was found of it.
struct FacetChunk {
  std::uint32_t count;
  const std::uint32_t *number, *first, *second;  // number: in the set
  const double *half_distance, *skew, *length, *stiffness;
  const double *jump_n, *jump_t, *turn, *nx, *ny, *cosine;
  // Null where the patch is plain.
  const double *start_n, *start_t, *start_turn, *rest_n, *rest_t, *share_1, *share_2, *weight;
};

// What they do; N, unweighted; 1 where a point is beyond its strength, else 0.
struct ActionColumns {
  alignas(64) Column x, y, moment_1, moment_2, normal, beyond;
};

// Returns 0 where no point is beyond its strength.
template <bool kPlain, bool kOneLaw>
ADIT_VECTOR_CLONES std::int64_t find_elastic_actions(const FacetChunk& of, const double* pressure,
                                                     const Strengths* strengths, ActionColumns& out) {
  const FacetChunk f = of;
  const Strengths only = strengths[0];
  std::int64_t exceeding = 0;
#pragma GCC ivdep
  for (std::uint32_t k = 0; k < f.count; ++k) {
    const Strengths law = kOneLaw ? only : strengths[k];
    const double p_1 = kPlain ? pressure[f.first[k]] : f.share_1[k] * pressure[f.first[k]],
                 p_2 = kPlain ? pressure[f.second[k]] : f.share_2[k] * pressure[f.second[k]];
    const double w = kPlain ? 1 : f.weight[k], share = kPlain ? 1 : 1 / w;
    double n = f.jump_n[k], t = f.jump_t[k], half_turn = 0.5 * f.turn[k];
    double sigma = f.stiffness[k] * n + 0.5 * share * (p_1 + p_2),
           tau = f.stiffness[k] * t + share * f.skew[k] * (p_1 - p_2);
    const double bending =
        f.stiffness[k] * f.turn[k] * f.length[k] * kFacetPoint;  // between the middle and a point
    if constexpr (!kPlain) {
      sigma += f.rest_n[k];
      tau += f.rest_t[k];
      n += f.start_n[k];
      t += f.start_t[k];
      half_turn += 0.5 * f.start_turn[k];
    }
    // The point that is pressed less is the weaker one: pressure makes no cohesion and friction smaller.
    const double worse = sigma + std::abs(bending), beyond = exceeds(law, worse, std::abs(tau)) ? 1.0 : 0.0;
    out.beyond[k] = beyond;
    exceeding |= std::bit_cast<std::int64_t>(beyond);
    const double normal = f.length[k] * sigma, shear = f.length[k] * tau,
                 moment = kFacetPoint * f.length[k] * f.length[k] * bending;
    const FacetAction a = action_of(f.half_distance[k], f.skew[k], f.cosine[k], half_turn, n, t, normal,
                                    shear, moment, f.nx[k], f.ny[k]);
    out.x[k] = w * a.x;
    out.y[k] = w * a.y;
    out.moment_1[k] = w * a.moment_1;
    out.moment_2[k] = w * a.moment_2;
    out.normal[k] = normal;
  }
  return exceeding;
}

std::int64_t find_actions(const FacetChunk& of, const FacetPatch& patch, const FacetSet& set,
                          const double* pressure, ActionColumns& out) {
  std::array<Strengths, kAtATime> strengths;
  if (patch.one_law)
    strengths[0] = strengths_of(set.laws[patch.first_law]);
  else
    for (std::uint32_t k = 0; k < of.count; ++k) strengths[k] = strengths_of(set.laws[set.law[of.number[k]]]);
  if (patch.plain && patch.one_law)
    return find_elastic_actions<true, true>(of, pressure, strengths.data(), out);
  const auto find = patch.plain     ? find_elastic_actions<true, false>
                    : patch.one_law ? find_elastic_actions<false, true>
                                    : find_elastic_actions<false, false>;
  return find(of, pressure, strengths.data(), out);
}

bool cracks(const WornFacet& worn) {
  return !worn.cracked &&
         (worn.parted || std::min(worn.ends[0].point.wear, worn.ends[1].point.wear) >= kCracked);
}

bool has_opened(const WornFacet& worn) {
  const auto& [left, right] = worn.ends;
  return left.point.opening + right.point.opening > std::abs(left.point.slip) + std::abs(right.point.slip);
}

// A step of one that is worn; the result is told of it.
void wear(const WornStep& step, double pressure_1, double pressure_2, const FacetSet& set, WornFacet& worn,
          FacetResult& result) {
  const double released = worn.released();
  step.add(pressure_1, pressure_2, worn);
  if (step.parts(worn)) {
    worn.parted = true;
    result.any_parted = true;
  }
  // 2 E = S (C + s M)^-1 S for the cells' sums S, whose pressures are p = (C + s M)^-1 S: a change of s takes
  // half of p_before M p, exactly.
  const double now = step.difference(pressure_1, pressure_2), before = worn.begun ? worn.difference : now;
  worn.difference = now;
  const double dissipated = step.find(worn);
  result.fracture +=
      set.weight[worn.facet] * (dissipated + step.uneven_energy(before * now, worn.released() - released));
  if (!cracks(worn)) return;
  worn.cracked = true;
  worn.opened = has_opened(worn);
  if (set.laws[set.law[worn.facet]].joined) result.cracked.push_back(worn.facet);
}

ADIT_VECTOR_CLONES std::int64_t largest_size(const double* values, std::uint32_t count) {
  std::int64_t largest = 0;
  for (std::uint32_t k = 0; k < count; ++k)
    largest = std::max(largest, std::bit_cast<std::int64_t>(std::abs(values[k])));
  return largest;
}

ADIT_VECTOR_CLONES void add_to_cells(const FacetChunk& f, const ActionColumns& actions, double* sums) {
  add_to_sums<kDiscValues>(f.count, f.first, f.second, actions.x.data(), actions.y.data(),
                           actions.moment_1.data(), actions.moment_2.data(), sums);
}

void add_spreads(std::size_t count, const std::uint32_t* first, const std::uint32_t* second,
                 const SpreadColumns& spreads, double* as_first, double* as_second) {
  for (std::size_t k = 0; k < count; ++k) {
    as_first[first[k]] += spreads.first[k];
    as_second[second[k]] += spreads.second[k];
  }
}

ADIT_VECTOR_CLONES void scale_sums(std::size_t count, const double* factor, const double* as_first,
                                   const double* as_second, double* scaled) {
#pragma GCC ivdep
  for (std::size_t i = 0; i < count; ++i) scaled[i] = factor[i] * (as_first[i] + as_second[i]);
}

std::uint32_t count_at(std::uint32_t at, std::uint32_t end) {
  return std::min(kAtATime, end - at);
}

// All of one patch in one step.
class PatchStep {
 public:
  PatchStep(const FacetPatch& patch, FacetSet& set, FacetWork& work)
      : patch_(patch), set_(set), work_(work), worn_(set.worn[patch.begin / kBlock]) {
    const auto grow = [](auto& values, std::size_t size) {
      if (values.size() < size) values.resize(size);
    };
    for (auto* column : {&work.jump_n, &work.jump_t, &work.turn, &work.nx, &work.ny, &work.cosine})
      grow(*column, patch.size());
    for (auto* column : {&work.as_first, &work.as_second, &work.pressure, &work.released})
      grow(*column, patch.places());
    grow(work.cells, patch.places());
  }

  // And what they give the areas of cells.
  void find_jumps(std::span<const double> ux, std::span<const double> uy) const {
    const double *sine = set_.sine.data(), *versine = set_.versine.data();
    look_up_cells(patch_.begin, patch_.cells, ux.data(), uy.data(), sine, versine, work_.cells.data());
    FacetWork::CellMotion* reached = &work_.cells[kBlock];
    for (const std::uint32_t i : patch_.reached) *reached++ = {ux[i], uy[i], sine[i], versine[i]};
    for (auto* of_cells : {&work_.as_first, &work_.as_second, &work_.released})
      std::fill_n(of_cells->begin(), patch_.places(), 0.0);
    TurnColumns turns;
    SpreadColumns spreads;
    const auto find = patch_.plain ? dem::find_jumps<true> : dem::find_jumps<false>;
    for (std::uint32_t at = 0; at < patch_.size(); at += kAtATime) {
      const std::uint32_t count = count_at(at, patch_.size());
      const std::uint32_t *first = &patch_.first[at], *second = &patch_.second[at];
      look_up(first, second, count, work_.cells.data(), turns);
      find(at, count, turns, patch_, work_, spreads);
      if (set_.any_worn) spread_worn(at, count, spreads);
      add_spreads(count, first, second, spreads, work_.as_first.data(), work_.as_second.data());
    }
  }

  // Of the cells whose facets the patch has all: those of the block and their neighbours.
  void find_pressures() const {
    scale_sums(patch_.places(), patch_.bulk.data(), work_.as_first.data(), work_.as_second.data(),
               work_.pressure.data());
    if (set_.any_worn) release();
    std::copy_n(work_.pressure.begin(), patch_.cells, set_.pressure.begin() + patch_.begin);
  }

  // What the facets of the block do.
  void act(bool internal_force, double* sums, FacetResult& result) const {
    ActionColumns actions;
    auto before = worn_.begin();
    std::int64_t largest = 0;
    for (std::uint32_t at = patch_.own_begin; at < patch_.own_end; at += kAtATime) {
      const FacetChunk chunk = chunk_at(at, count_at(at, patch_.own_end));
      const std::int64_t exceeding = find_actions(chunk, patch_, set_, work_.pressure.data(), actions);
      if (exceeding != 0 || (before != worn_.end() && before->facet <= chunk.number[chunk.count - 1]))
        for (std::uint32_t k = 0; k < chunk.count; ++k) {
          if (before != worn_.end() && before->facet == chunk.number[k])
            result.worn.push_back(*before++);
          else if (actions.beyond[k] != 0)
            result.worn.push_back({.facet = chunk.number[k]});
          else
            continue;
          wear_at(chunk, k, result.worn.back(), actions, result);
        }
      add_to_cells(chunk, actions, sums);
      if (internal_force)
        result.internal_force += protocol::sum_of_sizes(std::span(actions.x).first(chunk.count),
                                                        std::span(actions.y).first(chunk.count));
      const std::int64_t of_chunk = largest_size(actions.normal.data(), chunk.count);
      if (of_chunk <= largest) continue;
      largest = of_chunk;
      std::uint32_t k = 0;
      while (std::bit_cast<std::int64_t>(std::abs(actions.normal[k])) != largest) ++k;
      result.strongest = chunk.number[k];
    }
    result.max_normal = std::bit_cast<double>(largest);
  }

  // What those of other blocks do, which these blocks account.
  void act_incoming(double* sums) const {
    ActionColumns actions;
    Packed packed;
    const auto all = static_cast<std::uint32_t>(patch_.incoming.size());
    for (std::uint32_t at = 0; at < all; at += kAtATime) {
      const FacetChunk chunk = pack(std::span(patch_.incoming).subspan(at, count_at(at, all)), packed);
      const std::int64_t exceeding = find_actions(chunk, patch_, set_, work_.pressure.data(), actions);
      if (exceeding != 0 || set_.any_worn)
        for (std::uint32_t k = 0; k < chunk.count; ++k) {
          const WornFacet* before = set_.worn_facet(chunk.number[k]);
          if (!before && actions.beyond[k] == 0) continue;
          WornFacet worn = before ? *before : WornFacet{.facet = chunk.number[k]};
          FacetResult unread;
          wear_at(chunk, k, worn, actions, unread);
        }
      add_to_cells(chunk, actions, sums);
    }
  }

 private:
  // Columns of facets that are not side by side.
  struct Packed {
    std::array<std::uint32_t, kAtATime> number, first, second;
    std::array<Column, 18> values;
  };

  FacetMotion motion_at(std::uint32_t place) const {
    return {work_.jump_n[place], work_.jump_t[place], work_.turn[place],
            work_.nx[place],     work_.ny[place],     work_.cosine[place]};
  }
  static FacetMotion motion_at(const FacetChunk& f, std::uint32_t k) {
    return {f.jump_n[k], f.jump_t[k], f.turn[k], f.nx[k], f.ny[k], f.cosine[k]};
  }

  // Spreads of the facets that are worn, of which a copy takes the step: it is taken again once the cells'
  // areas are known.
  void spread_worn(std::uint32_t begin, std::uint32_t count, SpreadColumns& spreads) const {
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::uint32_t place = begin + k, facet = patch_.facets[place];
      const WornFacet* before = set_.worn_facet(facet);
      if (!before) continue;
      WornFacet worn = *before;
      const WornStep step(facet, motion_at(place), set_);
      step.find(worn);
      const auto [first, second] = step.spread(worn);
      spreads.first[k] = first;
      spreads.second[k] = second;
      const auto [released_1, released_2] = step.released(worn);
      work_.released[patch_.first[place]] += released_1;
      work_.released[patch_.second[place]] += released_2;
    }
  }

  void release() const {
    for (std::size_t place = 0; place < patch_.places(); ++place)
      work_.pressure[place] /= 1 + patch_.bulk[place] * work_.released[place];
  }

  void wear_at(const FacetChunk& chunk, std::uint32_t k, WornFacet& worn, ActionColumns& actions,
               FacetResult& result) const {
    const WornStep step(worn.facet, motion_at(chunk, k), set_);
    wear(step, work_.pressure[chunk.first[k]], work_.pressure[chunk.second[k]], set_, worn, result);
    const FacetAction a = step.act(worn);
    actions.x[k] = a.x;
    actions.y[k] = a.y;
    actions.moment_1[k] = a.moment_1;
    actions.moment_2[k] = a.moment_2;
    actions.normal[k] = step.normal(worn);
  }

  // The columns of a chunk, in its order.
  std::array<const std::vector<double>*, 18> columns() const {
    return {&patch_.half_distance, &patch_.skew,    &patch_.length,     &patch_.stiffness, &work_.jump_n,
            &work_.jump_t,         &work_.turn,     &work_.nx,          &work_.ny,         &work_.cosine,
            &patch_.start_n,       &patch_.start_t, &patch_.start_turn, &patch_.rest_n,    &patch_.rest_t,
            &patch_.share_1,       &patch_.share_2, &patch_.weight};
  }

  FacetChunk chunk_at(std::uint32_t at, std::uint32_t count) const {
    const auto all = columns();
    return chunk_of(count, &patch_.facets[at], &patch_.first[at], &patch_.second[at],
                    [&](std::size_t c) { return all[c]->data() + at; });
  }

  FacetChunk pack(std::span<const std::uint32_t> places, Packed& to) const {
    for (std::size_t k = 0; k < places.size(); ++k) {
      to.number[k] = patch_.facets[places[k]];
      to.first[k] = patch_.first[places[k]];
      to.second[k] = patch_.second[places[k]];
    }
    const auto all = columns();
    for (std::size_t c = 0; c < (patch_.plain ? kOfPlain : all.size()); ++c)
      for (std::size_t k = 0; k < places.size(); ++k) to.values[c][k] = (*all[c])[places[k]];
    return chunk_of(static_cast<std::uint32_t>(places.size()), to.number.data(), to.first.data(),
                    to.second.data(), [&](std::size_t c) { return to.values[c].data(); });
  }

  static constexpr std::size_t kOfPlain = 10;

  template <class ColumnAt>
  FacetChunk chunk_of(std::uint32_t count, const std::uint32_t* number, const std::uint32_t* first,
                      const std::uint32_t* second, ColumnAt at) const {
    const auto varied = [&](std::size_t c) { return patch_.plain ? nullptr : at(c); };
    return {count,      number,     first,      second,     at(0),      at(1),     at(2),      at(3),
            at(4),      at(5),      at(6),      at(7),      at(8),      at(9),     varied(10), varied(11),
            varied(12), varied(13), varied(14), varied(15), varied(16), varied(17)};
  }

  const FacetPatch& patch_;
  FacetSet& set_;
  FacetWork& work_;
  const std::vector<WornFacet>& worn_;
};

}  // namespace

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

void add_facet_forces(const FacetPatch& patch, std::span<const double> ux, std::span<const double> uy,
                      bool internal_force, FacetSet& set, FacetWork& work, BlockDiscs& discs,
                      FacetResult& result) {
  result.max_normal = result.fracture = result.internal_force = 0;
  result.cracked.clear();
  result.any_parted = false;
  result.worn.clear();
  if (patch.size() == 0) return;
  const PatchStep step(patch, set, work);
  step.find_jumps(ux, uy);
  step.find_pressures();
  discs.make_room(patch.reached.size());
  step.act(internal_force, discs.sums(), result);
  step.act_incoming(discs.sums());
}

FacetMotion motion_of(std::uint32_t k, std::span<const double> ux, std::span<const double> uy,
                      const FacetSet& set) {
  const std::uint32_t i = set.first[k], j = set.second[k];
  FacetMotion motion =
      motion_of(set.nx[k], set.ny[k], set.half_distance[k], set.skew[k],
                {ux[j] - ux[i], uy[j] - uy[i], set.sine[i], set.versine[i], set.sine[j], set.versine[j]});
  motion.jump_n -= set.start_n[k];
  motion.jump_t -= set.start_t[k];
  motion.turn -= set.start_turn[k];
  return motion;
}

FacetAction action_of(std::uint32_t k, const FacetMotion& motion, const FacetSet& set) {
  const WornStep step(k, motion, set);
  if (const WornFacet* worn = set.worn_facet(k)) return step.act(*worn);
  WornFacet elastic{.facet = k};
  step.add(set.pressure[set.first[k]], set.pressure[set.second[k]], elastic);
  const double length = set.length[k], stiffness = set.stiffness[k];
  return step.action(length * (stiffness * motion.jump_n + elastic.added_n),
                     length * (stiffness * motion.jump_t + elastic.added_t),
                     stiffness * motion.turn * length * length * length / 12);
}

}  // namespace adit::dem
