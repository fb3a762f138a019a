#include "coupler/tunnel/host_block.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>

#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

using geometry::BoundingBox;

constexpr double kOnLine = 1e-6;  // of a zone: a place this near to a line lies on it

bool holds(const BoundingBox& outer, const BoundingBox& inner) {
  return outer.x_min <= inner.x_min && outer.x_max >= inner.x_max && outer.y_min <= inner.y_min &&
         outer.y_max >= inner.y_max;
}

bool overlap(const ZoneRange& a, const ZoneRange& b) {
  return a.left < b.right && b.left < a.right && a.lower < b.upper && b.lower < a.upper;
}

template <class Box>
BoundingBox bounds_of(const Box& box) {
  return {box.x_min(), box.x_max(), box.y_min(), box.y_max()};
}

bool of_equal_zones(const scene::GridBlock& block) {
  return block.has_rectangle() && block.along().ratio() == 1 && block.across().ratio() == 1;
}

// The first and the last line around an interval, in zones from the block's first line.
std::pair<std::uint32_t, std::uint32_t> lines_around(double from, double to, std::uint32_t zones) {
  const double last = zones;
  return {static_cast<std::uint32_t>(std::clamp(std::floor(from + kOnLine), 0.0, last)),
          static_cast<std::uint32_t>(std::clamp(std::ceil(to - kOnLine), 0.0, last))};
}

}  // namespace

HostBlock HostBlock::around(const BoundingBox& box, const scene::Continuum& continuum,
                            const std::string& path) {
  if (continuum.has_block()) {
    const scene::Block& block = continuum.block();
    if (const auto bounds = bounds_of(block); holds(bounds, box))
      return {-1, "", bounds, block.zones_x(), block.zones_y()};
  }
  for (int i = 0; i < continuum.blocks_size(); ++i) {
    const scene::GridBlock& block = continuum.blocks(i);
    if (!of_equal_zones(block)) continue;
    if (const auto bounds = bounds_of(block.rectangle()); holds(bounds, box))
      return {i, block.name(), bounds, block.along().zones(), block.across().zones()};
  }
  throw protocol::UserError(
      path, fmt::format("has its lining from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}) m, which no rectangle of "
                        "equal zones holds; give the continuum a `block` there, or one of the `blocks` as a "
                        "`rectangle` without ratio",
                        box.x_min, box.y_min, box.x_max, box.y_max));
}

// Both ends exact, as those of a grid.
double HostBlock::x(std::uint32_t line) const {
  return std::lerp(box_.x_min, box_.x_max, static_cast<double>(line) / columns_);
}

double HostBlock::y(std::uint32_t line) const {
  return std::lerp(box_.y_min, box_.y_max, static_cast<double>(line) / rows_);
}

ZoneRange HostBlock::zones_around(const BoundingBox& box) const {
  const auto [left, right] = lines_around((box.x_min - box_.x_min) / zone_width(),
                                          (box.x_max - box_.x_min) / zone_width(), columns_);
  const auto [lower, upper] =
      lines_around((box.y_min - box_.y_min) / zone_height(), (box.y_max - box_.y_min) / zone_height(), rows_);
  return {left, right, lower, upper};
}

void HostBlock::take(const ZoneRange& zones, const std::string& path) {
  for (const Taken& other : taken_)
    protocol::require(!overlap(zones, other.zones), path,
                      fmt::format("has an area of fitted zones that overlaps the one of {}; move the tunnels "
                                  "apart, or give both a smaller `zones.around`",
                                  other.path));
  taken_.push_back({zones, path});
}

scene::GridBlock HostBlock::rectangle(const ZoneRange& zones) const {
  scene::GridBlock block;
  if (!group_.empty()) block.set_name(group_);
  block.mutable_rectangle()->set_x_min(x(zones.left));
  block.mutable_rectangle()->set_x_max(x(zones.right));
  block.mutable_rectangle()->set_y_min(y(zones.lower));
  block.mutable_rectangle()->set_y_max(y(zones.upper));
  block.mutable_along()->set_zones(zones.right - zones.left);
  block.mutable_across()->set_zones(zones.upper - zones.lower);
  return block;
}

std::vector<scene::GridBlock> HostBlock::remains() const {
  std::set<std::uint32_t> columns{0, columns_}, rows{0, rows_};
  for (const auto& [zones, path] : taken_) {
    columns.insert({zones.left, zones.right});
    rows.insert({zones.lower, zones.upper});
  }
  std::vector<scene::GridBlock> found;
  for (auto lower = rows.begin(); std::next(lower) != rows.end(); ++lower)
    for (auto left = columns.begin(); std::next(left) != columns.end(); ++left) {
      const ZoneRange part{*left, *std::next(left), *lower, *std::next(lower)};
      if (std::ranges::none_of(taken_, [&](const Taken& taken) { return overlap(part, taken.zones); }))
        found.push_back(rectangle(part));
    }
  return found;
}

}  // namespace adit::coupler
