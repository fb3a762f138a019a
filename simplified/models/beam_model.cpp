#include <algorithm>

#include "simplified/models/solve.hpp"
#include "simplified/scene/joint.hpp"

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
  return {chainage, {spring(stiffness.axial), spring(stiffness.lateral), spring(stiffness.vertical)}};
}

beam::Portal portal(scene::Portal portal) {
  return portal == scene::FIXED ? beam::Portal::kFixed : beam::Portal::kFree;
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

}  // namespace adit::simplified
