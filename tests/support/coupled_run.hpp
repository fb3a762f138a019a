// One participant as a coupler drives it, without a coupler: what the other side does is a function of the
// velocities that the participant predicts.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "protocol/messages/wire.pb.h"
#include "protocol/scene/fields/check_rules.hpp"

namespace adit::test {

template <class Participant>
class CoupledRun {
 public:
  Participant participant;
  wire::Model model;
  wire::Interface interface;
  wire::Predicted predicted;
  std::vector<double> impulses;  // of the next step
  std::uint64_t next = 0;
  double dt = 0;

  virtual ~CoupledRun() = default;

  void set_up(const wire::Setup& setup) {
    protocol::check_rules(setup.scene());
    participant.set_up(setup, model);
  }

  // `weight(x)` of the sample points; `request` holds the rest.
  template <class Weight>
  void weigh(Weight&& weight, wire::Weights request = {}) {
    for (int i = 0; i < model.sample_points_size(); i += 2)
      request.add_weights(weight(model.sample_points(i)));
    request.set_floor(1e-3);
    participant.weigh(request, interface);
  }

  // At the points of `request`, and at `count` more that fill x_min ≤ x ≤ x_min + width, 0 ≤ y ≤ 1 without a
  // pattern (multiples of two irrational numbers, modulo 1).
  void couple(double x_min, double width, int count, wire::Couple request = {}) {
    for (int k = 0; k < count; ++k) {
      request.add_points(x_min + width * std::fmod(0.618034 * k, 1.0));
      request.add_points(std::fmod(0.754878 * k, 1.0));
    }
    wire::Operator op;
    participant.couple(request, op);
  }

  void advance(bool wanted) {
    wire::Advance request;
    request.set_step(next++);
    request.set_dt(dt);
    request.mutable_impulses()->Assign(impulses.begin(), impulses.end());
    request.set_want_energies(wanted);
    request.set_want_histories(wanted);
    predicted.Clear();
    participant.advance(request, predicted);
    impulses.resize(static_cast<std::size_t>(predicted.velocities_size()));
    for (std::size_t i = 0; i < impulses.size(); ++i)
      impulses[i] = impulse(i, predicted.velocities(static_cast<int>(i)));
  }

 protected:
  // What the other side answers to a predicted velocity [N s]; `i` counts the coordinates of the coupling
  // points.
  virtual double impulse(std::size_t i, double velocity) = 0;
};

}  // namespace adit::test
