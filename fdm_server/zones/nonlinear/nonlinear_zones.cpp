#include "fdm_server/zones/nonlinear/nonlinear_zones.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "fdm_server/materials/demand.hpp"
#include "protocol/kernels/sums.hpp"

namespace adit::fdm {

NonlinearZones::NonlinearZones(ZoneKind kind, const Grid& grid, const Material& material,
                               std::span<const double> weights, bool large_strain,
                               std::span<const double> strengths)
    : kind_(kind),
      elasticity_(material.elasticity()),
      poisson_(material.poisson),
      linear_(material.linear() && !large_strain),
      bending_factor_(bending_factor(plane_strain(material.young, material.poisson))),
      weights_(weights.begin(), weights.end()),
      stresses_(weights.size()),
      dissipated_(weights.size(), 0.0),
      law_(make_law(material, weights.size(), large_strain, strengths)),
      fracture_(material.fracture),
      strengths_(strengths.begin(), strengths.end()) {
  auto layout = lay_out(grid);
  runs_ = std::move(layout.runs);
  for (const auto& corners : layout.shapes) shapes_.push_back(sampling_shape(kind, corners, bending_factor_));
  for (const auto& run : runs_) shape_of_.insert(shape_of_.end(), run.count, run.shape);
  if (!large_strain) return;
  corners_.emplace(weights.size());
  for (std::size_t z = 0; z < grid.zones.size(); ++z) {
    const Corners at = corners(grid, z);
    for (std::size_t c = 0; c < 4; ++c) {
      (*corners_)[c][z] = at.x[c];
      (*corners_)[4 + c][z] = at.y[c];
    }
  }
  zone_points_ = grid.zones;
}

// Zones `first` … `first + count`, which lie in the pieces of runs.
struct NonlinearZones::Batch {
  struct Piece {
    const ZoneRun* run;
    std::uint32_t done, count;
  };
  std::size_t first = 0;
  std::uint32_t count = 0, pieces = 0;
  std::array<Piece, kBatch> piece;
  CornerVectors moved, displacements;   // in the step; in all, in large strain
  ShapeBatch shapes;                    // undeformed
  const SamplingShape* same = nullptr;  // what all of `shapes` is
  StrainBatch strains;
  BatchValues pressures, mean;  // of the water; of the total stress
  CornerForces forces;
};

void NonlinearZones::add_forces(std::span<const ZoneRun> runs, double dt, const PointView& points) {
  Batch batch;
  const auto finish = [&] {
    prefetch(batch.first + batch.count);
    corners_ ? compute_in_large_strain(batch) : compute(batch);
    std::uint32_t from = 0;
    for (std::uint32_t p = 0; p < batch.pieces; ++p) {
      const auto& [run, done, count] = batch.piece[p];
      scatter(batch.forces, from, *run, done, count, points);
      from += count;
    }
    batch.count = batch.pieces = 0;
  };
  for (const auto& run : runs) {
    if (batch.count > 0 && run.first != batch.first + batch.count) finish();
    for (std::uint32_t done = 0; done < run.count;) {
      const std::uint32_t left = kBatch - (run.first + done) % kBatch,
                          count = std::min(left, run.count - done);
      take_up(run, done, count, dt, points, batch);
      done += count;
      if (count == left) finish();
    }
  }
  if (batch.count > 0) finish();
}

// Asks for what the zones of the next batch remember.
void NonlinearZones::prefetch(std::size_t first) const {
  stresses_.prefetch(first, kBatch);
  if (corners_) corners_->prefetch(first, kBatch);
  law_->prefetch(first);
}

void NonlinearZones::take_up(const ZoneRun& run, std::uint32_t done, std::uint32_t count, double dt,
                             const PointView& points, Batch& batch) const {
  const std::uint32_t at = batch.count;
  const auto gather = [&](const double* from, double factor, PointValues& to) {
    for (std::size_t c = 0; c < 4; ++c) {
      const double* corner = from + run.points[c] + done;
      double* values = to[c].data() + at;
      for (std::uint32_t i = 0; i < count; ++i) values[i] = factor * corner[i];
    }
  };
  gather(points.vx, dt, batch.moved.x);
  gather(points.vy, dt, batch.moved.y);
  if (corners_) {
    gather(ux_, 1, batch.displacements.x);
    gather(uy_, 1, batch.displacements.y);
  }
  const SamplingShape& shape = shapes_[run.shape];
  if (&shape != batch.same) {
    // Runs of the same shape follow one another mostly: then all places hold it.
    const std::uint32_t end = at == 0 ? kBatch : at + count;
    for (std::uint32_t i = at; i < end; ++i) batch.shapes.set(i, shape);
    batch.same = at == 0 ? &shape : nullptr;
  }
  if (at == 0) batch.first = run.first + done;
  batch.piece[batch.pieces++] = {&run, done, count};
  batch.count += count;
}

void NonlinearZones::compute(Batch& b) {
  const StressView stresses = view(stresses_, b.first);
  find_strains(kind_, b.count, b.shapes, b.moved, b.strains);
  law_->advance({b.first, b.count, b.shapes.point_area, b.strains, stresses, &dissipated_[b.first]});
  if (water_) water_->advance(b.first, b.count, b.strains.volume, b.pressures);
  find_forces(kind_, b.count, b.shapes, b.shapes, total(b), &weights_[b.first], b.forces);
}

ConstStressView NonlinearZones::total(Batch& b) const {
  ConstStressView stresses = view(stresses_, b.first);
  if (!water_) return stresses;
  for (std::uint32_t i = 0; i < b.count; ++i) b.mean[i] = stresses.mean[i] - b.pressures[i];
  stresses.mean = b.mean.data();
  return stresses;
}

void NonlinearZones::compute_in_large_strain(Batch& b) {
  const StressView stresses = view(stresses_, b.first);
  DeformedCorners corners{{}, {}, b.displacements, b.moved};
  for (std::size_t c = 0; c < 4; ++c) {
    corners.x[c] = &(*corners_)[c][b.first];
    corners.y[c] = &(*corners_)[4 + c][b.first];
  }
  ShapeBatch deformed;
  HalfTurns turns;
  find_shapes(kind_, b.count, corners, 0.5, bending_factor_, deformed);
  find_half_turns(b.count, deformed, b.moved, turns);
  find_strains(kind_, b.count, deformed, b.moved, b.strains);
  if (water_) {
    BatchValues growths;  // of the undeformed area
    for (std::uint32_t i = 0; i < b.count; ++i)
      growths[i] = b.strains.volume[i] * (deformed.area[i] / b.shapes.area[i]);
    water_->advance(b.first, b.count, growths, b.pressures);
  }
  turn(b.count, turns, stresses);
  law_->turn(b.first, b.count, turns);
  law_->advance({b.first, b.count, b.shapes.point_area, b.strains, stresses, &dissipated_[b.first]});
  turn(b.count, turns, stresses);
  law_->turn(b.first, b.count, turns);
  find_shapes(kind_, b.count, corners, 0, bending_factor_, deformed);
  if (water_)
    for (std::uint32_t i = 0; i < b.count; ++i) b.pressures[i] *= deformed.area[i] / b.shapes.area[i];
  find_forces(kind_, b.count, b.shapes, deformed, total(b), &weights_[b.first], b.forces);
}

void NonlinearZones::set_stress(std::size_t zone, const Stress& stress) {
  stresses_[kMeanStress][zone] = (stress.xx + stress.yy) / 2;
  for (std::size_t k = 0; k < 4; ++k) {
    stresses_[kDifference + k][zone] = (stress.xx - stress.yy) / 2;
    stresses_[kShearStress + k][zone] = stress.xy;
  }
  set_across(zone, poisson_ * (stress.xx + stress.yy));
}

void NonlinearZones::set_across(std::size_t zone, double zz) {
  stresses_[kAcross][zone] = zz;
  for (std::size_t k = 0; k < 4; ++k) law_->set_stress(zone, k, stress_at(zone, k));
}

// Of all stresses of the points with these generalized ones, those with the least energy: t = g_x q_x - g_y
// q_y and, where the pattern has a shear strain, s = g_y q_x + g_x q_y (sampling_shape.hpp), so that
//   Q_x = sum A (t g_x + s g_y),   Q_y = sum A (s g_x - t g_y).
void NonlinearZones::set_borne(std::size_t zone, const BorneStress& borne) {
  set_stress(zone, borne.mean);
  const double sheared = kind_ == ZoneKind::kMixedDiscretization ? 1 : 0;
  const auto& points = shapes_[shape_of_[zone]].points;
  double xx = 0, yy = 0, xy = 0;  // Q by q
  for (const auto& [area, gx, gy] : points) {
    xx += area * (gx * gx + sheared * gy * gy);
    yy += area * (gy * gy + sheared * gx * gx);
    xy -= area * (1 - sheared) * gx * gy;
  }
  const double size = xx * yy - xy * xy, qx = (yy * borne.pattern_x - xy * borne.pattern_y) / size,
               qy = (xx * borne.pattern_y - xy * borne.pattern_x) / size;
  for (std::size_t k = 0; k < 4; ++k) {
    stresses_[kDifference + k][zone] += points[k].gx * qx - points[k].gy * qy;
    stresses_[kShearStress + k][zone] += sheared * (points[k].gy * qx + points[k].gx * qy);
  }
  set_stress_zz(zone, borne.across);
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
  for (std::size_t z = 0; z < zone_points_.size(); ++z)
    for (std::size_t c = 0; c < 4; ++c) {
      (*corners_)[c][z] += ux_[zone_points_[z][c]];
      (*corners_)[4 + c][z] += uy_[zone_points_[z][c]];
    }
}

void NonlinearZones::exchange(state::Archive& archive) {
  stresses_.exchange(archive);
  archive("dissipated", std::span(dissipated_));
  if (corners_) corners_->exchange(archive);
  law_->exchange(archive);
}

PointStress NonlinearZones::stress_at(std::size_t zone, std::size_t k) const {
  return {stresses_[kMeanStress][zone], stresses_[kDifference + k][zone], stresses_[kShearStress + k][zone],
          stresses_[kAcross][zone]};
}

Corners NonlinearZones::corners_now(std::size_t zone) const {
  Corners at{};
  for (std::size_t c = 0; c < 4; ++c) {
    at.x[c] = (*corners_)[c][zone] + ux_[zone_points_[zone][c]];
    at.y[c] = (*corners_)[4 + c][zone] + uy_[zone_points_[zone][c]];
  }
  return at;
}

double NonlinearZones::stretch(std::size_t zone) const {
  return corners_ && ux_ ? area(corners_now(zone)) / shapes_[shape_of_[zone]].area : 1;
}

PointValues NonlinearZones::areas(std::size_t first, std::uint32_t count) const {
  const std::span shapes = std::span(shape_of_).subspan(first, count);
  const bool alike = std::ranges::all_of(shapes, [&](std::uint32_t shape) { return shape == shapes[0]; });
  PointValues areas{};
  for (std::size_t k = 0; k < 4; ++k)
    if (alike)  // as most are
      areas[k].fill(shapes_[shapes[0]].points[k].area);
    else
      for (std::uint32_t i = 0; i < count; ++i) areas[k][i] = shapes_[shapes[i]].points[k].area;
  return areas;
}

double NonlinearZones::strain_energy(const protocol::IndexRange& zones) const {
  BatchValues energies;
  double sum = 0;
  for (std::uint32_t first = zones.begin; first < zones.end;) {
    const std::uint32_t count = std::min(kBatch - first % kBatch, zones.end - first);
    law_->find_energies(first, count, areas(first, count), view(stresses_, first), energies);
    sum += protocol::eight_sums(0, count, [&](std::size_t i) { return weights_[first + i] * energies[i]; });
    first += count;
  }
  return sum;
}

void NonlinearZones::find_stresses(const protocol::IndexRange& zones, PlaneStresses& stresses) const {
  const std::uint32_t first = zones.begin, count = zones.end - first;
  mean_stresses(count, areas(first, count), view(stresses_, first), stresses);
  for (std::uint32_t i = 0; i < count; ++i) {
    const double factor = weights_[first + i] == 0 ? 0 : 1 / stretch(first + i);
    for (auto* values : {&stresses.mean, &stresses.difference, &stresses.shear}) (*values)[i] *= factor;
  }
}

double NonlinearZones::dissipated() const {
  double sum = 0;
  for (std::size_t z = 0; z < count(); ++z) sum += weights_[z] * dissipated_[z];
  return sum;
}

Stress NonlinearZones::stress(std::size_t zone) const {
  if (weights_[zone] == 0) return {};  // taken away
  const auto& shape = shapes_[shape_of_[zone]];
  const double inverse = 1 / stretch(zone);
  const double mean = inverse * stresses_[kMeanStress][zone];
  double difference = 0, shear = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const double share = inverse * shape.points[k].area / shape.area;
    difference += share * stresses_[kDifference + k][zone];
    shear += share * stresses_[kShearStress + k][zone];
  }
  return {mean + difference, mean - difference, shear};
}

