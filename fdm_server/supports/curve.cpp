#include "fdm_server/supports/curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace adit::fdm {
namespace {

using geometry::Point;
constexpr double kTurn = 2 * std::numbers::pi;

class ArcCurve final : public Curve {
 public:
  ArcCurve(const Point& centre, double radius, double from, double to)
      : centre_(centre), radius_(radius), from_(from), angle_(to - from) {}
  double length() const override { return radius_ * angle_; }
  // Angles may be given in degrees, so a whole turn may miss 2 pi by a rounding error.
  bool closed() const override { return angle_ > kTurn * (1 - 1e-9); }
  Point at(double s) const override {
    const double angle = from_ + s / radius_;
    return {centre_.x + radius_ * std::cos(angle), centre_.y + radius_ * std::sin(angle)};
  }
  Foot foot(const Point& place) const override {
    const double x = place.x - centre_.x, y = place.y - centre_.y;
    // The angle is counted from the middle of the arc, so that a place behind an end goes to the nearer end.
    const double angle = std::remainder(std::atan2(y, x) - from_ - angle_ / 2, kTurn) + angle_ / 2;
    const double held = std::clamp(angle, 0.0, angle_);  // behind an end: that end
    const auto nearest = at(radius_ * held);
    return {radius_ * held, std::hypot(place.x - nearest.x, place.y - nearest.y)};
  }

 private:
  Point centre_;
  double radius_, from_, angle_;
};

class Polyline final : public Curve {
 public:
  explicit Polyline(std::vector<Point> points) : points_(std::move(points)) {
    for (std::size_t i = 0; i + 1 < points_.size(); ++i)
      starts_.push_back(starts_[i] +
                        std::hypot(points_[i + 1].x - points_[i].x, points_[i + 1].y - points_[i].y));
  }
  double length() const override { return starts_.back(); }
  bool closed() const override {
    return points_.front().x == points_.back().x && points_.front().y == points_.back().y;
  }
  Point at(double s) const override {
    const auto last = static_cast<std::ptrdiff_t>(points_.size()) - 2;
    const auto i =
        std::clamp<std::ptrdiff_t>(std::ranges::upper_bound(starts_, s) - starts_.begin() - 1, 0, last);
    const double share = (s - starts_[i]) / (starts_[i + 1] - starts_[i]);
    return {points_[i].x + share * (points_[i + 1].x - points_[i].x),
            points_[i].y + share * (points_[i + 1].y - points_[i].y)};
  }
  Foot foot(const Point& place) const override {
    Foot nearest{0, HUGE_VAL};
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
      const double dx = points_[i + 1].x - points_[i].x, dy = points_[i + 1].y - points_[i].y;
      const double x = place.x - points_[i].x, y = place.y - points_[i].y;
      const double share = std::clamp((x * dx + y * dy) / (dx * dx + dy * dy), 0.0, 1.0);
      const double distance = std::hypot(x - share * dx, y - share * dy);
      if (distance < nearest.distance)
        nearest = {starts_[i] + share * (starts_[i + 1] - starts_[i]), distance};
    }
    return nearest;
  }

 private:
  std::vector<Point> points_;
  std::vector<double> starts_{0};  // s of each point
};

}  // namespace

std::unique_ptr<Curve> arc(const Point& centre, double radius, double from, double to) {
  return std::make_unique<ArcCurve>(centre, radius, from, to);
}

std::unique_ptr<Curve> polyline(std::vector<Point> points) {
  return std::make_unique<Polyline>(std::move(points));
}

}  // namespace adit::fdm
