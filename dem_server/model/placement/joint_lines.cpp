#include "dem_server/model/placement/joint_lines.hpp"

#include <cmath>
#include <numbers>

namespace adit::dem {

JointLine::JointLine(const geometry::Point& from, const geometry::Point& to)
    : from_(from), length_(std::hypot(to.x - from.x, to.y - from.y)) {
  tx_ = (to.x - from.x) / length_;
  ty_ = (to.y - from.y) / length_;
}

double JointLine::above(const geometry::Point& place) const {
  return (place.y - from_.y) * tx_ - (place.x - from_.x) * ty_;
}

// A lattice has rows of centres on the lines that people draw, and rounding must not choose their sides.
constexpr double kOnLine = 1e-9;  // of the line's length

int JointLine::side(const geometry::Point& place) const {
  const double distance = above(place);
  return (distance > kOnLine * length_) - (distance < -kOnLine * length_);
}

// Whether the way between places on both sides meets the line before its ends.
bool JointLine::meets(const geometry::Point& a, const geometry::Point& b) const {
  const double first = above(a), second = above(b);
  const double share = first / (first - second);
  const double x = a.x + share * (b.x - a.x) - from_.x;
  const double y = a.y + share * (b.y - a.y) - from_.y;
  const double along = x * tx_ + y * ty_;
  return along >= -kOnLine * length_ && along <= (1 + kOnLine) * length_;
}

bool JointLine::parts(const geometry::Point& a, const geometry::Point& b) const {
  return (side(a) < 0) != (side(b) < 0) && meets(a, b);
}

double JointLine::crossing(const geometry::Point& a, const geometry::Point& b) const {
  const int sides = side(a) - side(b);
  return sides != 0 && meets(a, b) ? sides / 2.0 : 0;
}

bool JointLine::parts(const Discs& discs, const Pair& pair) const {
  const auto [i, j] = pair;
  return parts({discs.x[i], discs.y[i]}, {discs.x[j], discs.y[j]});
}

std::array<double, 2> JointLine::normal(const Discs& discs, const Pair& pair) const {
  const double sign = side({discs.x[pair.first], discs.y[pair.first]}) < 0 ? 1 : -1;
  return {-sign * ty_, sign * tx_};
}

RingJoints::RingJoints(const scene::SegmentRing& ring)
    : centre_{ring.centre().x(), ring.centre().y()},
      first_(ring.first_joint()),
      step_(2 * std::numbers::pi / ring.segments()) {}

double RingJoints::angle(double x, double y) const {
  constexpr double kTurn = 2 * std::numbers::pi;
  const double angle = std::fmod(std::atan2(y - centre_.y, x - centre_.x) - first_, kTurn);
  return angle < 0 ? angle + kTurn : angle;
}

bool RingJoints::parts(const Discs& discs, const Pair& pair) const {
  const double a = angle(discs.x[pair.first], discs.y[pair.first]);
  const double b = angle(discs.x[pair.second], discs.y[pair.second]);
  if (std::abs(a - b) > std::numbers::pi) return true;  // the first joint lies between
  return std::floor(a / step_) != std::floor(b / step_);
}

std::array<double, 2> RingJoints::direction(std::uint32_t joint) const {
  const double angle = first_ + joint * step_;
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace adit::dem
