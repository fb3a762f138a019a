#include "dem_server/packing/voronoi/cover_discs.hpp"

#include <algorithm>
#include <cmath>

namespace adit::dem {
namespace {

constexpr double kInside = 1 - 1e-9;  // of the radius

bool lies_in(const CoverDisc& disc, double x, double y) {
  return std::hypot(x - disc.centre.x, y - disc.centre.y) < kInside * disc.radius;
}

}  // namespace

DiscField::DiscField(std::vector<CoverDisc> discs) : discs_(std::move(discs)) {
  if (discs_.empty()) return;
  std::vector<protocol::Extent> extents;
  extents.reserve(discs_.size());
  double largest = 0;
  for (const auto& [c, r] : discs_) {
    extents.push_back({c.x - r, c.x + r, c.y - r, c.y + r});
    largest = std::max(largest, r);
  }
  cells_ = {extents, 2 * largest};
}

bool DiscField::hold(const geometry::Point& p) const {
  return std::ranges::any_of(cells_.at(p.x, p.y),
                             [&](std::uint32_t d) { return lies_in(discs_[d], p.x, p.y); });
}

bool DiscField::cover(const geometry::BoundingBox& box) const {
  const auto corners = geometry::corners(box);
  return std::ranges::any_of(cells_.at(box.x_min, box.y_min), [&](std::uint32_t d) {
    return std::ranges::all_of(corners, [&](const auto& c) { return lies_in(discs_[d], c.x, c.y); });
  });
}

}  // namespace adit::dem