ZoneForces NonlinearZones::forces(std::size_t zone) const {
  if (weights_[zone] == 0) return {};
  ShapeBatch undeformed, now;
  undeformed.set(0, shapes_[shape_of_[zone]]);
  now.set(0, corners_ && ux_ ? sampling_shape(kind_, corners_now(zone), bending_factor_)
                             : shapes_[shape_of_[zone]]);
  const double whole = 1;
  CornerForces forces;
  find_forces(kind_, 1, undeformed, now, view(stresses_, zone), &whole, forces);
  return first_of(forces);
}

double NonlinearZones::demand(std::size_t zone) const {
  if (weights_[zone] == 0) return 0;
  double largest = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const PointStress stress = stress_at(zone, k);
    largest = std::max(largest, law_->demand(zone, k, stress));
    if (fracture_)
      largest = std::max(
          largest,
          fdm::demand(strengths_.empty() ? *fracture_ : times(strengths_[zone], *fracture_), stress));
  }
  return largest;
}

double NonlinearZones::field(std::size_t zone, ZoneField field) const {
  if (weights_[zone] == 0) return 0;
  if (field == ZoneField::kStressZz) return stresses_[kAcross][zone] / stretch(zone);
  const auto& shape = shapes_[shape_of_[zone]];
  double strain = 0;
  unsigned yields = kElastic;
  for (std::size_t k = 0; k < 4; ++k) {
    strain += shape.points[k].area / shape.area * law_->plastic_shear_strain(zone, k);
    yields |= law_->yields(zone, k);
  }
  return field == ZoneField::kPlasticShearStrain ? strain : yields;
}

}  // namespace adit::fdm
