#include "fdm_server/zones/elastic/elastic_forces.hpp"

#include "protocol/threads/vector_clones.hpp"

namespace adit::fdm {
namespace {

enum class Form { kRectangles, kSame, kEach };

// One zone's coefficients, displacements of its corners, strains and generalized stresses:
// elastic_forces.hpp.
struct Zone {
  double gx0, gx1, gy0, gy1, area, c0, c1, bulk, shear, kxx, kyy, kxy;
};
struct Displacements {
  double x0, x1, x2, x3, y0, y1, y2, y3;
};
struct Strains {
  double exx, eyy, gxy, qx, qy;
};
struct Stresses {
  double p, t, s, hx, hy;
};
struct Forces {  // on corners 0 and 1
  double x0, x1, y0, y1;
};

template <class Coefficient>
[[gnu::always_inline]] inline Zone zone(Coefficient&& of) {
  return {of(kGx0),    of(kGx1),  of(kGy0),   of(kGy1), of(kArea), of(kGamma0),
          of(kGamma1), of(kBulk), of(kShear), of(kKxx), of(kKyy),  of(kKxy)};
}

template <bool kRectangle>
[[gnu::always_inline]] inline Strains strains(const Zone& z, const Displacements& u) {
  const double x02 = u.x0 - u.x2, x13 = u.x1 - u.x3, x23 = u.x2 - u.x3;
  const double y02 = u.y0 - u.y2, y13 = u.y1 - u.y3, y23 = u.y2 - u.y3;
  if constexpr (kRectangle)
    return {.exx = z.gx0 * (x02 - x13),
            .eyy = z.gy0 * (y02 + y13),
            .gxy = z.gy0 * (x02 + x13) + z.gx0 * (y02 - y13),
            .qx = 0.25 * ((u.x0 - u.x1) + x23),
            .qy = 0.25 * ((u.y0 - u.y1) + y23)};
  else
    return {.exx = z.gx0 * x02 + z.gx1 * x13,
            .eyy = z.gy0 * y02 + z.gy1 * y13,
            .gxy = (z.gy0 * x02 + z.gy1 * x13) + (z.gx0 * y02 + z.gx1 * y13),
            .qx = (z.c0 * x02 + z.c1 * x13) + 0.5 * x23,
            .qy = (z.c0 * y02 + z.c1 * y13) + 0.5 * y23};
}

template <bool kRectangle>
[[gnu::always_inline]] inline Stresses stresses(const Zone& z, const Strains& e) {
  return {.p = z.bulk * (e.exx + e.eyy),
          .t = z.shear * (e.exx - e.eyy),
          .s = z.shear * e.gxy,
          .hx = kRectangle ? z.kxx * e.qx : z.kxx * e.qx + z.kxy * e.qy,
          .hy = kRectangle ? z.kyy * e.qy : z.kxy * e.qx + z.kyy * e.qy};
}

// The force on a point is minus the derivative of the energy.
template <bool kRectangle>
[[gnu::always_inline]] inline Forces corner_forces(const Zone& z, const Stresses& q) {
  const double xx = z.area * (q.p + q.t), yy = z.area * (q.p - q.t), xy = z.area * q.s;
  if constexpr (kRectangle) {
    const double xn = z.gx0 * xx, xs = z.gy0 * xy, yn = z.gy0 * yy, ys = z.gx0 * xy;
    const double wx = 0.25 * q.hx, wy = 0.25 * q.hy;
    return {-(xn + xs) - wx, (xn - xs) + wx, -(yn + ys) - wy, (ys - yn) + wy};
  } else {
    return {-((z.gx0 * xx + z.gy0 * xy) + z.c0 * q.hx), -((z.gx1 * xx + z.gy1 * xy) + z.c1 * q.hx),
            -((z.gy0 * yy + z.gx0 * xy) + z.c0 * q.hy), -((z.gy1 * yy + z.gx1 * xy) + z.c1 * q.hy)};
  }
}

// A batch's zones one by one; the loops over it become vector code.
template <Form kForm, bool kInitial>
struct Zones {
  static constexpr bool kRectangle = kForm == Form::kRectangles, kEach = kForm == Form::kEach;
  const std::array<const double*, 4> ux, uy;
  const std::array<const double*, kCoefficients> each;
  const std::array<const double*, kComponents> initial;
  const Coefficients same;

  explicit Zones(const ElasticBatch& batch)
      : ux(batch.ux),
        uy(batch.uy),
        each(batch.each),
        initial(batch.initial),
        same(kEach ? Coefficients{} : *batch.same) {}

