// The continuum as a participant of a run: translates the conversation (wire.proto) to the solver.
//
// Sample points are those of grid/samples.hpp. Requests that contradict an earlier one (counts, step numbers,
// dt) throw std::invalid_argument: the peer's bug.
#pragma once

#include <cstddef>
#include <ctime>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "fdm_server/boundaries/free_field.hpp"
#include "fdm_server/model/conditions.hpp"
#include "fdm_server/model/setup.hpp"
#include "fdm_server/output/histories.hpp"
#include "fdm_server/output/peaks.hpp"
#include "fdm_server/solver/relaxation.hpp"
#include "fdm_server/supports/lining_probe.hpp"
#include "fdm_server/supports/peak_forces.hpp"
#include "fdm_server/supports/supports.hpp"
#include "protocol/participant/interface_operator.hpp"
#include "protocol/participant/participant.hpp"
#include "protocol/participant/step.hpp"

namespace adit::fdm {

class FdmParticipant final : public protocol::Participant {
 public:
  // 0 threads: as many as pay. Results do not depend on it.
  explicit FdmParticipant(std::size_t threads = 1) : threads_(threads) {}
  void set_up(const wire::Setup& setup, wire::Model& model) override;
  void weigh(const wire::Weights& weights, wire::Interface& interface) override;
  void couple(const wire::Couple& couple, wire::Operator& op) override;
  void advance(const wire::Advance& advance, wire::Predicted& predicted) override;
  void complete() override;
  void snapshot(const wire::SnapshotRequest& request, wire::Snapshot& snapshot) override;
  void finish(wire::Bye& bye) override;

 private:
  // Of what the weights leave of the grid, with the columns of its free field.
  void make_continuum();
  // Of what is left of the zones; those of the base are the last.
  std::vector<Load> loads(std::span<const double> masses) const;
  std::vector<double> masses() const;  // of the points, with those of the structures
  // The grid points inside the box that the weights came with.
  void offer_grid_points(const wire::Weights& box, wire::Interface& interface) const;
  void check(const wire::Advance& advance) const;
  // Corrects the predicted velocities by impulses at the coupling points, if any.
  void push(const google::protobuf::RepeatedField<double>& impulses);
  // Says how far the grid is from rest after its correction, and stops it where it shall.
  void relax(bool stop, wire::Relaxation& answer);
  // Takes away the zones of the stages after the present one up to this one, and installs their linings and
  // bolts.
  void excavate(std::uint32_t stage);
  void require_interface_stays() const;
  // The material of each zone; none where time finds no ground (columns, what was taken away).
  std::vector<std::uint32_t> zone_kinds() const;
  // The first step that does not relax: from the state reached.
  void start_over();
  // Of the linings at the last step, once time goes on.
  void take_peak_forces();
  // Of the last step, where they are wanted, once it is corrected.
  void take_peaks();
  // Throw Unstable. Every step looks at the interface and the energies, every hundredth at the whole grid.
  void check_answer(const wire::Predicted& predicted) const;
  void check_grid(std::uint64_t step) const;

  std::size_t threads_;
  scene::Scene scene_;
  Setup setup_{};
  DampingLaw damping_;
  double critical_dt_ = 0;
  Grid grid_;
  std::vector<double> weights_;  // of the zones; 0 where they were taken away
  Supports supports_;
  std::vector<FreeFieldColumn> columns_;
  std::vector<Load> base_loads_;
  std::vector<std::uint32_t> stage_of_zone_;  // with which each is taken away; 0: it stays
  std::uint32_t stage_ = 0;                   // reached
  std::unique_ptr<Continuum> continuum_;
  protocol::InterfaceOperator operator_;
  PeakForces peak_forces_;
  std::optional<Histories> histories_;
  std::optional<Peaks> peaks_;            // once wanted
  bool peaks_due_ = false;                // of the last step
  std::optional<Relaxation> relaxation_;  // in statics
  protocol::Step step_{0, 0.0};           // the last one
  std::uint64_t next_step_ = 0, steps_done_ = 0;
  bool rest_left_ = false;  // of the last step: its interior
  std::clock_t started_ = 0;
};

}  // namespace adit::fdm
