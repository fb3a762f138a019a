// Scenes and conversations that several tests use.
#pragma once

#include <google/protobuf/text_format.h>

#include <stdexcept>
#include <string>

#include "fdm_server/participant/participant.hpp"
#include "protocol/scene/fields/check_rules.hpp"

namespace adit::fdm::test {

inline constexpr const char* kMaterial =
    "plane: PLANE_STRESS material { young_modulus: 25e9 poisson_ratio: 0.2 density: 2500 } ";
inline constexpr const char* kBlock = "block { x_min: 0 x_max: 6 y_min: 0 y_max: 1 zones_x: 12 zones_y: 4 } ";

// A scene whose continuum is the block above and `conditions`, in protobuf's text format.
inline wire::Setup setup_of(const std::string& conditions, const std::string& block = kBlock,
                            const std::string& material = kMaterial) {
  wire::Setup setup;
  if (!google::protobuf::TextFormat::ParseFromString(
          material + "time { duration: 1 } continuum { " + block + conditions + " }", setup.mutable_scene()))
    throw std::logic_error("the test's scene cannot be parsed");
  return setup;
}

// As a server does when a scene arrives: its rules, then the model.
inline void set_up(FdmParticipant& participant, const wire::Setup& setup, wire::Model& model) {
  protocol::check_rules(setup.scene());
  participant.set_up(setup, model);
}

// A participant that is ready to advance, alone and with all weights 1.
struct Conversation {
  FdmParticipant participant;
  wire::Model model;
  wire::Interface interface;
  wire::Predicted predicted;

  explicit Conversation(const std::string& conditions, const wire::Weights& weights = {}) {
    set_up(participant, setup_of(conditions), model);
    participant.weigh(weights, interface);
  }
  const wire::Predicted& advance(std::uint64_t step, double dt, std::initializer_list<double> impulses = {}) {
    wire::Advance advance;
    advance.set_step(step);
    advance.set_dt(dt);
    advance.mutable_impulses()->Assign(impulses.begin(), impulses.end());
    advance.set_want_energies(true);
    advance.set_want_histories(true);
    predicted.Clear();
    participant.advance(advance, predicted);
    return predicted;
  }
};

}  // namespace adit::fdm::test
