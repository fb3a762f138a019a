// Bonded particles as a participant of a run: translates the conversation (wire.proto) into calls of an
// engine.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "dem_server/engines/engine.hpp"
#include "dem_server/model/model.hpp"
#include "dem_server/participant/choose_engine.hpp"
#include "protocol/participant/stepped_participant.hpp"
#include "protocol/state/archive.hpp"

namespace adit::dem {

class DemParticipant final : public protocol::SteppedParticipant {
 public:
  // Threads that share the computing, 0: as many as pay. Results do not depend on their number.
  explicit DemParticipant(std::size_t threads = 1)
      : DemParticipant(std::make_unique<LocalEngines>(threads)) {}
  explicit DemParticipant(std::unique_ptr<EngineMaker> engines) : engines_(std::move(engines)) {}

  void set_up(const wire::Setup& setup, wire::Model& model) override;
  void weigh(const wire::Weights& weights, wire::Interface& interface) override;
  void couple(const wire::Couple& couple, wire::Operator& op) override;
  std::string state_format() const override { return engines_->state_format(); }
  void took(double seconds) override { engine_->took(seconds); }
  void finish(wire::Bye& bye) override;

 private:
  void balance_under_weights(std::span<const double> centres);
  // What broke in a step, and the largest force, for the next answer.
  void note_events(const protocol::Step& step);

  // The steps (stepped_participant.hpp).
  std::size_t coupling_points() const override { return coupling_points_; }
  void correct(std::span<const double> impulses) override { engine_->correct(impulses); }
  void measure_unrest(const protocol::Step& last, wire::Relaxation& answer) override;
  double kinetic_energy() const override { return engine_->kinetic_energy(); }
  void stop() override { engine_->stop(); }
  void slow(double factor) override { engine_->slow(factor); }
  void excavate(std::uint32_t stage) override;
  void scale_masses(bool scaled) override;
  void start_over(const protocol::Drift& drift) override { engine_->start_over(drift); }
  void remember_for_peaks() override { engine_->remember_for_peaks(); }
  void take_peaks(const protocol::Step& step) override { engine_->take_peaks(step); }
  void prepare(const protocol::Step& step, const wire::Advance& wanted) override;
  void condense_solver(const wire::Condense& request, wire::Condensed& condensed) override;
  void follow(const protocol::Step& step, const wire::Following& masters) override;
  double arrive(const protocol::Step& step) override;
  void go_on() override { engine_->go_on(); }
  void step_interface(const protocol::Step& step) override { engine_->step_interface(step); }
  void step_interior(const protocol::Step& step) override;
  void read_velocities(std::span<double> velocities) const override { engine_->read_velocities(velocities); }
  void read_energies(const protocol::Step& step, wire::Energies& energies) override;
  void read_histories(const protocol::Step& step, google::protobuf::RepeatedField<double>& values) override;
  void read_events(wire::Predicted& predicted) override;
  void draw(wire::Snapshot& snapshot) override { engine_->snapshot(snapshot); }
  void exchange_solver(state::Archive& archive) override;

  std::unique_ptr<EngineMaker> engines_;
  scene::Scene scene_;
  Model model_;
  std::unique_ptr<Engine> engine_;
  CriticalElement critical_{};  // of the unweighted model
  std::size_t coupling_points_ = 0;
  std::uint32_t stage_ = 0;        // of excavation, reached
  bool scaled_ = false;            // masses, in statics
  wire::Predicted unreported_;     // cracks and largest forces of whole steps
  std::vector<double> histories_;  // of the step told last
  std::uint64_t moves_ = 0;
};

}  // namespace adit::dem
