#include "fdm_server/zones/nonlinear/nonlinear_zones.hpp"

#include <limits>

#include "fdm_server/materials/admissible.hpp"

namespace adit::fdm {
namespace {

constexpr unsigned kNow = kShearNow | kTensionNow | kSlipNow | kOpeningNow;
constexpr unsigned kPast = kNow << 2;

double dot(const CornerValues& a, const CornerValues& b) {
  return (a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3]);
}

double mean_in_plane(const SolidStress& s) {
  return (s.xx + s.yy) / 2;
}

Corners moved(const Corners& c, const CornerValues& ux, const CornerValues& uy, const CornerValues& dx,
              const CornerValues& dy, double share) {
  Corners to{};
  for (std::size_t a = 0; a < 4; ++a) {
    to.x[a] = c.x[a] + ux[a] + share * dx[a];
    to.y[a] = c.y[a] + uy[a] + share * dy[a];
  }
  return to;
}

// A zone turned inside out has no strain: the run stops at the values that are not finite.
void refuse_tangled(SamplingShape& shape) {
  if (!(shape.area > 0)) shape.x[0] = std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

NonlinearZones::NonlinearZones(ZoneKind kind, const Grid& grid, const Material& material,
                               std::span<const double> weights, bool large_strain)
    : kind_(kind),
      material_(material),
      elasticity_(material.elasticity()),
      plane_law_(plane_strain(material.young, material.poisson)),
      large_strain_(large_strain),
      weights_(weights.begin(), weights.end()),
      points_(4 * weights.size()),
      memory_(material.hysteretic ? points_.size() * material.hysteretic->values() : 0),
      dissipated_(weights.size(), 0.0),
      turned_(weights.size(), 0.0),
      stretch_(weights.size(), 1.0) {
  auto layout = lay_out(grid);
  runs_ = std::move(layout.runs);
  for (const auto& corners : layout.shapes) shapes_.push_back(sampling_shape(kind, corners, plane_law_));
  for (const auto& run : runs_) shape_of_.insert(shape_of_.end(), run.count, run.shape);
  if (!large_strain) return;
  for (std::size_t z = 0; z < grid.zones.size(); ++z) corners_.push_back(corners(grid, z));
  zone_points_ = grid.zones;
}

std::span<double> NonlinearZones::memory(std::size_t zone, std::size_t k) {
  if (!material_.hysteretic) return {};
  const auto values = material_.hysteretic->values();
  return {&memory_[(4 * zone + k) * values], values};
}

std::span<const double> NonlinearZones::memory(std::size_t zone, std::size_t k) const {
  if (!material_.hysteretic) return {};
  const auto values = material_.hysteretic->values();
  return {&memory_[(4 * zone + k) * values], values};
}

void NonlinearZones::add_forces(std::span<const ZoneRun> runs, double dt, const PointView& points) {
  for (const auto& run : runs)
    for (std::uint32_t i = 0; i < run.count; ++i) {
      const std::size_t zone = run.first + i;
      CornerValues dx, dy, fx{}, fy{};
      for (std::size_t c = 0; c < 4; ++c) {
        dx[c] = dt * points.vx[run.points[c] + i];
        dy[c] = dt * points.vy[run.points[c] + i];
      }
      const auto& reference = shapes_[shape_of_[zone]];
      if (large_strain_) {
        CornerValues ux, uy;
        for (std::size_t c = 0; c < 4; ++c) {
          ux[c] = ux_[run.points[c] + i];
          uy[c] = uy_[run.points[c] + i];
        }
        auto during = sampling_shape(kind_, moved(corners_[zone], ux, uy, dx, dy, -0.5), plane_law_);
        refuse_tangled(during);
        const double tangent = (dot(during.x, dy) - dot(during.y, dx)) / 4,
                     cosine = 1 / std::sqrt(1 + tangent * tangent);
        const Turn half{cosine, tangent * cosine, std::atan(tangent)};
        turn_zone(zone, half);
        strain_zone(zone, reference, during, dx, dy);
        turn_zone(zone, half);
        auto now = sampling_shape(kind_, moved(corners_[zone], ux, uy, dx, dy, 0), plane_law_);
        refuse_tangled(now);
        stretch_[zone] = now.area / reference.area;
        add_corner_forces(zone, reference, now, fx, fy);
      } else {
        strain_zone(zone, reference, reference, dx, dy);
        add_corner_forces(zone, reference, reference, fx, fy);
      }
      for (std::size_t c = 0; c < 4; ++c) {
        points.fx[run.points[c] + i] += fx[c];
        points.fy[run.points[c] + i] += fy[c];
      }
    }
}

void NonlinearZones::turn_zone(std::size_t zone, const Turn& turn) {
  turned_[zone] += turn.angle;
  for (std::size_t k = 0; k < 4; ++k) {
    auto& stress = points_[4 * zone + k].stress;
    stress = turned(stress, turn.cosine, turn.sine);
    if (material_.hysteretic) material_.hysteretic->turn(memory(zone, k), turn.cosine, turn.sine);
  }
}

void NonlinearZones::strain_zone(std::size_t zone, const SamplingShape& reference,
                                 const SamplingShape& during, const CornerValues& dx,
                                 const CornerValues& dy) {
  const double volume = dot(during.x, dx) + dot(during.y, dy);
  double plastic_work = 0;
  bool yields = false;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& at = during.points[k];
    const double difference = dot(at.difference_x, dx) + dot(at.difference_y, dy);
    const double shear = dot(at.shear_x, dx) + dot(at.shear_y, dy);
    auto& point = points_[4 * zone + k];
    const Strain strain{(volume + difference) / 2, (volume - difference) / 2, 0, shear};
    plastic_work += reference.points[k].area * strain_point(point, memory(zone, k), strain, turned_[zone]);
    yields = yields || (point.yield & kNow) != 0;
  }
  dissipated_[zone] += plastic_work;
  if (yields && !material_.hysteretic) average_mean_stress(zone, reference);
}

double NonlinearZones::strain_point(Point& point, std::span<double> memory, const Strain& strain,
                                    double turned) {
  if (material_.hysteretic) {
    const double lost = material_.hysteretic->add(elasticity_, strain, memory, point.stress);
    point.yield = lost > 0 ? kShearNow | kShearPast : point.yield & kShearPast;
    return lost;
  }
  const SolidStress before = point.stress, predicted = before + stress_of(elasticity_, strain);
  const auto [stress, shear_strain, now] =
      admissible(material_, elasticity_, point.plastic_shear_strain, predicted, turned);
  point.stress = stress;
  point.plastic_shear_strain += shear_strain;
  point.yield = (point.yield & kPast) | now | now << 2;  // a bit of the past is its bit of now, times 4
  if (now == kElastic) return 0;
  return product(before + point.stress, strain_of(elasticity_, predicted - point.stress)) / 2;
}

void NonlinearZones::average_mean_stress(std::size_t zone, const SamplingShape& shape) {
  double mean = 0, zz = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const double share = shape.points[k].area / shape.area;
    mean += share * mean_in_plane(points_[4 * zone + k].stress);
    zz += share * points_[4 * zone + k].stress.zz;
  }
  for (std::size_t k = 0; k < 4; ++k) {
    auto& stress = points_[4 * zone + k].stress;
    const double change = mean - mean_in_plane(stress);
    const SolidStress averaged{stress.xx + change, stress.yy + change, zz, stress.xy};
    dissipated_[zone] +=
        shape.points[k].area * (elastic_energy(elasticity_, stress) - elastic_energy(elasticity_, averaged));
    stress = averaged;
  }
}

