// Scenes in stressed ground of particles, at rest, and what they tell.
#pragma once

#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>
#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "coupler/stepping/statics.hpp"
#include "tests/support/local_participants.hpp"

namespace adit::test {

inline scene::Scene scene_of(const std::string& text) {
  scene::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &scene)) << text;
  return scene;
}

inline const google::protobuf::RepeatedField<double>& field(
    const google::protobuf::RepeatedPtrField<wire::Field>& fields, const std::string& name) {
  for (const auto& candidate : fields)
    if (candidate.name() == name) return candidate.values();
  throw std::out_of_range(name);
}

// The scene at rest, after all its stages.
struct Settled {
  coupler::Model model;
  coupler::Stepper stepper;
  coupler::Rest rest;
  std::vector<std::vector<double>> histories;  // of each member

  explicit Settled(const std::string& text) : Settled(scene_of(text)) {}
  explicit Settled(const scene::Scene& scene) : model(local_model(scene)), stepper(model) {
    rest = relax(model, stepper);
    stepper.step(0, {.energies = true, .histories = true});
    for (const coupler::Participant& participant : model.participants) {
      const auto& values = participant.prediction().histories();
      histories.emplace_back(values.begin(), values.end());
    }
  }

  const std::vector<wire::Crack>& cracks(std::size_t member = 0) const {
    return model.participants[member].cracks;
  }
};

// The particles that are drawn.
struct Drawn {
  std::vector<double> x, y, ux, uy;

  explicit Drawn(const wire::Snapshot& snapshot) {
    const auto& piece = snapshot.pieces(0);
    const auto& u = field(piece.point_fields(), "displacement_m");
    for (const auto point : piece.connectivity()) {
      const int i = static_cast<int>(point);
      x.push_back(piece.points(2 * i));
      y.push_back(piece.points(2 * i + 1));
      ux.push_back(u[3 * i]);
      uy.push_back(u[3 * i + 1]);
    }
  }
  double largest() const {
    double most = 0;
    for (std::size_t i = 0; i < x.size(); ++i) most = std::max(most, std::hypot(ux[i], uy[i]));
    return most;
  }
};

// Stresses over a circle, as histories.
inline std::string stress_over(double x, double y, double radius) {
  std::string text;
  for (const char* quantity : {"STRESS_XX", "STRESS_YY", "STRESS_XY"})
    text += fmt::format("histories {{ name: '{}_{}_{}' quantity: {} at {{ x: {} y: {} }} radius: {} }} ",
                        quantity, x, y, quantity, x, y, radius);
  return text;
}

// The same over circles whose middles fill a box, 7 by 7, and the mean of what they tell.
inline std::string stress_over_box(double x_min, double x_max, double y_min, double y_max, double radius) {
  std::string text;
  for (int i = 0; i < 7; ++i)
    for (int j = 0; j < 7; ++j)
      text += stress_over(x_min + (x_max - x_min) * i / 6, y_min + (y_max - y_min) * j / 6, radius);
  return text;
}
struct MeanStress {
  double xx = 0, yy = 0, xy = 0;
  explicit MeanStress(const std::vector<double>& histories) {
    const double share = 3.0 / static_cast<double>(histories.size());
    for (std::size_t k = 0; k < histories.size(); k += 3) {
      xx += share * histories[k];
      yy += share * histories[k + 1];
      xy += share * histories[k + 2];
    }
  }
};

// Holds what lies outside of a box.
inline std::string held_outside(double x_min, double x_max, double y_min, double y_max) {
  return fmt::format(
      "motions {{ where {{ x_max: {} }} velocity {{ x: 0 y: 0 }} }} "
      "motions {{ where {{ x_min: {} }} velocity {{ x: 0 y: 0 }} }} "
      "motions {{ where {{ x_min: {} x_max: {} y_max: {} }} velocity {{ x: 0 y: 0 }} }} "
      "motions {{ where {{ x_min: {} x_max: {} y_min: {} }} velocity {{ x: 0 y: 0 }} }} ",
      x_min, x_max, x_min + 1e-6, x_max - 1e-6, y_min, x_min + 1e-6, x_max - 1e-6, y_max);
}

}  // namespace adit::test
