// The largest displacement, velocity and acceleration of each of some points over time.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "protocol/messages/wire.pb.h"
#include "protocol/participant/step.hpp"
#include "protocol/state/archive.hpp"

namespace adit::protocol {

// Components, one value a point.
struct PlaneVectors {
  std::span<const double> x, y;
};

class PeakMotion {
 public:
  explicit PeakMotion(std::size_t points)
      : before_x_(points),
        before_y_(points),
        displacement_(points),
        velocity_(points),
        acceleration_(points) {}

  // Before a step n to look at: v(n-1/2), corrected.
  void remember(const PlaneVectors& velocity) {
    std::ranges::copy(velocity.x, before_x_.begin());
    std::ranges::copy(velocity.y, before_y_.begin());
  }

  // After it: the displacement at n of each point, displacement(point) = {x, y}, and v(n+1/2), corrected.
  template <class Displacement>
  void take(Displacement&& displacement, const PlaneVectors& velocity, const Step& step) {
    const double rate = 1 / step.kick();
    const auto raise = [](double& peak, double x, double y) {
      peak = std::max(peak, std::sqrt(x * x + y * y));
    };
    for (std::size_t i = 0; i < before_x_.size(); ++i) {
      const auto [x, y] = displacement(i);
      raise(displacement_[i], x, y);
      raise(velocity_[i], before_x_[i], before_y_[i]);
      raise(acceleration_[i], rate * (velocity.x[i] - before_x_[i]), rate * (velocity.y[i] - before_y_[i]));
    }
  }

  void exchange(state::Archive& archive) {
    for (auto* values : {&before_x_, &before_y_, &displacement_, &velocity_, &acceleration_})
      archive("peak_motion", std::span(*values));
  }

  std::span<const double> displacement() const { return displacement_; }  // [m]
  std::span<const double> velocity() const { return velocity_; }          // [m/s]
  std::span<const double> acceleration() const { return acceleration_; }  // [m/s^2]

 private:
  std::vector<double> before_x_, before_y_;
  std::vector<double> displacement_, velocity_, acceleration_;
};

// Fields of a snapshot: peak_displacement_m, peak_velocity_m_per_s, peak_acceleration_m_per_s2.
void add_peak_fields(const PeakMotion& peaks, google::protobuf::RepeatedPtrField<wire::Field>& fields);

}  // namespace adit::protocol
