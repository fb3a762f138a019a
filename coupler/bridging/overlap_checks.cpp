#include "coupler/bridging/overlap_checks.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <vector>

#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

using protocol::UserError;

constexpr double kTolerance = 0.15;

std::string reach(const BoundingBox& box) {
  return fmt::format("reaches from ({:g}, {:g}) to ({:g}, {:g}) m", box.x_min, box.y_min, box.x_max,
                     box.y_max);
}

BoundingBox grown(const BoundingBox& box, double by_x, double by_y) {
  return {box.x_min - by_x, box.x_max + by_x, box.y_min - by_y, box.y_max + by_y};
}

// The parts of `box` that lie beyond each side of `other`.
std::vector<BoundingBox> outside(const BoundingBox& box, const BoundingBox& other) {
  std::vector<BoundingBox> parts;
  if (box.x_min < other.x_min)
    parts.push_back({box.x_min, std::min(box.x_max, other.x_min), box.y_min, box.y_max});
  if (box.x_max > other.x_max)
    parts.push_back({std::max(box.x_min, other.x_max), box.x_max, box.y_min, box.y_max});
  if (box.y_min < other.y_min)
    parts.push_back({box.x_min, box.x_max, box.y_min, std::min(box.y_max, other.y_min)});
  if (box.y_max > other.y_max)
    parts.push_back({box.x_min, box.x_max, std::max(box.y_min, other.y_max), box.y_max});
  return parts;
}

bool meets_core_or_overlap(const Overlap& overlap, const BoundingBox& box) {
  return overlap.core().distance(box) < overlap.width();
}

bool meets_overlap(const Overlap& overlap, const BoundingBox& box) {
  return meets_core_or_overlap(overlap, box) && !overlap.core().covers(box);
}

// The two edges are parallel lines. Both run through the box if one of its corners lies before both of them
// and another behind both.
void require_edges_inside(const Overlap& overlap, const std::string& model, const BoundingBox& box) {
  const auto [lowest, highest] =
      std::minmax({overlap.depth(box.x_min, box.y_min), overlap.depth(box.x_max, box.y_min),
                   overlap.depth(box.x_min, box.y_max), overlap.depth(box.x_max, box.y_max)});
  constexpr double kTouching = 1e-9;
  const auto refuse = [&](const char* field, const scene::Point& point) {
    throw UserError(fmt::format("{}.overlap.{}", overlap.path(), field),
                    fmt::format("is ({:g}, {:g}) m, which puts this edge of the overlap outside `{}`, which "
                                "{}; both models must exist over the whole overlap",
                                point.x(), point.y(), model, reach(box)));
  };
  const scene::Overlap& given = overlap.interface().overlap();
  if (highest < 1 - kTouching) refuse("particles_begin", given.particles_begin());
  if (lowest > kTouching) refuse("continuum_ends", given.continuum_ends());
}

// Where only one of the two models exists, the weight of the other would be missing.
void require_equal_cross_sections(const Overlap& overlap, const BoundingBox& outer,
                                  const BoundingBox& inner) {
  const double slack_x = kTolerance * std::max(outer.x_max - outer.x_min, inner.x_max - inner.x_min);
  const double slack_y = kTolerance * std::max(outer.y_max - outer.y_min, inner.y_max - inner.y_min);
  const auto fills = [&](const BoundingBox& model, const BoundingBox& other) {
    return std::ranges::none_of(outside(other, grown(model, slack_x, slack_y)),
                                [&](const BoundingBox& part) { return meets_overlap(overlap, part); });
  };
  if (!fills(inner, outer) || !fills(outer, inner))
    throw UserError(
        overlap.path() + ".overlap",
        fmt::format("joins `{}`, which {}, with `{}`, which {}; both must fill the overlap's "
                    "cross-section",
                    overlap.interface().outer(), reach(outer), overlap.interface().inner(), reach(inner)));
}

// The outer model must surround the ring, or end with the inner one where the ring reaches beyond it. Within
// the ring the inner model must exist wherever the outer one does.
void require_ring_filled(const Overlap& overlap, const BoundingBox& outer, const BoundingBox& inner) {
  const auto refuse = [&](const std::string& what) { throw UserError(overlap.path() + ".overlap", what); };
  const std::string &outer_name = overlap.interface().outer(), &inner_name = overlap.interface().inner();
  const double slack = kTolerance * overlap.width();
  if (!meets_core_or_overlap(overlap, outer))
    refuse(fmt::format("lies outside `{}`, which {}; move it inside", outer_name, reach(outer)));
  if (overlap.core().covers(outer))
    refuse(fmt::format("leaves nothing of `{}`, which {}; give a smaller shape", outer_name, reach(outer)));
  for (const BoundingBox& part : outside(outer, grown(inner, slack, slack)))
    if (meets_core_or_overlap(overlap, part))
      refuse(
          fmt::format("is not filled by `{}`, which {}; let it reach over the ring and what that lies "
                      "around, wherever `{}` is",
                      inner_name, reach(inner), outer_name));
  for (const BoundingBox& part : outside(inner, grown(outer, slack, slack)))
    if (meets_overlap(overlap, part))
      refuse(fmt::format("is not filled by `{}`, which {}, where `{}` reaches further; let both end together",
                         outer_name, reach(outer), inner_name));
}

}  // namespace

void require_inside(const Overlap& overlap, const BoundingBox& outer, const BoundingBox& inner) {
  if (overlap.is_ring()) return require_ring_filled(overlap, outer, inner);
  require_edges_inside(overlap, overlap.interface().outer(), outer);
  require_edges_inside(overlap, overlap.interface().inner(), inner);
  require_equal_cross_sections(overlap, outer, inner);
}

}  // namespace adit::coupler
