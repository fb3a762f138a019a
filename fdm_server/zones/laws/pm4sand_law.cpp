#include "fdm_server/zones/laws/pm4sand_law.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

#include "protocol/threads/vector_clones.hpp"

namespace adit::fdm {
namespace {

// That of the secant modulus at a shear strain of about 4e-4.
constexpr double kShareOfModulus = 0.5;

Material frictional(const Elasticity& e) {
  const double young = 9 * e.bulk * e.shear / (3 * e.bulk + e.shear);
  Material material{0, young, young / (2 * e.shear) - 1};
  material.mohr_coulomb.emplace(Strength{0, std::asin(kPm4SandSine), 0, 0});
  return material;
}

// Strains stand where stresses do: means over zones then are found alike.
ConstStressView view(const StrainBatch& strains) {
  ConstStressView view{strains.volume.data(), nullptr, {}, {}};
  for (std::size_t k = 0; k < 4; ++k) {
    view.difference[k] = strains.difference[k].data();
    view.shear[k] = strains.shear[k].data();
  }
  return view;
}
ConstStressView constant(const StressView& stresses) {
  ConstStressView view{stresses.mean, stresses.across, {}, {}};
  std::ranges::copy(stresses.difference, view.difference.begin());
  std::ranges::copy(stresses.shear, view.shear.begin());
  return view;
}

// Of the mean over zones, with p, t and s positive in compression.
struct MeanStresses {
  alignas(64) BatchValues pressure, t, s;
};
MeanStresses compressive(std::uint32_t count, const PlaneStresses& means) {
  MeanStresses result;
  for (std::uint32_t i = 0; i < count; ++i) {
    result.pressure[i] = -means.mean[i];
    result.t[i] = -means.difference[i];
    result.s[i] = -means.shear[i];
  }
  return result;
}

// Adds half the work of the stresses on the strains, and `sense` times what they store.
ADIT_VECTOR_CLONES void book(const LawStep& step, const double* modulus, double sense, BatchValues& energy) {
  const auto& [a0, a1, a2, a3] = step.areas;
  const auto& [d0, d1, d2, d3] = step.strains.difference;
  const auto& [g0, g1, g2, g3] = step.strains.shear;
  const auto [t0, t1, t2, t3] = step.stresses.difference;
  const auto [s0, s1, s2, s3] = step.stresses.shear;
  const double *volume = step.strains.volume.data(), *mean = step.stresses.mean;
  double* sum = energy.data();
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < step.count; ++i) {
    const double area = (a0[i] + a1[i]) + (a2[i] + a3[i]);
    const double squared =
        (a0[i] * (t0[i] * t0[i] + s0[i] * s0[i]) + a1[i] * (t1[i] * t1[i] + s1[i] * s1[i])) +
        (a2[i] * (t2[i] * t2[i] + s2[i] * s2[i]) + a3[i] * (t3[i] * t3[i] + s3[i] * s3[i]));
    const double work = (a0[i] * (t0[i] * d0[i] + s0[i] * g0[i]) + a1[i] * (t1[i] * d1[i] + s1[i] * g1[i])) +
                        (a2[i] * (t2[i] * d2[i] + s2[i] * g2[i]) + a3[i] * (t3[i] * d3[i] + s3[i] * g3[i]));
    sum[i] += 0.5 * (area * mean[i] * volume[i] + work) +
              sense * area * stored_energy(mean[i], squared / area, modulus[i]);
  }
}

// The means have gone from `before` to `after` under the mean strains. The points follow; `stiffness`: of
// what they differ.
ADIT_VECTOR_CLONES void spread(const LawStep& step, const PlaneStresses& before, const PlaneStresses& strains,
                               const MeanStresses& after, const double* stiffness) {
  const auto& [d0, d1, d2, d3] = step.strains.difference;
  const auto& [g0, g1, g2, g3] = step.strains.shear;
  const auto [t0, t1, t2, t3] = step.stresses.difference;
  const auto [s0, s1, s2, s3] = step.stresses.shear;
  const double *t = before.difference.data(), *s = before.shear.data(), *d = strains.difference.data(),
               *g = strains.shear.data(), *p_to = after.pressure.data(), *t_to = after.t.data(),
               *s_to = after.s.data();
  double *mean = step.stresses.mean, *across = step.stresses.across;
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < step.count; ++i) {
    const auto of_t = [&](double stress, double strain) {
      return (stress - t[i]) + stiffness[i] * (strain - d[i]);
    };
    const auto of_s = [&](double stress, double strain) {
      return (stress - s[i]) + stiffness[i] * (strain - g[i]);
    };
    const double u0 = of_t(t0[i], d0[i]), u1 = of_t(t1[i], d1[i]), u2 = of_t(t2[i], d2[i]),
                 u3 = of_t(t3[i], d3[i]);
    const double v0 = of_s(s0[i], g0[i]), v1 = of_s(s1[i], g1[i]), v2 = of_s(s2[i], g2[i]),
                 v3 = of_s(s3[i], g3[i]);
    const double most = std::max(std::max(u0 * u0 + v0 * v0, u1 * u1 + v1 * v1),
                                 std::max(u2 * u2 + v2 * v2, u3 * u3 + v3 * v3));
    const double limit = kPm4SandSine * p_to[i], size = std::sqrt(most);
    const double factor = limit < size ? limit / size : 1;
    t0[i] = factor * u0 - t_to[i];
    t1[i] = factor * u1 - t_to[i];
    t2[i] = factor * u2 - t_to[i];
    t3[i] = factor * u3 - t_to[i];
    s0[i] = factor * v0 - s_to[i];
    s1[i] = factor * v1 - s_to[i];
    s2[i] = factor * v2 - s_to[i];
    s3[i] = factor * v3 - s_to[i];
    const double ratio = mean[i] < 0 ? across[i] / mean[i] : 1;
    mean[i] = -p_to[i];
    across[i] = -ratio * p_to[i];
  }
}

}  // namespace

