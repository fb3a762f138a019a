#include "dem_server/model/reading/bars.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dem_server/model/placement/crossed.hpp"
#include "dem_server/model/solid/facets_of_material.hpp"
#include "protocol/errors.hpp"
#include "protocol/geometry/read_path.hpp"
#include "protocol/materials/read_steel.hpp"
#include "protocol/sections/bars_area.hpp"

namespace adit::dem {
namespace {

using geometry::Point;
using protocol::require;

struct BarLine {
  std::vector<Point> points;
  bool closed = false;
};

BarLine read_circle(const scene::RoundPath& circle, const std::string& path) {
  constexpr double kTurn = 2 * std::numbers::pi, kPiece = kTurn / 1440;
  geometry::require_arc(circle, path);
  const double turn = circle.has_from() ? circle.to() - circle.from() : kTurn;
  const int pieces = std::max(1, static_cast<int>(std::ceil(turn / kPiece)));
  BarLine line{.points = {}, .closed = !circle.has_from()};
  for (int k = 0; k <= pieces; ++k) {
    const double angle = circle.from() + turn * k / pieces;
    line.points.push_back({circle.centre().x() + circle.radius() * std::cos(angle),
                           circle.centre().y() + circle.radius() * std::sin(angle)});
  }
  return line;
}

BarLine read_line(const scene::LinePath& line, const std::string& path) {
  BarLine read;
  for (const auto& point : line.points()) read.points.push_back({point.x(), point.y()});
  geometry::require_simple(read.points, path);
  const Point &first = read.points.front(), &last = read.points.back();
  read.closed = first.x == last.x && first.y == last.y;
  return read;
}

BarLine read_along(const scene::BarPath& along, const std::string& path) {
  require(along.path_case() != scene::BarPath::PATH_NOT_SET, path, "names no path; give `circle` or `line`");
  return along.has_circle() ? read_circle(along.circle(), path + ".circle")
                            : read_line(along.line(), path + ".line");
}

// A bar is held by the particles in which a good part of it lies: those of which it cuts a corner take no
// share, and elements stay about as long as particles.
std::vector<Crossed> holding(const std::vector<Crossed>& crossed, const Model& model) {
  constexpr double kLeast = 0.3;  // of the root of a particle's area
  std::vector<Crossed> kept;
  std::ranges::copy_if(crossed, std::back_inserter(kept), [&](const Crossed& one) {
    return one.length() >= kLeast * std::sqrt(model.cell_area(one.disc));
  });
  return kept;
}

// A whole circle may begin within a particle: it is then counted once, from before the line's first point.
void close(double length, std::vector<Crossed>& crossed) {
  if (crossed.size() < 2 || crossed.front().disc != crossed.back().disc) return;
  crossed.front().begin = crossed.back().begin - length;
  crossed.pop_back();
}

// Half of the way to the neighbours, to the outermost particles' ends at the ends of the bar.
std::vector<double> bonded_lengths(const std::vector<Crossed>& all, const std::vector<Crossed>& held,
                                   const BarLine& line) {
  const double length = length_of(line.points);
  std::vector<double> ends{line.closed ? (held.back().middle() - length + held.front().middle()) / 2
                                       : all.front().begin};
  for (std::size_t k = 0; k + 1 < held.size(); ++k)
    ends.push_back((held[k].middle() + held[k + 1].middle()) / 2);
  ends.push_back(line.closed ? ends.front() + length : all.back().end);
  std::vector<double> lengths;
  for (std::size_t k = 0; k < held.size(); ++k) lengths.push_back(ends[k + 1] - ends[k]);
  return lengths;
}

void require_inside(const std::vector<Crossed>& crossed, const BarLine& line, const Model& model,
                    const std::string& path) {
  for (std::size_t k = 0; k + 1 < crossed.size(); ++k) {
    const double gap = crossed[k + 1].begin - crossed[k].end;
    const Point place = place_on(line.points, crossed[k].end);
    require(
        gap <= 2 * model.discs.radius[crossed[k].disc], path,
        fmt::format("leaves the particles at ({:.6g}, {:.6g}) m for {:.4g} m; end the bar there, or lead it "
                    "through particles",
                    place.x, place.y, gap));
  }
}

// Of the concrete, at a particle [Pa].
double strength_at(std::uint32_t disc, const scene::ParticleBar& bar, const std::vector<Group>& groups,
                   const Model& model, const std::string& path) {
  if (bar.has_concrete_strength()) return bar.concrete_strength();
  const MaterialAt& at = groups[model.group[disc]].material;
  require(at.material.has_fracture(), path + ".concrete_strength",
          "is missing, and the particles' material has no `fracture` that states it; give it");
  return compressive_strength(fracture_of(at.material.fracture(), at.path + ".fracture"));
}

BarBondLaw bond_of(const scene::BarBond& bond, double concrete) {
  constexpr double kMega = 1e6;
  return {
      bond.stiffness(),     bond.has_strength() ? bond.strength() : 2.5 * std::sqrt(concrete / kMega) * kMega,
      bond.peak_slip(),     bond.plateau_slip(),
      bond.residual_slip(), bond.exponent(),
      bond.residual()};
}

void set_dowel(const Bar& bar, double concrete, BarNode& node) {
  const double d = bar.diameter, bars = bar.area / sections::bar_area(d);
  const double bending = bar.steel.modulus * std::numbers::pi / 64 * d * d * d * d;
  const double foundation = 127e9 * std::sqrt(concrete / 1e6) / std::pow(1000 * d, 2.0 / 3);  // [Pa/m]
  node.dowel_stiffness = bars * bending * std::pow(foundation * d / (4 * bending), 0.75);
  node.dowel_strength = bars * 1.3 * d * d * std::sqrt(concrete * bar.steel.yield);
}

Bar read_bar(const scene::ParticleBar& given, const std::vector<Group>& groups, const Model& model,
             const std::string& path) {
  const double area = sections::bars_area(given, path);
  require(!given.has_values() || given.steel().has_class_(), path + ".values",
          "chooses among the values of a class of steel, but the steel is given by numbers; leave it out");
  const protocol::SteelValues steel =
      protocol::read_steel(given.steel(), protocol::values_of(given.values()), path + ".steel");
  const BarLine line = read_along(given.along(), path + ".along");
  std::vector<Crossed> all = crossed_by(line.points, model);
  if (line.closed) close(length_of(line.points), all);
  const std::vector<Crossed> held = holding(all, model);
  const std::size_t fewest = line.closed ? 3 : 2;
  require(held.size() >= fewest, path + ".along",
          fmt::format("passes through {} particles, and a bar is held by {} and more; lead it through them",
                      held.size(), fewest));
  require_inside(all, line, model, path + ".along");
  Bar bar{
      {},  line.closed, protocol::steel_law(steel), steel.limit_strain, area, given.diameter(), given.stage(),
      path};
  const std::vector<double> lengths = bonded_lengths(all, held, line);
  for (std::size_t k = 0; k < held.size(); ++k) {
    const Point place = place_on(line.points, held[k].middle());
    const double concrete = strength_at(held[k].disc, given, groups, model, path);
    BarNode node{held[k].disc, place.x, place.y, lengths[k], bond_of(given.bond(), concrete), 0, 0};
    set_dowel(bar, concrete, node);
    bar.nodes.push_back(node);
  }
  return bar;
}

}  // namespace

std::vector<Bar> read_bars(const scene::Particles& particles, const std::vector<Group>& groups,
                           const Model& model) {
  std::vector<Bar> bars;
  for (int k = 0; k < particles.bars_size(); ++k)
    bars.push_back(read_bar(particles.bars(k), groups, model, fmt::format("particles.bars[{}]", k)));
  return bars;
}

}  // namespace adit::dem
