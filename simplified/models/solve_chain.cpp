#include "simplified/models/solve.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "protocol/errors.hpp"
#include "protocol/stop_signals.hpp"
#include "simplified/chain/simulation.hpp"
#include "simplified/scene/along_chainage.hpp"
#include "simplified/scene/joint.hpp"
#include "simplified/scene/liquefaction.hpp"

namespace adit::simplified {
namespace {

using protocol::UserError;

// Shear stiffness of a lining without shear deformation, relative to the bending stiffness of one body. The
// relative error of the deflection is the inverse of this factor.
constexpr double kShearlessFactor = 1e4;

const scene::Section& section_of(const scene::Simplified& scene, const Line& line, std::size_t piece) {
  return scene.tunnel().sections(static_cast<int>(line.section[piece]));
}

// A rigid body replaces a piece of the lining; the deformation of the piece takes place in the hinges at its
// ends.
chain::Body body(const scene::Simplified& scene, const scene::Section& section, double from, double to) {
  chain::Body body;
  const double length = to - from, middle = (from + to) / 2;
  body.length = length;
  body.mass = section.mass() * length;
  // As in the beam model, a lining with shear deformation (Timoshenko) has the rotary inertia of its
  // cross-section, too.
  body.inertia = body.mass * length * length / 12;
  if (section.has_shear_area()) body.inertia += body.mass * section.lateral_inertia() / section.area();
  const SoilStiffness soil = soil_stiffness(scene, middle, section);
  // The lateral springs along the body also resist its rotation: int k x^2 dx = k l^3/12.
  body.ground_stiffness = {soil.axial * length, soil.lateral * length,
                           soil.lateral * length * length * length / 12};
  const double time = scene.soil_springs().dashpot_time();
  body.ground_dashpot = {time * body.ground_stiffness.axial, time * body.ground_stiffness.lateral,
                         time * body.ground_stiffness.rotation};
  return body;
}

// The flexibility of half a piece of lining: as a bar, in bending, and in shear.
Flexibility half_lining(const scene::Section& section, double length) {
  const double E = section.young_modulus(), half = length / 2;
  const double bending = E * section.lateral_inertia();
  const double shear = section.has_shear_area()
                           ? half / (E / (2 * (1 + section.poisson_ratio())) * section.shear_area())
                           : half * length * length / (kShearlessFactor * bending);
  return {half / (E * section.area()), shear, half / bending};
}

void check_limits_of_the_chain(const scene::Simplified& scene) {
  if (scene.soil_springs().has_slip_force())
    throw UserError("simplified.soil_springs.slip_force",
                    "needs the model beam, because the chain's ground springs are linear; leave it out or "
                    "write `model: beam`");
  if (may_liquefy(scene))
    throw UserError(
        "simplified.ground",
        "has a layer with `liquefaction`, which needs the model beam, because the chain's ground springs "
        "do not weaken; leave it out or write `model: beam`");
  if (!scene.tunnel().inertia())
    throw UserError(
        "simplified.tunnel.inertia",
        "is false, which needs the model beam, because rigid bodies have a mass; write `model: beam`");
  if (scene.excitation().vertical() != 0)
    throw UserError(
        "simplified.excitation.vertical",
        "needs the model beam, because the chain moves in the horizontal plane; write `model: beam`");
}

using protocol::UserError;

// Largest number of places at which fields are recorded.
constexpr std::size_t kFieldPlaces = 1000;

void check(const scene::Integration& integration) {
  if (integration.scheme() != scene::Integration::NEWMARK)
    throw UserError("simplified.integration.scheme", "is for the model beam; the model chain has newmark");
}

std::vector<double> centres(const Line& line) {
  std::vector<double> centres;
  for (std::size_t i = 0; i + 1 < line.nodes.size(); ++i)
    centres.push_back((line.nodes[i] + line.nodes[i + 1]) / 2);
  return centres;
}

// The ground motion at the bodies, step by step.
class Ground {
 public:
  Ground(const GroundField& field, const std::vector<double>& centres)
      : field_(field), along_(field.chainage, centres) {
    for (auto& values : values_) values.assign(centres.size(), 0.0);
  }
  chain::Excitation at(std::size_t step) {
    const auto fill = [&](Direction direction, bool velocity,
                          std::vector<double>& to) -> std::span<const double> {
      const Shaking& shaking = field_.shaking[direction];
      const auto& table = velocity ? shaking.velocity : shaking.displacement;
      if (table.empty()) return {};
      along_.interpolate(table.data() + step * shaking.places, to.data());
      return to;
    };
    chain::Excitation excitation;
    excitation.ground_x = fill(kAxial, false, values_[0]);
    excitation.ground_y = fill(kLateral, false, values_[1]);
    excitation.ground_vx = fill(kAxial, true, values_[2]);
    excitation.ground_vy = fill(kLateral, true, values_[3]);
    return excitation;
  }

