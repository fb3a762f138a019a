// Which discs of the model are joined, and by what.
#pragma once

#include <string>
#include <vector>

#include "dem_server/model/model.hpp"
#include "dem_server/model/placement/groups.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::dem {

// Counts of pairs in the stage that has most of them.
struct Joined {
  std::size_t bonds = 0, nearly = 0;  // with a bond; without one, but within Reach::near
  std::vector<std::size_t> crossing;  // parted by each of `joints`, of those that something would join
};

// Sets the bonds of each stage, and the laws of the model, from its discs and their groups. The rule for two
// discs near each other: the last of `joints` whose line parts them; else the ring's joints; else `between`
// their groups; else the bonds of their groups. A joint without a stage begins with the first groups between
// which it stands. UserError for joints that part nothing, groups that are unknown or joined by laws of two
// kinds.
Joined join(const scene::Particles& particles, const std::vector<Group>& groups, const Placement& placement,
            std::vector<ParticleStage>& stages, Model& model);

// What is likely to be wrong with the bonds of a model.
// One sentence each, where
// - many pairs are left without a bond by a gap that the rounding of their places may have opened;
// - rows of particles interlock across an open joint, which then does not slide as a plane,
// - discs at a smooth joint are free to spin, and roll instead of bearing its pressure.
std::vector<std::string> join_warnings(const scene::Particles& particles, const Joined& joined,
                                       const Reach& reach, const Model& model);

}  // namespace adit::dem