  [[gnu::always_inline]] Zone zone_at(std::uint32_t i) const {
    return zone([&](Coefficient c) { return kEach ? each[c][i] : same[c]; });
  }
  [[gnu::always_inline]] Stresses stresses_at(std::uint32_t i, const Zone& z) const {
    const Displacements u{ux[0][i], ux[1][i], ux[2][i], ux[3][i], uy[0][i], uy[1][i], uy[2][i], uy[3][i]};
    Stresses q = stresses<kRectangle>(z, strains<kRectangle>(z, u));
    if constexpr (kInitial) {
      q.p += initial[kMean][i];
      q.t += initial[kDeviator][i];
      q.s += initial[kSxy][i];
      q.hx += initial[kPatternX][i];
      q.hy += initial[kPatternY][i];
    }
    return q;
  }
};

template <Form kForm, bool kInitial, bool kWeighted>
[[gnu::always_inline]] inline void compute(const ElasticBatch& batch, CornerForces& forces) {
  const Zones<kForm, kInitial> zones(batch);
  const double* weight = batch.weight;
  double *fx0 = forces.x[0].data(), *fx1 = forces.x[1].data(), *fx2 = forces.x[2].data();
  double *fx3 = forces.x[3].data(), *fy0 = forces.y[0].data(), *fy1 = forces.y[1].data();
  double *fy2 = forces.y[2].data(), *fy3 = forces.y[3].data();

#pragma GCC ivdep
  for (std::uint32_t i = 0; i < batch.count; ++i) {
    const Zone z = zones.zone_at(i);
    auto [p, t, s, hx, hy] = zones.stresses_at(i, z);
    if constexpr (kWeighted) {
      p *= weight[i];
      t *= weight[i];
      s *= weight[i];
      hx *= weight[i];
      hy *= weight[i];
    }
    const auto [x0, x1, y0, y1] = corner_forces<zones.kRectangle>(z, {p, t, s, hx, hy});
    const double half_x = 0.5 * hx, half_y = 0.5 * hy;  // of opposite corners, b cancels, gamma sums to 1/2 h
    fx0[i] = x0;
    fx1[i] = x1;
    fx2[i] = -half_x - x0;
    fx3[i] = half_x - x1;
    fy0[i] = y0;
    fy1[i] = y1;
    fy2[i] = -half_y - y0;
    fy3[i] = half_y - y1;
  }
}

template <Form kForm>
[[gnu::always_inline]] inline void compute(const ElasticBatch& batch, CornerForces& forces) {
  const bool initial = batch.initial[kMean] != nullptr, weighted = batch.weight != nullptr;
  if (initial)
    weighted ? compute<kForm, true, true>(batch, forces) : compute<kForm, true, false>(batch, forces);
  else
    weighted ? compute<kForm, false, true>(batch, forces) : compute<kForm, false, false>(batch, forces);
}

// Of the uniform strain, and of the pattern whose stiffness is kappa.
template <Form kForm, bool kInitial>
[[gnu::always_inline]] inline void find_energies(const ElasticBatch& batch, double* energies) {
  const Zones<kForm, kInitial> zones(batch);
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < batch.count; ++i) {
    const Zone z = zones.zone_at(i);
    const auto [p, t, s, hx, hy] = zones.stresses_at(i, z);
    const double uniform = z.area * (p * p / z.bulk + (t * t + s * s) / z.shear);
    const double pattern =
        (z.kyy * hx * hx - 2 * z.kxy * hx * hy + z.kxx * hy * hy) / (z.kxx * z.kyy - z.kxy * z.kxy);
    energies[i] = 0.5 * (uniform + pattern);
  }
}

template <Form kForm>
[[gnu::always_inline]] inline void find_energies(const ElasticBatch& batch, double* energies) {
  batch.initial[kMean] != nullptr ? find_energies<kForm, true>(batch, energies)
                                  : find_energies<kForm, false>(batch, energies);
}

// p, t and s are what is asked for.
template <Form kForm, bool kInitial>
[[gnu::always_inline]] inline void find_stresses(const ElasticBatch& batch, std::uint32_t at,
                                                 PlaneStresses& to) {
  const Zones<kForm, kInitial> zones(batch);
  double *mean = &to.mean[at], *difference = &to.difference[at], *shear = &to.shear[at];
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < batch.count; ++i) {
    const auto [p, t, s, hx, hy] = zones.stresses_at(i, zones.zone_at(i));
    mean[i] = p;
    difference[i] = t;
    shear[i] = s;
  }
}

template <Form kForm>
[[gnu::always_inline]] inline void find_stresses(const ElasticBatch& batch, std::uint32_t at,
                                                 PlaneStresses& to) {
  batch.initial[kMean] != nullptr ? find_stresses<kForm, true>(batch, at, to)
                                  : find_stresses<kForm, false>(batch, at, to);
}

}  // namespace

ADIT_VECTOR_CLONES void elastic_stresses(const ElasticBatch& batch, std::uint32_t at,
                                         PlaneStresses& stresses) {
  if (!batch.same)
    find_stresses<Form::kEach>(batch, at, stresses);
  else if (batch.rectangles)
    find_stresses<Form::kRectangles>(batch, at, stresses);
  else
    find_stresses<Form::kSame>(batch, at, stresses);
}

ADIT_VECTOR_CLONES void elastic_energies(const ElasticBatch& batch, std::span<double> energies) {
  if (!batch.same)
    find_energies<Form::kEach>(batch, energies.data());
  else if (batch.rectangles)
    find_energies<Form::kRectangles>(batch, energies.data());
  else
    find_energies<Form::kSame>(batch, energies.data());
}

ADIT_VECTOR_CLONES void elastic_forces(const ElasticBatch& batch, CornerForces& forces) {
  if (!batch.same)
    compute<Form::kEach>(batch, forces);
  else if (batch.rectangles)
    compute<Form::kRectangles>(batch, forces);
  else
    compute<Form::kSame>(batch, forces);
}

}  // namespace adit::fdm
