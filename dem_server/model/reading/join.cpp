#include "dem_server/model/reading/join.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "dem_server/model/placement/joint_lines.hpp"
#include "dem_server/model/reading/bond_type.hpp"
#include "protocol/errors.hpp"
#include "protocol/text.hpp"

namespace adit::dem {
namespace {

using protocol::UserError;
using GroupPair = std::pair<std::uint32_t, std::uint32_t>;  // ascending

GroupPair ordered(std::uint32_t a, std::uint32_t b) {
  return std::minmax(a, b);
}

std::string joint_path(std::size_t number) {
  return "particles.joints[" + std::to_string(number) + "]";
}

// What stands between discs: a joint's line, the ring's, or neither.
constexpr int kRing = -1, kNothing = -2;

// The types of bonds of the scene, each read once.
class BondTypes {
 public:
  BondTypes(const scene::Particles& particles, const std::vector<Group>& groups)
      : particles_(particles), groups_(groups) {
    for (int k = 0; k < particles.between_size(); ++k) {
      const auto& between = particles.between(k);
      const std::string path = between_path(k);
      const auto pair = ordered(group_named(between.first(), groups, path + ".first"),
                                group_named(between.second(), groups, path + ".second"));
      if (pair.first == pair.second)
        throw UserError(path, "names one group twice; give the bonds within a group there");
      if (!between_.emplace(pair, k).second)
        throw UserError(path, "names two groups that an earlier one names; give each two once");
    }
  }

  // Number of the type that joins discs of two groups across what stands between them, kNothing: none does.
  int find(int barrier, std::uint32_t first, std::uint32_t second) {
    const GroupPair pair = ordered(first, second);
    const auto [found, is_new] = numbers_.try_emplace({barrier, pair}, kNothing);
    if (is_new)
      if (const auto type = read(barrier, pair)) {
        found->second = static_cast<int>(types_.size());
        types_.push_back(*type);
      }
    return found->second;
  }
  const BondType& operator[](int number) const { return types_[static_cast<std::size_t>(number)]; }

  // The largest of all reaches that the scene gives.
  double largest_reach() const {
    double reach = scene::Bonds::default_instance().reach();
    const auto add = [&reach](const scene::Bonds& bonds) { reach = std::max(reach, bonds.reach()); };
    add(particles_.bonds());
    add(particles_.ring().joints());
    for (const auto& group : particles_.groups()) add(group.bonds());
    for (const auto& between : particles_.between()) add(between.bonds());
    for (const auto& joint : particles_.joints()) add(joint.bonds());
    return reach;
  }

 private:
  static std::string between_path(int number) { return "particles.between[" + std::to_string(number) + "]"; }

  std::optional<BondType> read(int barrier, const GroupPair& pair) {
    if (barrier == kNothing) return of_groups(pair);
    if (barrier == kRing)
      return particles_.ring().has_joints() ? read(particles_.ring().joints(), "particles.ring.joints", pair)
                                            : std::nullopt;
    const auto& joint = particles_.joints(barrier);
    const std::string path = joint_path(static_cast<std::size_t>(barrier));
    if (joint.has_bonds()) return read(joint.bonds(), path + ".bonds", pair);
    if (!joint.has_smooth()) return std::nullopt;
    const auto replaced = of_groups(pair);
    const double reach = replaced ? replaced->reach : scene::Bonds::default_instance().reach();
    return read_smooth_joint(joint.smooth(), reach);
  }

  std::optional<BondType> read(const scene::Bonds& bonds, const std::string& path,
                               const GroupPair& pair) const {
    return read_bond_type(bonds, path, source(groups_[pair.first], groups_[pair.second]));
  }

  std::optional<BondType> of_groups(const GroupPair& pair) const {
    if (const auto named = between_.find(pair); named != between_.end()) {
      const auto& between = particles_.between(named->second);
      if (!between.has_bonds()) return std::nullopt;
      return read(between.bonds(), between_path(named->second) + ".bonds", pair);
    }
    const auto first = of_group(groups_[pair.first]), second = of_group(groups_[pair.second]);
    if (!first || !second || pair.first == pair.second) return second ? first : std::nullopt;
    const auto common = between(*first, *second);
    if (!common)
      throw UserError(
          "particles.between",
          fmt::format(
              "does not say how to bond the groups {} and {}, which meet, one with contact bonds and one "
              "with parallel bonds; name the two there",
              protocol::quote(groups_[pair.first].name), protocol::quote(groups_[pair.second].name)));
    return common;
  }

  std::optional<BondType> of_group(const Group& group) const {
    if (group.bonds == nullptr) return std::nullopt;
    return read_bond_type(*group.bonds, group.bonds_path, source(group, group));
  }

