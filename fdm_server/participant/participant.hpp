// The continuum as a participant of a run: translates the conversation (wire.proto) to the solver.
//
// Sample points are those of grid/samples.hpp. Requests that contradict an earlier one throw
// protocol::RequestError.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fdm_server/boundaries/free_field.hpp"
#include "fdm_server/interfaces/contact_peaks.hpp"
#include "fdm_server/model/boundaries/base_motion.hpp"
#include "fdm_server/model/conditions.hpp"
#include "fdm_server/model/grid/zone_stages.hpp"
#include "fdm_server/model/setup.hpp"
#include "fdm_server/model/water/sea.hpp"
#include "fdm_server/output/histories.hpp"
#include "fdm_server/output/peaks.hpp"
#include "fdm_server/participant/critical_element.hpp"
#include "fdm_server/solver/relaxation.hpp"
#include "fdm_server/supports/peak_dowels.hpp"
#include "fdm_server/supports/peak_forces.hpp"
#include "fdm_server/supports/peak_joints.hpp"
#include "fdm_server/supports/peak_shapes.hpp"
#include "fdm_server/supports/peak_use.hpp"
#include "fdm_server/supports/supports.hpp"
#include "protocol/participant/interface/interface_operator.hpp"
#include "protocol/participant/step.hpp"
#include "protocol/participant/stepped_participant.hpp"
#include "protocol/participant/travel.hpp"
#include "protocol/release.hpp"
#include "protocol/state/archive.hpp"

namespace adit::fdm {

class FdmParticipant final : public protocol::SteppedParticipant {
 public:
  // 0 threads: as many as pay. Results do not depend on it.
  explicit FdmParticipant(std::size_t threads = 1) : threads_(threads) {}
  void set_up(const wire::Setup& setup, wire::Model& model) override;
  void weigh(const wire::Weights& weights, wire::Interface& interface) override;
  void couple(const wire::Couple& couple, wire::Operator& op) override;
  std::string state_format() const override { return "fdm_server " + std::string(protocol::release()); }
  void took(double seconds) override { continuum_->took(seconds); }
  void finish(wire::Bye& bye) override;

 private:
  // The steps (stepped_participant.hpp).
  std::size_t coupling_points() const override { return operator_.rows(); }
  void correct(std::span<const double> impulses) override;
  void measure_unrest(const protocol::Step& last, wire::Relaxation& answer) override;
  double kinetic_energy() const override;
  void stop() override { slow(0); }
  void slow(double factor) override;
  // Passes the stages after the present one up to this one.
  void excavate(std::uint32_t stage) override;
  void scale_masses(bool scaled) override;
  void start_over(const protocol::Drift& drift) override;
  void remember_for_peaks() override;
  void take_peaks(const protocol::Step& step) override;
  void prepare(const protocol::Step& step, const wire::Advance& wanted) override;
  void step_interface(const protocol::Step& step) override;
  void step_interior(const protocol::Step& step) override;
  void read_velocities(std::span<double> velocities) const override;
  void read_energies(const protocol::Step& step, wire::Energies& energies) override;
  void read_histories(const protocol::Step& step, google::protobuf::RepeatedField<double>& values) override;
  void draw(wire::Snapshot& snapshot) override;
  void exchange_solver(state::Archive& archive) override;

  // The points whose forces are needed before all are known, so that structures there move explicitly
  // (solver/continuum.hpp).
  KnownEarly known_early(const Supports& supports, const Grid& grid, bool alone) const;
  // Makes the continuum of what the weights leave of the grid, with the columns of its free field.
  void make_continuum();
  // Takes away its zones, changes and adds others, installs its linings and bolts.
  void begin_stage(std::uint32_t stage);
  // Statics are over, or there are none: the water is free to follow the ground, and to flow.
  void begin_time();
  std::optional<Flow> flow() const;
  WaterAtRest water_at_rest() const;  // in the present stage
  // Loads on the zones that are left; those of the base are the last.
  std::vector<Load> loads(std::span<const double> masses) const;
  std::vector<double> masses() const;  // of the points, with those of the structures
  // Those that make the step of statics the critical one of every zone, beam, bar and joint: no frequency of
  // the whole is above the largest of one of them (zones/critical_step.hpp).
  std::vector<double> scaled_masses() const;
  bool can_scale_masses() const;
  // In statics contacts bring masses of their own, since they do not average there.
  void set_masses();
  // The grid points inside the box that the weights came with.
  void offer_grid_points(const wire::Weights& box, wire::Interface& interface) const;
  void require_interface_stays() const;
  void require_apart_from_contacts() const;
  void require_free_field_stays() const;
  void require_renewed_apart() const;
  // Refuses a scene that takes away, or changes, a zone for which `is_tied` holds. `why`: to what, and what
  // to do.
  template <class Test>
  void refuse_excavated(const Test& is_tied, std::string_view why) const;
  template <class Test>
  void refuse_renewed(const Test& is_tied, std::string_view why) const;
  // The farthest point of this stage of statics.
  void tell_travel(wire::Relaxation& answer);
  // What a point belongs to, as in "lining roof", empty where it has no name.
  std::string name_of(std::uint32_t point) const;
  // The material of each zone in time; none where it finds no ground (columns, what was taken away).
  std::vector<std::uint32_t> zone_kinds() const;
  // Throw Unstable. Every step looks at the interface and at the energies that are wanted, every hundredth at
  // the whole grid.
  void check_interface(const protocol::Step& step) const;
  void check_grid(const protocol::Step& step) const;

  std::size_t threads_;
  scene::Scene scene_;
  Setup setup_{};
  DampingLaw damping_;
  double critical_dt_ = 0, critical_static_dt_ = 0;
  Grid grid_;
  std::vector<double> weights_;   // of the zones; 0 where they were taken away
  std::size_t zones_there_ = 0;   // not taken away
  std::vector<Corners> slivers_;  // zones that an overlap leaves next to nothing of (samples.hpp)
  SideShares side_shares_;        // by the overlap
  Supports supports_;
  std::vector<FreeFieldColumn> columns_;
  BaseAccelerations base_accelerations_;
  std::vector<Load> base_loads_;
  ZoneStages zone_stages_;
  std::vector<bool> absorbing_;     // zones with dashpots of boundaries
  std::uint32_t stage_ = 0;         // reached
  std::vector<double> zone_steps_;  // critical, in statics [s], once they are needed
  bool scaled_ = false;             // masses, in statics
  bool relaxes_ = false;            // the last step was one of statics
  std::unique_ptr<Continuum> continuum_;
  protocol::InterfaceOperator operator_;
  PeakForces peak_forces_, member_forces_;  // of linings, of members
  ContactPeaks contact_peaks_;
  PeakUse peak_use_, member_use_;
  PeakJoints peak_joints_;
  PeakDowels peak_dowels_;
  std::optional<PeakShapes> peak_shapes_;  // of linings, once set up
  std::optional<Histories> histories_;
  std::optional<Peaks> peaks_;              // once wanted
  std::optional<Relaxation> relaxation_;    // in statics
  std::optional<protocol::Travel> travel_;  // of a stage of them
  std::uint64_t steps_done_ = 0;            // whole ones that moved, of statics and of time
  std::uint64_t updates_ = 0;               // of the zones that were there, in these steps
};

}  // namespace adit::fdm
