#include "dem_server/model/placement/placement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "dem_server/model/calibration.hpp"
#include "dem_server/model/placement/cells.hpp"
#include "dem_server/model/placement/placed_table.hpp"
#include "dem_server/model/placement/scene_checks.hpp"
#include "dem_server/packing/discs.hpp"
#include "dem_server/packing/regular.hpp"
#include "protocol/errors.hpp"
#include "protocol/geometry/selection.hpp"

namespace adit::dem {
namespace {

using protocol::UserError;
using Notes = std::vector<std::string>;

// Stress over normal stiffness above which discs overlap by more than a tenth of their radii.
constexpr double kLargestStress = 0.1;

Placement hexagonal(const scene::HexagonalPacking& wanted) {
  const std::string path = "particles.packing";
  const double radius = wanted.radius();
  const geometry::BoundingBox box = box_of(wanted);
  require_room_for(count_hexagonal(box, radius), radius, path + ".radius");
  HexagonalLattice lattice = pack_hexagonally(box, radius);
  if (lattice.discs.size() == 0) refuse_small_box(wanted, 0);
  return {std::move(lattice.discs), cell_mass, lattice.cells, {}};
}

Placement square(const scene::SquarePacking& wanted) {
  const std::string path = "particles.square_packing";
  const double radius = wanted.radius();
  const geometry::BoundingBox box = box_of(wanted);
  require_room_for((box.x_max - box.x_min) * (box.y_max - box.y_min) / (4 * radius * radius), radius,
                   path + ".radius");
  Discs discs = pack_squarely(box, radius);
  if (discs.size() == 0) throw UserError(path, "holds no particle; enlarge the box or reduce the radius");
  const auto extent = extent_of(discs);
  return {std::move(discs), [](double density, double r) { return density * (4 * r * r); }, extent, {}};
}

RandomPacking checked(const scene::RandomPacking& wanted, double normal_stiffness) {
  const std::string path = "particles.random_packing";
  const RandomPacking packing{box_of(wanted),
                              wanted.radius_min(),
                              wanted.radius_max(),
                              wanted.porosity(),
                              wanted.stress() / normal_stiffness,
                              wanted.seed(),
                              wanted.keep_floaters(),
                              wanted.keep_stress()};
  const double side = std::min(packing.box.x_max - packing.box.x_min, packing.box.y_max - packing.box.y_min);
  if (side < 4 * packing.radius_max)
    throw UserError(path + ".radius_max",
                    fmt::format("is {} m, but the box is only {} m wide; give at most a quarter of that",
                                packing.radius_max, side));
  if (packing.stress > kLargestStress)
    throw UserError(
        path + ".stress",
        fmt::format("is {} Pa, but at a normal stiffness of {:.4g} N/m discs would be pressed flat; give "
                    "at most {:.3g} Pa",
                    wanted.stress(), normal_stiffness, kLargestStress * normal_stiffness));
  require_room_for(count_random(packing), packing.radius_min, path + ".radius_min");
  return packing;
}

Placement random(const scene::RandomPacking& scene, double normal_stiffness, const Growing& growing,
                 Notes& notes) {
  const RandomPacking wanted = checked(scene, normal_stiffness);
  auto grown = pack_randomly(wanted, growing);
  if (!grown)
    throw UserError(
        "particles.random_packing.porosity",
        fmt::format("is {}, from which no packing that bears {} Pa was reached; choose one nearer to 0.16",
                    wanted.porosity, scene.stress()));
  const PackingState& state = grown->state;
  notes.push_back(
      fmt::format("random packing: {} particles, porosity {:.4f}, stress {:.4g} Pa across and {:.4g} Pa up "
                  "({:.4g} Pa wanted), "
                  "{:.2f} contacts a particle, radii {:.4f} times the drawn ones, {} floaters {}",
                  grown->discs.size(), state.porosity, state.stress_x * normal_stiffness,
                  state.stress_y * normal_stiffness, scene.stress(), state.coordination, state.radius_factor,
                  state.floaters, wanted.keep_floaters ? "kept" : "taken away"));
  const auto& radius = grown->discs.radius;
  const double squares = std::inner_product(radius.begin(), radius.end(), radius.begin(), 0.0);
  const double box = (wanted.box.x_max - wanted.box.x_min) * (wanted.box.y_max - wanted.box.y_min);
  const auto share_of_box = [=](double density, double r) { return density * (box * r * r / squares); };
  const auto extent = extent_of(grown->discs);
  return {std::move(grown->discs), share_of_box, extent, {}, !scene.keep_stress()};
}

void refuse_deep_overlaps(const Discs& discs, const std::string& path) {
  for (const auto [i, j] : pairs_within(discs, 0)) {
    const double distance = std::hypot(discs.x[j] - discs.x[i], discs.y[j] - discs.y[i]);
    if (distance == 0)
      throw UserError(
          path, fmt::format("particles {} and {} (counted from 0) both lie at ({}, {}) m; take one away", i,
                            j, discs.x[i], discs.y[i]));
    const double overlap = discs.radius[i] + discs.radius[j] - distance;
    if (overlap > std::min(discs.radius[i], discs.radius[j]) / 2)
      throw UserError(
          path, fmt::format("particles {} and {} (counted from 0) overlap by {:.4g} m at ({:.6g}, {:.6g}) "
                            "m, more than half the smaller radius; move them apart",
                            i, j, overlap, discs.x[i], discs.y[i]));
  }
}

// Rounding in a file opens gaps: it moves both discs in both directions, and changes both radii.
constexpr double kFine = 2e-4;     // of a radius: numbers with a coarser last digit are meant as they stand
constexpr double kNearest = 0.02;  // of a radius

Reach reach_after_rounding(const PlacedDiscs& table) {
  const double radius = std::ranges::min(table.discs.radius);
  const auto gap = [radius](double x, double y, double size) {
    return 2 * (std::hypot(x, y) + size) / radius;
  };
  const auto fine = [radius](double rounding) { return rounding <= kFine * radius ? rounding : 0; };
  Reach reach;
  reach.unstated = std::max(reach.unstated,
                            gap(fine(table.x_rounding), fine(table.y_rounding), fine(table.radius_rounding)));
  reach.near =
      std::clamp(gap(table.x_rounding, table.y_rounding, table.radius_rounding), reach.near, kNearest);
  return reach;
}

Placement placed(const scene::PlacedParticles& wanted, Notes& notes) {
  const std::string path = "particles.placed.path";
  const std::string& content = wanted.content();
  const auto begin = content.find_first_not_of(" \t\r\n");
  const bool xml = begin != std::string::npos && content[begin] == '<';
  PlacedDiscs table = xml ? read_vtp(content, path) : read_csv(content, path);
  if (table.discs.size() == 0) throw UserError(path, "holds no particles; give at least one");
  require_room_for(static_cast<double>(table.discs.size()), std::ranges::min(table.discs.radius), path);
  refuse_deep_overlaps(table.discs, path);
  const auto extent = extent_of(table.discs);
  const auto own_area = [](double density, double r) { return density * (std::numbers::pi * r * r); };
  const Reach reach = reach_after_rounding(table);
  if (reach.unstated > Reach{}.unstated)
    notes.push_back(fmt::format(
        "{}: its numbers are rounded; bonds without a `reach` of their own join particles up to {:.2g} "
        "of their mean radius apart",
        path, reach.unstated));
  return {std::move(table.discs), own_area, extent, std::move(table.number), false, reach};
}

Placement fill(const scene::Particles& p, double normal_stiffness, const Growing& growing, Notes& notes) {
  const int given =
      p.has_packing() + p.has_square_packing() + p.has_random_packing() + p.has_placed() + p.has_cells();
  if (given != 1)
    throw UserError(
        "particles",
        fmt::format("has {} packings; give one of cells, packing, square_packing, random_packing and placed",
                    given == 0 ? "no" : std::to_string(given)));
  if (p.has_cells()) return place_cells(p);
  if (p.has_packing()) return hexagonal(p.packing());
  if (p.has_square_packing()) return square(p.square_packing());
  if (p.has_random_packing()) return random(p.random_packing(), normal_stiffness, growing, notes);
  return placed(p.placed(), notes);
}

std::vector<bool> flags(std::size_t count, const std::vector<std::uint32_t>& chosen) {
  std::vector<bool> flags(count, false);
  for (const std::uint32_t i : chosen) flags[i] = true;
  return flags;
}

void keep_ring(const scene::SegmentRing& ring, Placement& placement) {
  const std::string path = "particles.ring";
  const double slack = placement.tolerance();
  std::vector<bool> inside;
  for (std::size_t i = 0; i < placement.discs.size(); ++i) {
    const double r =
        std::hypot(placement.discs.x[i] - ring.centre().x(), placement.discs.y[i] - ring.centre().y());
    inside.push_back(r >= ring.inner_radius() - slack &&
                     (ring.within_ground() || r <= ring.outer_radius() + slack));
  }
  if (std::ranges::count(inside, true) == 0)
    throw UserError(path, "leaves no particles; give a packing that covers what lies between its circles");
  placement.keep_only(inside);
}

}  // namespace

void refuse_small_box(const scene::HexagonalPacking& packing, std::size_t particles) {
  throw UserError(
      "particles.packing",
      fmt::format(
          "a box of {} m x {} m holds {} particle(s) of radius {} m (a row is sqrt(3) R high, a disc 2 R "
          "wide) and no bond; enlarge the box or reduce the radius",
          packing.x_max() - packing.x_min(), packing.y_max() - packing.y_min(), particles, packing.radius()));
}

void Placement::keep_only(const std::vector<bool>& keep) {
  dem::keep_only(keep, discs);
  if (!number.empty()) dem::keep_only(keep, number);
  if (cells) cells->keep_only(keep);
  if (std::ranges::count(keep, false) > 0) extent = extent_of(discs);
}

double Placement::tolerance() const {
  if (discs.size() == 0) return 0;
  const auto [left, right] = std::ranges::minmax(discs.x);
  const auto [below, above] = std::ranges::minmax(discs.y);
  return 1e-9 * std::max({right - left, above - below, std::ranges::max(discs.radius)});
}

std::vector<std::uint32_t> select(const scene::Area& area, const Placement& placement,
                                  const std::string& path) {
  std::vector<double> centres;
  for (std::size_t i = 0; i < placement.discs.size(); ++i)
    centres.insert(centres.end(), {placement.discs.x[i], placement.discs.y[i]});
  return protocol::select(area, centres, placement.tolerance(), path, "particles");
}

Placement place_discs(const scene::Particles& particles, double normal_stiffness, const Growing& growing,
                      Notes& notes) {
  Placement placement = fill(particles, normal_stiffness, growing, notes);
  if (particles.has_within())
    placement.keep_only(
        flags(placement.discs.size(), select(particles.within(), placement, "particles.within")));
  if (particles.has_ring()) keep_ring(particles.ring(), placement);
  return placement;
}

}  // namespace adit::dem
