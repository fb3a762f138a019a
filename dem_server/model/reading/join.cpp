#include "dem_server/model/reading/join.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "dem_server/laws/pair_kinematics.hpp"
#include "dem_server/model/placement/joint_lines.hpp"
#include "dem_server/model/placement/scene_checks.hpp"
#include "dem_server/model/reading/bond_type.hpp"
#include "dem_server/model/solid/facets_of_material.hpp"
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

// Keys of bonds that facets take from the material.
void refuse_keys_of_discs(const scene::Bonds& bonds, const std::string& path) {
  for (const auto& [given, name] :
       {std::pair{bonds.has_tensile_strength(), "tensile_strength"},
        std::pair{bonds.has_shear_strength(), "shear_strength"},
        std::pair{bonds.has_normal_stiffness(), "normal_stiffness"},
        std::pair{bonds.has_shear_stiffness(), "shear_stiffness"},
        std::pair{bonds.has_parallel(), "parallel"}, std::pair{bonds.has_reach(), "reach"},
        std::pair{bonds.strength_of_material(), "strength_of_material"}})
    if (given)
      throw UserError(path + "." + name,
                      "is given, but facets between cells have the stiffness of the material and its "
                      "`fracture`; leave it out, "
                      "or give `fracture` here");
}

// What stands between discs: a joint's line, the ring's, or neither.
constexpr int kRing = -1, kNothing = -2;

// The types of bonds of the scene, each read once.
class BondTypes {
 public:
  BondTypes(const scene::Particles& particles, const std::vector<Group>& groups, double reach)
      : particles_(particles), groups_(groups), reach_(reach) {
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
      if (auto type = read(barrier, pair)) {
        auto* facet = std::get_if<FacetType>(&type->law);
        if (facet && barrier == kNothing && pair.first == pair.second) facet->law.contraction = kContraction;
        found->second = static_cast<int>(types_.size());
        types_.push_back(*type);
      }
    return found->second;
  }
  const BondType& operator[](int number) const { return types_[static_cast<std::size_t>(number)]; }

  // The largest of all reaches.
  double largest_reach() const {
    double reach = reach_;
    const auto add = [&reach](const scene::Bonds& bonds) {
      if (bonds.has_reach()) reach = std::max(reach, bonds.reach());
    };
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
    const double reach = replaced ? replaced->reach : reach_;
    return read_smooth_joint(joint.smooth(), reach);
  }

  std::optional<BondType> read(const scene::Bonds& bonds, const std::string& path,
                               const GroupPair& pair) const {
    if (particles_.has_cells()) return facet_type(bonds, path, groups_[pair.first], groups_[pair.second]);
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
    if (particles_.has_cells()) return facet_type(*group.bonds, group.bonds_path, group, group);
    return read_bond_type(*group.bonds, group.bonds_path, source(group, group));
  }

  // Between cells of two groups, or of one: stiffnesses in series, and the weaker of both materials unless
  // the bonds state a strength.
  BondType facet_type(const scene::Bonds& bonds, const std::string& path, const Group& first,
                      const Group& second) const {
    refuse_keys_of_discs(bonds, path);
    const auto strength = [](const Group& group) {
      const scene::Material& material = group.material.material;
      return material.has_fracture() ? fracture_of(material.fracture(), group.material.path + ".fracture")
                                     : unbroken();
    };
    const FacetLaw law = bonds.has_fracture() ? fracture_of(bonds.fracture(), path + ".fracture")
                                              : weaker(strength(first), strength(second));
    return {FacetType{in_series(elasticity_of(first.material, first.plane).stiffness,
                                elasticity_of(second.material, second.plane).stiffness),
                      law},
            reach_};
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
                      std::nullopt, reach_};
    if (particles_.has_packing()) source.lattice_radius = particles_.packing().radius();
    return source;
  }

  const scene::Particles& particles_;
  const std::vector<Group>& groups_;
  double reach_;  // of bonds that state none
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
    require_two_ends(joint.from(), joint.to(), path, "joint");
    if (joint.law_case() == scene::ParticleJoint::LAW_NOT_SET || (joint.has_open() && !joint.open()))
      throw UserError(path,
                      "does not say what joins the particles across it; give bonds, smooth or open: true");
    lines.emplace_back(from, to);
  }
  return lines;
}