 private:
  const GroundField& field_;
  AlongChainage along_;
  std::array<std::vector<double>, 4> values_;
};

// The axial force of every joint at rest, which balances the water pressure. Results count from this state.
std::vector<double> forces_at_rest(const scene::Simplified& scene, const Line& line) {
  std::vector<double> forces(line.nodes.size());
  for (std::size_t k = 0; k < line.joints.size(); ++k)
    forces[line.joint_node[k]] =
        -scene.tunnel().joints(static_cast<int>(line.joints[k].group)).gasket().installed_force();
  return forces;
}

// Records histories and fields while the chain moves.
class Recorder {
 public:
  Recorder(const scene::Simplified& scene, const Line& line, const std::vector<double>& centres)
      : at_rest_(forces_at_rest(scene, line)) {
    response_.histories.columns = {"time_s"};
    for (const scene::Station& station : scene.stations()) {
      bodies_.push_back(nearest(centres, station.chainage()));
      joints_.push_back(nearest(line.nodes, station.chainage()));
      for (const char* quantity : {"ux_m", "uy_m", "axial_force_N", "moment_lateral_N_m", "shear_lateral_N"})
        response_.histories.columns.push_back(station.name() + "_" + quantity);
    }
    // Rounded up, so that there are never more places than allowed.
    const std::size_t stride = (centres.size() + kFieldPlaces - 1) / kFieldPlaces;
    for (std::size_t i = 0; i < centres.size(); i += stride) {
      places_.push_back(i);
      response_.fields.chainage.push_back(centres[i]);
    }
  }

  void add_histories(const chain::Simulation& run) {
    const chain::BodyMotion bodies = run.bodies();
    const chain::Joints joints = run.joints();
    auto& row = response_.histories.rows.emplace_back(1, run.time());
    for (std::size_t s = 0; s < bodies_.size(); ++s) {
      const std::size_t body = bodies_[s], joint = joints_[s];
      row.insert(row.end(), {bodies.x[body], bodies.y[body], joints.axial.force[joint] - at_rest_[joint],
                             joints.rotation.force[joint], joints.shear.force[joint]});
    }
  }

  void add_fields(const chain::Simulation& run) {
    const chain::BodyMotion bodies = run.bodies();
    const chain::Joints joints = run.joints();
    Fields& fields = response_.fields;
    fields.time.push_back(run.time());
    for (const std::size_t i : places_) {
      fields.axial_velocity.push_back(bodies.vx[i]);
      fields.lateral_velocity.push_back(bodies.vy[i]);
      fields.spin.push_back(bodies.spin[i]);
      fields.axial_force.push_back(
          (joints.axial.force[i] - at_rest_[i] + joints.axial.force[i + 1] - at_rest_[i + 1]) / 2);
    }
  }

  Response take() { return std::move(response_); }

