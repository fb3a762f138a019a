// A model as it is from the beginning of one of its stages on.
#pragma once

#include <vector>

#include "dem_server/model/model.hpp"

namespace adit::dem {

// Gives the model the discs' masses and groups, and the bonds, of a stage.
void set_stage(const ParticleStage& stage, Model& model);

// The model at the beginning and in each of its stages.
std::vector<Model> all_stages(const Model& model);

// UserError at particles.excavations for a disc that changes in some stage where other than the full weight
// acts on it, which is in an overlap.
void require_overlap_stays(const Model& model);

}  // namespace adit::dem