// The stages with which the joints begin: as the scene says, or else with the groups that each of them parts.
std::vector<std::uint32_t> begin_of_joints(const scene::Particles& particles, const Discs& discs,
                                           const std::vector<JointLine>& lines, const std::vector<Pair>& near,
                                           const std::vector<std::uint32_t>& group) {
  const auto begin_of = [&](std::uint32_t disc) { return begin_of_group(particles, group[disc]); };
  std::vector<std::uint32_t> begin;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const auto& joint = particles.joints(static_cast<int>(k));
    std::optional<std::uint32_t> first;
    if (joint.has_stage()) {
      first = joint.stage();
    } else {
      for (const Pair& pair : near)
        if (lines[k].parts(discs, pair)) {
          const std::uint32_t stage = std::max(begin_of(pair.first), begin_of(pair.second));
          first = std::min(first.value_or(stage), stage);
        }
    }
    begin.push_back(first.value_or(0));
  }
  return begin;
}

// Joins two discs, if anything does.
class Joiner {
 public:
  Joiner(const scene::Particles& particles, const std::vector<Group>& groups, const Placement& placement,
         const std::vector<ParticleStage>& stages, Model& model)
      : discs_(model.discs),
        groups_(groups),
        reach_(placement.reach),
        cells_(placement.cells ? &*placement.cells : nullptr),
        model_(model),
        lines_(read_lines(particles)),
        types_(particles, groups, reach_.unstated),
        laws_(model) {
    near_ = cells_ ? pairs_of(cells_->facets)
                   : pairs_within(discs_, std::max(types_.largest_reach(), reach_.near) *
                                              std::ranges::max(discs_.radius));
    begin_of_lines_ = begin_of_joints(particles, discs_, lines_, near_, stages.back().group);
    joined_.crossing.resize(lines_.size(), 0);
    if (particles.has_ring()) ring_.emplace(particles.ring());
    within_ground_ = particles.ring().within_ground();
  }

  void join(ParticleStage& stage) {
    nearly_ = 0;
    crossing_.assign(lines_.size(), 0);
    for (std::size_t k = 0; k < near_.size(); ++k)
      if (stage.present[near_[k].first] && stage.present[near_[k].second]) join(k, stage);
    joined_.bonds = std::max(joined_.bonds, stage.bonds.size());
    joined_.nearly = std::max(joined_.nearly, nearly_);
    for (std::size_t k = 0; k < lines_.size(); ++k)
      joined_.crossing[k] = std::max(joined_.crossing[k], crossing_[k]);
  }

  const Joined& joined() const { return joined_; }

  void require_parting() const {
    for (std::size_t k = 0; k < lines_.size(); ++k)
      if (joined_.crossing[k] == 0)
        throw UserError(joint_path(k), "parts no particles that are joined; move it between them");
  }

 private:
  // The joints of a ring within ground end at its outer side.
  bool in_ring(const Pair& pair, const ParticleStage& stage) const {
    const auto is_lining = [&](std::uint32_t i) { return groups_[stage.group[i]].name == kLining; };
    return !within_ground_ || (is_lining(pair.first) && is_lining(pair.second));
  }

  int barrier_between(const Pair& pair, const ParticleStage& stage) const {
    for (std::size_t k = lines_.size(); k-- > 0;)
      if (begin_of_lines_[k] <= stage.number && lines_[k].parts(discs_, pair)) return static_cast<int>(k);
    return ring_ && in_ring(pair, stage) && ring_->parts(discs_, pair) ? kRing : kNothing;
  }

