#include "simplified/zoom/plan_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "protocol/errors.hpp"
#include "simplified/models/solve.hpp"
#include "simplified/scene/ground.hpp"
#include "simplified/scene/tunnel.hpp"
#include "simplified/zoom/plan_joint.hpp"
#include "simplified/zoom/slab.hpp"

namespace adit::simplified {
namespace {

constexpr int kZonesAcross = 16;      // of the slab
constexpr int kLeastRowsPerZone = 2;  // of particles
constexpr double kLeastColumns = 10;  // radii between the joint and the end of its particles
constexpr double kLeastReach = 0.1;   // of the particles to either side, over the slab's width

// The lengths of the model along the tunnel.
struct Lengths {
  double begin, joint, end;  // of the window [m]
  double left, right;        // where the next joint begins to be spread: halfway to it, or an edge [m]
  double reach;              // of the particles to either side of the joint [m]
};

Lengths lengths(const beam::Tunnel& tunnel, std::size_t joint, const Window& window, double width) {
  const double begin = window.begin.chainage, at = tunnel.joints[joint].chainage, end = window.end.chainage;
  const double before = joint > 0 ? tunnel.joints[joint - 1].chainage : -HUGE_VAL;
  const double after = joint + 1 < tunnel.joints.size() ? tunnel.joints[joint + 1].chainage : HUGE_VAL;
  Lengths lengths{begin, at, end, std::max(begin, (before + at) / 2), std::min(end, (at + after) / 2), 0};
  lengths.reach =
      std::min({at - lengths.left, lengths.right - at, (at - begin) / 2, (end - at) / 2, width / 2});
  if (lengths.reach < kLeastReach * width)
    throw protocol::UserError(
        "simplified.zoom",
        fmt::format(
            "leaves {:.3g} m of particles on a side of the joint at {:g} m, between the joints beside it and "
            "the window from {:g} to {:g} m; {:.3g} m are needed, a tenth of the slab's width: give a larger "
            "`width`, or zoom into a tunnel of longer bodies",
            lengths.reach, at, begin, end, kLeastReach * width));
  return lengths;
}

std::vector<beam::Joint> joints_between(const beam::Tunnel& tunnel, double from, double to) {
  std::vector<beam::Joint> joints;
  for (const beam::Joint& joint : tunnel.joints)
    if (joint.chainage > from && joint.chainage < to) joints.push_back(joint);
  return joints;
}

scene::Material material_of(const Slab& slab) {
  scene::Material material;
  material.set_young_modulus(slab.young_modulus);
  material.set_poisson_ratio(slab.poisson_ratio);
  material.set_density(slab.density);
  return material;
}

// As many zones as make them square or shorter; somewhat more where grid lines then lie where joints begin to
// be spread.
int zones_along(const Lengths& at, double height) {
  const double length = at.end - at.begin;
  const int least = static_cast<int>(std::ceil(length / height));
  const auto on_a_line = [&](double x, int zones) {
    const double number = (x - at.begin) / length * zones;
    return std::abs(number - std::round(number)) < 1e-6;
  };
  for (int zones = least; zones <= 2 * least; ++zones)
    if (on_a_line(at.left, zones) && on_a_line(at.right, zones)) return zones;
  return least;
}

void add_zones(const beam::Tunnel& tunnel, const scene::Section& section, const Slab& slab, const Lengths& at,
               scene::Continuum& continuum) {
  scene::Block& block = *continuum.mutable_block();
  block.set_x_min(at.begin);
  block.set_x_max(at.end);
  block.set_y_min(-slab.width / 2);
  block.set_y_max(slab.width / 2);
  block.set_zones_x(static_cast<std::uint32_t>(zones_along(at, slab.width / kZonesAcross)));
  block.set_zones_y(kZonesAcross);
  const auto add = [&](double from, double to, scene::Area where) {
    const JointedSlab jointed = spread(section, slab, joints_between(tunnel, from, to), to - from);
    const auto add_area = [&](double modulus) -> scene::Area& {
      scene::MaterialArea& area = *continuum.add_materials();
      *area.mutable_where() = where;
      *area.mutable_material() = material_of(slab);
      area.mutable_material()->set_young_modulus(modulus);
      area.mutable_material()->set_poisson_ratio(jointed.poisson_ratio);
      return *area.mutable_where();
    };
    add_area(jointed.inner_modulus);
    add_area(jointed.outer_modulus).set_y_max(-slab.width / 4);
    add_area(jointed.outer_modulus).set_y_min(slab.width / 4);
  };
  scene::Area left, right;
  left.set_x_max(at.left);
  right.set_x_min(at.right);
  if (at.left > at.begin) add(at.begin, at.left, left);
  if (at.right < at.end) add(at.right, at.end, right);
}

// Whole rows to a zone, so that both models have the same share of any band of zones.
PlanPacking packing_of(const Slab& slab, const Lengths& at) {
  const double zone = slab.width / kZonesAcross;
  const double rows = std::ceil(zone / (std::numbers::sqrt3 * at.reach / kLeastColumns) - 1e-9);
  return {at.joint, slab.width, kZonesAcross * std::max(kLeastRowsPerZone, static_cast<int>(rows))};
}

// Columns lie at half a radius and whole radii more from the joint, on either side at least as far as the
// particles reach.
void add_particles(const PlanPacking& packing, const Lengths& at, scene::Particles& particles) {
  const double radius = packing.radius();
  const double pairs = std::ceil((at.reach / radius + 0.5) / 2);
  scene::HexagonalPacking& box = *particles.mutable_packing();
  box.set_x_min(at.joint - (2 * pairs + 0.5) * radius);
  box.set_x_max(at.joint + (2 * pairs + 1.5) * radius);
  box.set_y_min(-packing.width / 2);
  box.set_y_max(packing.width / 2);
  box.set_radius(radius);
}

void add_overlap(const Slab& slab, const Lengths& at, scene::Interface& interface) {
  scene::Box& box = *interface.mutable_overlap()->mutable_around()->mutable_box();
  box.set_x_min(at.joint - at.reach / 2);
  box.set_x_max(at.joint + at.reach / 2);
  box.set_y_min(-slab.width);
  box.set_y_max(slab.width);
  interface.mutable_overlap()->set_width(at.reach / 2);
}

scene::FoundationSpring foundation_spring(double stiffness, const scene::SoilSprings& soil, double width) {
  scene::FoundationSpring spring;
  spring.set_stiffness(stiffness / width);
  if (soil.dashpot_time() > 0) spring.set_dashpot(soil.dashpot_time() * stiffness / width);
  if (soil.has_slip_force()) spring.set_slip_stress(soil.slip_force() / width);
  if (soil.hardening() > 0) spring.set_hardening(soil.hardening());
  return spring;
}

// The beam's axial springs act on its axis and do not hinder it from turning: they hold the two zones beside
// the axis.
template <class Model>
void add_foundations(const SoilStiffness& stiffness, const scene::SoilSprings& soil, const Slab& slab,
                     const std::string& table, Model& model) {
  const double beside_axis = slab.width / kZonesAcross;
  scene::Foundation &axial = *model.add_foundations(), &lateral = *model.add_foundations();
  axial.mutable_where()->set_y_min(-beside_axis);
  axial.mutable_where()->set_y_max(beside_axis);
  *axial.mutable_x() = foundation_spring(stiffness.axial, soil, 2 * beside_axis);
  *lateral.mutable_y() = foundation_spring(stiffness.lateral, soil, slab.width);
  for (scene::Foundation* one : {&axial, &lateral}) one->mutable_ground()->set_path(table);
}

std::string comment(const scene::Section& section, const Slab& slab, const Lengths& at,
                    const beam::Joint& joint, const JointResponse& response, const scene::Joints& group,
                    const std::string& name) {
  const double shear_modulus = section.young_modulus() / (2 * (1 + section.poisson_ratio()));
  const double shear = section.has_shear_area() ? 5. / 6 * section.area() / section.shear_area() : 0;
  return fmt::format(
      "# The joint `{}` at {:g} m of the tunnel in plan: x the chainage, y to the left, the tunnel's axis at "
      "y = 0.\n"
      "# In the beam model it opens by at most {:.4g} mm and shifts by at most {:.4g} mm; over time: "
      "{}_joint.csv.\n"
      "#\n"
      "# The section is a solid slab of {:.4g} m x 1 m, of {:.4g} GPa and {:.4g} kg/m^3, which has the "
      "hollow section's\n"
      "# EA = {:.4g} N, EI = {:.4g} N m^2 and {:.4g} t/m. Forces are those of the whole section.{}\n"
      "# Particles stand for the bodies within {:.4g} m of the joint. In zones beyond {:.6g} and {:.6g} m "
      "the other\n"
      "# joints are spread over the length: two moduli and Poisson's ratio have the flexibility of slab and "
      "joints at rest,\n"
      "# along the axis, in bending and in shear.\n"
      "# Gasket forces count from the installed state, in which {:.4g} MN of water pressure press the bodies "
      "together.\n"
      "# The ground holds slab and particles by the soil springs of the beam: along the axis, where they let "
      "it turn, and "
      "across\n# it over the whole width.\n",
      group.name(), at.joint, 1e3 * response.opening, 1e3 * response.offset, name, slab.width,
      slab.young_modulus / 1e9, slab.density, section.young_modulus() * section.area(),
      section.young_modulus() * section.lateral_inertia(), section.mass() / 1e3,
      shear > 0 ? fmt::format(" Its shear stiffness is {:.2g} times\n# the section's {:.4g} N.", shear,
                              shear_modulus * section.shear_area())
                : "",
      at.reach, at.left, at.right, joint.hydrostatic_force / 1e6);
}

// When the joint opens most, on its axis.
double time_of_peak(const Fields& fields, const JointCourse& course) {
  return fields
      .time[static_cast<std::size_t>(std::ranges::max_element(course.opening) - course.opening.begin())];
}

}  // namespace

PlanScene plan_scene(const Setup& setup, const Response& response, std::size_t joint, const Window& window,
                     const std::string& name, double duration) {
  const scene::Simplified& simplified = *setup.scene;
  const beam::Tunnel tunnel = beam_model(simplified, setup.line);
  const std::size_t piece = setup.line.joint_node[joint] - 1;
  const scene::Section& section = simplified.tunnel().sections(static_cast<int>(setup.line.section[piece]));
  const scene::Joints& group = simplified.tunnel().joints(static_cast<int>(setup.line.joints[joint].group));
  const Slab slab = slab_of(section);
  const Lengths at = lengths(tunnel, joint, window, slab.width);
  const PlanPacking packing = packing_of(slab, at);

  scene::Scene scene = fragment(window, name, duration);
  scene.set_description(fmt::format("{} at {:g} m, coupled in plan", group.name(), at.joint));
  scene.set_plane(scene::PLANE_STRESS);
  *scene.mutable_material() = material_of(slab);
  scene.mutable_time()->set_dt_factor(0.9);  // nothing breaks
  add_zones(tunnel, section, slab, at, *scene.mutable_continuum());
  add_particles(packing, at, *scene.mutable_particles());
  add_joint(tunnel.joints[joint], group, packing, *scene.mutable_particles());
  add_overlap(slab, at, *scene.mutable_interface());
  const SoilStiffness soil = soil_stiffness(simplified, at.joint, section);
  const std::string ground = name + "_along.csv";
  add_foundations(soil, simplified.soil_springs(), slab, ground, *scene.mutable_continuum());
  add_foundations(soil, simplified.soil_springs(), slab, ground, *scene.mutable_particles());
  scene.mutable_output()->set_history_interval(response.fields.time[1] - response.fields.time[0]);
  scene.mutable_output()->add_field_times(time_of_peak(response.fields, response.courses[joint]));
  return {scene, comment(section, slab, at, tunnel.joints[joint], response.joints[joint], group, name)};
}

}  // namespace adit::simplified
