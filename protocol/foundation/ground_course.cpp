#include "protocol/foundation/ground_course.hpp"

#include <cmath>
#include <utility>

namespace adit::foundation {

GroundCourse::GroundCourse(std::vector<double> time, std::vector<double> x, std::vector<double> vx,
                           std::vector<double> vy, const std::string& file)
    : time_(std::move(time)), x_(std::move(x)), vx_(std::move(vx)), vy_(std::move(vy)) {
  require_ascending(time_, "time", "s", file);
  require_ascending(x_, "place", "m", file);
}

void GroundCourse::velocities(Direction direction, double time, std::vector<double>& values) const {
  values.assign(x_.size(), 0.0);
  if (time_.empty()) return;
  const std::vector<double>& table = direction == Direction::kX ? vx_ : vy_;
  const Bracket now = bracket(time_, time);
  for (std::size_t k = 0; k < values.size(); ++k)
    values[k] = std::lerp(table[now.before * x_.size() + k], table[now.after * x_.size() + k], now.share);
}

}  // namespace adit::foundation
