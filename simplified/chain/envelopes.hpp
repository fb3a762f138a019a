// The least and the greatest value of every result since the start.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace adit::simplified::chain {

struct Extremes {
  explicit Extremes(std::size_t size) : min(size), max(size) {}
  std::vector<double> min, max;

  void reset_to(std::span<const double> values) {
    std::copy(values.begin(), values.end(), min.begin());
    std::copy(values.begin(), values.end(), max.begin());
  }
  // Widens the envelope to values[begin] … values[end - 1]. In most steps no value lies beyond it; then
  // nothing is written, because writing to memory beyond the cache costs as much as reading it.
  void widen_to(std::span<const double> values, std::size_t begin, std::size_t end) {
    double *least = min.data(), *most = max.data();
    int beyond = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const int below = values[i] < least[i];
      const int above = values[i] > most[i];
      beyond |= below | above;
    }
    if (beyond == 0) return;
    for (std::size_t i = begin; i < end; ++i) {
      least[i] = values[i] < least[i] ? values[i] : least[i];
      most[i] = values[i] > most[i] ? values[i] : most[i];
    }
  }
};

struct Envelopes {
  Envelopes(std::size_t bodies, std::size_t joints)
      : x(bodies),
        y(bodies),
        opening(joints),
        slip(joints),
        rotation(joints),
        axial_force(joints),
        shear_force(joints),
        moment(joints) {}
  Extremes x, y;                              // displacements of the centres [m], by body
  Extremes opening, slip, rotation;           // [m], [m], [rad], by joint
  Extremes axial_force, shear_force, moment;  // [N], [N], [N m], by joint, including the force at rest
};

}  // namespace adit::simplified::chain
