#include "dem_server/packing/voronoi/cell_size.hpp"

#include <algorithm>

namespace adit::dem {
namespace {

constexpr double kGrowth = 0.25;  // per distance

}  // namespace

CellSize::CellSize(double largest, std::vector<FinerPlace> finer)
    : largest_(largest), finer_(std::move(finer)) {
  for (const FinerPlace& place : finer_) least_ = std::min(least_, place.size);
}

double CellSize::at(const geometry::Point& point) const {
  double size = largest_;
  for (const auto& [distance, finest] : finer_)
    size = std::min(size, finest + kGrowth * std::max(distance(point), 0.0));
  return size;
}

double CellSize::least_around(const geometry::Point& point, double distance) const {
  return std::max(at(point) - (finer_.empty() ? 0 : kGrowth * distance), least_);
}

}  // namespace adit::dem
