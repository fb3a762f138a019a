#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "protocol/errors.hpp"
#include "simplified/beam/run.hpp"
#include "simplified/models/differences.hpp"
#include "simplified/models/solve.hpp"
#include "simplified/scene/along_chainage.hpp"
#include "simplified/scene/joint.hpp"
#include "simplified/scene/liquefaction.hpp"

namespace adit::simplified {
namespace {

beam::Section section(const scene::Section& scene, double from, double to) {
  beam::Section section;
  section.from = from;
  section.to = to;
  section.youngs_modulus = scene.young_modulus();
  section.area = scene.area();
  section.inertia_lateral = scene.lateral_inertia();
  section.inertia_vertical = scene.vertical_inertia();
  section.shear_modulus = scene.young_modulus() / (2 * (1 + scene.poisson_ratio()));
  section.shear_area_lateral = section.shear_area_vertical = scene.shear_area();
  section.mass = scene.mass();
  section.half_width = scene.width() / 2;
  section.half_height = scene.height() / 2;
  return section;
}

beam::SoilStation soil_station(const scene::Simplified& scene, double chainage,
                               const scene::Section& section) {
  const SoilStiffness stiffness = soil_stiffness(scene, chainage, section);
  const auto& given = scene.soil_springs();
  const auto spring = [&](double k) {
    return beam::SoilSpring{k, given.slip_force(), given.hardening(), given.dashpot_time() * k};
  };
  beam::SoilStation station{chainage,
                            {spring(stiffness.axial), spring(stiffness.lateral), spring(stiffness.vertical)}};
  if (may_liquefy(scene)) {
    station.liquefied = given.liquefied();
    station.uplift = uplift(scene, chainage, section);
  }
  return station;
}

beam::Portal portal(scene::Portal portal) {
  return portal == scene::FIXED ? beam::Portal::kFixed : beam::Portal::kFree;
}

using protocol::UserError;

beam::Scheme scheme(const scene::Integration& integration) {
  using Scene = scene::Integration;
  // An absent enumerator reads as the first one, newmark, but the beam has another default
  // (simplified.proto).
  if (!integration.has_scheme()) return beam::energy_conserving();
  switch (integration.scheme()) {
    case Scene::NEWMARK:
      return beam::newmark();
    case Scene::ENERGY_CONSERVING:
      return beam::energy_conserving();
    case Scene::HHT:
      return beam::hht(0.1);
    default:
      throw UserError("simplified.integration.scheme",
                      "is for the model chain; the model beam has newmark, energy_conserving and hht");
  }
}

// The ground motion for the beam, whose time steps are those of the field.
beam::GroundMotion motion_of(const scene::Simplified& scene, const GroundField& ground, const Clock& clock) {
  std::optional<AlongChainage> along;  // made in the first call, which gives the chainages
  std::vector<double> pressure;
  if (may_liquefy(scene)) pressure = pressure_at_tunnel(scene, ground);
  return [&ground, clock, along, pressure](double time, std::span<const double> chainages,
                                           beam::GroundState& state) mutable {
    if (!along) along.emplace(ground.chainage, std::vector(chainages.begin(), chainages.end()));
    // The time is a product of a step and dt, which division may turn into a number just below the step.
    const auto step = static_cast<std::size_t>(std::lround(time / clock.dt));
    for (int d = 0; d < kDirections; ++d) {
      const Shaking& shaking = ground.shaking[d];
      const auto fill = [&](const std::vector<double>& table, std::vector<double>& to) {
        if (table.empty())
          std::ranges::fill(to, 0.0);
        else
          along->interpolate(table.data() + step * shaking.places, to.data());
      };
      fill(shaking.displacement, state.displacement[d]);
      fill(shaking.velocity, state.velocity[d]);
    }
    if (!pressure.empty())
      along->interpolate_linearly(pressure.data() + step * ground.chainage.size(),
                                  state.pressure_ratio.data());
  };
}

Envelope envelope(const char* name, const char* unit, const beam::Envelope& of) {
  return {name, unit, of.minimum, of.maximum};
}

Table histories(const scene::Simplified& scene, const std::vector<beam::Record>& records) {
  Table table;
  table.columns = {"time_s"};
  std::vector<const char*> quantities = {"ux_m",
                                         "uy_m",
                                         "uz_m",
                                         "axial_force_N",
                                         "moment_lateral_N_m",
                                         "moment_vertical_N_m",
                                         "shear_lateral_N",
                                         "shear_vertical_N"};
  if (may_liquefy(scene)) quantities.push_back("pressure_ratio");
  for (const scene::Station& station : scene.stations())
    for (const char* quantity : quantities) table.columns.push_back(station.name() + "_" + quantity);
  for (const beam::Record& record : records) {
    auto& row = table.rows.emplace_back(1, record.time);
    const std::array values = {&record.displacement[0], &record.displacement[1], &record.displacement[2],
                               &record.axial_force,     &record.moment_lateral,  &record.moment_vertical,
                               &record.shear_lateral,   &record.shear_vertical,  &record.pressure_ratio};
    for (std::size_t s = 0; s < static_cast<std::size_t>(scene.stations_size()); ++s)
      for (std::size_t q = 0; q < quantities.size(); ++q) row.push_back((*values[q])[s]);
  }
  return table;
}

Fields fields(const beam::Results& results) {
  Fields fields;
  fields.chainage = results.chainage;
  std::vector<double> axial, lateral, rotation;
  const auto append = [](std::vector<double>& to, const std::vector<double>& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  for (const beam::Record& record : results.fields) {
    fields.time.push_back(record.time);
    append(fields.axial_force, record.axial_force);
    append(axial, record.displacement[beam::kAxial]);
    append(lateral, record.displacement[beam::kLateral]);
    append(rotation, record.rotation);
  }
  fields.axial_velocity = rates(axial, fields.time, fields.chainage.size());
  fields.lateral_velocity = rates(lateral, fields.time, fields.chainage.size());
  fields.spin = rates(rotation, fields.time, fields.chainage.size());
  return fields;
}

std::vector<JointCourse> courses(const beam::Results& results) {
  std::vector<JointCourse> courses(results.joints.size());
  for (const beam::Record& record : results.fields)
    for (std::size_t j = 0; j < courses.size(); ++j) {
      const beam::JointAction& action = record.joints[j];
      courses[j].opening.push_back(action.opening);
      courses[j].offset.push_back(action.offset);
      courses[j].rotation.push_back(action.rotation);
      courses[j].axial_force.push_back(action.axial_force);
      courses[j].shear.push_back(action.shear);
      courses[j].moment.push_back(action.moment);
    }
  return courses;
}

std::vector<JointResponse> joints(const Line& line, const std::vector<beam::JointResult>& results) {
  std::vector<JointResponse> joints;
  for (std::size_t j = 0; j < results.size(); ++j) {
    const beam::JointResult& result = results[j];
    joints.push_back({result.chainage, line.joints[j].group, result.largest_opening,
                      result.largest_compression, result.largest_offset});
  }
  return joints;
}

beam::Results run(const scene::Simplified& scene, const Line& line, const GroundField& ground,
                  const Clock& clock) {
  beam::RunOptions options;
  options.dt = clock.dt;
  options.steps = static_cast<long>(clock.steps);
  options.scheme = scheme(scene.integration());
  options.history_every = static_cast<int>(clock.stride);
  options.field_every = std::max(1, static_cast<int>(kFieldInterval / clock.dt + 1e-9));
  for (const scene::Station& station : scene.stations()) options.stations.push_back(station.chainage());
  const beam::Tunnel tunnel = beam_model(scene, line);
  try {
    return beam::run(tunnel, motion_of(scene, ground, clock), options);
    // The kernels know nothing of the scene, so their paths are repeated in the message below the scene's
    // path.
  } catch (const UserError& error) {
    throw UserError("simplified.tunnel", error.path() + ": " + error.what());
  }
}

}  // namespace

// Each piece of the line is one element; the soil is linear over it and may jump with the section.
beam::Tunnel beam_model(const scene::Simplified& scene, const Line& line) {
  beam::Tunnel tunnel;
  for (std::size_t i = 0; i < line.section.size(); ++i) {
    const auto& here = scene.tunnel().sections(static_cast<int>(line.section[i]));
    const double from = line.nodes[i], to = line.nodes[i + 1];
    tunnel.sections.push_back(section(here, from, to));
    tunnel.soil.push_back(soil_station(scene, from, here));
    tunnel.soil.push_back(soil_station(scene, to, here));
    // The length is a little more than the longest piece, so that rounding errors never cut a piece in two.
    tunnel.element_length = std::max(tunnel.element_length, 1.001 * (to - from));
  }
  for (std::size_t j = 0; j < line.joints.size(); ++j) {
    const std::size_t node = line.joint_node[j];
    tunnel.joints.push_back(beam_joint(scene.tunnel().joints(static_cast<int>(line.joints[j].group)),
                                       joint_outline(scene.tunnel(), line, node), line.nodes[node]));
  }
  tunnel.start = portal(scene.tunnel().begin());
  tunnel.end = portal(scene.tunnel().end());
  tunnel.inertia = scene.tunnel().inertia();
  return tunnel;
}

Response solve_beam(const scene::Simplified& scene, const Line& line, const GroundField& ground,
                    const Clock& clock) {
  const beam::Results results = run(scene, line, ground, clock);
  Response response;
  response.chainage = results.chainage;
  response.envelopes = {envelope("axial_force", "N", results.axial_force),
                        envelope("moment_lateral", "N_m", results.moment_lateral),
                        envelope("moment_vertical", "N_m", results.moment_vertical),
                        envelope("shear_lateral", "N", results.shear_lateral),
                        envelope("shear_vertical", "N", results.shear_vertical),
                        envelope("strain", "", results.strain)};
  if (may_liquefy(scene)) {
    response.envelopes.push_back(envelope("uplift", "m", results.vertical_displacement));
    response.envelopes.push_back(envelope("pressure_ratio", "", results.pressure_ratio));
  }
  response.joints = joints(line, results.joints);
  response.histories = histories(scene, results.histories);
  response.fields = fields(results);
  response.courses = courses(results);
  response.figures = {{"elements", static_cast<double>(results.chainage.size())},
                      {"newton_iterations", static_cast<double>(results.newton_iterations)},
                      {"energy_error", results.energy_error}};
  response.wall_s = results.wall_s;
  return response;
}

}  // namespace adit::simplified
