#include "fdm_server/zones/laws/reversal_kernels.hpp"

#include "protocol/threads/vector_clones.hpp"

namespace adit::fdm {
namespace {

// Products over a zone of the strain f1 before, f2 after, its increment, and the drift u, times its area.
struct Products {
  double f1_f2, f1_de, f2_de, f2_f2, f2_u, de_u, u_u;
};

[[gnu::always_inline]] inline void add(Products& p, double weight, double f1, double de, double u) {
  const double f2 = f1 + de;
  p.f1_f2 += weight * (f1 * f2);
  p.f1_de += weight * (f1 * de);
  p.f2_de += weight * (f2 * de);
  p.f2_f2 += weight * (f2 * f2);
  p.f2_u += weight * (f2 * u);
  p.de_u += weight * (de * u);
  p.u_u += weight * (u * u);
}

template <bool kNarrow>
[[gnu::always_inline]] inline bool stay(const PolylineView& line, std::uint32_t count,
                                        const PointValues& areas, const StrainBatch& strains,
                                        const InnerView& inner, Advanced& to) {
  const auto [t0, t1, t2, t3, s0, s1, s2, s3, z] = inner.strain;
  const auto [tu0, tu1, tu2, tu3, su0, su1, su2, su3, zu] = inner.drift;
  const double *a0 = areas[0].data(), *a1 = areas[1].data(), *a2 = areas[2].data(), *a3 = areas[3].data();
  const auto& [d0, d1, d2, d3] = strains.difference;
  const auto& [g0, g1, g2, g3] = strains.shear;
  const double *volumes = strains.volume.data(), *de[] = {d0.data(), d1.data(), d2.data(), d3.data(),
                                                          g0.data(), g1.data(), g2.data(), g3.data()};
  double *befores = to.before.data(), *afters = to.after.data(), *lost = to.dissipated.data();
  std::int64_t* leave = to.leaves.data();
  double* radii = inner.radius;
  const double *ends = inner.end, *shares = inner.share, *springs = inner.spring;
  const double elastic = line.end[0];
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < count; ++i) {
    const double area = (a0[i] + a1[i]) + (a2[i] + a3[i]);
    Products p{};
    const auto point = [&](double weight, double t, double dt, double tu, double s, double ds, double su) {
      add(p, weight, t, dt, tu);
      add(p, weight, s, ds, su);
    };
    point(a0[i], t0[i], de[0][i], tu0[i], s0[i], de[4][i], su0[i]);
    point(a1[i], t1[i], de[1][i], tu1[i], s1[i], de[5][i], su1[i]);
    point(a2[i], t2[i], de[2][i], tu2[i], s2[i], de[6][i], su2[i]);
    point(a3[i], t3[i], de[3][i], tu3[i], s3[i], de[7][i], su3[i]);
    add(p, 0.75 * area, z[i], (-2.0 / 3) * volumes[i], zu[i]);

    const double r1 = radii[i], r2 = sphere_radius(p.f2_u, area - p.u_u, p.f2_f2);
    const bool leaves = ((r2 < r1) & (r1 > elastic)) | (r2 > ends[i]);
    const std::int64_t piece1 = line.piece(r1), piece2 = line.piece(r2);
    const double slope1 = line.slope[piece1], slope2 = line.slope[piece2];
    const double intercept1 = line.intercept[piece1], intercept2 = line.intercept[piece2];
    const double moment1 = line.moment[piece1], moment2 = line.moment[piece2];
    const double over1 = r1 > 0 ? 1 / r1 : 0, over2 = r2 > 0 ? 1 / r2 : 0;
    // Twice the energy: of elements that touch before and after, then of those that begin to.
    double twice =
        intercept1 * ((p.f1_de * over1 + p.f2_de * over2) - 2 * p.de_u) +
        (((slope1 - slope2) * p.f1_f2 + (intercept2 - intercept1) * (p.f2_de * over2 - 2 * p.f2_u)) -
         (moment2 - moment1) * (area - p.u_u));
    double before = slope1 + intercept1 * over1, after = slope2 + intercept2 * over2;
    if constexpr (kNarrow) {
      const double stored1 = (1 - (line.share[piece1] + line.share_slope[piece1] * r1)) *
                             (intercept1 * r1 - moment1),
                   stored2 = (1 - (line.share[piece2] + line.share_slope[piece2] * r2)) *
                             (intercept2 * r2 - moment2);
      const double first_loading = ends[i] == kNoEnd ? 1 : 0;
      before = shares[i] * before + springs[i];
      after = shares[i] * after + springs[i];
      twice = shares[i] * twice + area * first_loading * (stored1 - stored2);
    }
    befores[i] = before;
    afters[i] = after;
    lost[i] = 0.5 * twice;
    leave[i] = leaves;
    radii[i] = leaves ? r1 : r2;
  }
  std::int64_t any = 0;
  for (std::uint32_t i = 0; i < count; ++i) any |= to.leaves[i];
  return any != 0;
}

// By how much the stress grows over a strain, which is taken to the end of the step.
[[gnu::always_inline]] inline double growth(double before, double after, bool leaves, double step,
                                            double& strain) {
  const double f1 = strain, f2 = leaves ? f1 : f1 + step;
  strain = f2;
  return leaves ? 0 : after * f2 - before * f1;
}

template <bool kTurned>
[[gnu::always_inline]] inline void grow_points(double modulus, std::uint32_t count,
                                               const StrainBatch& strains, const Advanced& by,
                                               const AxesView& axes, const InnerView& inner,
                                               const StressView& stresses) {
  const double *before = by.before.data(), *after = by.after.data();
  const double *cosine = axes.cosine, *sine = axes.sine;
  const std::int64_t* leaves = by.leaves.data();
  for (std::size_t k = 0; k < 4; ++k) {
    const double *d_step = strains.difference[k].data(), *s_step = strains.shear[k].data();
    double *d_strain = inner.strain[k], *s_strain = inner.strain[4 + k];
    double *difference = stresses.difference[k], *shear = stresses.shear[k];
#pragma GCC ivdep
    for (std::uint32_t i = 0; i < count; ++i) {
      const double d = growth(before[i], after[i], leaves[i] != 0, d_step[i], d_strain[i]);
      const double s = growth(before[i], after[i], leaves[i] != 0, s_step[i], s_strain[i]);
      difference[i] += modulus * (kTurned ? cosine[i] * d - sine[i] * s : d);
      shear[i] += modulus * (kTurned ? cosine[i] * s + sine[i] * d : s);
    }
  }
}

}  // namespace

