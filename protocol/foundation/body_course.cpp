#include "protocol/foundation/body_course.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "protocol/foundation/bracket.hpp"
#include "protocol/foundation/columns.hpp"
#include "protocol/motion/errors_at.hpp"

namespace adit::foundation {

BodyCourse::BodyCourse(const scene::BodyMotion& motion, const std::string& path) {
  const std::array<std::string, 4> names{"time_s", "vx_m_per_s", "vy_m_per_s", "spin_rad_per_s"};
  motion::errors_at(path + ".path", [&] {
    auto columns = read_columns(motion.path(), motion.content(), names);
    require_ascending(columns[0], "time", "s", motion.path());
    time_ = std::move(columns[0]);
    x_ = std::move(columns[1]);
    y_ = std::move(columns[2]);
    spin_ = std::move(columns[3]);
  });
}

BodyVelocity BodyCourse::at(double time) const {
  const Bracket now = bracket(time_, time);
  const auto value = [&](const std::vector<double>& values) {
    return std::lerp(values[now.before], values[now.after], now.share);
  };
  return {value(x_), value(y_), value(spin_)};
}

}  // namespace adit::foundation
