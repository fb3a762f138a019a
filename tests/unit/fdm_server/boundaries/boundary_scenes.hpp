// Ground of easy numbers, and runs of scenes that shake it.
#pragma once

#include <google/protobuf/text_format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "fdm_server/participant/participant.hpp"
#include "protocol/scene/fields/check_rules.hpp"

namespace adit::fdm::test {

// c_s = 200 m/s, c_p = 346 m/s (nu = 1/4), plane strain.
inline constexpr double kShearVelocity = 200, kGroundDensity = 2000;
inline const std::string kGround = "material { young_modulus: 2e8 poisson_ratio: 0.25 density: 2000 } ";

struct GroundRun {
  scene::Scene scene;
  FdmParticipant participant;
  wire::Model model;
  wire::Interface interface;
  wire::Predicted predicted;
  double dt;
  std::uint64_t next = 0;

  // `continuum` and `others` in protobuf's text format; dt as a share of the critical step; `weight`: of all
  // zones alike.
  explicit GroundRun(const std::string& continuum, double duration, double dt_factor = 0.5,
                     const std::string& others = "", double weight = 1) {
    if (!google::protobuf::TextFormat::ParseFromString(kGround + others + " continuum { " + continuum + " }",
                                                       &scene))
      throw std::logic_error("the test's scene cannot be parsed");
    scene.mutable_time()->set_duration(duration);
    protocol::check_rules(scene);
    wire::Setup setup;
    *setup.mutable_scene() = scene;
    participant.set_up(setup, model);
    dt = dt_factor * model.critical_dt();
    wire::Weights weights;
    if (weight != 1)
      for (int k = 0; k < model.sample_points_size(); k += 2) weights.add_weights(weight);
    participant.weigh(weights, interface);
  }

  std::uint64_t steps() const { return static_cast<std::uint64_t>(std::ceil(scene.time().duration() / dt)); }

  const wire::Predicted& advance(bool relax = false, bool stop = false) {
    wire::Advance request;
    request.set_step(next++);
    request.set_dt(dt);
    request.set_want_energies(true);
    request.set_want_histories(true);
    request.set_relax(relax);
    request.set_stop(stop);
    predicted.Clear();
    participant.advance(request, predicted);
    participant.complete();
    return predicted;
  }

  // As many steps of statics, stopped whenever the kinetic energy has passed a peak; then time begins.
  void rest(int count) {
    double before = 0;
    bool stop = false;
    for (int n = 0; n < count; ++n) {
      const double kinetic = advance(true, stop).relaxation().kinetic_energy();
      stop = kinetic < before;
      before = stop ? 0 : kinetic;
    }
    next = 0;
  }

  wire::Snapshot snapshot() {
    wire::Snapshot snapshot;
    participant.snapshot({}, snapshot);
    return snapshot;
  }
};

}  // namespace adit::fdm::test
