#include "fdm_server/zones/assumed_strain.hpp"

#include <algorithm>

#include "fdm_server/zones/hourglass.hpp"

namespace adit::fdm {

AssumedStrainShape assumed_strain_shape(const Corners& corners) {
  const auto hourglass = hourglass_shape(corners);
  AssumedStrainShape shape{area(corners), mean_gradient(corners), hourglass.gamma, 0, 0, 0};
  for (const auto& [area, hx, hy] : hourglass.points) {
    shape.hxx += hx * hx * area;
    shape.hyy += hy * hy * area;
    shape.hxy += hx * hy * area;
  }
  return shape;
}

AssumedStrainZones::AssumedStrainZones(const Grid& grid, const PlaneLaw& law, std::span<const double> weights)
    : law_(law), state_(grid.zones.size()) {
  auto layout = lay_out(grid);
  runs_ = std::move(layout.runs);
  for (const auto& shape : layout.shapes) shapes_.push_back(assumed_strain_shape(shape));
  std::ranges::copy(weights, state_[kWeight].begin());
}

void AssumedStrainZones::add_forces(std::span<const ZoneRun> runs, double dt, const PointView& points) {
  add_batches(runs, points,
              [&](const ZoneRun& run, std::uint32_t done, std::uint32_t count, CornerForces& forces) {
                strain_batch(run, done, count, dt, points, forces);
              });
}

void AssumedStrainZones::strain_batch(const ZoneRun& run, std::uint32_t done, std::uint32_t count, double dt,
                                      const PointView& points, CornerForces& forces) {
  const auto& shape = shapes_[run.shape];
  const auto [gx0, gx1, gy0, gy1] = shape.gradient;
  const auto [c0, c1, c2, c3] = shape.gamma;
  const double bulk = dt * law_.bulk, shear = dt * law_.shear, young = dt * law_.young_prime();
  const double kxx = young * shape.hxx, kyy = young * shape.hyy;
  const double kxy = -young * law_.poisson_prime() * shape.hxy;
  const double area = shape.area;

  const double *vx0 = points.vx + run.points[0] + done, *vy0 = points.vy + run.points[0] + done;
  const double *vx1 = points.vx + run.points[1] + done, *vy1 = points.vy + run.points[1] + done;
  const double *vx2 = points.vx + run.points[2] + done, *vy2 = points.vy + run.points[2] + done;
  const double *vx3 = points.vx + run.points[3] + done, *vy3 = points.vy + run.points[3] + done;
  const std::size_t first = run.first + done;
  double *mean = &state_[kMean][first], *deviator = &state_[kDeviator][first];
  double *sxy = &state_[kShear][first], *bend_x = &state_[kBendingX][first];
  double* bend_y = &state_[kBendingY][first];
  const double* weight = &state_[kWeight][first];
  double *fx0 = forces.x[0].data(), *fx1 = forces.x[1].data(), *fx2 = forces.x[2].data();
  double *fx3 = forces.x[3].data(), *fy0 = forces.y[0].data(), *fy1 = forces.y[1].data();
  double *fy2 = forces.y[2].data(), *fy3 = forces.y[3].data();

#pragma GCC ivdep
  for (std::uint32_t i = 0; i < count; ++i) {
    const double x02 = vx0[i] - vx2[i], x13 = vx1[i] - vx3[i];
    const double y02 = vy0[i] - vy2[i], y13 = vy1[i] - vy3[i];
    const double exx = gx0 * x02 + gx1 * x13, eyy = gy0 * y02 + gy1 * y13;
    const double gxy = (gy0 * x02 + gy1 * x13) + (gx0 * y02 + gx1 * y13);
    const double qx = (c0 * vx0[i] + c1 * vx1[i]) + (c2 * vx2[i] + c3 * vx3[i]);
    const double qy = (c0 * vy0[i] + c1 * vy1[i]) + (c2 * vy2[i] + c3 * vy3[i]);

    const double p = mean[i] + bulk * (exx + eyy), t = deviator[i] + shear * (exx - eyy);
    const double s = sxy[i] + shear * gxy;
    const double hx = bend_x[i] + (kxx * qx + kxy * qy), hy = bend_y[i] + (kxy * qx + kyy * qy);
    mean[i] = p;
    deviator[i] = t;
    sxy[i] = s;
    bend_x[i] = hx;
    bend_y[i] = hy;

    // the force on a point is minus the derivative of the energy
    const double w = -weight[i], wa = w * area;
    const double xx = wa * (p + t), yy = wa * (p - t), xy = wa * s, wx = w * hx, wy = w * hy;
    const double x0 = gx0 * xx + gy0 * xy, x1 = gx1 * xx + gy1 * xy;
    const double y0 = gy0 * yy + gx0 * xy, y1 = gy1 * yy + gx1 * xy;
    fx0[i] = c0 * wx + x0;
    fx1[i] = c1 * wx + x1;
    fx2[i] = c2 * wx - x0;
    fx3[i] = c3 * wx - x1;
    fy0[i] = c0 * wy + y0;
    fy1[i] = c1 * wy + y1;
    fy2[i] = c2 * wy - y0;
    fy3[i] = c3 * wy - y1;
  }
}

void AssumedStrainZones::set_stress(std::size_t zone, const Stress& stress) {
  state_[kMean][zone] = (stress.xx + stress.yy) / 2;
  state_[kDeviator][zone] = (stress.xx - stress.yy) / 2;
  state_[kShear][zone] = stress.xy;
  state_[kBendingX][zone] = state_[kBendingY][zone] = 0;
}

double AssumedStrainZones::strain_energy() const {
  const double young = law_.young_prime(), poisson = law_.poisson_prime();
  double energy = 0;
  for (const auto& run : runs_) {
    const auto& shape = shapes_[run.shape];
    // inverse of the generalized stiffness [[kxx, kxy], [kxy, kyy]]
    const double kxx = young * shape.hxx, kyy = young * shape.hyy, kxy = -young * poisson * shape.hxy;
    const double determinant = kxx * kyy - kxy * kxy;
    for (std::size_t z = run.first; z < run.first + run.count; ++z) {
      const double p = state_[kMean][z], t = state_[kDeviator][z], s = state_[kShear][z];
      const double hx = state_[kBendingX][z], hy = state_[kBendingY][z];
      const double uniform = shape.area * (p * p / law_.bulk + (t * t + s * s) / law_.shear);
      const double bending = (kyy * hx * hx - 2 * kxy * hx * hy + kxx * hy * hy) / determinant;
      energy += 0.5 * state_[kWeight][z] * (uniform + bending);
    }
  }
  return energy;
}

Stress AssumedStrainZones::stress(std::size_t zone) const {
  const double p = state_[kMean][zone], t = state_[kDeviator][zone];
  return {p + t, p - t, state_[kShear][zone]};
}

}  // namespace adit::fdm
