#include "protocol/participant/time_function.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adit::protocol {
namespace {

double interpolate(const scene::Table& table, double t) {
  const auto& times = table.time();
  const auto after = std::upper_bound(times.begin(), times.end(), t);
  if (after == times.begin()) return table.value(0);
  if (after == times.end()) return table.value(table.value_size() - 1);
  const int i = static_cast<int>(after - times.begin());
  const double share = (t - times[i - 1]) / (times[i] - times[i - 1]);
  return table.value(i - 1) + share * (table.value(i) - table.value(i - 1));
}

}  // namespace

double evaluate(const scene::TimeFunction& function, double t) {
  switch (function.shape_case()) {
    case scene::TimeFunction::kConstant:
      return function.constant();
    case scene::TimeFunction::kTable:
      return interpolate(function.table(), t);
    case scene::TimeFunction::kSine: {
      const auto& sine = function.sine();
      return t <= sine.end() ? std::sin(2 * std::numbers::pi * sine.frequency() * t + sine.phase()) : 0.0;
    }
    case scene::TimeFunction::SHAPE_NOT_SET:
      return 1.0;
  }
  return 1.0;
}

bool is_steady(const scene::TimeFunction& function) {
  return function.has_constant() || function.shape_case() == scene::TimeFunction::SHAPE_NOT_SET;
}

}  // namespace adit::protocol
