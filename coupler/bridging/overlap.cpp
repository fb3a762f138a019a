#include "coupler/bridging/overlap.hpp"

#include <algorithm>

#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

// What lies on an edge of the strip belongs to it, whatever the last digits of its place are.
constexpr double kEdge = 1e-9;  // of the width

}  // namespace

Overlap::Overlap(const scene::Overlap& overlap)
    : begin_x_(overlap.particles_begin().x()), begin_y_(overlap.particles_begin().y()) {
  const double dx = overlap.continuum_ends().x() - begin_x_;
  const double dy = overlap.continuum_ends().y() - begin_y_;
  const double squared_width = dx * dx + dy * dy;
  if (!(squared_width > 0))
    throw protocol::UserError("interface.overlap",
                              "has no width: particles_begin and continuum_ends coincide; place "
                              "continuum_ends at least one zone further into the particles");
  gradient_x_ = dx / squared_width;
  gradient_y_ = dy / squared_width;
}

double Overlap::across(double x, double y) const {
  return gradient_x_ * (x - begin_x_) + gradient_y_ * (y - begin_y_);
}

double Overlap::continuum_weight(double x, double y) const {
  return 1.0 - std::clamp(across(x, y), 0.0, 1.0);
}

double Overlap::particle_weight(double x, double y) const {
  const double share = across(x, y);
  return share < -kEdge ? 0.0 : std::clamp(share, kEdge, 1.0);
}

bool Overlap::contains(double x, double y) const {
  const double share = across(x, y);
  return share >= -kEdge && share <= 1.0 + kEdge;
}

bool Overlap::begins_in(const BoundingBox& model) const {
  return meets(model, 0.0);
}

bool Overlap::ends_in(const BoundingBox& model) const {
  return meets(model, 1.0);
}

bool Overlap::meets(const BoundingBox& model, double edge) const {
  const auto [lowest, highest] =
      std::minmax({across(model.x_min, model.y_min), across(model.x_max, model.y_min),
                   across(model.x_min, model.y_max), across(model.x_max, model.y_max)});
  return lowest <= edge + kEdge && edge - kEdge <= highest;
}

std::vector<double> Overlap::continuum_weights(std::span<const double> points) const {
  std::vector<double> weights(points.size() / 2);
  for (std::size_t i = 0; i < weights.size(); ++i)
    weights[i] = continuum_weight(points[2 * i], points[2 * i + 1]);
  return weights;
}

std::vector<double> Overlap::particle_weights(std::span<const double> points) const {
  std::vector<double> weights(points.size() / 2);
  for (std::size_t i = 0; i < weights.size(); ++i)
    weights[i] = particle_weight(points[2 * i], points[2 * i + 1]);
  return weights;
}

BoundingBox Overlap::bounds(const BoundingBox& model) const {
  // The strip is unbounded along its two lines; a strip along an axis cuts the model's box exactly, any
  // other is covered by the whole box, of which only a little is offered in vain.
  BoundingBox box = model;
  if (follows_x()) {
    box.x_min = std::max(box.x_min, std::min(begin_x_, begin_x_ + 1.0 / gradient_x_));
    box.x_max = std::min(box.x_max, std::max(begin_x_, begin_x_ + 1.0 / gradient_x_));
  }
  if (follows_y()) {
    box.y_min = std::max(box.y_min, std::min(begin_y_, begin_y_ + 1.0 / gradient_y_));
    box.y_max = std::min(box.y_max, std::max(begin_y_, begin_y_ + 1.0 / gradient_y_));
  }
  return box;
}

}  // namespace adit::coupler
