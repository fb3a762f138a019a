#include "dem_server/observe/cell_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "dem_server/observe/crack_paths.hpp"
#include "dem_server/observe/snapshot.hpp"

namespace adit::dem {
namespace {

PlaneVector turned(double angle, const PlaneVector& v) {
  return vector_of(std::cos(angle), std::sin(angle), v.x, v.y);
}

// How far a place on a cell has moved since displacements count: with its nucleus, and about it.
class CellMotion {
 public:
  explicit CellMotion(const Observable& observed)
      : p_(observed.particles()), turn_(observed.turn()), settled_(observed.settled_turn()) {}

  PlaneVector at(std::uint32_t cell, double x, double y) const {
    const PlaneVector arm{x - p_.x[cell], y - p_.y[cell]};
    const PlaneVector now = turned(turn_of(cell, turn_), arm), then = turned(turn_of(cell, settled_), arm);
    return {p_.ux[cell] - p_.settled_x[cell] + now.x - then.x,
            p_.uy[cell] - p_.settled_y[cell] + now.y - then.y};
  }

 private:
  static double turn_of(std::uint32_t cell, std::span<const double> turns) {
    return turns.empty() ? 0 : turns[cell];
  }

  const Particles& p_;
  std::span<const double> turn_, settled_;
};

// Points with their displacements.
class Points {
 public:
  explicit Points(wire::Piece& piece) : piece_(piece) {}

  void add(double x, double y, const PlaneVector& moved) {
    piece_.add_connectivity(static_cast<std::uint32_t>(ux_.size()));
    piece_.add_points(x);
    piece_.add_points(y);
    ux_.push_back(moved.x);
    uy_.push_back(moved.y);
  }
  void end() { add_vectors(*piece_.mutable_point_fields(), "displacement_m", ux_, uy_); }

 private:
  wire::Piece& piece_;
  std::vector<double> ux_, uy_;
};

wire::Piece& begin_piece(const std::string& name, wire::Piece::Shape shape, wire::Snapshot& snapshot) {
  wire::Piece& piece = *snapshot.add_pieces();
  piece.set_name(name);
  piece.set_shape(shape);
  return piece;
}

// A field of the particles that are there becomes one of their polygons.
void copy_field(const std::string& name, const Particles& p, const wire::Piece& from, wire::Piece& to) {
  const wire::Field& field =
      *std::ranges::find(from.point_fields(), name, [](const wire::Field& one) { return one.name(); });
  const int components = static_cast<int>(field.components());
  auto& values = add_field(*to.mutable_cell_fields(), name, field.components());
  for (std::uint32_t i = 0; i < p.size(); ++i)
    for (int k = 0; p.is_there(i) && k < components; ++k)
      values.Add(field.values(components * static_cast<int>(i) + k));
}

}  // namespace

void add_cells(const Observable& observed, wire::Snapshot& snapshot) {
  const auto outlines = observed.outlines();
  if (outlines.empty()) return;
  const Particles& p = observed.particles();
  wire::Piece& piece = begin_piece("cells", wire::Piece::POLYGONS, snapshot);
  const CellMotion motion(observed);
  Points points(piece);
  for (std::uint32_t i = 0; i < p.size(); ++i) {
    if (!p.is_there(i)) continue;
    for (const geometry::Point& corner : outlines[i]) {
      const double x = p.x[i] + corner.x, y = p.y[i] + corner.y;
      points.add(x, y, motion.at(i, x, y));
    }
    piece.add_corners(static_cast<std::uint32_t>(outlines[i].size()));
  }
  points.end();
  for (const char* name : {"group", "stress_Pa", "fragment"}) copy_field(name, p, snapshot.pieces(0), piece);
}

void add_cracks(const Observable& observed, wire::Snapshot& snapshot) {
  const auto cracks = observed.cracks();
  if (cracks.empty()) return;
  const CrackPaths paths = paths_of(cracks);
  wire::Piece& piece = begin_piece("cracks", wire::Piece::LINES, snapshot);
  const CellMotion motion(observed);
  Points points(piece);
  Fields& fields = *piece.mutable_cell_fields();
  std::vector<double> state, opening, slip, path, debonded;
  for (const ObservedCrack& crack : cracks) {
    for (const auto& [x, y] : {PlaneVector{crack.x_1, crack.y_1}, PlaneVector{crack.x_2, crack.y_2}}) {
      const PlaneVector a = motion.at(crack.first, x, y), b = motion.at(crack.second, x, y);
      points.add(x, y, {(a.x + b.x) / 2, (a.y + b.y) / 2});
    }
    path.push_back(paths.number[state.size()]);
    state.push_back(static_cast<double>(crack.mode));
    opening.push_back(crack.opening);
    slip.push_back(crack.slip);
    debonded.push_back(crack.debonded ? 1 : 0);
  }
  points.end();
  add_scalars(fields, "state", state);
  add_scalars(fields, "opening_m", opening);
  add_scalars(fields, "slip_m", slip);
  add_scalars(fields, "path", path);
  add_scalars(fields, "debonded", debonded);
}

void add_bars(const Observable& observed, wire::Snapshot& snapshot) {
  const auto bars = observed.bars();
  if (bars.empty()) return;
  wire::Piece& piece = begin_piece("bars", wire::Piece::LINES, snapshot);
  const CellMotion motion(observed);
  Points points(piece);
  Fields& fields = *piece.mutable_cell_fields();
  std::vector<double> number, stress, strain, force, dowel, slip;
  for (const ObservedBar& bar : bars) {
    if (!bar.whole) continue;
    points.add(bar.x_1, bar.y_1, motion.at(bar.first, bar.x_1, bar.y_1));
    points.add(bar.x_2, bar.y_2, motion.at(bar.second, bar.x_2, bar.y_2));
    number.push_back(bar.bar);
    stress.push_back(bar.stress);
    strain.push_back(bar.strain);
    force.push_back(bar.pull);
    dowel.push_back(bar.dowel);
    slip.push_back((bar.slip_1 + bar.slip_2) / 2);
  }
  points.end();
  add_scalars(fields, "bar", number);
  add_scalars(fields, "stress_Pa", stress);
  add_scalars(fields, "strain", strain);
  add_scalars(fields, "force_N", force);
  add_scalars(fields, "dowel_force_N", dowel);
  add_scalars(fields, "slip_m", slip);
}

}  // namespace adit::dem
