#include "fdm_server/zones/batch/zone_kernels.hpp"

#include <cmath>
#include <limits>

#include "protocol/threads/vector_clones.hpp"

namespace adit::fdm {
namespace {

template <ZoneKind kKind>
[[gnu::always_inline]] inline void strains_of(std::uint32_t count, const ShapeBatch& shapes,
                                              const CornerVectors& moved, StrainBatch& strains) {
  const auto& [ux, uy] = moved;
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < count; ++i) {
    const double x02 = ux[0][i] - ux[2][i], x13 = ux[1][i] - ux[3][i], x23 = ux[2][i] - ux[3][i];
    const double y02 = uy[0][i] - uy[2][i], y13 = uy[1][i] - uy[3][i], y23 = uy[2][i] - uy[3][i];
    const double exx = shapes.x0[i] * x02 + shapes.x1[i] * x13, eyy = shapes.y0[i] * y02 + shapes.y1[i] * y13;
    const double gxy = (shapes.y0[i] * x02 + shapes.y1[i] * x13) + (shapes.x0[i] * y02 + shapes.x1[i] * y13);
    const double qx = (shapes.c0[i] * x02 + shapes.c1[i] * x13) + 0.5 * x23;
    const double qy = (shapes.c0[i] * y02 + shapes.c1[i] * y13) + 0.5 * y23;
    const auto point = [&](std::size_t k) {
      strains.difference[k][i] = (exx - eyy) + (shapes.gx[k][i] * qx - shapes.gy[k][i] * qy);
      if constexpr (kKind == ZoneKind::kMixedDiscretization)
        strains.shear[k][i] = gxy + (shapes.gy[k][i] * qx + shapes.gx[k][i] * qy);
      else
        strains.shear[k][i] = gxy;
    };
    strains.volume[i] = exx + eyy;
    point(0);
    point(1);
    point(2);
    point(3);
  }
}

template <ZoneKind kKind>
[[gnu::always_inline]] inline void forces_of(std::uint32_t count, const ShapeBatch& reference,
                                             const ShapeBatch& now, const ConstStressView& stresses,
                                             const double* weights, CornerForces& forces) {
  const double* mean = stresses.mean;
  const auto [t0, t1, t2, t3] = stresses.difference;
  const auto [s0, s1, s2, s3] = stresses.shear;
  const auto& area = reference.point_area;
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < count; ++i) {
    double t = 0, s = 0, hx = 0, hy = 0;  // over the zone; of the pattern
    const auto point = [&](std::size_t k, double t_k, double s_k) {
      const double at = area[k][i] * t_k, as = area[k][i] * s_k;
      t += at;
      s += as;
      hx += now.gx[k][i] * at;
      hy -= now.gy[k][i] * at;
      if constexpr (kKind == ZoneKind::kMixedDiscretization) {
        hx += now.gy[k][i] * as;
        hy += now.gx[k][i] * as;
      }
    };
    point(0, t0[i], s0[i]);
    point(1, t1[i], s1[i]);
    point(2, t2[i], s2[i]);
    point(3, t3[i], s3[i]);
    // The force on a point is minus the derivative of the energy.
    const double weight = -weights[i], p = reference.area[i] * mean[i];
    const double xx = weight * (p + t), yy = weight * (p - t), xy = weight * s, wx = weight * hx,
                 wy = weight * hy;
    const double fx0 = (now.x0[i] * xx + now.y0[i] * xy) + now.c0[i] * wx;
    const double fx1 = (now.x1[i] * xx + now.y1[i] * xy) + now.c1[i] * wx;
    const double fy0 = (now.y0[i] * yy + now.x0[i] * xy) + now.c0[i] * wy;
    const double fy1 = (now.y1[i] * yy + now.x1[i] * xy) + now.c1[i] * wy;
    forces.x[0][i] = fx0;
    forces.x[1][i] = fx1;
    forces.x[2][i] = 0.5 * wx - fx0;
    forces.x[3][i] = -0.5 * wx - fx1;
    forces.y[0][i] = fy0;
    forces.y[1][i] = fy1;
    forces.y[2][i] = 0.5 * wy - fy0;
    forces.y[3][i] = -0.5 * wy - fy1;
  }
}

template <ZoneKind kKind>
[[gnu::always_inline]] inline void shapes_of(std::uint32_t count, const DeformedCorners& corners,
                                             double behind, double factor, ShapeBatch& shapes) {
  const auto [x0, x1, x2, x3] = corners.x;
  const auto [y0, y1, y2, y3] = corners.y;
  const auto &u = corners.displacements, &d = corners.moved;
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto x = [&](std::size_t c, double from) { return (from + u.x[c][i]) - behind * d.x[c][i]; };
    const auto y = [&](std::size_t c, double from) { return (from + u.y[c][i]) - behind * d.y[c][i]; };
    SamplingShape shape = sampling_shape<kKind>({{x(0, x0[i]), x(1, x1[i]), x(2, x2[i]), x(3, x3[i])},
                                                 {y(0, y0[i]), y(1, y1[i]), y(2, y2[i]), y(3, y3[i])}},
                                                factor);
    shape.x0 = shape.area > 0 ? shape.x0 : std::numeric_limits<double>::quiet_NaN();
    shapes.set(i, shape);
  }
}

}  // namespace

ADIT_VECTOR_CLONES void find_strains(ZoneKind kind, std::uint32_t count, const ShapeBatch& shapes,
                                     const CornerVectors& moved, StrainBatch& strains) {
  if (kind == ZoneKind::kMixedDiscretization)
    strains_of<ZoneKind::kMixedDiscretization>(count, shapes, moved, strains);
  else
    strains_of<ZoneKind::kAssumedStrain>(count, shapes, moved, strains);
}

