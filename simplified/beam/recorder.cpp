#include "simplified/beam/recorder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "protocol/errors.hpp"

namespace adit::simplified::beam {
namespace {

// A run stops if the energy that no work explains exceeds this share of all energy exchanged, and also
// exceeds what rounding errors can cause.
constexpr double kLargestGrowth = 0.5;
constexpr double kSmallestEnergy = 1e-3;  // [J]

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Envelope empty_envelope(std::size_t places) {
  return {std::vector<double>(places, kInfinity), std::vector<double>(places, 0.0),
          std::vector<double>(places, -kInfinity), std::vector<double>(places, 0.0)};
}

void widen(Envelope& envelope, std::size_t place, double low, double high, double time) {
  if (low < envelope.minimum[place]) {
    envelope.minimum[place] = low;
    envelope.minimum_time[place] = time;
  }
  if (high > envelope.maximum[place]) {
    envelope.maximum[place] = high;
    envelope.maximum_time[place] = time;
  }
}

void enlarge(double& largest, double& when, double value, double time) {
  if (value <= largest) return;
  largest = value;
  when = time;
}

std::size_t nearest(const std::vector<double>& chainages, double x) {
  const auto above = std::lower_bound(chainages.begin(), chainages.end(), x);
  if (above == chainages.begin()) return 0;
  if (above == chainages.end() || x - *(above - 1) <= *above - x) return above - 1 - chainages.begin();
  return above - chainages.begin();
}

}  // namespace

Recorder::Recorder(const Stepper& stepper, const RunOptions& options, Results& results)
    : stepper_(stepper), options_(options), results_(results) {
  const Structure& structure = stepper.structure();
  const std::size_t elements = structure.elements.size();
  for (std::size_t e = 0; e < elements; ++e) results.chainage.push_back(structure.middle(e));
  for (Envelope* envelope :
       {&results.axial_force, &results.moment_lateral, &results.moment_vertical, &results.shear_lateral,
        &results.shear_vertical, &results.strain, &results.vertical_displacement, &results.pressure_ratio})
    *envelope = empty_envelope(elements);
  for (std::size_t j = 0; j < stepper.joints().size(); ++j) {
    JointResult joint;
    joint.chainage = structure.mesh.nodes[structure.mesh.joints[j]];
    joint.installed_compression = stepper.joints().installed_compression(j);
    results.joints.push_back(joint);
  }
  const double start = structure.mesh.nodes.front(), end = structure.mesh.nodes.back();
  for (std::size_t i = 0; i < options.stations.size(); ++i) {
    const double x = options.stations[i];
    if (!(x >= start && x <= end))
      throw protocol::UserError(fmt::format("stations[{}]", i),
                                fmt::format("{:g} m lies outside the tunnel, which runs "
                                            "from {:g} m to {:g} m",
                                            x, start, end));
    at_stations_.push_back(nearest(results.chainage, x));
  }
  all_.resize(elements);
  std::iota(all_.begin(), all_.end(), 0);
  forces_.resize(elements);
}

void Recorder::record(long step) {
  const double time = stepper_.time();
  update_envelopes(time);
  update_joints(time);
  if (!at_stations_.empty() && (step % options_.history_every == 0 || step == options_.steps))
    results_.histories.push_back(snapshot(time, at_stations_));
  if (options_.field_every > 0 && step % options_.field_every == 0)
    results_.fields.push_back(snapshot(time, all_));
  const Energy& e = stepper_.energy();
  const double error = e.error();
  largest_error_ = std::max(largest_error_, std::abs(error));
  largest_energy_ =
      std::max({largest_energy_, std::abs(e.input), std::abs(e.kinetic), std::abs(e.strain), std::abs(e.soil),
                std::abs(e.joints), std::abs(e.loads), e.slip, e.weakening, e.dashpots});
  // Only a gain stops the run: a loss is the numerical damping of a scheme like HHT and cannot blow up.
  if (error > kLargestGrowth * largest_energy_ + kSmallestEnergy)
    throw protocol::Unstable(
        fmt::format("mass-spring-beam: energy grows without cause, {:g} J of {:g} J at time {:g} s: take a "
                    "smaller step or the "
                    "energy-conserving scheme",
                    error, largest_energy_, time));
}

void Recorder::update_envelopes(double time) {
  for (std::size_t e = 0; e < forces_.size(); ++e) {
    const SectionForces f = forces_[e] = stepper_.structure().forces(e, stepper_.displacement());
    widen(results_.axial_force, e, f.axial, f.axial, time);
    widen(results_.moment_lateral, e, f.moment_lateral, f.moment_lateral, time);
    widen(results_.moment_vertical, e, f.moment_vertical, f.moment_vertical, time);
    widen(results_.shear_lateral, e, f.shear_lateral, f.shear_lateral, time);
    widen(results_.shear_vertical, e, f.shear_vertical, f.shear_vertical, time);
    // The fibres on both sides count: one gives the least strain, the other the greatest.
    widen(results_.strain, e, f.strain_low, f.strain_high, time);
    const double z = stepper_.structure().middle_displacement(e, kVertical, stepper_.displacement());
    widen(results_.vertical_displacement, e, z, z, time);
    const double ratio = stepper_.soil().pressure_ratio(e);
    widen(results_.pressure_ratio, e, ratio, ratio, time);
  }
}

void Recorder::update_joints(double time) {
  for (std::size_t j = 0; j < results_.joints.size(); ++j) {
    const JointState now = stepper_.joints().state(j, stepper_.displacement());
    const Joint& joint = stepper_.structure().tunnel.joints[j];
    JointResult& result = results_.joints[j];
    enlarge(result.largest_opening, result.opening_time, now.opening, time);
    enlarge(result.largest_compression, result.compression_time, now.compression, time);
    enlarge(result.largest_offset, result.offset_time, now.offset, time);
    if (!joint.gaskets.empty() && now.opening > result.installed_compression)
      result.contact_lost_time = std::min(result.contact_lost_time, time);
    if (now.opening > joint.omega_limit)
      result.omega_exceeded_time = std::min(result.omega_exceeded_time, time);
  }
}

Record Recorder::snapshot(double time, std::span<const std::size_t> elements) const {
  Record record;
  record.time = time;
  for (const std::size_t e : elements) {
    for (const Direction d : {kAxial, kLateral, kVertical})
      record.displacement[d].push_back(
          stepper_.structure().middle_displacement(e, d, stepper_.displacement()));
    record.rotation.push_back(stepper_.structure().middle_rotation(e, stepper_.displacement()));
    record.axial_force.push_back(forces_[e].axial);
    record.moment_lateral.push_back(forces_[e].moment_lateral);
    record.moment_vertical.push_back(forces_[e].moment_vertical);
    record.shear_lateral.push_back(forces_[e].shear_lateral);
    record.shear_vertical.push_back(forces_[e].shear_vertical);
    record.pressure_ratio.push_back(stepper_.soil().pressure_ratio(e));
  }
  for (std::size_t j = 0; j < stepper_.joints().size(); ++j)
    record.joints.push_back(stepper_.joints().action(j, stepper_.displacement()));
  return record;
}

void Recorder::finish() {
  results_.energy = stepper_.energy();
  results_.energy_error = largest_energy_ > 0 ? largest_error_ / largest_energy_ : 0;
  results_.newton_iterations = stepper_.newton_iterations();
  results_.factorizations = stepper_.factorizations();
}

}  // namespace adit::simplified::beam
