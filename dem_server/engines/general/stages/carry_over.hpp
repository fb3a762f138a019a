// What the bonds of a new stage of excavation take over from those before.
#pragma once

#include <span>
#include <vector>

#include "dem_server/engines/general/forces/joints.hpp"
#include "dem_server/engines/general/pairs/pairs.hpp"

namespace adit::dem {

// The pairs of a stage, with the laws that their numbers name.
struct StagePairs {
  std::span<const PairLaw> laws;
  const Pairs& bonds;
};

// A bond of the same two discs, law and width keeps its state, broken or not, unless one of them begins
// (`fresh`). Any other starts whole and free of force at its present place, and so does its contact.
void carry_over(const StagePairs& before, const std::vector<bool>& fresh, std::span<const PairLaw> laws,
                const Particles& particles, Pairs& bonds);

// The same for smooth joints; both lists ascend.
void carry_over(std::span<const Joints::Joint> before, const std::vector<bool>& fresh,
                std::vector<Joints::Joint>& joints);

}  // namespace adit::dem
