// A participant that runs a scene in process.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "dem_server/participant/participant.hpp"
#include "protocol/scene/fields/check_rules.hpp"

namespace adit::dem::test {

// A participant after set_up and weigh, with the messages that it answered.
struct InProcessRun {
  DemParticipant participant;
  wire::Model model;
  wire::Interface interface;
  wire::Predicted predicted;
  std::uint64_t next = 0;
  double dt;

  explicit InProcessRun(const scene::Scene& scene, const wire::Weights& weights = {},
                        double dt_factor = 0.5) {
    protocol::check_rules(scene);
    wire::Setup setup;
    *setup.mutable_scene() = scene;
    if (dt_factor > 1) setup.mutable_scene()->mutable_time()->set_beyond_critical(true);
    participant.set_up(setup, model);
    participant.weigh(weights, interface);
    dt = dt_factor * model.critical_dt();
  }

  const wire::Predicted& advance(const std::vector<double>& impulses = {}) {
    wire::Advance request;
    request.set_step(next++);
    request.set_dt(dt);
    request.mutable_impulses()->Assign(impulses.begin(), impulses.end());
    request.set_want_energies(true);
    request.set_want_histories(true);
    predicted.Clear();
    participant.advance(request, predicted);
    return predicted;
  }

  std::map<std::string, double> shares() const {
    std::map<std::string, double> values;
    for (const auto& share : predicted.energies().shares()) values[share.name()] = share.value();
    return values;
  }
  // What changes by the time step's share only.
  double sum() const {
    const auto& e = predicted.energies();
    return e.kinetic() + e.strain() + e.released() + e.dissipated() - e.external_work();
  }
};

}  // namespace adit::dem::test
