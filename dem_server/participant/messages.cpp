#include "dem_server/participant/messages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "protocol/errors.hpp"

namespace adit::dem {

void assign(google::protobuf::RepeatedField<double>& field, std::span<const double> values) {
  field.Assign(values.begin(), values.end());
}

std::span<const double> view(const google::protobuf::RepeatedField<double>& field) {
  return {field.data(), static_cast<std::size_t>(field.size())};
}

// Weights of the particles' centres and the bonds' midpoints, from one list in the order of the sample
// points.
SampledWeights split_weights(const wire::Weights& sent, std::size_t centres, std::size_t midpoints) {
  const auto& all = sent.weights();
  if (static_cast<std::size_t>(all.size()) != centres + midpoints)
    throw protocol::RequestError(
        fmt::format("weights: {} weights came for {} sample points", all.size(), centres + midpoints));
  if (!std::all_of(all.begin(), all.end(), [](double w) { return w >= 0 && w <= 1; }))
    throw protocol::RequestError("weights: a weight lies outside [0, 1]");
  if (!(sent.floor() > 0 && sent.floor() <= 1))
    throw protocol::RequestError("weights: the floor lies outside (0, 1]");
  return {{all.data(), centres}, {all.data() + centres, midpoints}, sent.floor()};
}

void report(const Crack& crack, std::uint64_t step, wire::Crack& to) {
  to.set_step(step);
  to.set_mode(crack.mode == BondState::kTensileCrack ? wire::Crack::TENSILE : wire::Crack::SHEAR);
  to.set_x(crack.x);
  to.set_y(crack.y);
  to.set_length(crack.length);
  to.set_orientation(crack.orientation);
  to.set_parent_a(crack.parent_a);
  to.set_parent_b(crack.parent_b);
}

void check_impulses(std::span<const double> impulses, std::size_t points, const protocol::Step& last) {
  if (last.dt == 0)
    throw protocol::RequestError("impulses came before the first step, which has nothing to correct");
  if (impulses.size() != 2 * points)
    throw protocol::RequestError(
        fmt::format("{} impulses came for {} coupling points", impulses.size(), points));
}

double checked_dt(const wire::Advance& advance, double before) {
  const double dt = advance.dt();
  if (advance.step() == 0) before = dt;
  if (!(dt > 0) || !std::isfinite(dt) || dt != before)
    throw protocol::RequestError(fmt::format(
        "advance: dt is {} s; it must be positive and the same in every step (it was {} s)", dt, before));
  return dt;
}

}  // namespace adit::dem
