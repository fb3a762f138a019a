#include "protocol/participant/stepped_participant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "protocol/errors.hpp"
#include "protocol/messages/spans.hpp"
#include "protocol/wire/bounds.hpp"

namespace adit::protocol {
namespace {

// A matrix of so many rows, whose columns all occur.
void require_rows(const wire::Condense& n, std::size_t rows) {
  const auto& starts = n.row_starts();
  const auto entries = static_cast<std::uint32_t>(n.columns_size());
  if (static_cast<std::size_t>(starts.size()) != rows + 1 || starts[0] != 0 ||
      !std::ranges::is_sorted(starts) || *starts.rbegin() != entries || n.values_size() != n.columns_size())
    throw RequestError(
        fmt::format("condense: its rows are not those of a matrix for {} coupling points", rows));
  if (n.masters() == 0 || n.masters() > entries || condensed_bytes(n.masters()) > kMaxFrameBytes ||
      std::ranges::any_of(n.columns(), [&](std::uint32_t column) { return column >= n.masters(); }))
    throw RequestError(fmt::format("condense: {} masters do not fit its {} entries", n.masters(), entries));
}

}  // namespace

void SteppedParticipant::advance(const wire::Advance& request, wire::Predicted& predicted) {
  check(request);
  if (request.has_follow()) return follow_masters(request, predicted);
  if (masters_ > 0) {
    masters_ = 0;
    go_on();
  }
  correct_last_step(request.impulses());
  take_peaks_due();
  if (last_.relax && !request.relax()) begin_time({request.drift_x(), request.drift_y()});
  if (request.relax()) relax(request, *predicted.mutable_relaxation());

  const Step step{request.step(), request.dt(), request.relax(), request.stop(), request.local_damping()};
  prepare(step, request);
  if (request.want_peaks()) remember_for_peaks();
  const bool whole =
      coupling_points() == 0 || request.relax() || request.want_energies() || request.want_histories();
  step_interface(step);
  if (whole) step_interior(step);
  last_ = step;
  started_ = true;
  corrected_ = false;
  peaks_due_ = request.want_peaks();
  interior_left_ = !whole;
  answer(step, request, predicted);
  if (request.relax()) predicted.mutable_relaxation()->set_kinetic_energy(kinetic_energy());
}

void SteppedParticipant::answer(const Step& step, const wire::Advance& request, wire::Predicted& predicted) {
  predicted.set_step(step.number);
  read_velocities(resize(*predicted.mutable_velocities(), 2 * coupling_points()));
  read_events(predicted);
  if (request.want_energies()) read_energies(step, *predicted.mutable_energies());
  if (request.want_histories()) read_histories(step, *predicted.mutable_histories());
}

void SteppedParticipant::begin_time(const Drift& drift) {
  start_over(drift);
  scale_masses(scaled_ = false);
  last_ = {};
}

// The last impulses of statics would have no effect: time begins from rest.
void SteppedParticipant::condense(const wire::Condense& request, wire::Condensed& condensed) {
  require_rows(request, coupling_points());
  if (last_.relax) begin_time({});
  condense_solver(request, condensed);
  masters_ = condensed.reason().empty() ? request.masters() : 0;
}

void SteppedParticipant::follow_masters(const wire::Advance& request, wire::Predicted& predicted) {
  const wire::Following& masters = request.follow();
  for (const auto* list : {&masters.displacements(), &masters.velocities_before(), &masters.velocities()})
    if (masters_ == 0 || static_cast<std::size_t>(list->size()) != 2 * masters_)
      throw RequestError(fmt::format("step {}: the motion of masters came with {} numbers for {} of them",
                                     request.step(), list->size(), masters_));
  if (!request.impulses().empty() || request.relax())
    throw RequestError(fmt::format(
        "step {}: a model that follows its masters gets no impulses, nor does it relax", request.step()));
  take_peaks_due();
  last_ = {request.step(), request.dt()};
  started_ = corrected_ = true;
  interior_left_ = false;
  follow(last_, masters);
  prepare(last_, request);
  if (request.want_peaks()) remember_for_peaks();
  peaks_due_ = request.want_peaks();
  predicted.set_demand(arrive(last_));
  answer(last_, request, predicted);
}

void SteppedParticipant::complete() {
  if (!interior_left_) return;
  interior_left_ = false;
  step_interior(last_);
}

void SteppedParticipant::snapshot(const wire::SnapshotRequest& request, wire::Snapshot& snapshot) {
  correct_last_step(request.impulses());
  if (coupling_points() == 0 || corrected_) take_peaks_due();
  draw(snapshot);
}

void SteppedParticipant::exchange(state::Archive& archive) {
  archive("last_step", last_.number);
  archive("last_step_dt", last_.dt);
  archive("last_step_local_damping", last_.local_damping);
  archive("relax", last_.relax);
  archive("stop", last_.stop);
  archive("scaled", scaled_);
  archive("started", started_);
  archive("corrected", corrected_);
  archive("peaks_due", peaks_due_);
  archive("interior_left", interior_left_);
  archive("masters", masters_);
  exchange_solver(archive);
  if (archive.reads()) scale_masses(scaled_);
}

void SteppedParticipant::relax(const wire::Advance& request, wire::Relaxation& answer) {
  measure_unrest(started_ ? last_ : Step{0, request.dt()}, answer);
  if (request.stop())
    stop();
  else if (request.slowing() > 0)
    slow(1 - request.slowing());
  excavate(request.stage());
  scale_masses(scaled_ = request.scale_masses());
}

void SteppedParticipant::take_peaks_due() {
  if (!peaks_due_) return;
  peaks_due_ = false;
  take_peaks(last_);
}

void SteppedParticipant::correct_last_step(const google::protobuf::RepeatedField<double>& impulses) {
  if (impulses.empty()) return;
  const auto count = static_cast<std::size_t>(impulses.size());
  if (!started_) throw RequestError("impulses came before the first step, which has nothing to correct");
  if (corrected_)
    throw RequestError(
        fmt::format("impulses came twice to correct step {}; send them once, with the next "
                    "step or with a snapshot before it",
                    last_.number));
  if (count != 2 * coupling_points())
    throw RequestError(fmt::format("{} impulse components came for {} coupling points; send two for each",
                                   count, coupling_points()));
  correct(view(impulses));
  corrected_ = true;
}

// Statics and time may have different steps, and either begins with step 0.
void SteppedParticipant::check(const wire::Advance& request) const {
  const double dt = request.dt();
  if (!(dt > 0))
    throw RequestError(fmt::format("step {}: dt is {} s; send a positive number", request.step(), dt));
  if (request.step() > 0 && dt != last_.dt && !request.stop())
    throw RequestError(fmt::format("step {}: dt is {} s, but it was {} s in the step before; keep it",
                                   request.step(), dt, last_.dt));
  if (!request.relax() && (request.stop() || request.stage() > 0 || request.scale_masses()))
    throw RequestError(
        fmt::format("step {}: `stop`, `stage` or `scale_masses` came without `relax`; only statics know them",
                    request.step()));
  if (request.relax() && started_ && request.scale_masses() != scaled_ && !request.stop())
    throw RequestError(
        fmt::format("step {}: `scale_masses` changed without `stop`; change it at rest", request.step()));
  if (request.local_damping() < 0 || !(request.local_damping() < 1) ||
      (!request.relax() && request.local_damping() > 0))
    throw RequestError(fmt::format("step {}: `local_damping` is {}; send a share below 1, with `relax` only",
                                   request.step(), request.local_damping()));
  if (request.slowing() < 0 || request.slowing() > 1 || (!request.relax() && request.slowing() > 0))
    throw RequestError(fmt::format("step {}: `slowing` is {}; send a share of at most 1, with `relax` only",
                                   request.step(), request.slowing()));
  if ((request.drift_x() != 0 || request.drift_y() != 0) && !(last_.relax && !request.relax()))
    throw RequestError(fmt::format("step {}: a drift came elsewhere than with the first step after statics",
                                   request.step()));
}

}  // namespace adit::protocol
