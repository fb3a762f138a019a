// A participant of discs that runs a scene in process.
#pragma once

#include <map>
#include <string>

#include "dem_server/engines/general/observe/participant.hpp"

namespace adit::dem::test {

struct DiscsRun {
  DiscsParticipant participant;
  wire::Model model;
  wire::Interface interface;
  wire::Predicted predicted;
  std::uint64_t next = 0;
  double dt;

  explicit DiscsRun(const scene::Scene& scene, double dt_factor = 0.5, std::size_t threads = 1,
                    const wire::Weights& weights = {})
      : participant(threads) {
    wire::Setup setup;
    *setup.mutable_scene() = scene;
    participant.set_up(setup, model);
    participant.weigh(weights, interface);
    dt = dt_factor * model.critical_dt();
  }

  const wire::Predicted& advance(bool want_energies = true) {
    wire::Advance request;
    request.set_step(next++);
    request.set_dt(dt);
    request.set_want_energies(want_energies);
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
