#include "fdm_server/meshing/blocks.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <unordered_map>

#include "fdm_server/grid/edges.hpp"

namespace adit::fdm {
namespace {

constexpr double kCoincide = 1e-6;  // of the shortest side of a zone

double shortest_side(const std::vector<Point>& points, std::size_t columns) {
  double shortest = HUGE_VAL;
  const auto measure = [&](std::size_t a, std::size_t b) {
    shortest = std::min(shortest, std::hypot(points[a].x - points[b].x, points[a].y - points[b].y));
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % columns != 0) measure(i - 1, i);
    if (i >= columns) measure(i - columns, i);
  }
  return shortest;
}

// Finds points again by their places: each is kept in a square cell, and looked for in the cells around it
// too.
class PointsByPlace {
 public:
  PointsByPlace(const Grid& grid, double reach) : grid_(grid), reach_(reach) {}

  // A point within reach, or -1.
  std::int32_t find(const Point& place) const {
    // A cell is twice as wide as the square of half side `reach` around the place, so the square's corners
    // lie in all cells that it touches.
    for (const double dy : {-reach_, reach_})
      for (const double dx : {-reach_, reach_}) {
        const auto [begin, end] = cells_.equal_range(cell(place.x + dx, place.y + dy));
        for (auto entry = begin; entry != end; ++entry)
          if (std::hypot(grid_.x[entry->second] - place.x, grid_.y[entry->second] - place.y) <= reach_)
            return entry->second;
      }
    return -1;
  }
  void add(std::int32_t point) { cells_.emplace(cell(grid_.x[point], grid_.y[point]), point); }

 private:
  std::uint64_t cell(double x, double y) const {
    const double size = 4 * reach_;
    // The bits of a double: no place is too large for them, also where all points of a block coincide and the
    // size is 0. Adding 0.0 makes one cell of 0 and -0.
    const auto number = [size](double place) {
      return std::bit_cast<std::uint64_t>(std::floor(place / size) + 0.0);
    };
    // Cells that fall together by chance cost time only, because find() asks for the distance.
    return number(x) * 0x9e3779b97f4a7c15u ^ number(y);
  }
  const Grid& grid_;
  double reach_;
  std::unordered_multimap<std::uint64_t, std::int32_t> cells_;
};

// All zones of a block run the same way round.
void turn_counter_clockwise(Grid& grid, std::size_t first_zone) {
  double whole = 0;
  for (std::size_t z = first_zone; z < grid.zones.size(); ++z) whole += area(corners(grid, z));
  if (whole >= 0) return;
  for (std::size_t z = first_zone; z < grid.zones.size(); ++z) std::swap(grid.zones[z][1], grid.zones[z][3]);
}

void add_to_group(Grid& grid, const std::string& name, std::size_t first_zone) {
  if (name.empty()) return;
  auto group = std::ranges::find(grid.groups, name, &Group::name);
  if (group == grid.groups.end()) group = grid.groups.insert(group, Group{name, {}, {}});
  for (std::size_t z = first_zone; z < grid.zones.size(); ++z)
    group->zones.push_back(static_cast<std::uint32_t>(z));
}

}  // namespace

JoinedBlocks join(const std::vector<MappedBlock>& blocks) {
  std::vector<std::vector<Point>> of_blocks;
  double shortest = HUGE_VAL;
  for (const auto& block : blocks) {
    of_blocks.push_back(points(block));
    shortest = std::min(shortest, shortest_side(of_blocks.back(), block.along.zones + std::size_t{1}));
  }
  JoinedBlocks joined;
  Grid& grid = joined.grid;
  PointsByPlace outline(grid, kCoincide * shortest);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const std::size_t columns = blocks[b].along.zones, rows = blocks[b].across.zones,
                      first_zone = grid.zones.size();
    joined.first_zones.push_back(static_cast<std::uint32_t>(first_zone));
    std::vector<std::int32_t> number;
    for (std::size_t j = 0; j <= rows; ++j)
      for (std::size_t i = 0; i <= columns; ++i) {
        const Point& place = of_blocks[b][number.size()];
        // Blocks meet along their outlines only, so points inside are not looked up.
        const bool on_outline = i == 0 || i == columns || j == 0 || j == rows;
        std::int32_t point = on_outline ? outline.find(place) : -1;
        if (point < 0) {
          point = static_cast<std::int32_t>(grid.x.size());
          grid.x.push_back(place.x);
          grid.y.push_back(place.y);
          if (on_outline) outline.add(point);
        }
        number.push_back(point);
      }
    for (std::size_t j = 0; j < rows; ++j)
      for (std::size_t i = 0; i < columns; ++i) {
        const std::size_t lower = j * (columns + 1) + i, upper = lower + columns + 1;
        grid.zones.push_back({number[lower], number[lower + 1], number[upper + 1], number[upper]});
      }
    turn_counter_clockwise(grid, first_zone);
    add_to_group(grid, blocks[b].name, first_zone);
  }
  grid.boundary = boundary(number_edges(grid));
  return joined;
}

}  // namespace adit::fdm