void NonlinearZones::add_corner_forces(std::size_t zone, const SamplingShape& reference,
                                       const SamplingShape& now, CornerValues& fx, CornerValues& fy) const {
  const double weight = -weights_[zone];  // the force on a point is minus the derivative of the energy
  double mean = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& stress = points_[4 * zone + k].stress;
    const auto& at = now.points[k];
    const double area = weight * reference.points[k].area;
    const double t = area * (stress.xx - stress.yy) / 2, s = area * stress.xy;
    mean += area * mean_in_plane(stress);
    for (std::size_t c = 0; c < 4; ++c) {
      fx[c] += t * at.difference_x[c] + s * at.shear_x[c];
      fy[c] += t * at.difference_y[c] + s * at.shear_y[c];
    }
  }
  for (std::size_t c = 0; c < 4; ++c) {
    fx[c] += mean * now.x[c];
    fy[c] += mean * now.y[c];
  }
}

void NonlinearZones::set_stress(std::size_t zone, const Stress& stress) {
  for (std::size_t k = 0; k < 4; ++k) points_[4 * zone + k].stress = {stress.xx, stress.yy, 0, stress.xy};
  set_stress_zz(zone, material_.poisson * (stress.xx + stress.yy));
}

void NonlinearZones::set_stress_zz(std::size_t zone, double zz) {
  for (std::size_t k = 0; k < 4; ++k) {
    auto& stress = points_[4 * zone + k].stress;
    stress.zz = zz;
    if (material_.hysteretic) material_.hysteretic->set_stress(memory(zone, k), stress);
  }
}

