#include "fdm_server/zones/elastic/elastic_forces.hpp"

#include "protocol/threads/vector_clones.hpp"

namespace adit::fdm {
namespace {

enum class Form { kRectangles, kSame, kEach };

template <Form kForm, bool kInitial, bool kWeighted>
[[gnu::always_inline]] inline void compute(const ElasticBatch& batch, CornerForces& forces) {
  constexpr bool kRectangles = kForm == Form::kRectangles, kEach = kForm == Form::kEach;
  const auto [ux0, ux1, ux2, ux3] = batch.ux;
  const auto [uy0, uy1, uy2, uy3] = batch.uy;
  const auto each = batch.each;
  const auto initial = batch.initial;
  const double* weight = batch.weight;
  const Coefficients same = kEach ? Coefficients{} : *batch.same;
  double *fx0 = forces.x[0].data(), *fx1 = forces.x[1].data(), *fx2 = forces.x[2].data();
  double *fx3 = forces.x[3].data(), *fy0 = forces.y[0].data(), *fy1 = forces.y[1].data();
  double *fy2 = forces.y[2].data(), *fy3 = forces.y[3].data();

#pragma GCC ivdep
  for (std::uint32_t i = 0; i < batch.count; ++i) {
    const auto coefficient = [&](Coefficient c) { return kEach ? each[c][i] : same[c]; };
    const double gx0 = coefficient(kGx0), gx1 = kRectangles ? -gx0 : coefficient(kGx1);
    const double gy0 = coefficient(kGy0), gy1 = kRectangles ? gy0 : coefficient(kGy1);
    const double c0 = coefficient(kGamma0), c1 = coefficient(kGamma1);
    const double bulk = coefficient(kBulk), shear = coefficient(kShear), area = coefficient(kArea);
    const double kxx = coefficient(kKxx), kyy = coefficient(kKyy), kxy = coefficient(kKxy);

    const double x02 = ux0[i] - ux2[i], x13 = ux1[i] - ux3[i], x23 = ux2[i] - ux3[i];
    const double y02 = uy0[i] - uy2[i], y13 = uy1[i] - uy3[i], y23 = uy2[i] - uy3[i];
    double exx, eyy, gxy, qx, qy;
    if constexpr (kRectangles) {
      exx = gx0 * (x02 - x13);
      eyy = gy0 * (y02 + y13);
      gxy = gy0 * (x02 + x13) + gx0 * (y02 - y13);
      qx = 0.25 * ((ux0[i] - ux1[i]) + x23);
      qy = 0.25 * ((uy0[i] - uy1[i]) + y23);
    } else {
      exx = gx0 * x02 + gx1 * x13;
      eyy = gy0 * y02 + gy1 * y13;
      gxy = (gy0 * x02 + gy1 * x13) + (gx0 * y02 + gx1 * y13);
      qx = (c0 * x02 + c1 * x13) + 0.5 * x23;
      qy = (c0 * y02 + c1 * y13) + 0.5 * y23;
    }

    double p = bulk * (exx + eyy), t = shear * (exx - eyy), s = shear * gxy;
    double hx = kRectangles ? kxx * qx : kxx * qx + kxy * qy;
    double hy = kRectangles ? kyy * qy : kxy * qx + kyy * qy;
    if constexpr (kInitial) {
      p += initial[kMean][i];
      t += initial[kDeviator][i];
      s += initial[kSxy][i];
      hx += initial[kPatternX][i];
      hy += initial[kPatternY][i];
    }
    if constexpr (kWeighted) {
      p *= weight[i];
      t *= weight[i];
      s *= weight[i];
      hx *= weight[i];
      hy *= weight[i];
    }

    // The force on a point is minus the derivative of the energy. Of opposite corners, b cancels and gamma
    // sums to half a pattern.
    const double xx = area * (p + t), yy = area * (p - t), xy = area * s;
    double x0, x1, y0, y1;
    if constexpr (kRectangles) {
      const double xn = gx0 * xx, xs = gy0 * xy, yn = gy0 * yy, ys = gx0 * xy, wx = 0.25 * hx, wy = 0.25 * hy;
      x0 = -(xn + xs) - wx;
      x1 = (xn - xs) + wx;
      y0 = -(yn + ys) - wy;
      y1 = (ys - yn) + wy;
    } else {
      x0 = -((gx0 * xx + gy0 * xy) + c0 * hx);
      x1 = -((gx1 * xx + gy1 * xy) + c1 * hx);
      y0 = -((gy0 * yy + gx0 * xy) + c0 * hy);
      y1 = -((gy1 * yy + gx1 * xy) + c1 * hy);
    }
    const double half_x = 0.5 * hx, half_y = 0.5 * hy;
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

}  // namespace

ADIT_VECTOR_CLONES void elastic_forces(const ElasticBatch& batch, CornerForces& forces) {
  if (!batch.same)
    compute<Form::kEach>(batch, forces);
  else if (batch.rectangles)
    compute<Form::kRectangles>(batch, forces);
  else
    compute<Form::kSame>(batch, forces);
}

}  // namespace adit::fdm
