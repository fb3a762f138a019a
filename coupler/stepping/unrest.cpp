#include "coupler/stepping/unrest.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "coupler/exchange/round_trip.hpp"

namespace adit::coupler {
namespace {

// What the multipliers' impulses add to a participant's predicted kinetic energy, from both velocities at the
// coupling points: the change of m v^2 / 2.
double kinetic_energy_of_correction(Participant& participant) {
  if (!participant.interpolation) return 0;
  correct_velocities(participant);
  double twice = 0;
  const std::span<const double> impulses = participant.correction.impulses();
  for (std::size_t i = 0; i < impulses.size(); ++i)
    twice += impulses[i] * (participant.predicted[i] + participant.corrected[i]);
  return twice / 2;
}

Moved moved_of(const Participant& participant, const wire::Relaxation& r) {
  const wire::Model& model = participant.model;
  return {r.largest_displacement(),
          r.moved_x(),
          r.moved_y(),
          participant.member.name,
          r.moved(),
          std::max(model.x_max() - model.x_min(), model.y_max() - model.y_min())};
}

}  // namespace

Unrest::Unrest(std::vector<Participant>& participants) {
  for (Participant& participant : participants) {
    const wire::Relaxation& r = participant.prediction().relaxation();
    kinetic_energy += r.kinetic_energy() + kinetic_energy_of_correction(participant);
    unbalanced_force += r.unbalanced_force();
    internal_force += r.internal_force();
    points += r.points();
    elements += r.elements();
    net_x += r.net_x();
    net_y += r.net_y();
    drag_x += r.drag_x();
    drag_y += r.drag_y();
    if (r.largest_displacement() > moved.distance) moved = moved_of(participant, r);
    if (r.largest_unbalanced_force() < largest) continue;
    largest = r.largest_unbalanced_force();
    x = r.x();
    y = r.y();
    largest_of = participant.member.name;
  }
}

double Unrest::mean_internal_force(double internal_at_first) const {
  return elements > 0 ? std::max(internal_force, internal_at_first) / static_cast<double>(elements) : 0;
}

double Unrest::mean_ratio(double internal_at_first) const {
  if (unbalanced_force == 0) return 0;
  return (unbalanced_force / static_cast<double>(points)) / mean_internal_force(internal_at_first);
}

double Unrest::largest_ratio(double internal_at_first) const {
  return largest == 0 ? 0 : largest / mean_internal_force(internal_at_first);
}

bool Unrest::falls(double internal_at_first) const {
  const double net = std::max(std::abs(net_x), std::abs(net_y));
  return drag_along_net() == 0 && net > unbalanced_force / 2 && mean_ratio(internal_at_first) > 1;
}

bool Unrest::may_land() const {
  return drag_along_net() > 0;
}

protocol::Drift Unrest::drift() const {
  return {drag_x > 0 ? net_x / drag_x : 0, drag_y > 0 ? net_y / drag_y : 0};
}

Stall::Kind Stall::noticed(double ratio, const Moved& moved) {
  if (steps_ % kBin == 0) smallest_.push_back(ratio);
  smallest_.back() = std::min(smallest_.back(), ratio);
  ++steps_;
  if (steps_ % kBin != 0) return kGoesOn;
  moved_.push_back(moved.distance);
  if (steps_ >= kFirstLookAtFlow && flows(moved)) return kFlows;
  return steps_ >= kFirstLook && stalls() ? kStalls : kGoesOn;
}

bool Stall::stalls() const {
  const auto end = smallest_.end(), middle = end - static_cast<std::ptrdiff_t>(smallest_.size() / 2),
             begin = middle - static_cast<std::ptrdiff_t>(smallest_.size() / 4);
  const double before = *std::min_element(begin, middle), now = *std::min_element(middle, end);
  if (std::isinf(now)) return true;            // where nothing bears anything
  const double fall = std::log(before / now);  // in about half of the steps
  const double needed = std::log(now / wanted_) / fall * static_cast<double>(steps_) / 2;
  return fall <= 0 || needed > 2 * (static_cast<double>(max_steps_) - static_cast<double>(steps_));
}

bool Stall::flows(const Moved& moved) const {
  const double halfway = moved_[moved_.size() / 2 - 1], now = moved_.back();
  if (now - halfway < halfway || now < 0.05 * moved.extent || now == 0) return false;
  const double ratio_halfway = smallest_[smallest_.size() / 2 - 1];
  return now > moved.extent || !(smallest_.back() < ratio_halfway / 2);
}

}  // namespace adit::coupler
