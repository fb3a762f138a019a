// Bonded particles as a participant of a run: translates the conversation (wire.proto) into calls of the
// kernels.
#pragma once

#include <cstdint>
#include <ctime>
#include <optional>
#include <span>
#include <vector>

#include "dem_server/assembly.hpp"
#include "dem_server/contact_forces.hpp"
#include "dem_server/coupling_points.hpp"
#include "dem_server/energy.hpp"
#include "dem_server/histories.hpp"
#include "dem_server/loads.hpp"
#include "dem_server/motions.hpp"
#include "protocol/participant.hpp"

namespace adit::dem {

class DemParticipant : public protocol::Participant {
 public:
  void set_up(const wire::Setup& setup, wire::Model& model) override;
  void weigh(const wire::Weights& weights, wire::Interface& interface) override;
  void couple(const wire::Couple& couple, wire::Operator& op) override;
  void advance(const wire::Advance& advance, wire::Predicted& predicted) override;
  void snapshot(const wire::SnapshotRequest& request, wire::Snapshot& snapshot) override;
  void finish(wire::Bye& bye) override;

 private:
  // Adds the coupler's impulses to the velocities predicted last; empty: none.
  void correct(std::span<const double> impulses);
  void check_dt(double dt, bool start);
  void report_contacts(const ContactResult& contacts, std::uint64_t step, wire::Predicted& predicted) const;
  void report_energies(bool start, wire::Energies& energies) const;

  std::clock_t started_ = 0;
  scene::Scene scene_;
  Packing packing_;
  BondLaw law_{};
  Assembly assembly_;
  std::optional<Loads> loads_;
  std::optional<Motions> motions_;
  std::optional<Histories> histories_;
  CouplingPoints coupling_;
  Velocities before_;
  std::vector<std::uint32_t> broken_;  // bonds that broke in this step
  double released_ = 0;                // [J]
  std::uint64_t step_ = 0;
  double dt_ = 0;  // [s]
};

}  // namespace adit::dem