void NonlinearZones::follow(const double* ux, const double* uy) {
  ux_ = ux;
  uy_ = uy;
}

void NonlinearZones::remove(const std::vector<bool>& gone) {
  runs_ = without(runs_, gone);
  for (std::size_t z = 0; z < gone.size(); ++z)
    if (gone[z]) weights_[z] = 0;
}

void NonlinearZones::start_over() {
  std::ranges::fill(dissipated_, 0.0);
  for (std::size_t z = 0; z < corners_.size(); ++z)
    for (std::size_t c = 0; c < 4; ++c) {
      corners_[z].x[c] += ux_[zone_points_[z][c]];
      corners_[z].y[c] += uy_[zone_points_[z][c]];
    }
}

double NonlinearZones::strain_energy() const {
  double energy = 0;
  for (std::size_t z = 0; z < count(); ++z)
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& stress = points_[4 * z + k].stress;
      const double density = material_.hysteretic
                                 ? material_.hysteretic->energy(elasticity_, memory(z, k), stress)
                                 : elastic_energy(elasticity_, stress);
      energy += weights_[z] * shapes_[shape_of_[z]].points[k].area * density;
    }
  return energy;
}

double NonlinearZones::dissipated() const {
  double sum = 0;
  for (std::size_t z = 0; z < count(); ++z) sum += weights_[z] * dissipated_[z];
  return sum;
}

Stress NonlinearZones::stress(std::size_t zone) const {
  if (weights_[zone] == 0) return {};  // taken away
  const auto& shape = shapes_[shape_of_[zone]];
  Stress mean{};
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& stress = points_[4 * zone + k].stress;
    const double share = shape.points[k].area / (shape.area * stretch_[zone]);
    mean.xx += share * stress.xx;
    mean.yy += share * stress.yy;
    mean.xy += share * stress.xy;
  }
  return mean;
}

double NonlinearZones::field(std::size_t zone, ZoneField field) const {
  const auto& shape = shapes_[shape_of_[zone]];
  double zz = 0, strain = 0;
  unsigned yield = kElastic;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& point = points_[4 * zone + k];
    const double share = shape.points[k].area / shape.area;
    zz += share * point.stress.zz;
    strain += share * point.plastic_shear_strain;
    yield |= point.yield;
  }
  if (field == ZoneField::kStressZz) return zz / stretch_[zone];
  return field == ZoneField::kPlasticShearStrain ? strain : yield;
}

}  // namespace adit::fdm
