#include "dem_server/lining/read_lining.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "dem_server/model/placement/joint_lines.hpp"
#include "dem_server/model/placement/scene_checks.hpp"
#include "protocol/errors.hpp"
#include "protocol/sections/read_section.hpp"
#include "protocol/text.hpp"

namespace adit::dem {
namespace {

using protocol::UserError;

// Surfaces of this gap and less face each other; of the largest radius. In a lattice those of second
// neighbours are 1.46 radii apart.
constexpr double kFacing = 0.5;

std::string path_of(const char* list, int number) {
  return fmt::format("particles.{}[{}]", list, number);
}

geometry::Point place(const scene::Point& point) {
  return {point.x(), point.y()};
}

[[noreturn]] void refuse_name(const std::string& path, const std::string& name, const char* kind) {
  throw UserError(path + ".name", fmt::format("is {}, like that of an earlier {}; give each its own",
                                              protocol::quote(name), kind));
}

std::vector<Cut> read_cuts(const scene::Particles& scene) {
  std::vector<Cut> cuts;
  for (int k = 0; k < scene.sections_size(); ++k) {
    const auto& section = scene.sections(k);
    const std::string path = path_of("sections", k);
    Cut cut{section.name(), place(section.from()), place(section.to())};
    if (section.has_section())
      cut.strength = std::make_shared<const sections::Strength>(
          sections::strength_of(sections::read_section(section.section(), 1, path + ".section")));
    require_two_ends(section.from(), section.to(), path, "section");
    if (std::ranges::find(cuts, cut.name, &Cut::name) != cuts.end()) refuse_name(path, cut.name, "section");
    cuts.push_back(std::move(cut));
  }
  return cuts;
}

std::vector<Pair> facing(const Discs& discs) {
  return pairs_within(discs, discs.radius.empty() ? 0 : kFacing * std::ranges::max(discs.radius));
}

// The joint that parts what lies at both sides of a cut; empty if there is none.
std::string joint_along(const Cut& cut, const scene::Particles& scene, const Discs& discs) {
  const JointLine line(cut.from, cut.to);
  for (const Pair& pair : facing(discs)) {
    if (!line.parts(discs, pair)) continue;
    for (int k = 0; k < scene.joints_size(); ++k) {
      const auto& joint = scene.joints(k);
      if (!JointLine(place(joint.from()), place(joint.to())).parts(discs, pair)) continue;
      return path_of("joints", k) +
             (joint.has_name() ? fmt::format(" ({})", protocol::quote(joint.name())) : "");
    }
    if (scene.has_ring() && RingJoints(scene.ring()).parts(discs, pair)) return "a joint of particles.ring";
  }
  return {};
}

[[noreturn]] void refuse_cut(const std::string& path, const std::string& joint) {
  if (joint.empty())
    throw UserError(path,
                    "crosses no bond between particles; lay it through the lining, from its inner to its "
                    "outer side");
  throw UserError(path,
                  fmt::format("crosses no bond, because it lies on {}; lay it beside the joint", joint));
}

Sections read_sections(const scene::Particles& scene, const Particles& particles,
                       std::span<const Pair> bonds) {
  Sections sections(read_cuts(scene), particles, bonds);
  for (std::size_t k = 0; k < sections.cuts().size(); ++k)
    if (sections.beside(k).empty())
      refuse_cut(path_of("sections", static_cast<int>(k)),
                 joint_along(sections.cuts()[k], scene, {particles.x, particles.y, particles.radius}));
  return sections;
}

std::vector<JointFaces> read_joints(const scene::Particles& scene, const Particles& p) {
  const std::vector<Pair> near = facing({p.x, p.y, p.radius});
  std::vector<JointFaces> joints;
  const auto add = [&](const std::string& name, const geometry::Point& from, const geometry::Point& to,
                       const std::string& path) {
    if (std::ranges::find(joints, name, &JointFaces::name) != joints.end()) refuse_name(path, name, "joint");
    joints.emplace_back(name, from, to, p, near);
    if (std::min(joints.back().near_face().size(), joints.back().far_face().size()) < 2)
      throw UserError(
          path,
          fmt::format(
              "has fewer than two particles on a face of {}; let it part more, or take smaller particles",
              protocol::quote(name)));
  };
  if (scene.has_ring()) {
    const auto& ring = scene.ring();
    const RingJoints lines(ring);
    for (std::uint32_t k = 0; k < ring.segments(); ++k) {
      const auto [ex, ey] = lines.direction(k);
      const auto at = [&, ex = ex, ey = ey](double radius) {
        return geometry::Point{ring.centre().x() + radius * ex, ring.centre().y() + radius * ey};
      };
      add("joint_" + std::to_string(k), at(ring.inner_radius()), at(ring.outer_radius()), "particles.ring");
    }
  }
  for (int k = 0; k < scene.joints_size(); ++k) {
    const auto& joint = scene.joints(k);
    if (joint.has_name()) add(joint.name(), place(joint.from()), place(joint.to()), path_of("joints", k));
  }
  return joints;
}

std::vector<Oval> read_ovals(const scene::Particles& scene, const Particles& particles) {
  std::vector<Oval> ovals;
  for (int k = 0; k < scene.ovals_size(); ++k) {
    const auto& oval = scene.ovals(k);
    const std::string path = path_of("ovals", k);
    if (std::ranges::find(ovals, oval.name(), &Oval::name) != ovals.end())
      refuse_name(path, oval.name(), "oval");
    const auto& annulus = oval.annulus();
    ovals.emplace_back(oval.name(), place(annulus.centre()), annulus.inner_radius(), annulus.outer_radius(),
                       particles);
    if (!ovals.back().is_whole())
      throw UserError(path + ".annulus",
                      "has gaps without particles; lay it around a whole ring of them, as thick as the ring");
  }
  return ovals;
}

bool has_joints(const scene::Particles& scene) {
  return scene.has_ring() ||
         std::ranges::any_of(scene.joints(), [](const auto& joint) { return joint.has_name(); });
}

}  // namespace

Lining read_lining(const scene::Particles& scene, const Particles& particles, std::span<const Pair> bonds) {
  Lining lining;
  if (scene.sections_size() > 0) lining.sections = read_sections(scene, particles, bonds);
  if (has_joints(scene)) lining.joints = read_joints(scene, particles);
  lining.ovals = read_ovals(scene, particles);
  return lining;
}

}  // namespace adit::dem
