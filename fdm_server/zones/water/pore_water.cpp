#include "fdm_server/zones/water/pore_water.hpp"

#include <algorithm>
#include <array>

#include "protocol/threads/vector_clones.hpp"

namespace adit::fdm {
namespace {

using Corners4 = std::array<const double*, 4>;

// Some zones of a run: what they hold from the first of them on, and their corners.
struct Water {
  const double *rest, *inflow, *weight, *area, *dx, *dy, *ex, *ey;
  double *excess, *lost;
  Corners4 vx, vy, ux, uy;
};

// Pressures and forces at the end of a step in which the corners moved by dt v. `stiffness`: 0 where the
// water is not sealed in.
template <bool kLarge>
[[gnu::always_inline]] inline void push(std::uint32_t count, double dt, double stiffness, const Water& water,
                                        CornerForces& forces) {
  const auto [rest, inflow, weight, area, dx, dy, ex, ey, excess, lost, vx, vy, ux, uy] = water;
  const auto [vx0, vx1, vx2, vx3] = vx;
  const auto [vy0, vy1, vy2, vy3] = vy;
  const auto [ux0, ux1, ux2, ux3] = ux;
  const auto [uy0, uy1, uy2, uy3] = uy;
  auto& [fx, fy] = forces;
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < count; ++i) {
    const double mdx = dt * (vx2[i] - vx0[i]), mex = dt * (vx3[i] - vx1[i]);
    const double mdy = dt * (vy2[i] - vy0[i]), mey = dt * (vy3[i] - vy1[i]);
    double ndx = dx[i], ndy = dy[i], nex = ex[i], ney = ey[i];  // at the end
    double hdx = ndx, hdy = ndy, hex = nex, hey = ney;          // half way
    if constexpr (kLarge) {
      ndx += ux2[i] - ux0[i];
      ndy += uy2[i] - uy0[i];
      nex += ux3[i] - ux1[i];
      ney += uy3[i] - uy1[i];
      hdx = ndx - mdx / 2;
      hdy = ndy - mdy / 2;
      hex = nex - mex / 2;
      hey = ney - mey / 2;
    }
    const double grown = (hdx * mey + mdx * hey - (hex * mdy + mex * hdy)) / 2;
    const double before = excess[i], after = before + stiffness * (inflow[i] - grown / area[i]);
    excess[i] = after;
    lost[i] -= area[i] * ((before + after) / 2 * inflow[i]);
    const double half = weight[i] * (rest[i] + after) / 2;
    fx[0][i] = -half * ney;
    fx[1][i] = half * ndy;
    fx[2][i] = half * ney;
    fx[3][i] = -half * ndy;
    fy[0][i] = half * nex;
    fy[1][i] = -half * ndx;
    fy[2][i] = -half * nex;
    fy[3][i] = half * ndx;
  }
}

ADIT_VECTOR_CLONES void push_small(std::uint32_t count, double dt, double stiffness, const Water& water,
                                   CornerForces& forces) {
  push<false>(count, dt, stiffness, water, forces);
}

ADIT_VECTOR_CLONES void push_large(std::uint32_t count, double dt, double stiffness, const Water& water,
                                   CornerForces& forces) {
  push<true>(count, dt, stiffness, water, forces);
}

Corners4 corners_of(const double* values, const ZoneRun& run, std::uint32_t done) {
  Corners4 corners;
  for (std::size_t c = 0; c < 4; ++c) corners[c] = values + run.points[c] + done;
  return corners;
}

}  // namespace

PoreWater::PoreWater(const Grid& grid, double stiffness, std::span<const double> weights, bool large_strain)
    : stiffness_(stiffness), large_strain_(large_strain), fields_(grid.zones.size()), points_(grid.zones) {
  std::ranges::copy(weights, fields_[kWeight].begin());
  for (std::size_t z = 0; z < points_.size(); ++z) {
    const Corners at = corners(grid, z);
    fields_[kArea][z] = area(at);
    fields_[kDx][z] = at.x[2] - at.x[0];
    fields_[kDy][z] = at.y[2] - at.y[0];
    fields_[kEx][z] = at.x[3] - at.x[1];
    fields_[kEy][z] = at.y[3] - at.y[1];
  }
}

void PoreWater::seal(std::span<const double> vertical) {
  sealed_ = true;
  std::ranges::copy(vertical, fields_[kVertical].begin());
}

void PoreWater::follow(const double* ux, const double* uy) {
  ux_ = ux;
  uy_ = uy;
}

