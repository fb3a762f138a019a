// Overlaps for tests, from text as it is written in a scene.
#pragma once

#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>
#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "coupler/bridging/overlap.hpp"

namespace adit::test {

inline scene::Interface interface_of(const std::string& text) {
  scene::Interface interface;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &interface)) << text;
  return interface;
}

// `text`: of the message Overlap.
inline coupler::Overlap overlap_of(const std::string& text, const std::string& ramp = "LINEAR") {
  return {interface_of("overlap { " + text + " } ramp: " + ramp), "interface"};
}

// Weights of the overlap's outer or inner model at points x0 y0 x1 y1 …
template <class Weight>
std::vector<double> weights_at(std::span<const double> points, Weight weight) {
  std::vector<double> weights;
  for (std::size_t i = 0; i < points.size(); i += 2) weights.push_back(weight(points[i], points[i + 1]));
  return weights;
}
inline std::vector<double> outer_weights(const coupler::Overlap& overlap, std::span<const double> points) {
  return weights_at(points, [&](double x, double y) { return overlap.outer_weight(x, y); });
}
inline std::vector<double> inner_weights(const coupler::Overlap& overlap, std::span<const double> points) {
  return weights_at(points, [&](double x, double y) { return overlap.inner_weight(x, y); });
}

inline std::string point(double x, double y) {
  return fmt::format("{{ x: {:.17g} y: {:.17g} }}", x, y);
}

inline std::string strip(double begin_x, double begin_y, double end_x, double end_y) {
  return "particles_begin " + point(begin_x, begin_y) + " continuum_ends " + point(end_x, end_y);
}

inline std::string ring(const std::string& shape, double width) {
  return fmt::format("around {{ {} }} width: {:.17g}", shape, width);
}

inline std::string box(double x_min, double x_max, double y_min, double y_max) {
  return fmt::format("box {{ x_min: {:.17g} x_max: {:.17g} y_min: {:.17g} y_max: {:.17g} }}", x_min, x_max,
                     y_min, y_max);
}

inline std::string circle(double x, double y, double radius) {
  return fmt::format("circle {{ centre {} radius: {:.17g} }}", point(x, y), radius);
}

// Corners on a circle of which every second one is drawn in to `inward` of the radius: convex at 1.
inline std::string star(double x, double y, double radius, int corners, double turn, double inward) {
  std::string text;
  for (int k = 0; k < corners; ++k) {
    const double angle = turn + 2 * std::numbers::pi * k / corners, r = k % 2 ? radius * inward : radius;
    text += "corners " + point(x + r * std::cos(angle), y + r * std::sin(angle)) + " ";
  }
  return text;
}

}  // namespace adit::test
