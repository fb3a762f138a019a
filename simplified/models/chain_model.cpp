#include "protocol/errors.hpp"
#include "simplified/models/solve.hpp"
#include "simplified/scene/joint.hpp"

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
  if (!scene.tunnel().inertia())
    throw UserError(
        "simplified.tunnel.inertia",
        "is false, which needs the model beam, because rigid bodies have a mass; write `model: beam`");
  if (scene.excitation().vertical() != 0)
    throw UserError(
        "simplified.excitation.vertical",
        "needs the model beam, because the chain moves in the horizontal plane; write `model: beam`");
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

}  // namespace adit::simplified