void PoreWater::add_forces(std::span<const ZoneRun> runs, double dt, const PointView& points) {
  const double stiffness = sealed_ ? stiffness_ : 0;
  const auto push = large_strain_ ? push_large : push_small;
  add_batches(
      runs, points, [&](const ZoneRun& run, std::uint32_t done, std::uint32_t count, CornerForces& forces) {
        const auto at = [&](Field field) { return &fields_[field][run.first + done]; };
        push(count, dt, stiffness,
             {at(kRest), at(kInflow), at(kWeight), at(kArea), at(kDx), at(kDy), at(kEx), at(kEy), at(kExcess),
              at(kLost), corners_of(points.vx, run, done), corners_of(points.vy, run, done),
              corners_of(ux_, run, done), corners_of(uy_, run, done)},
             forces);
      });
}

void PoreWater::remove(const std::vector<bool>& gone) {
  for (std::size_t z = 0; z < gone.size(); ++z)
    if (gone[z]) fields_[kWeight][z] = 0;
}

// In large strain the corners' places become those of the grid.
void PoreWater::start_over() {
  std::ranges::fill(fields_[kLost], 0.0);
  for (std::size_t z = 0; large_strain_ && z < points_.size(); ++z) {
    const auto [dx, dy, ex, ey] = moved(z);
    fields_[kDx][z] = dx;
    fields_[kDy][z] = dy;
    fields_[kEx][z] = ex;
    fields_[kEy][z] = ey;
  }
}

void PoreWater::exchange(state::Archive& archive) {
  archive("sealed", sealed_);
  for (const Field field : {kRest, kExcess, kInflow, kLost, kVertical}) archive("water", fields_[field]);
  if (large_strain_)
    for (const Field field : {kDx, kDy, kEx, kEy}) archive("diagonals", fields_[field]);
}

PoreWater::Diagonals PoreWater::of_grid(std::size_t zone) const {
  return {fields_[kDx][zone], fields_[kDy][zone], fields_[kEx][zone], fields_[kEy][zone]};
}

PoreWater::Diagonals PoreWater::moved(std::size_t zone) const {
  const auto [dx, dy, ex, ey] = of_grid(zone);
  const auto [a, b, c, d] = points_[zone];
  return {dx + (ux_[c] - ux_[a]), dy + (uy_[c] - uy_[a]), ex + (ux_[d] - ux_[b]), ey + (uy_[d] - uy_[b])};
}

double PoreWater::growth(std::size_t zone) const {
  const Diagonals before = of_grid(zone), now = moved(zone);
  if (large_strain_) return now.area() - before.area();
  const double mdx = now.dx - before.dx, mdy = now.dy - before.dy, mex = now.ex - before.ex,
               mey = now.ey - before.ey;
  return (before.dx * mey + mdx * before.ey - (before.ex * mdy + mex * before.dy)) / 2;
}

double PoreWater::strain_energy(const protocol::IndexRange& zones) const {
  if (stiffness_ == 0) return 0;
  double sum = 0;
  for (std::uint32_t z = zones.begin; z < zones.end; ++z) {
    const double excess = fields_[kExcess][z];
    sum += fields_[kWeight][z] * fields_[kArea][z] * (excess * excess / (2 * stiffness_));
  }
  return sum;
}

double PoreWater::external_work() const {
  double sum = 0;
  for (std::size_t z = 0; z < points_.size(); ++z) sum += fields_[kWeight][z] * fields_[kRest][z] * growth(z);
  return sum;
}

double PoreWater::dissipated() const {
  double sum = 0;
  for (std::size_t z = 0; z < points_.size(); ++z) sum += fields_[kWeight][z] * fields_[kLost][z];
  return sum;
}

double PoreWater::pressure(std::size_t zone) const {
  return fields_[kWeight][zone] == 0 ? 0 : fields_[kRest][zone] + fields_[kExcess][zone];
}

double PoreWater::ratio(std::size_t zone) const {
  constexpr double kRounding = 1e-9;  // of the pressure at rest
  const double vertical = fields_[kVertical][zone];
  const bool bears = fields_[kWeight][zone] > 0 && vertical > kRounding * fields_[kRest][zone];
  return bears ? fields_[kExcess][zone] / vertical : 0;
}

ZoneForces PoreWater::forces(std::size_t zone) const {
  const auto [dx, dy, ex, ey] = large_strain_ ? moved(zone) : of_grid(zone);
  const double half = fields_[kWeight][zone] * pressure(zone) / 2;
  return {{-half * ey, half * dy, half * ey, -half * dy}, {half * ex, -half * dx, -half * ex, half * dx}};
}

}  // namespace adit::fdm
