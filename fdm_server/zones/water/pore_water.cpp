#include "fdm_server/zones/water/pore_water.hpp"

#include <algorithm>

#include "protocol/threads/vector_clones.hpp"

namespace adit::fdm {
namespace {

// From one zone on.
struct Water {
  const double *rest, *inflow, *share;
  double *excess, *lost;
};

// `stiffness`: 0 where the water is not sealed in.
template <bool kFlows>
[[gnu::always_inline]] inline void advance(std::uint32_t count, double stiffness, const Water& water,
                                           const BatchValues& growths, BatchValues& pressures) {
  const auto [rest, inflow, share, excess, lost] = water;
  const double* growth = growths.data();
  double* pressure = pressures.data();
#pragma GCC ivdep
  for (std::uint32_t i = 0; i < count; ++i) {
    const double volume = kFlows ? inflow[i] - growth[i] : -growth[i];
    const double before = excess[i], after = before + stiffness * volume;
    excess[i] = after;
    if constexpr (kFlows) lost[i] -= (before + after) / 2 * inflow[i];
    pressure[i] = share[i] * (rest[i] + after);
  }
}

ADIT_VECTOR_CLONES void advance_flowing(std::uint32_t count, double stiffness, const Water& water,
                                        const BatchValues& growths, BatchValues& pressures) {
  advance<true>(count, stiffness, water, growths, pressures);
}

ADIT_VECTOR_CLONES void advance_closed(std::uint32_t count, double stiffness, const Water& water,
                                       const BatchValues& growths, BatchValues& pressures) {
  advance<false>(count, stiffness, water, growths, pressures);
}

}  // namespace

PoreWater::PoreWater(const Grid& grid, double stiffness, std::span<const double> weights,
                     std::span<const double> shares, bool large_strain)
    : stiffness_(stiffness),
      large_strain_(large_strain),
      fields_(grid.zones.size()),
      shares_(shares.begin(), shares.end()),
      points_(grid.zones) {
  ones_.fill(1);
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

void PoreWater::advance(std::size_t first, std::uint32_t count, const BatchValues& growths,
                        BatchValues& pressures) {
  const auto at = [&](Field field) { return &fields_[field][first]; };
  const Water water{at(kRest), at(kInflow), shares_.empty() ? ones_.data() : &shares_[first], at(kExcess),
                    at(kLost)};
  const auto advance = flows_ ? advance_flowing : advance_closed;
  advance(count, sealed_ ? stiffness_ : 0, water, growths, pressures);
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
  archive("flows", flows_);
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
  for (std::size_t z = 0; z < points_.size(); ++z)
    sum += fields_[kWeight][z] * fields_[kArea][z] * fields_[kLost][z];
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
