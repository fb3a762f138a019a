#include "fdm_server/model/supports/segments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "protocol/errors.hpp"

namespace adit::fdm {
namespace {

using protocol::require;

// Of a section by area and inertia that of the rectangle that has both.
double thickness_of(const scene::Lining& lining) {
  if (lining.has_section()) return lining.section().thickness();
  return lining.has_thickness() ? lining.thickness() : std::sqrt(12 * lining.inertia() / lining.area());
}

void require_inside(double position, double edge, const std::string& path) {
  require(
      std::abs(position) <= edge, path,
      fmt::format("is {:.4g} m, outside the section, which reaches {:.4g} m from the axis to either side; "
                  "give a place inside",
                  position, edge));
}

JointBolts read_bolts(const scene::JointBolts& bolts, double edge, double share, const std::string& path) {
  require_inside(bolts.position(), edge, path + ".position");
  require(bolts.pretension() <= bolts.yield_force(), path + ".pretension",
          fmt::format("is {:.4g} N, more than the yield force of {:.4g} N; give less", bolts.pretension(),
                      bolts.yield_force()));
  const double spacing = bolts.spacing() / share;
  return {bolts.stiffness() / spacing, bolts.pretension() / spacing, bolts.yield_force() / spacing,
          bolts.position(), spacing};
}

JointGasket read_gasket(const scene::JointGasket& gasket, double edge, double share,
                        const std::string& path) {
  require_inside(gasket.position(), edge, path + ".position");
  std::vector<double> opening(gasket.force().opening().begin(), gasket.force().opening().end()),
      force(gasket.force().force().begin(), gasket.force().force().end());
  require(std::ranges::is_sorted(force) && force.back() == 0, path + ".force.force",
          "must rise to 0 where the gasket lets go, because it presses, compression is negative, and it "
          "presses less as the joint opens; list the forces so");
  for (double& one : force) one *= share;
  // The first slope goes on, the last one does not: a gasket does not pull.
  opening.push_back(opening.back() + 1);
  force.push_back(0);
  require(gasket.has_width() == gasket.has_water_pressure(), path,
          "needs both for its tightness: give `width` and `water_pressure`, or neither");
  return {protocol::ForceCurve(std::move(opening), std::move(force)), gasket.position(),
          share * gasket.width() * gasket.water_pressure()};
}

}  // namespace

std::shared_ptr<const JointLaw> read_segments(const scene::Lining& lining, const scene::LiningJoint& joint,
                                              const LiningSection* section, double share,
                                              const std::string& path) {
  if (!joint.has_contact()) {
    require(joint.bolts().empty() && !joint.has_gasket(), path,
            "has bolts or a gasket, but no faces between which they act; give `contact`, too");
    return nullptr;
  }
  require(!joint.has_rotational_stiffness() && !joint.has_yield_moment(), path,
          "is both the faces of segments (`contact`) and a spring (`rotational_stiffness`); leave one out");
  const double thickness = thickness_of(lining), edge = thickness / 2;
  const auto& contact = joint.contact();
  require(contact.height() <= thickness, path + ".contact.height",
          fmt::format("is {:.4g} m, more than the lining's thickness of {:.4g} m; give at most that",
                      contact.height(), thickness));
  const double of_lining = section != nullptr ? section->concrete_modulus : lining.young_modulus();
  JointLaw law{
      {contact.height(), share * (contact.has_young_modulus() ? contact.young_modulus() : of_lining)}};
  law.edge = edge;
  for (int i = 0; i < joint.bolts_size(); ++i)
    law.bolts.push_back(read_bolts(joint.bolts(i), edge, share, fmt::format("{}.bolts[{}]", path, i)));
  if (joint.has_gasket()) law.gasket = read_gasket(joint.gasket(), edge, share, path + ".gasket");
  require(law.installed().has_value(), path + ".bolts",
          fmt::format("have a pretension beside the contact of the faces, which reaches {:.4g} m from the "
                      "axis to either side, and nothing balances it; move them, or leave it out",
                      contact.height() / 2));
  return std::make_shared<const JointLaw>(std::move(law));
}

void require_segments_fit(const scene::Lining& lining, std::span<const LiningJoint> joints, const Path& along,
                          const std::string& path) {
  const std::size_t nodes = along.points.size();
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (!joints[i].segments) continue;
    const auto node = joints[i].node;
    const auto here = fmt::format("{}.joints[{}]", path, i);
    if (!along.closed && (node == 0 || node + 1 == nodes))
      require(
          node == 0 ? lining.first_end_fixed() : lining.last_end_fixed(), here,
          "is of segments (`contact`), but lies at an end of the lining, where none follows; leave it out, "
          "or fix the rotation of that end, as in a plane of symmetry");
    for (std::size_t other = 0; other < i; ++other) {
      const auto apart = std::max(node, joints[other].node) - std::min(node, joints[other].node);
      require(
          !joints[other].segments || (apart > 1 && (!along.closed || apart + 1 < nodes)), here,
          fmt::format("is one beam from joints[{}], but segments are at least two beams long; use shorter "
                      "zones",
                      other));
    }
  }
}

}  // namespace adit::fdm
