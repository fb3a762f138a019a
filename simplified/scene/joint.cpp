#include "simplified/scene/joint.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "protocol/errors.hpp"

namespace adit::simplified {
namespace {

using protocol::UserError;

// A deformation that no joint reaches [m]; beyond it curves continue with their last slope.
constexpr double kFar = 10;

// Number of pieces into which the gasket is divided on each side of the rectangle.
constexpr int kRunsPerSide = 2;

// The load curve of the whole joint, or of a metre of gasket.
std::vector<beam::CurvePoint> load_curve(const scene::Gasket& gasket, double length = 1) {
  std::vector<beam::CurvePoint> points;
  for (int i = 0; i < gasket.compression_size(); ++i)
    points.push_back({gasket.compression(i), gasket.force(i) / length});
  return points;
}

// The force of the whole joint's gasket over the opening. Opening and force count from the installed state.
beam::Curve installed(const scene::Gasket& gasket) {
  return beam::gasket(load_curve(gasket), gasket.installed_force());
}

// The force over opening of all axial parts of the joint, with the force at rest, and the corners of this
// curve.
struct AxialLaw {
  std::function<double(double)> force;
  std::vector<double> corners;
};

AxialLaw axial_law(const scene::Joints& group) {
  std::vector<beam::Curve> parts;
  if (group.has_axial_stiffness()) parts.push_back(beam::linear(group.axial_stiffness()));
  if (group.has_cables()) parts.push_back(beam::cable(group.cables().stiffness(), group.cables().slack()));
  if (group.has_gasket()) parts.push_back(installed(group.gasket()));
  AxialLaw law;
  // The installed state is a corner, too, so that the point at rest lies on the curve exactly.
  law.corners = {-kFar, 0, kFar};
  for (const beam::Curve& part : parts)
    for (const beam::CurvePoint& point : part.points) law.corners.push_back(point.elongation);
  std::ranges::sort(law.corners);
  // The chain refuses two points at one deformation, and parts may share corners up to rounding errors.
  const double tiny = 1e-12;
  law.corners.erase(
      std::unique(law.corners.begin(), law.corners.end(), [&](double a, double b) { return b - a < tiny; }),
      law.corners.end());
  const double at_rest = group.has_gasket() ? group.gasket().installed_force() : 0;
  law.force = [parts, at_rest](double opening) {
    double sum = -at_rest;
    for (const beam::Curve& part : parts) sum += part.force(opening);
    return sum;
  };
  return law;
}

double tangent_at_rest(const scene::Joints& group) {
  double sum = group.axial_stiffness();
  if (group.has_gasket()) sum += installed(group.gasket()).tangent(0);
  return sum;
}

// The law in series with a linear flexibility: the opening increases by the elongation of the lining under
// the force.
chain::Curve in_series(const AxialLaw& law, double flexibility) {
  const double at_rest = law.force(0);
  chain::Curve curve;
  for (const double opening : law.corners) {
    const double force = law.force(opening);
    curve.deformation.push_back(opening + (force - at_rest) * flexibility);
    curve.force.push_back(force);
  }
  return curve;
}

double stiffness_in_series(double joint, double flexibility) {
  return joint > 0 ? 1 / (1 / joint + flexibility) : 0;
}

chain::HingeDirection keys(const scene::ShearKeys& keys, double flexibility) {
  chain::HingeDirection direction;
  if (keys.clearance() == 0) {
    direction.stiffness = stiffness_in_series(keys.stiffness(), flexibility);
    return direction;
  }
  const double free = keys.clearance(), force = keys.stiffness() * kFar;
  // The ends carry the force of the keys after kFar beyond the clearance; the lining adds its elongation.
  const double reach = free + kFar + force * flexibility;
  direction.curve = {{-reach, -free, free, reach}, {-force, 0, 0, force}};
  return direction;
}

beam::Curve key_curve(bool given, const scene::ShearKeys& keys) {
  return given ? beam::key(keys.stiffness(), keys.clearance()) : beam::Curve{};
}

// Adds four springs on the axes of the cross-section that together have the axial stiffness and, in both
// planes, the rotation stiffness.
void add_linear(beam::Joint& joint, const scene::Joints& group, const Outline& outline) {
  const double k = group.axial_stiffness();
  const double lateral =
      group.has_rotation_stiffness() ? group.rotation_stiffness() / k : outline.lateral_lever2();
  const double vertical =
      group.has_rotation_stiffness() ? group.rotation_stiffness() / k : outline.vertical_lever2();
  // Two springs of stiffness k/4 at the distance r from the axis have the rotation stiffness 2 (k/4) r^2.
  const double y = std::sqrt(2 * lateral), z = std::sqrt(2 * vertical);
  for (const double side : {-1.0, 1.0}) {
    joint.springs.push_back({side * y, 0, beam::linear(k / 4)});
    joint.springs.push_back({0, side * z, beam::linear(k / 4)});
  }
}

}  // namespace

Outline joint_outline(const scene::Tunnel& tunnel, const Line& line, std::size_t node) {
  const auto& before = tunnel.sections(static_cast<int>(line.section[node - 1]));
  const auto& after = tunnel.sections(static_cast<int>(line.section[node]));
  return {std::min(before.width(), after.width()), std::min(before.height(), after.height())};
}

void check(const scene::Joints& group, const std::string& path) {
  if (!group.has_axial_stiffness() && !group.has_gasket())
    throw UserError(path,
                    "has neither `axial_stiffness` nor `gasket`; a joint needs one that holds it together");
  if (group.has_rotation_stiffness() && !group.has_axial_stiffness())
    throw UserError(path + ".rotation_stiffness",
                    "is given without `axial_stiffness`; add it, or leave the rotation stiffness to the "
                    "gasket and the cables, whose places determine it");
  if (!group.has_gasket()) return;
  const scene::Gasket& gasket = group.gasket();
  beam::check_load_curve(load_curve(gasket), path + ".gasket.force");
}

beam::Joint beam_joint(const scene::Joints& group, const Outline& outline, double chainage) {
  beam::Joint joint;
  joint.chainage = chainage;
  if (group.has_gasket()) {
    joint.hydrostatic_force = group.gasket().installed_force();
    joint.gaskets = beam::rectangular_gasket(outline.width, outline.height, kRunsPerSide,
                                             load_curve(group.gasket(), outline.perimeter()));
  }
  if (group.has_axial_stiffness()) add_linear(joint, group, outline);
  if (group.has_cables())
    for (const double side : {-0.5, 0.5})
      joint.springs.push_back(
          {side * outline.width, 0, beam::cable(group.cables().stiffness() / 2, group.cables().slack())});
  joint.lateral = key_curve(group.has_lateral_keys(), group.lateral_keys());
  joint.vertical = key_curve(group.has_vertical_keys(), group.vertical_keys());
  if (group.has_seal_limit()) joint.omega_limit = group.seal_limit();
  return joint;
}

chain::Hinge hinge(const scene::Joints& group, const Outline& outline, const Flexibility& lining) {
  chain::Hinge hinge;
  if (group.has_gasket() || group.has_cables())
    hinge.axial.curve = in_series(axial_law(group), lining.axial);
  else
    hinge.axial.stiffness = stiffness_in_series(group.axial_stiffness(), lining.axial);
  // Rotation is linear, with the tangent stiffness of the parts at rest.
  const double rotation = group.has_rotation_stiffness() ? group.rotation_stiffness()
                                                         : tangent_at_rest(group) * outline.lateral_lever2();
  hinge.rotation.stiffness = stiffness_in_series(rotation, lining.rotation);
  if (group.has_lateral_keys()) hinge.shear = keys(group.lateral_keys(), lining.lateral);
  return hinge;
}

chain::Hinge hinge(const Flexibility& lining) {
  chain::Hinge hinge;
  hinge.axial.stiffness = 1 / lining.axial;
  hinge.rotation.stiffness = 1 / lining.rotation;
  hinge.shear.stiffness = 1 / lining.lateral;
  return hinge;
}

}  // namespace adit::simplified
