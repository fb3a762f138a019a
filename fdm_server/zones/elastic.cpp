#include "fdm_server/zones/elastic.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fdm_server/zones/assumed_strain.hpp"
#include "fdm_server/zones/mixed_discretization.hpp"

namespace adit::fdm {
namespace {

// To the rounding of the coordinates.
bool is_parallelogram(const Corners& c) {
  double largest = 0;
  for (std::size_t a = 0; a < 4; ++a) largest = std::max({largest, std::abs(c.x[a]), std::abs(c.y[a])});
  const auto [hx, hy] = skewness(c);
  return std::max(std::abs(hx), std::abs(hy)) <= 8 * std::numeric_limits<double>::epsilon() * largest;
}

}  // namespace

ElasticShape elastic_shape(ZoneKind kind, const Corners& c, const PlaneLaw& law) {
  const auto gradient = mean_gradient(c);
  const bool parallelogram = is_parallelogram(c);
  return {area(c),
          gradient,
          parallelogram ? std::array{0.25, -0.25, 0.25, -0.25} : gamma(c, gradient),
          parallelogram,
          law.bulk,
          law.shear,
          kind == ZoneKind::kMixedDiscretization ? mixed_discretization_stiffness(c, law)
                                                 : assumed_strain_stiffness(c, law)};
}

ElasticZones::ElasticZones(ZoneKind kind, const Grid& grid, const PlaneLaw& law,
                           std::span<const double> weights)
    : weights_(weights.begin(), weights.end()),
      weighted_(std::ranges::any_of(weights, [](double weight) { return weight != 1; })) {
  auto layout = lay_out(grid);
  runs_ = std::move(layout.runs);
  for (const auto& shape : layout.shapes) shapes_.push_back(elastic_shape(kind, shape, law));
}

void ElasticZones::follow(const double* ux, const double* uy) {
  ux_ = ux;
  uy_ = uy;
}

void ElasticZones::add_forces(std::span<const ZoneRun> runs, double /*dt*/, const PointView& points) {
  add_batches(runs, points,
              [&](const ZoneRun& run, std::uint32_t done, std::uint32_t count, CornerForces& forces) {
                const auto call = [&]<bool kParallelogram, bool kWeighted>() {
                  if (initial_)
                    batch<kParallelogram, kWeighted, true>(run, done, count, forces);
                  else
                    batch<kParallelogram, kWeighted, false>(run, done, count, forces);
                };
                if (shapes_[run.shape].parallelogram)
                  weighted_ ? call.operator()<true, true>() : call.operator()<true, false>();
                else
                  weighted_ ? call.operator()<false, true>() : call.operator()<false, false>();
              });
}

template <bool kParallelogram, bool kWeighted, bool kInitial>
void ElasticZones::batch(const ZoneRun& run, std::uint32_t done, std::uint32_t count,
                         CornerForces& forces) const {
  const ElasticShape& shape = shapes_[run.shape];
  const auto [gx0, gx1, gy0, gy1] = shape.gradient;
  const double ax0 = -shape.area * gx0, ax1 = -shape.area * gx1, ay0 = -shape.area * gy0,
               ay1 = -shape.area * gy1;
  const double bulk = shape.bulk, shear = shape.shear;
  const auto [c0, c1, c2, c3] = shape.gamma;
  const auto [kxx, kyy, kxy] = shape.hourglass;

  const double *ux0 = ux_ + run.points[0] + done, *uy0 = uy_ + run.points[0] + done;
  const double *ux1 = ux_ + run.points[1] + done, *uy1 = uy_ + run.points[1] + done;
  const double *ux2 = ux_ + run.points[2] + done, *uy2 = uy_ + run.points[2] + done;
  const double *ux3 = ux_ + run.points[3] + done, *uy3 = uy_ + run.points[3] + done;
  const std::size_t first = run.first + done;
  const double* weight = weights_.data() + first;
  std::array<const double*, kColumns> initial{};
  if constexpr (kInitial)
    for (std::size_t column = 0; column < kColumns; ++column) initial[column] = &(*initial_)[column][first];
  double *fx0 = forces.x[0].data(), *fx1 = forces.x[1].data(), *fx2 = forces.x[2].data();
  double *fx3 = forces.x[3].data(), *fy0 = forces.y[0].data(), *fy1 = forces.y[1].data();
  double *fy2 = forces.y[2].data(), *fy3 = forces.y[3].data();

#pragma GCC ivdep
  for (std::uint32_t i = 0; i < count; ++i) {
    const double x02 = ux0[i] - ux2[i], x13 = ux1[i] - ux3[i];
    const double y02 = uy0[i] - uy2[i], y13 = uy1[i] - uy3[i];
    const double exx = gx0 * x02 + gx1 * x13, eyy = gy0 * y02 + gy1 * y13;
    const double gxy = (gy0 * x02 + gy1 * x13) + (gx0 * y02 + gx1 * y13);
    double qx, qy;
    if constexpr (kParallelogram) {
      qx = 0.25 * ((ux0[i] + ux2[i]) - (ux1[i] + ux3[i]));
      qy = 0.25 * ((uy0[i] + uy2[i]) - (uy1[i] + uy3[i]));
    } else {
      qx = (c0 * ux0[i] + c1 * ux1[i]) + (c2 * ux2[i] + c3 * ux3[i]);
      qy = (c0 * uy0[i] + c1 * uy1[i]) + (c2 * uy2[i] + c3 * uy3[i]);
    }

    double p = bulk * (exx + eyy), t = shear * (exx - eyy), s = shear * gxy;
    double hx = kxx * qx + kxy * qy, hy = kxy * qx + kyy * qy;
    if constexpr (kInitial) {
      p += initial[kMean][i];
      t += initial[kDeviator][i];
      s += initial[kShear][i];
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

    // the force on a point is minus the derivative of the energy
    const double xx = p + t, yy = p - t;
    const double x0 = ax0 * xx + ay0 * s, x1 = ax1 * xx + ay1 * s;
    const double y0 = ay0 * yy + ax0 * s, y1 = ay1 * yy + ax1 * s;
    if constexpr (kParallelogram) {
      const double wx = 0.25 * hx, wy = 0.25 * hy;
      fx0[i] = x0 - wx;
      fx1[i] = x1 + wx;
      fx2[i] = -x0 - wx;
      fx3[i] = wx - x1;
      fy0[i] = y0 - wy;
      fy1[i] = y1 + wy;
      fy2[i] = -y0 - wy;
      fy3[i] = wy - y1;
    } else {
      fx0[i] = x0 - c0 * hx;
      fx1[i] = x1 - c1 * hx;
      fx2[i] = -x0 - c2 * hx;
      fx3[i] = -x1 - c3 * hx;
      fy0[i] = y0 - c0 * hy;
      fy1[i] = y1 - c1 * hy;
      fy2[i] = -y0 - c2 * hy;
      fy3[i] = -y1 - c3 * hy;
    }
  }
}

ElasticZones::State ElasticZones::state(const ZoneRun& run, std::uint32_t k) const {
  const ElasticShape& shape = shapes_[run.shape];
  const auto [gx0, gx1, gy0, gy1] = shape.gradient;
  const auto [kxx, kyy, kxy] = shape.hourglass;
  std::array<double, 4> x{}, y{};
  double qx = 0, qy = 0;
  for (std::size_t a = 0; a < 4; ++a) {
    x[a] = ux_[run.points[a] + static_cast<std::int32_t>(k)];
    y[a] = uy_[run.points[a] + static_cast<std::int32_t>(k)];
    qx += shape.gamma[a] * x[a];
    qy += shape.gamma[a] * y[a];
  }
  const double exx = gx0 * (x[0] - x[2]) + gx1 * (x[1] - x[3]),
               eyy = gy0 * (y[0] - y[2]) + gy1 * (y[1] - y[3]);
  const double gxy =
      (gy0 * (x[0] - x[2]) + gy1 * (x[1] - x[3])) + (gx0 * (y[0] - y[2]) + gx1 * (y[1] - y[3]));
  State state{shape.bulk * (exx + eyy), shape.shear * (exx - eyy), shape.shear * gxy, kxx * qx + kxy * qy,
              kxy * qx + kyy * qy};
  if (initial_)
    for (std::size_t column = 0; column < kColumns; ++column)
      state[column] += (*initial_)[column][run.first + k];
  return state;
}

Columns<ElasticZones::kColumns>& ElasticZones::initial() {
  if (!initial_) initial_.emplace(count());
  return *initial_;
}

void ElasticZones::set_stress(std::size_t zone, const Stress& stress) {
  const State uniform{(stress.xx + stress.yy) / 2, (stress.xx - stress.yy) / 2, stress.xy, 0, 0};
  for (std::size_t column = 0; column < kColumns; ++column) initial()[column][zone] = uniform[column];
}

void ElasticZones::start_over() {
  initial();
  for (const auto& run : runs_)
    for (std::uint32_t k = 0; k < run.count; ++k) {
      const State reached = state(run, k);
      for (std::size_t column = 0; column < kColumns; ++column)
        (*initial_)[column][run.first + k] = reached[column];
    }
}

double ElasticZones::strain_energy() const {
  double energy = 0;
  for (const auto& run : runs_) {
    const auto& shape = shapes_[run.shape];
    const auto [kxx, kyy, kxy] = shape.hourglass;
    const double determinant = kxx * kyy - kxy * kxy;
    for (std::uint32_t k = 0; k < run.count; ++k) {
      const auto [p, t, s, hx, hy] = state(run, k);
      const double uniform = shape.area * (p * p / shape.bulk + (t * t + s * s) / shape.shear);
      const double pattern = (kyy * hx * hx - 2 * kxy * hx * hy + kxx * hy * hy) / determinant;
      energy += 0.5 * weights_[run.first + k] * (uniform + pattern);
    }
  }
  return energy;
}

Stress ElasticZones::stress(std::size_t zone) const {
  // the run that holds the zone is the last that does not begin behind it
  const auto run = std::ranges::upper_bound(runs_, static_cast<std::uint32_t>(zone), {}, &ZoneRun::first) - 1;
  const auto [p, t, s, hx, hy] = state(*run, static_cast<std::uint32_t>(zone) - run->first);
  return {p + t, p - t, s};
}

}  // namespace adit::fdm