  static std::vector<Pair> pairs_of(std::span<const Facet> facets) {
    std::vector<Pair> pairs;
    for (const Facet& facet : facets) pairs.push_back({facet.first, facet.second});
    return pairs;
  }

  static double length_of(const Facet& facet) {
    return std::hypot(facet.x_2 - facet.x_1, facet.y_2 - facet.y_1);
  }

  // What nothing joins lies face to face.
  FacetType touching_type(std::uint32_t first, std::uint32_t second) const {
    const Group &one = groups_[first], &other = groups_[second];
    const double stiffness = in_series(elasticity_of(one.material, one.plane).stiffness,
                                       elasticity_of(other.material, other.plane).stiffness);
    return {stiffness, touching(stiffness, model_.contacts[model_.contact_number(first, second)].friction)};
  }

  void join_over(const Facet& facet, const FacetType& type, ParticleStage& stage) {
    const auto [i, j] = std::pair(facet.first, facet.second);
    const double x = discs_.x[j] - discs_.x[i], y = discs_.y[j] - discs_.y[i], distance = std::hypot(x, y);
    const double nx = x / distance, ny = y / distance;
    const double off =
        across(nx, ny, (facet.x_1 + facet.x_2) / 2 - discs_.x[i], (facet.y_1 + facet.y_2) / 2 - discs_.y[i]);
    const auto found = std::ranges::find(model_.facet_laws, type.law);
    const auto law = static_cast<std::uint32_t>(found - model_.facet_laws.begin());
    if (found == model_.facet_laws.end()) model_.facet_laws.push_back(type.law);
    stage.bonds.push_back({i, j, Bond::Law::kFacet, static_cast<std::uint32_t>(model_.facets.size())});
    model_.facets.push_back(
        {nx, ny, distance / 2, off / distance, length_of(facet), type.stiffness / distance, law});
  }

  void join(std::size_t near, ParticleStage& stage) {
    const Pair& pair = near_[near];
    const auto [i, j] = pair;
    const double distance = std::hypot(discs_.x[j] - discs_.x[i], discs_.y[j] - discs_.y[i]);
    // Cells that have a facet touch along it.
    const double share = cells_ ? 0
                                : (distance - discs_.radius[i] - discs_.radius[j]) /
                                      (0.5 * (discs_.radius[i] + discs_.radius[j]));
    const auto joins = [&](int type) { return type != kNothing && share <= types_[type].reach; };
    const int barrier = barrier_between(pair, stage);
    const int type = types_.find(barrier, stage.group[i], stage.group[j]);
    if (barrier >= 0 && (joins(type) || joins(types_.find(kNothing, stage.group[i], stage.group[j]))))
      ++crossing_[static_cast<std::size_t>(barrier)];
    if (!joins(type)) {
      if (cells_)
        join_over(cells_->facets[near], touching_type(stage.group[i], stage.group[j]), stage);
      else if (type != kNothing && share <= reach_.near)
        ++nearly_;
      return;
    }
    if (const auto* facet = std::get_if<FacetType>(&types_[type].law)) {
      join_over(cells_->facets[near], *facet, stage);
      return;
    }
    const double half_width =
        cells_ ? length_of(cells_->facets[near]) / 2 : std::min(discs_.radius[i], discs_.radius[j]);
    const auto [law, number] = laws_.find(type, types_[type], half_width);
    Bond bond{i, j, law, number};
    if (law == Bond::Law::kSmoothJoint) {
      const auto [nx, ny] = lines_[static_cast<std::size_t>(barrier)].normal(discs_, pair);
      bond.nx = nx;
      bond.ny = ny;
    }
    stage.bonds.push_back(bond);
  }

