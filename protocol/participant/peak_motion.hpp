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
    const double *vx = velocity.x.data(), *vy = velocity.y.data(), *last_vx = before_x_.data(),
                 *last_vy = before_y_.data();
    raise(displacement_, displacement);
    raise(velocity_, [&](std::size_t i) { return std::array{last_vx[i], last_vy[i]}; });
    raise(acceleration_, [&](std::size_t i) {
      return std::array{rate * (vx[i] - last_vx[i]), rate * (vy[i] - last_vy[i])};
    });
  }

  void exchange(state::Archive& archive) {
    archive("peak_motion_before_x", std::span(before_x_));
    archive("peak_motion_before_y", std::span(before_y_));
    archive("peak_motion_displacement", std::span(displacement_));
    archive("peak_motion_velocity", std::span(velocity_));
    archive("peak_motion_acceleration", std::span(acceleration_));
  }

  std::vector<double> displacement() const { return roots(displacement_); }  // [m]
  std::vector<double> velocity() const { return roots(velocity_); }          // [m/s]
  std::vector<double> acceleration() const { return roots(acceleration_); }  // [m/s^2]

 private:
  template <class VectorOf>
  static void raise(std::vector<double>& squares, VectorOf&& vector_of) {
    double* peaks = squares.data();
    for (std::size_t i = 0, count = squares.size(); i < count; ++i) {
      const auto [x, y] = vector_of(i);
      const double square = x * x + y * y;
      peaks[i] = peaks[i] < square ? square : peaks[i];
    }
  }
  static std::vector<double> roots(std::vector<double> squares) {
    for (double& value : squares) value = std::sqrt(value);
    return squares;
  }

  std::vector<double> before_x_, before_y_;
  std::vector<double> displacement_, velocity_, acceleration_;  // squared
};

// Fields of a snapshot: peak_displacement_m, peak_velocity_m_per_s, peak_acceleration_m_per_s2.
void add_peak_fields(const PeakMotion& peaks, google::protobuf::RepeatedPtrField<wire::Field>& fields);

}  // namespace adit::protocol
