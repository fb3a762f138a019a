#include "coupler/bridging/overlap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "protocol/errors.hpp"
#include "protocol/geometry/read_shape.hpp"

namespace adit::coupler {
namespace {

using protocol::UserError;

// A point on an edge of the overlap belongs to the overlap, whatever the rounding of its coordinates. The
// edge therefore has a thickness, relative to the width of the overlap and to the size of the coordinates.
constexpr double kEdge = 1e-9;
constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();

void require(bool given, const std::string& path, const char* field, const char* purpose) {
  if (!given) throw UserError(path + "." + field, std::string("is missing; ") + purpose);
}

void require_one_kind(const scene::Overlap& overlap, const std::string& path) {
  const bool strip = overlap.has_particles_begin() || overlap.has_continuum_ends();
  const bool ring = overlap.has_around() || overlap.has_width();
  if (strip && ring)
    throw UserError(path,
                    "is a strip and a ring at once; keep particles_begin and continuum_ends, or around and "
                    "width");
  if (!strip && !ring)
    throw UserError(path,
                    "is neither a strip nor a ring; give particles_begin and continuum_ends, or around and "
                    "width");
  if (ring) {
    require(overlap.has_around(), path, "around", "give the shape that the ring lies around");
    require(overlap.has_width(), path, "width", "give the ring's width");
  } else {
    require(overlap.has_particles_begin(), path, "particles_begin", "give the point where the strip begins");
    require(overlap.has_continuum_ends(), path, "continuum_ends", "give the point where the strip ends");
  }
}

double width_of(const scene::Overlap& overlap, const std::string& path) {
  if (overlap.has_around()) return overlap.width();
  const double width = std::hypot(overlap.particles_begin().x() - overlap.continuum_ends().x(),
                                  overlap.particles_begin().y() - overlap.continuum_ends().y());
  if (!(width > 0))
    throw UserError(
        path,
        "has no width: particles_begin and continuum_ends coincide; place continuum_ends at least "
        "one zone further into the particles");
  return width;
}

std::shared_ptr<const geometry::Shape> core_of(const scene::Overlap& overlap, double width,
                                               const std::string& path) {
  if (overlap.has_around()) return geometry::read_shape(overlap.around(), path + ".around");
  const auto &begin = overlap.particles_begin(), &end = overlap.continuum_ends();
  return geometry::half_plane(end.x(), end.y(), (begin.x() - end.x()) / width, (begin.y() - end.y()) / width);
}

// Weight of the outer model at the depth `s` between the edges (overlap.hpp).
double ramp(scene::Ramp kind, double s) {
  switch (kind) {
    case scene::LINEAR:
      return s;
    case scene::CUBIC:
      return s * s * (3 - 2 * s);
    case scene::CONSTANT:
      return 0.5;
  }
  return s;
}

}  // namespace

Overlap::Overlap(const scene::Interface& interface, const std::string& path)
    : interface_(interface), path_(path) {
  const std::string overlap_path = path + ".overlap";
  require_one_kind(interface.overlap(), overlap_path);
  width_ = width_of(interface.overlap(), overlap_path);
  core_ = core_of(interface.overlap(), width_, overlap_path);
}

double Overlap::share(double x, double y) const {
  return core_->distance(x, y) / width_;
}

double Overlap::edge(double x, double y) const {
  return kEdge + kRounding * (std::abs(x) + std::abs(y)) / width_;
}

double Overlap::depth(double x, double y) const {
  return std::clamp(share(x, y), 0.0, 1.0);
}

double Overlap::outer_weight(double x, double y) const {
  const double s = share(x, y), thickness = edge(x, y);
  if (s <= thickness) return 0.0;
  if (s >= 1.0 - thickness) return 1.0;
  return ramp(interface_.ramp(), s);
}

// The smallest weight inside the overlap is kEdge and not 0, so that a particle on the edge exists
// (overlap.hpp).
double Overlap::inner_weight(double x, double y) const {
  const double thickness = edge(x, y);
  return share(x, y) > 1.0 + thickness ? 0.0 : std::max(kEdge, 1.0 - outer_weight(x, y));
}

bool Overlap::contains(double x, double y) const {
  const double s = share(x, y), thickness = edge(x, y);
  return s >= -thickness && s <= 1.0 + thickness;
}

BoundingBox Overlap::bounds(const BoundingBox& model) const {
  const BoundingBox box = core_->box_around(width_);
  const double margin = width_ * std::max(edge(model.x_min, model.y_min), edge(model.x_max, model.y_max));
  return {std::max(model.x_min, box.x_min - margin), std::min(model.x_max, box.x_max + margin),
          std::max(model.y_min, box.y_min - margin), std::min(model.y_max, box.y_max + margin)};
}

}  // namespace adit::coupler