ADIT_VECTOR_CLONES void find_energies(std::uint32_t count, const Elasticity& elasticity,
                                      const PointValues& areas, const ConstStressView& stresses,
                                      BatchValues& energies) {
  const Elasticity elastic = elasticity;
  const double *mean = stresses.mean, *across = stresses.across;
  double* sum = energies.data();
  for (std::uint32_t i = 0; i < count; ++i) sum[i] = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const double *area = areas[k].data(), *difference = stresses.difference[k], *shear = stresses.shear[k];
#pragma GCC ivdep
    for (std::uint32_t i = 0; i < count; ++i)
      sum[i] +=
          area[i] * elastic_energy(elastic, solid_stress({mean[i], difference[i], shear[i], across[i]}));
  }
}

ADIT_VECTOR_CLONES void mean_stresses(std::uint32_t count, const PointValues& areas,
                                      const ConstStressView& stresses, PlaneStresses& means) {
  const double *a0 = areas[0].data(), *a1 = areas[1].data(), *a2 = areas[2].data(), *a3 = areas[3].data();
  const auto [t0, t1, t2, t3] = stresses.difference;
  const auto [s0, s1, s2, s3] = stresses.shear;
  const double* mean = stresses.mean;
  double *p = means.mean.data(), *t = means.difference.data(), *s = means.shear.data();
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < count; ++i) {
    const double by_area = 1 / ((a0[i] + a1[i]) + (a2[i] + a3[i]));
    p[i] = mean[i];
    t[i] = by_area * ((a0[i] * t0[i] + a1[i] * t1[i]) + (a2[i] * t2[i] + a3[i] * t3[i]));
    s[i] = by_area * ((a0[i] * s0[i] + a1[i] * s1[i]) + (a2[i] * s2[i] + a3[i] * s3[i]));
  }
}

// With sxx = p + t and syy = p - t.
ADIT_VECTOR_CLONES void stress_sizes(std::uint32_t count, const PlaneStresses& stresses, BatchValues& sizes) {
  const double *p = stresses.mean.data(), *t = stresses.difference.data(), *s = stresses.shear.data();
  double* size = sizes.data();
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < count; ++i)
    size[i] = std::sqrt(2 * (p[i] * p[i] + t[i] * t[i] + s[i] * s[i]));
}

ADIT_VECTOR_CLONES void add_elastic(std::uint32_t count, const Elasticity& elasticity,
                                    const StrainBatch& strains, const StressView& stresses) {
  const double lame = elasticity.lame(), shear = elasticity.shear;
  double *mean = stresses.mean, *across = stresses.across;
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < count; ++i) {
    mean[i] += (lame + shear) * strains.volume[i];
    across[i] += lame * strains.volume[i];
  }
  for (std::size_t k = 0; k < 4; ++k) {
    double *differences = stresses.difference[k], *shears = stresses.shear[k];
#pragma GCC ivdep
    for (std::uint32_t i = 0; i < count; ++i) {
      differences[i] += shear * strains.difference[k][i];
      shears[i] += shear * strains.shear[k][i];
    }
  }
}

ADIT_VECTOR_CLONES void find_forces(ZoneKind kind, std::uint32_t count, const ShapeBatch& reference,
                                    const ShapeBatch& now, const ConstStressView& stresses,
                                    const double* weights, CornerForces& forces) {
  if (kind == ZoneKind::kMixedDiscretization)
    forces_of<ZoneKind::kMixedDiscretization>(count, reference, now, stresses, weights, forces);
  else
    forces_of<ZoneKind::kAssumedStrain>(count, reference, now, stresses, weights, forces);
}

ADIT_VECTOR_CLONES void find_shapes(ZoneKind kind, std::uint32_t count, const DeformedCorners& corners,
                                    double behind, double bending_factor, ShapeBatch& shapes) {
  if (kind == ZoneKind::kMixedDiscretization)
    shapes_of<ZoneKind::kMixedDiscretization>(count, corners, behind, bending_factor, shapes);
  else
    shapes_of<ZoneKind::kAssumedStrain>(count, corners, behind, bending_factor, shapes);
}

ADIT_VECTOR_CLONES void find_half_turns(std::uint32_t count, const ShapeBatch& shapes,
                                        const CornerVectors& moved, HalfTurns& turns) {
  const auto& [ux, uy] = moved;
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < count; ++i) {
    const double uy_x = shapes.x0[i] * (uy[0][i] - uy[2][i]) + shapes.x1[i] * (uy[1][i] - uy[3][i]);
    const double ux_y = shapes.y0[i] * (ux[0][i] - ux[2][i]) + shapes.y1[i] * (ux[1][i] - ux[3][i]);
    const double tangent = (uy_x - ux_y) / 4, inverse = 1 / (1 + tangent * tangent);
    turns.cosine[i] = (1 - tangent * tangent) * inverse;
    turns.sine[i] = 2 * tangent * inverse;
  }
}

ADIT_VECTOR_CLONES void turn(std::uint32_t count, const HalfTurns& turns, const StressView& stresses) {
  for (std::size_t k = 0; k < 4; ++k) {
    double *difference = stresses.difference[k], *shear = stresses.shear[k];
#pragma GCC ivdep
    for (std::uint32_t i = 0; i < count; ++i) {
      const double t = difference[i], s = shear[i];
      difference[i] = turns.cosine[i] * t - turns.sine[i] * s;
      shear[i] = turns.sine[i] * t + turns.cosine[i] * s;
    }
  }
}

}  // namespace adit::fdm
