#include "dem_server/participant/messages.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "protocol/errors.hpp"

namespace adit::dem {

namespace {

wire::Crack::Mode mode_of(BondState state) {
  return state == BondState::kTensileCrack ? wire::Crack::TENSILE : wire::Crack::SHEAR;
}

}  // namespace

void assign(google::protobuf::RepeatedField<double>& field, std::span<const double> values) {
  field.Assign(values.begin(), values.end());
}

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

void report(const CriticalElement& element, wire::Model& to) {
  to.set_critical_dt(element.step);
  to.set_critical_static_dt(element.static_step);
  to.set_critical_element(element.kind);
  to.set_critical_x(element.x);
  to.set_critical_y(element.y);
}

void report(const WaveSpeeds& speeds, wire::Model& to) {
  to.set_p_wave_speed(speeds.p);
  to.set_s_wave_speed(speeds.s);
}

void report(const Crack& crack, std::uint64_t step, std::span<const std::string> group_names,
            wire::Crack& to) {
  to.set_step(step);
  to.set_mode(mode_of(crack.mode));
  to.set_x(crack.x);
  to.set_y(crack.y);
  to.set_length(crack.length);
  to.set_orientation(crack.orientation);
  to.set_parent_a(crack.parent_a);
  to.set_parent_b(crack.parent_b);
  const std::string &a = group_names[crack.group_a], &b = group_names[crack.group_b];
  to.set_group(crack.group_a == crack.group_b ? a : a + "-" + b);
}

void report(const CrackPath& path, wire::CrackPath& to) {
  to.set_cracks(path.cracks);
  to.set_mode(mode_of(path.mode));
  to.set_length(path.length);
  to.set_opening(path.opening);
  to.set_slip(path.slip);
  to.set_x(path.x);
  to.set_y(path.y);
}

void report(const Strongest& strongest, std::uint64_t step, wire::BondForce& to) {
  to.set_step(step);
  to.set_force(strongest.force);
  to.set_x(strongest.x);
  to.set_y(strongest.y);
}

void report(const Energies& energies, wire::Energies& to) {
  to.set_kinetic(energies.kinetic);
  to.set_strain(energies.strain);
  to.set_external_work(energies.external_work);
  to.set_released(energies.released);
  to.set_dissipated(energies.dissipated);
  for (const auto& [name, value] : energies.shares) {
    wire::EnergyShare& share = *to.add_shares();
    share.set_name(name);
    share.set_value(value);
  }
}

}  // namespace adit::dem
