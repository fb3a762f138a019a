#include "fdm_server/zones/elastic/elastic_zones.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fdm_server/materials/demand.hpp"
#include "fdm_server/zones/shape/assumed_strain.hpp"
#include "fdm_server/zones/shape/mixed_discretization.hpp"
#include "protocol/kernels/sums.hpp"

namespace adit::fdm {
namespace {

// To the rounding of the coordinates.
bool is_upright_rectangle(const Corners& c) {
  double largest = 0;
  for (std::size_t a = 0; a < 4; ++a) largest = std::max({largest, std::abs(c.x[a]), std::abs(c.y[a])});
  return std::ranges::all_of(std::array{c.x[3] - c.x[0], c.x[2] - c.x[1], c.y[1] - c.y[0], c.y[3] - c.y[2]},
                             [rounding = 8 * std::numeric_limits<double>::epsilon() *
                                         largest](double offset) { return std::abs(offset) <= rounding; });
}

// A run of fewer zones is not worth a call of the kernel, if its neighbours can be had with it.
constexpr std::uint32_t kShort = 8;
constexpr std::uint32_t kOwnShapes = ~std::uint32_t{0};

bool continues(const ZoneRun& run, const ZoneRun& next) {
  if (next.first != run.first + run.count) return false;
  for (std::size_t c = 0; c < 4; ++c)
    if (next.points[c] != run.points[c] + static_cast<std::int32_t>(run.count)) return false;
  return true;
}

}  // namespace

ElasticShape elastic_shape(ZoneKind kind, const Corners& c, const PlaneLaw& law) {
  const auto g = mean_gradient(c);
  const auto pattern = gamma(c, g);
  const auto k = kind == ZoneKind::kMixedDiscretization ? mixed_discretization_stiffness(c, law)
                                                        : assumed_strain_stiffness(c, law);
  return {{g.x0, g.x1, g.y0, g.y1, area(c), pattern[0], pattern[1], law.bulk, law.shear, k.xx, k.yy, k.xy},
          is_upright_rectangle(c)};
}

ElasticZones::ElasticZones(ZoneKind kind, const Grid& grid, const PlaneLaw& law,
                           std::span<const double> weights, double across,
                           const std::optional<YieldCone>& strength, std::span<const double> factors)
    : weights_(weights.begin(), weights.end()),
      weighted_(std::ranges::any_of(weights, [](double weight) { return weight != 1; })),
      across_(across) {
  auto layout = lay_out(grid);
  runs_ = std::move(layout.runs);
  for (const auto& shape : layout.shapes) shapes_.push_back(elastic_shape(kind, shape, law));
  if (strength) {
    strength_.emplace(Strength{*strength, {factors.begin(), factors.end()}, {}, {}});
    for (const auto& shape : layout.shapes) strength_->patterns.push_back(pattern_stresses(kind, shape, law));
    for (const auto& run : runs_)
      strength_->pattern_of.insert(strength_->pattern_of.end(), run.count, run.shape);
  }
  join_short_runs();
}

void ElasticZones::join_short_runs() {
  std::vector<ZoneRun> joined;
  const auto take_up = [this](const ZoneRun& run) {
    if (!own_) own_.emplace(count());
    for (std::size_t c = 0; c < kCoefficients; ++c)
      std::ranges::fill((*own_)[c].subspan(run.first, run.count), shapes_[run.shape].coefficients[c]);
  };
  for (const ZoneRun& run : runs_) {
    ZoneRun* last = joined.empty() ? nullptr : &joined.back();
    if (!last || run.count >= kShort || !continues(*last, run) ||
        (last->shape != kOwnShapes && last->count >= kShort)) {
      joined.push_back(run);
      continue;
    }
    if (last->shape != kOwnShapes) take_up(*last);
    take_up(run);
    last->shape = kOwnShapes;
    last->count += run.count;
  }
  runs_ = std::move(joined);
}

Coefficients ElasticZones::coefficients(const ZoneRun& run, std::uint32_t k) const {
  if (run.shape != kOwnShapes) return shapes_[run.shape].coefficients;
  Coefficients result{};
  for (std::size_t c = 0; c < kCoefficients; ++c) result[c] = (*own_)[c][run.first + k];
  return result;
}

void ElasticZones::follow(const double* ux, const double* uy) {
  ux_ = ux;
  uy_ = uy;
}

void ElasticZones::add_forces(std::span<const ZoneRun> runs, double /*dt*/, const PointView& points) {
  add_batches(runs, points,
              [this](const ZoneRun& run, std::uint32_t done, std::uint32_t count, CornerForces& forces) {
                elastic_forces(batch(run, done, count), forces);
              });
}

ElasticBatch ElasticZones::batch(const ZoneRun& run, std::uint32_t done, std::uint32_t count) const {
  ElasticBatch result{{}, {}, count, nullptr, false, {}, {}, nullptr};
  for (std::size_t c = 0; c < 4; ++c) {
    result.ux[c] = ux_ + run.points[c] + done;
    result.uy[c] = uy_ + run.points[c] + done;
  }
  const std::size_t first = run.first + done;
  if (run.shape == kOwnShapes) {
    for (std::size_t c = 0; c < kCoefficients; ++c) result.each[c] = &(*own_)[c][first];
  } else {
    result.same = &shapes_[run.shape].coefficients;
    result.rectangles = shapes_[run.shape].rectangle;
  }
  if (initial_)
    for (std::size_t c = 0; c < kComponents; ++c) result.initial[c] = &(*initial_)[c][first];
  if (weighted_) result.weight = &weights_[first];
  return result;
}

ElasticZones::State ElasticZones::state(const ZoneRun& run, std::uint32_t k) const {
  const auto [gx0, gx1, gy0, gy1, area, c0, c1, bulk, shear, kxx, kyy, kxy] = coefficients(run, k);
  std::array<double, 4> x{}, y{};
  for (std::size_t c = 0; c < 4; ++c) {
    x[c] = ux_[run.points[c] + static_cast<std::int32_t>(k)];
    y[c] = uy_[run.points[c] + static_cast<std::int32_t>(k)];
  }
  const double x02 = x[0] - x[2], x13 = x[1] - x[3], y02 = y[0] - y[2], y13 = y[1] - y[3];
  const double exx = gx0 * x02 + gx1 * x13, eyy = gy0 * y02 + gy1 * y13;
  const double gxy = (gy0 * x02 + gy1 * x13) + (gx0 * y02 + gx1 * y13);
  const double qx = (c0 * x02 + c1 * x13) + 0.5 * (x[2] - x[3]),
               qy = (c0 * y02 + c1 * y13) + 0.5 * (y[2] - y[3]);
  State state{bulk * (exx + eyy), shear * (exx - eyy), shear * gxy, kxx * qx + kxy * qy, kxy * qx + kyy * qy};
  if (initial_)
    for (std::size_t c = 0; c < kComponents; ++c) state[c] += (*initial_)[c][run.first + k];
  return state;
}

FieldArrays<kComponents>& ElasticZones::initial() {
  if (!initial_) initial_.emplace(count());
  return *initial_;
}

void ElasticZones::set_stress(std::size_t zone, const Stress& stress) {
  const State uniform{(stress.xx + stress.yy) / 2, (stress.xx - stress.yy) / 2, stress.xy, 0, 0};
  for (std::size_t c = 0; c < kComponents; ++c) initial()[c][zone] = uniform[c];
}

void ElasticZones::set_borne(std::size_t zone, const BorneStress& borne) {
  const auto [xx, yy, xy] = borne.mean;
  const State wanted{(xx + yy) / 2, (xx - yy) / 2, xy, borne.pattern_x, borne.pattern_y};
  const ZoneRun& run = run_of(zone);
  const State now = state(run, static_cast<std::uint32_t>(zone) - run.first);
  for (std::size_t c = 0; c < kComponents; ++c) initial()[c][zone] += wanted[c] - now[c];
}

void ElasticZones::remove(const std::vector<bool>& gone) {
  runs_ = without(runs_, gone);
  for (std::size_t z = 0; z < gone.size(); ++z)
    if (gone[z]) weights_[z] = 0;
}

void ElasticZones::start_over() {
  initial();
  for (const auto& run : runs_)
    for (std::uint32_t k = 0; k < run.count; ++k) {
      const State reached = state(run, k);
      for (std::size_t c = 0; c < kComponents; ++c) (*initial_)[c][run.first + k] = reached[c];
    }
}

void ElasticZones::for_each_batch(const protocol::IndexRange& zones, const auto& visit) const {
  auto run = std::ranges::upper_bound(runs_, zones.begin, {},
                                      [](const ZoneRun& some) { return some.first + some.count; });
  for (; run != runs_.end() && run->first < zones.end; ++run) {
    const std::uint32_t end = std::min(zones.end, run->first + run->count);
    for (std::uint32_t zone = std::max(zones.begin, run->first); zone < end; zone += kBatch)
      visit(batch(*run, zone - run->first, std::min(kBatch, end - zone)), zone);
  }
}

double ElasticZones::strain_energy(const protocol::IndexRange& zones) const {
  std::array<double, kBatch> energies;
  double sum = 0;
  for_each_batch(zones, [&](const ElasticBatch& batch, std::uint32_t first) {
    elastic_energies(batch, energies);
    sum += protocol::eight_sums(0, batch.count,
                                [&](std::size_t k) { return weights_[first + k] * energies[k]; });
  });
  return sum;
}

void ElasticZones::find_stresses(const protocol::IndexRange& zones, PlaneStresses& stresses) const {
  stresses = {};  // of what was taken away
  for_each_batch(zones, [&](const ElasticBatch& batch, std::uint32_t first) {
    elastic_stresses(batch, first - zones.begin, stresses);
  });
}

// The run that holds the zone is the last that does not begin behind it.
const ZoneRun& ElasticZones::run_of(std::size_t zone) const {
  return *(std::ranges::upper_bound(runs_, static_cast<std::uint32_t>(zone), {}, &ZoneRun::first) - 1);
}

Stress ElasticZones::stress(std::size_t zone) const {
  if (weights_[zone] == 0) return {};  // taken away
  const ZoneRun& run = run_of(zone);
  const auto [p, t, s, hx, hy] = state(run, static_cast<std::uint32_t>(zone) - run.first);
  return {p + t, p - t, s};
}

ZoneForces ElasticZones::forces(std::size_t zone) const {
  if (weights_[zone] == 0) return {};
  const ZoneRun& run = run_of(zone);
  ElasticBatch alone = batch(run, static_cast<std::uint32_t>(zone) - run.first, 1);
  alone.weight = nullptr;
  CornerForces forces;
  elastic_forces(alone, forces);
  return first_of(forces);
}

double ElasticZones::demand(std::size_t zone) const {
  if (!strength_ || weights_[zone] == 0) return 0;
  const auto& [common, factors, patterns, pattern_of] = *strength_;
  const YieldCone cone = factors.empty() ? common : times(factors[zone], common);
  const ZoneRun& run = run_of(zone);
  const auto [mean, difference, shear, x, y] = state(run, static_cast<std::uint32_t>(zone) - run.first);
  double largest = 0;
  for (const PatternStress& pattern : patterns[pattern_of[zone]]) {
    const auto with = [x = x, y = y](double middle, const std::array<double, 2>& added) {
      return middle + added[0] * x + added[1] * y;
    };
    const double here = with(mean, pattern.mean);
    largest = std::max(largest, fdm::demand(cone, {here, with(difference, pattern.difference),
                                                   with(shear, pattern.shear), 2 * across_ * here}));
  }
  return largest;
}

double ElasticZones::field(std::size_t zone, ZoneField field) const {
  if (field != ZoneField::kStressZz) return 0;
  const auto [xx, yy, xy] = stress(zone);
  return across_ * (xx + yy);
}

}  // namespace adit::fdm