ADIT_VECTOR_CLONES bool stay_on_piece(const PolylineView& line, std::uint32_t count, const PointValues& areas,
                                      const StrainBatch& strains, const InnerView& inner, Advanced& to) {
  return inner.share ? stay<true>(line, count, areas, strains, inner, to)
                     : stay<false>(line, count, areas, strains, inner, to);
}

ADIT_VECTOR_CLONES void grow(const Elasticity& elasticity, std::uint32_t count, const StrainBatch& strains,
                             const Advanced& by, const AxesView& axes, const InnerView& inner,
                             const StressView& stresses) {
  const double bulk = elasticity.bulk, modulus = elasticity.shear;
  const double *before = by.before.data(), *after = by.after.data(), *volume = strains.volume.data();
  const std::int64_t* leaves = by.leaves.data();
  double *mean = stresses.mean, *across = stresses.across, *strain = inner.strain[8];
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < count; ++i) {
    const double pressure = (2 * mean[i] + across[i]) * (1.0 / 3);
    const double z = growth(before[i], after[i], leaves[i] != 0, (-2.0 / 3) * volume[i], strain[i]);
    const double deviator = (across[i] - pressure) + modulus * z, now = pressure + bulk * volume[i];
    mean[i] = now - 0.5 * deviator;
    across[i] = now + deviator;
  }
  if (axes.cosine)
    grow_points<true>(modulus, count, strains, by, axes, inner, stresses);
  else
    grow_points<false>(modulus, count, strains, by, axes, inner, stresses);
}

}  // namespace adit::fdm
