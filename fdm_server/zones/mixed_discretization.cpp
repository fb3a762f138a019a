#include "fdm_server/zones/mixed_discretization.hpp"

#include <algorithm>
#include <cstdint>

namespace adit::fdm {
namespace {

TriangleGradient scaled(const TriangleGradient& g, double factor) {
  return {g.x1 * factor, g.x2 * factor, g.y1 * factor, g.y2 * factor};
}

}  // namespace

MixedDiscretizationShape mixed_discretization_shape(const Corners& c) {
  MixedDiscretizationShape shape{};
  shape.area = area(c);
  shape.gradient = mean_gradient(c);
  for (std::size_t k = 0; k < 4; ++k) {
    const auto [i, j, l] = kTriangles[k];
    const double x1 = c.x[j] - c.x[i], y1 = c.y[j] - c.y[i], x2 = c.x[l] - c.x[i], y2 = c.y[l] - c.y[i];
    const double twice = x1 * y2 - x2 * y1;
    shape.areas[k] = twice / 2;
    shape.triangles[k] = {y2 / twice, -y1 / twice, -x2 / twice, x1 / twice};
  }
  return shape;
}

MixedDiscretizationZones::MixedDiscretizationZones(const Grid& grid, const PlaneLaw& law,
                                                   std::span<const double> weights)
    : law_(law), state_(grid.zones.size()) {
  auto layout = lay_out(grid);
  runs_ = std::move(layout.runs);
  for (const auto& shape : layout.shapes) shapes_.push_back(mixed_discretization_shape(shape));
  std::ranges::copy(weights, state_[kWeight].begin());
}

void MixedDiscretizationZones::add_forces(std::span<const ZoneRun> runs, double dt, const PointView& points) {
  add_batches(runs, points,
              [&](const ZoneRun& run, std::uint32_t done, std::uint32_t count, CornerForces& forces) {
                strain_batch(run, done, count, dt, points, forces);
              });
}

void MixedDiscretizationZones::strain_batch(const ZoneRun& run, std::uint32_t done, std::uint32_t count,
                                            double dt, const PointView& points, CornerForces& forces) {
  const auto& shape = shapes_[run.shape];
  const auto [gx0, gx1, gy0, gy1] = shape.gradient;
  const double bulk = dt * law_.bulk, area = shape.area;
  // gradients times what turns velocities into stress increments, and stresses into forces
  std::array<TriangleGradient, 4> rate, pull;
  for (std::size_t k = 0; k < 4; ++k) {
    rate[k] = scaled(shape.triangles[k], dt * law_.shear);
    pull[k] = scaled(shape.triangles[k], shape.areas[k] / 2);
  }

  const std::size_t first = run.first + done;
  std::array<const double*, 4> vx, vy;
  std::array<double*, 4> fx, fy, deviator, shear;
  for (std::size_t c = 0; c < 4; ++c) {
    vx[c] = points.vx + run.points[c] + done;
    vy[c] = points.vy + run.points[c] + done;
    fx[c] = forces.x[c].data();
    fy[c] = forces.y[c].data();
    deviator[c] = &state_[kDeviator + c][first];
    shear[c] = &state_[kShear + c][first];
  }
  double* mean = &state_[kMean][first];
  const double* weight = &state_[kWeight][first];

#pragma GCC ivdep
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::array<double, 4> x{vx[0][i], vx[1][i], vx[2][i], vx[3][i]};
    const std::array<double, 4> y{vy[0][i], vy[1][i], vy[2][i], vy[3][i]};
    const double w = -weight[i];  // the force on a point is minus the derivative of the energy
    const double p = mean[i] + bulk * ((gx0 * (x[0] - x[2]) + gx1 * (x[1] - x[3])) +
                                       (gy0 * (y[0] - y[2]) + gy1 * (y[1] - y[3])));
    mean[i] = p;
    const double wp = w * area * p;
    std::array<double, 4> force_x{gx0 * wp, gx1 * wp, -(gx0 * wp), -(gx1 * wp)};
    std::array<double, 4> force_y{gy0 * wp, gy1 * wp, -(gy0 * wp), -(gy1 * wp)};
#pragma GCC unroll 4
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t a = kTriangles[k][0], b = kTriangles[k][1], c = kTriangles[k][2];
      const double xb = x[b] - x[a], xc = x[c] - x[a], yb = y[b] - y[a], yc = y[c] - y[a];
      const auto& r = rate[k];
      const double t = deviator[k][i] + ((r.x1 * xb + r.x2 * xc) - (r.y1 * yb + r.y2 * yc));
      const double s = shear[k][i] + ((r.y1 * xb + r.y2 * xc) + (r.x1 * yb + r.x2 * yc));
      deviator[k][i] = t;
      shear[k][i] = s;
      const double wt = w * t, ws = w * s;
      const auto& g = pull[k];
      const double fxb = g.x1 * wt + g.y1 * ws, fxc = g.x2 * wt + g.y2 * ws;
      const double fyb = g.x1 * ws - g.y1 * wt, fyc = g.x2 * ws - g.y2 * wt;
      force_x[a] -= fxb + fxc;
      force_x[b] += fxb;
      force_x[c] += fxc;
      force_y[a] -= fyb + fyc;
      force_y[b] += fyb;
      force_y[c] += fyc;
    }
    for (std::size_t c = 0; c < 4; ++c) {
      fx[c][i] = force_x[c];
      fy[c][i] = force_y[c];
    }
  }
}

void MixedDiscretizationZones::set_stress(std::size_t zone, const Stress& stress) {
  state_[kMean][zone] = (stress.xx + stress.yy) / 2;
  for (std::size_t k = 0; k < 4; ++k) {
    state_[kDeviator + k][zone] = (stress.xx - stress.yy) / 2;
    state_[kShear + k][zone] = stress.xy;
  }
}

double MixedDiscretizationZones::strain_energy() const {
  double energy = 0;
  for (const auto& run : runs_) {
    const auto& shape = shapes_[run.shape];
    for (std::size_t z = run.first; z < run.first + run.count; ++z) {
      const double p = state_[kMean][z];
      double sum = shape.area * p * p / law_.bulk;
      for (std::size_t k = 0; k < 4; ++k) {
        const double t = state_[kDeviator + k][z], s = state_[kShear + k][z];
        sum += 0.5 * shape.areas[k] * (t * t + s * s) / law_.shear;
      }
      energy += 0.5 * state_[kWeight][z] * sum;
    }
  }
  return energy;
}

Stress MixedDiscretizationZones::stress(std::size_t zone) const {
  // the run that holds the zone is the last that does not begin behind it
  const auto run = std::ranges::upper_bound(runs_, static_cast<std::uint32_t>(zone), {}, &ZoneRun::first) - 1;
  const auto& shape = shapes_[run->shape];
  double t = 0, s = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    t += 0.5 * shape.areas[k] / shape.area * state_[kDeviator + k][zone];
    s += 0.5 * shape.areas[k] / shape.area * state_[kShear + k][zone];
  }
  const double p = state_[kMean][zone];
  return {p + t, p - t, s};
}

}  // namespace adit::fdm