  // Of bonds between particles of two groups, or of one.
  BondSource source(const Group& first, const Group& second) const {
    BondSource source{[&] {
                        return &first == &second ? first.stiffness()
                                                 : in_series(first.stiffness(), second.stiffness());
                      },
                      [&](const std::string& path) {
                        return weaker(strength_of(first.material, path), strength_of(second.material, path));
                      },
                      std::nullopt};
    if (particles_.has_packing()) source.lattice_radius = particles_.packing().radius();
    return source;
  }

  const scene::Particles& particles_;
  const std::vector<Group>& groups_;
  std::map<GroupPair, int> between_;
  std::map<std::pair<int, GroupPair>, int> numbers_;
  std::vector<BondType> types_;
};

// Numbers the model's laws: those of one type and one size once.
class Laws {
 public:
  explicit Laws(Model& model) : model_(model) {}

  std::pair<Bond::Law, std::uint32_t> find(int type, const BondType& bond, double radius) {
    const auto add = [&](auto& laws, auto law) {
      const auto [found, is_new] =
          numbers_.try_emplace({type, radius}, static_cast<std::uint32_t>(laws.size()));
      if (is_new) laws.push_back(law);
      return found->second;
    };
    if (const auto* contact = std::get_if<ContactBond>(&bond.law)) {
      radius = 0;  // any
      return {Bond::Law::kContactBond, add(model_.contact_bonds, *contact)};
    }
    if (const auto* parallel = std::get_if<ParallelBond>(&bond.law)) {
      ParallelBond law = *parallel;
      law.radius *= radius;
      return {Bond::Law::kParallelBond, add(model_.parallel_bonds, law)};
    }
    SmoothJoint law = std::get<SmoothJoint>(bond.law);
    law.length *= 2 * radius;
    return {Bond::Law::kSmoothJoint, add(model_.smooth_joints, law)};
  }

 private:
  Model& model_;
  std::map<std::pair<int, double>, std::uint32_t> numbers_;
};

std::vector<JointLine> read_lines(const scene::Particles& particles) {
  std::vector<JointLine> lines;
  for (const auto& joint : particles.joints()) {
    const std::string path = joint_path(lines.size());
    const geometry::Point from{joint.from().x(), joint.from().y()}, to{joint.to().x(), joint.to().y()};
    if (from.x == to.x && from.y == to.y)
      throw UserError(path + ".to", "is the same place as `from`; give a joint two ends");
    if (joint.law_case() == scene::ParticleJoint::LAW_NOT_SET || (joint.has_open() && !joint.open()))
      throw UserError(path,
                      "does not say what joins the particles across it; give bonds, smooth or open: true");
    lines.emplace_back(from, to);
  }
  return lines;
}

}  // namespace

void join(const scene::Particles& particles, const std::vector<Group>& groups, Model& model) {
  const Discs& discs = model.discs;
  const auto lines = read_lines(particles);
  std::optional<RingJoints> ring;
  if (particles.has_ring()) ring.emplace(particles.ring());
  BondTypes types(particles, groups);
  Laws laws(model);
  std::vector<bool> parts_some(lines.size(), false);
  // The joints of a ring within ground end at its outer side.
  const bool within_ground = particles.ring().within_ground();
  const auto is_lining = [&](std::uint32_t i) { return groups[model.group[i]].name == kLining; };
  const auto in_ring = [&](const Pair& pair) {
    return !within_ground || (is_lining(pair.first) && is_lining(pair.second));
  };

  for (const Pair& pair : pairs_within(discs, types.largest_reach() * std::ranges::max(discs.radius))) {
    const auto [i, j] = pair;
    const double share =
        (std::hypot(discs.x[j] - discs.x[i], discs.y[j] - discs.y[i]) - discs.radius[i] - discs.radius[j]) /
        (0.5 * (discs.radius[i] + discs.radius[j]));
    const auto joins = [&](int type) { return type != kNothing && share <= types[type].reach; };
    int barrier = kNothing;
    if (ring && in_ring(pair) && ring->parts(discs, pair)) barrier = kRing;
    for (std::size_t k = lines.size(); k-- > 0;)
      if (lines[k].parts(discs, pair)) {
        barrier = static_cast<int>(k);
        break;
      }
    const int type = types.find(barrier, model.group[i], model.group[j]);
    if (barrier >= 0 && (joins(type) || joins(types.find(kNothing, model.group[i], model.group[j]))))
      parts_some[static_cast<std::size_t>(barrier)] = true;
    if (!joins(type)) continue;
    const auto [law, number] = laws.find(type, types[type], std::min(discs.radius[i], discs.radius[j]));
    Bond bond{i, j, law, number};
    if (law == Bond::Law::kSmoothJoint) {
      const auto [nx, ny] = lines[static_cast<std::size_t>(barrier)].normal(discs, pair);
      bond.nx = nx;
      bond.ny = ny;
    }
    model.bonds.push_back(bond);
  }
  for (std::size_t k = 0; k < lines.size(); ++k)
    if (!parts_some[k])
      throw UserError(joint_path(k), "parts no particles that are joined; move it between them");
}

}  // namespace adit::dem
