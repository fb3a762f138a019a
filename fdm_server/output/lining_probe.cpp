#include "fdm_server/output/lining_probe.hpp"

#include <algorithm>
#include <cmath>

#include "fdm_server/supports/joint_use.hpp"
#include "fdm_server/supports/section_use.hpp"
#include "protocol/errors.hpp"
#include "protocol/nearest_name.hpp"

namespace adit::fdm {

bool is_of_lining(scene::Quantity quantity) {
  return quantity == scene::THRUST || quantity == scene::MOMENT || quantity == scene::SHEAR_FORCE ||
         is_of_reinforced_section(quantity) || is_of_segments(quantity) || is_of_dowels(quantity);
}

bool is_of_reinforced_section(scene::Quantity quantity) {
  return quantity == scene::UTILISATION || quantity == scene::CURVATURE || quantity == scene::SHEAR_STRENGTH;
}

bool is_of_segments(scene::Quantity quantity) {
  return quantity == scene::ROTATION || quantity == scene::OUTER_OPENING ||
         quantity == scene::INNER_OPENING || quantity == scene::GASKET_OPENING ||
         quantity == scene::TIGHTNESS || quantity == scene::BOLT_FORCE;
}

bool is_of_dowels(scene::Quantity quantity) {
  return quantity == scene::DOWEL_FORCE || quantity == scene::RING_OFFSET;
}

namespace {

LiningJoint joint_at(std::size_t node, const Lining& lining, scene::Quantity quantity,
                     const std::string& path) {
  const auto joint = std::ranges::find(lining.joints, node, &LiningJoint::node);
  protocol::require(joint != lining.joints.end() && joint->segments, path + ".at",
                    "lies where lining `" + lining.name +
                        "` has no joint of segments (`contact`); give the place of one of its joints");
  const JointLaw& law = *joint->segments;
  const auto needs = [&](scene::Quantity of, bool there, const std::string& what) {
    protocol::require(quantity != of || there, path + ".quantity",
                      "is of " + what + ", which the joint at this place of lining `" + lining.name +
                          "` does not have; add it, or ask for another quantity");
  };
  needs(scene::BOLT_FORCE, !law.bolts.empty(), "bolts");
  needs(scene::GASKET_OPENING, law.gasket.has_value(), "a gasket");
  needs(scene::TIGHTNESS, law.gasket && law.gasket->water_force > 0, "a gasket against water");
  return *joint;
}

std::uint32_t dowel_at(const geometry::Point& place, const Lining& lining, const Grid& grid,
                       const std::string& path) {
  protocol::require(
      !lining.dowels.empty(), path + ".lining",
      "is `" + lining.name + "`, which has no dowels to a ring beside it; name the lining that has `beside`");
  const auto away = [&](std::size_t node) {
    const auto point = lining.path.points[node];
    return std::hypot(grid.x[point] - place.x, grid.y[point] - place.y);
  };
  const auto nearest = std::ranges::min_element(lining.dowels, {}, away) - lining.dowels.begin();
  return lining.first_dowel + static_cast<std::uint32_t>(nearest);
}

double value_of_dowel(scene::Quantity quantity, const Lining& lining, const Dowel& dowel) {
  return quantity == scene::RING_OFFSET ? dowel.offset() : lining.ring_width * dowel.force();
}

double value_of_joint(scene::Quantity quantity, const JointUse& use) {
  switch (quantity) {
    case scene::OUTER_OPENING:
      return use.outer_opening;
    case scene::INNER_OPENING:
      return use.inner_opening;
    case scene::GASKET_OPENING:
      return use.gasket_opening;
    case scene::TIGHTNESS:
      return use.tightness;
    case scene::BOLT_FORCE:
      return use.bolt_force;
    default:
      return use.rotation;
  }
}

}  // namespace

LiningProbe resolve_lining_probe(const scene::History& history, const Supports& supports, const Grid& grid,
                                 const std::string& path) {
  protocol::require(!history.has_lining() || !history.has_member(), path + ".member",
                    "is given beside `lining`; name one of them");
  const bool of_member = history.has_member();
  const auto& chains = of_member ? supports.members : supports.linings;
  const std::string kind = of_member ? "member" : "lining",
                    name = of_member ? history.member() : history.lining();
  const auto found = std::ranges::find(chains, name, &Lining::name);
  if (found == chains.end()) {
    std::vector<std::string> names;
    for (const Lining& chain : chains) names.push_back(chain.name);
    throw protocol::UserError(
        path + "." + kind,
        of_member || history.has_lining()
            ? "is `" + name + "`, but no " + kind + " of the continuum has this name" +
                  protocol::did_you_mean(name, names)
            : std::string("is missing; name the lining or `member` whose force is recorded"));
  }
  protocol::require(found->section || !is_of_reinforced_section(history.quantity()), path + ".quantity",
                    "is of sections of reinforced concrete, but " + kind + " `" + found->name +
                        "` is elastic; give it a `section`");
  const geometry::Point place{history.at().x(), history.at().y()};
  LiningProbe probe{history.quantity(), of_member, static_cast<std::size_t>(found - chains.begin()),
                    nearest_node(place, found->path, grid, path + ".at")};
  if (is_of_segments(history.quantity()))
    probe.joint = joint_at(probe.node, *found, history.quantity(), path);
  if (is_of_dowels(history.quantity())) probe.dowel = dowel_at(place, *found, grid, path);
  return probe;
}

double value(const LiningProbe& probe, const Supports& supports, const Structures& structures) {
  const Lining& lining = (probe.of_member ? supports.members : supports.linings)[probe.number];
  if (probe.joint) return value_of_joint(probe.quantity, joint_use(lining, structures, *probe.joint));
  if (probe.dowel) return value_of_dowel(probe.quantity, lining, structures.dowels()[*probe.dowel]);
  if (probe.quantity == scene::UTILISATION) return section_use(lining, structures, probe.node).utilisation;
  if (probe.quantity == scene::CURVATURE) return section_use(lining, structures, probe.node).curvature;
  if (probe.quantity == scene::SHEAR_STRENGTH) return shear_strength(lining, structures, probe.node);
  const auto [thrust, moment, shear] = forces_at(lining, structures, probe.node);
  return probe.quantity == scene::THRUST ? thrust : probe.quantity == scene::MOMENT ? moment : shear;
}

}  // namespace adit::fdm