  const Discs& discs_;
  const std::vector<Group>& groups_;
  Reach reach_;
  const CellShapes* cells_;  // null: discs
  Model& model_;
  std::vector<JointLine> lines_;
  std::vector<std::uint32_t> begin_of_lines_;
  std::optional<RingJoints> ring_;
  bool within_ground_ = false;
  BondTypes types_;
  Laws laws_;
  std::vector<Pair> near_;
  Joined joined_;
  std::size_t nearly_ = 0;             // in the stage at hand
  std::vector<std::size_t> crossing_;  // likewise, of each line
};

constexpr double kFewPairs = 0.05;             // of the bonds
constexpr std::size_t kContactsOfLining = 40;  // that cross it; its joints are short, and keys hold them

void warn_of_near_pairs(const Joined& joined, const Reach& reach, std::vector<std::string>& warnings) {
  if (static_cast<double>(joined.nearly) <= kFewPairs * static_cast<double>(joined.bonds)) return;
  warnings.push_back(
      fmt::format("particles have {} bonds, and {} more pairs only touch, though their gaps are at most "
                  "{:.2g} of their mean "
                  "radius; where rounding opened them, give bonds.reach: {:.2g}",
                  joined.bonds, joined.nearly, reach.near, reach.near));
}

void warn_of_teeth(const scene::Particles& particles, const Joined& joined,
                   std::vector<std::string>& warnings) {
  if (!particles.has_packing() && !particles.has_square_packing()) return;
  for (std::size_t k = 0; k < joined.crossing.size(); ++k) {
    if (!particles.joints(static_cast<int>(k)).open() || joined.crossing[k] <= kContactsOfLining) continue;
    warnings.push_back(fmt::format(
        "particles.joints[{}] is open across {} contacts of particles in rows, which interlock and part "
        "where the faces shift; a `smooth` joint slides along its plane",
        k, joined.crossing[k]));
  }
}

// Whether a bond holds both of its discs from spinning by itself, with more than a hundredth of its
// stiffness.
bool resists_spin(const Model& model, const Bond& bond) {
  if (bond.law == Bond::Law::kSmoothJoint) return false;
  if (bond.law != Bond::Law::kContactBond) return true;
  const auto [normal, shear] = model.contact_bonds[bond.number].stiffness;
  return shear > normal / 100;
}

// The force of a smooth joint does not act along the line of its discs' centres, and turns them. Discs that
// spin freely roll out of its way.
void warn_of_rolling(const Model& model, std::vector<std::string>& warnings) {
  if (model.smooth_joints.empty()) return;
  std::vector<bool> held(model.discs.size());
  for (const Bond& bond : model.bonds)
    if (resists_spin(model, bond)) held[bond.first] = held[bond.second] = true;
  const auto rolls = [&](const Bond& bond) {
    return bond.law == Bond::Law::kSmoothJoint && !(held[bond.first] && held[bond.second]);
  };
  if (const auto count = std::ranges::count_if(model.bonds, rolls))
    warnings.push_back(fmt::format(
        "{} bonds of smooth joints lie between discs that no other bond keeps from spinning, so that they "
        "roll on one another and bear little; a lattice has no shear stiffness if Poisson's ratio is 0.25 in "
        "plane strain or 1/3 in plane stress: choose a smaller one, parallel bonds, or cells",
        count));
}

}  // namespace

Joined join(const scene::Particles& particles, const std::vector<Group>& groups, const Placement& placement,
            std::vector<ParticleStage>& stages, Model& model) {
  Joiner joiner(particles, groups, placement, stages, model);
  for (ParticleStage& stage : stages) joiner.join(stage);
  joiner.require_parting();
  return joiner.joined();
}

std::vector<std::string> join_warnings(const scene::Particles& particles, const Joined& joined,
                                       const Reach& reach, const Model& model) {
  std::vector<std::string> warnings;
  warn_of_near_pairs(joined, reach, warnings);
  warn_of_teeth(particles, joined, warnings);
  warn_of_rolling(model, warnings);
  return warnings;
}

}  // namespace adit::dem