 private:
  Response response_;
  std::vector<double> at_rest_;
  std::vector<std::size_t> bodies_, joints_, places_;
};

Envelope envelope(const char* name, const char* unit, const chain::Extremes& of) {
  // Places are the hinges between bodies. The two ends are left out: they carry no force or are abutments.
  return {name, unit, {of.min.begin() + 1, of.min.end() - 1}, {of.max.begin() + 1, of.max.end() - 1}};
}

Envelope axial_force(const scene::Simplified& scene, const Line& line, const chain::Envelopes& envelopes) {
  Envelope force = envelope("axial_force", "N", envelopes.axial_force);
  const std::vector<double> at_rest = forces_at_rest(scene, line);
  for (std::size_t j = 0; j < force.least.size(); ++j) {
    force.least[j] -= at_rest[j + 1];
    force.greatest[j] -= at_rest[j + 1];
  }
  return force;
}

double largest(const chain::Extremes& extremes, std::size_t j) {
  return std::max(-extremes.min[j], extremes.max[j]);
}

// Strain of the lining's outermost fibre beside every hinge, N/EA plus M (d/2)/EI, on the side of the hinge
// where it is larger. It is an upper bound, because force and moment are largest at different times.
Envelope strain(const scene::Simplified& scene, const Line& line, const chain::Envelopes& envelopes) {
  const Envelope force = axial_force(scene, line, envelopes);
  const std::size_t hinges = line.section.size() - 1;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Envelope strain{"strain", "", std::vector(hinges, kInfinity), std::vector(hinges, -kInfinity)};
  for (std::size_t h = 0; h < hinges; ++h)
    for (const std::size_t piece : {h, h + 1}) {
      const auto& section = scene.tunnel().sections(static_cast<int>(line.section[piece]));
      const double bending = largest(envelopes.moment, h + 1) * section.width() / 2 /
                             (section.young_modulus() * section.lateral_inertia());
      const double axial = section.young_modulus() * section.area();
      strain.least[h] = std::min(strain.least[h], force.least[h] / axial - bending);
      strain.greatest[h] = std::max(strain.greatest[h], force.greatest[h] / axial + bending);
    }
  return strain;
}

// The deformation of the joints alone: that of the hinge less that of the lining under the hinge's force. The
// largest opening is an upper bound if a joint both opens along the axis and rotates, because both are
// largest at different times.
std::vector<JointResponse> joints(const scene::Simplified& scene, const Line& line,
                                  const chain::Envelopes& envelopes) {
  const Envelope force = axial_force(scene, line, envelopes);
  std::vector<JointResponse> joints;
  for (std::size_t k = 0; k < line.joints.size(); ++k) {
    const std::size_t j = line.joint_node[k];
    const Flexibility lining = lining_about(scene, line, j);
    const double rotation = largest(envelopes.rotation, j) - largest(envelopes.moment, j) * lining.rotation;
    const double turn = rotation * joint_outline(scene.tunnel(), line, j).width / 2;
    joints.push_back({line.nodes[j], line.joints[k].group,
                      envelopes.opening.max[j] - force.greatest[j - 1] * lining.axial + turn,
                      turn - envelopes.opening.min[j] + force.least[j - 1] * lining.axial,
                      largest(envelopes.slip, j)});
  }
  return joints;
}

chain::Simulation prepare(const scene::Simplified& scene, const Line& line, const Clock& clock) {
  check(scene.integration());
  const chain::Chain chain = chain_model(scene, line);
  try {
    return {chain, {.dt = clock.dt}};
  } catch (const UserError& error) {
    // Errors of the scene have their path already; those of the kernels name a place of the chain.
    if (error.path().starts_with("simplified.")) throw;
    throw UserError("simplified.tunnel", error.path() + ": " + error.what());
  }
}

}  // namespace

Flexibility lining_about(const scene::Simplified& scene, const Line& line, std::size_t node) {
  Flexibility sum{};
  for (const std::size_t piece : {node - 1, node}) {
    if (piece >= line.section.size())
      continue;  // no piece beyond the portals; before the first, -1 wraps around
    const Flexibility half =
        half_lining(section_of(scene, line, piece), line.nodes[piece + 1] - line.nodes[piece]);
    sum.axial += half.axial;
    sum.lateral += half.lateral;
    sum.rotation += half.rotation;
  }
  return sum;
}

chain::Chain chain_model(const scene::Simplified& scene, const Line& line) {
  check_limits_of_the_chain(scene);
  chain::Chain chain;
  auto joint = line.joint_node.begin();
  for (std::size_t piece = 0; piece < line.section.size(); ++piece) {
    const auto& section = section_of(scene, line, piece);
    chain.bodies.push_back(body(scene, section, line.nodes[piece], line.nodes[piece + 1]));
    // Hinges lie between pieces, so the first piece has none before it; a fixed portal gets its hinge below.
    if (piece == 0) continue;
    const Flexibility lining = lining_about(scene, line, piece);
    if (joint != line.joint_node.end() && *joint == piece) {
      const auto group = line.joints[static_cast<std::size_t>(joint - line.joint_node.begin())].group;
      chain.hinges.push_back(hinge(scene.tunnel().joints(static_cast<int>(group)),
                                   joint_outline(scene.tunnel(), line, piece), lining));
      ++joint;
    } else {
      chain.hinges.push_back(hinge(lining));
    }
  }
  if (scene.tunnel().begin() == scene::FIXED) chain.start = hinge(lining_about(scene, line, 0));
  if (scene.tunnel().end() == scene::FIXED)
    chain.finish = hinge(lining_about(scene, line, line.section.size()));
  return chain;
}

Response solve_chain(const scene::Simplified& scene, const Line& line, const GroundField& field,
                     const Clock& clock) {
  using Time = std::chrono::steady_clock;
  const std::vector<double> centres = simplified::centres(line);
  const auto started = Time::now();
  chain::Simulation run = prepare(scene, line, clock);
  Ground ground(field, centres);
  Recorder recorder(scene, line, centres);
  const auto field_stride =
      std::max<std::uint64_t>(1, static_cast<std::uint64_t>(kFieldInterval / clock.dt + 1e-9));
  recorder.add_histories(run);
  recorder.add_fields(run);
  for (std::uint64_t n = 1; n <= clock.steps; ++n) {
    protocol::end_if_stopped();
    run.step(ground.at(n));
    if (n % clock.stride == 0 || n == clock.steps) recorder.add_histories(run);
    if (n % field_stride == 0) recorder.add_fields(run);
  }

  Response response = recorder.take();
  const chain::Envelopes& envelopes = run.envelopes();
  response.chainage.assign(line.nodes.begin() + 1, line.nodes.end() - 1);
  response.envelopes = {
      axial_force(scene, line, envelopes), envelope("moment_lateral", "N_m", envelopes.moment),
      envelope("shear_lateral", "N", envelopes.shear_force), strain(scene, line, envelopes)};
  response.joints = joints(scene, line, envelopes);
  response.wall_s = std::chrono::duration<double>(Time::now() - started).count();
  response.figures = {
      {"bodies", static_cast<double>(centres.size())},
      {"linear_solutions", static_cast<double>(run.iterations())},
      {"time_per_body_and_step_s", response.wall_s / static_cast<double>(clock.steps * centres.size())}};
  return response;
}

}  // namespace adit::simplified