Pm4SandLaw::Pm4SandLaw(const Elasticity& statics, const Pm4Sand& sand, std::size_t zones)
    : ZoneLaw(statics),
      sand_(sand),
      statics_(std::in_place, frictional(statics), zones, false),
      memory_(zones) {}

void Pm4SandLaw::advance(const LawStep& step) {
  if (statics_) return statics_->advance(step);
  PlaneStresses before, strains;
  mean_stresses(step.count, step.areas, constant(step.stresses), before);
  mean_stresses(step.count, step.areas, view(step.strains), strains);
  MeanStresses stress = compressive(step.count, before);
  for (std::uint32_t i = 0; i < step.count; ++i)
    if (!has_begun(step.first + i)) {
      Pm4SandStress own{stress.pressure[i], {stress.t[i], stress.s[i]}};
      take_up(step.first + i, own);
      stress.pressure[i] = own.pressure;
      stress.t[i] = own.shear.t;
      stress.s[i] = own.shear.s;
    }
  const MeanStresses strain = compressive(step.count, strains);
  double* now = &memory_.at(kModulus, step.first);
  BatchValues energy{};
  book(step, now, 1, energy);
  Pm4SandPoints points{step.count,
                       strain.pressure.data(),
                       strain.t.data(),
                       strain.s.data(),
                       stress.pressure.data(),
                       stress.t.data(),
                       stress.s.data(),
                       {}};
  for (std::size_t n = 0; n < kPm4SandFields; ++n) points.state[n] = &memory_.at(n, step.first);
  fdm::advance(sand_, points, reconsolidates_);
  spread(step, before, strains, stress, &memory_.at(kStiffness, step.first));
  book(step, now, -1, energy);
  for (std::uint32_t i = 0; i < step.count; ++i) step.dissipated[i] += energy[i];
}

void Pm4SandLaw::take_up(std::size_t zone, Pm4SandStress& stress) {
  const auto fields = std::bit_cast<std::array<double, kPm4SandFields>>(begin(sand_, stress));
  for (std::size_t n = 0; n < kPm4SandFields; ++n) memory_.at(n, zone) = fields[n];
  memory_.at(kStiffness, zone) = kShareOfModulus * memory_.at(kModulus, zone);
}

// Vectors turn as stresses do (zone_kernels.hpp).
void Pm4SandLaw::turn(std::size_t first, std::uint32_t count, const HalfTurns& turns) {
  for (std::size_t n = 0; n < 2 * kPm4SandVectors; n += 2) {
    double *t = &memory_.at(n, first), *s = &memory_.at(n + 1, first);
    for (std::uint32_t i = 0; i < count; ++i) {
      const double was = t[i];
      t[i] = turns.cosine[i] * was - turns.sine[i] * s[i];
      s[i] = turns.sine[i] * was + turns.cosine[i] * s[i];
    }
  }
}

void Pm4SandLaw::exchange(state::Archive& archive) {
  bool in_time = !statics_;
  archive("in time", in_time);
  if (in_time) begin_time();
  if (statics_) statics_->exchange(archive);
  memory_.exchange(archive);
}

void Pm4SandLaw::find_energies(std::size_t first, std::uint32_t count, const PointValues& areas,
                               const ConstStressView& stresses, BatchValues& energies) const {
  if (statics_) return statics_->find_energies(first, count, areas, stresses, energies);
  PlaneStresses means;
  mean_stresses(count, areas, stresses, means);
  for (std::uint32_t i = 0; i < count; ++i) {
    Pm4SandStress mean{-means.mean[i], {-means.difference[i], -means.shear[i]}};
    const double modulus =
        has_begun(first + i) ? memory_.at(kModulus, first + i) : begin(sand_, mean).shear_modulus;
    energies[i] = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const double t = stresses.difference[k][i], s = stresses.shear[k][i];
      energies[i] += areas[k][i] * stored_energy(stresses.mean[i], t * t + s * s, modulus);
    }
  }
}

}  // namespace adit::fdm
