#include "dem_server/model/at_stage.hpp"

#include <fmt/format.h>

#include "protocol/errors.hpp"

namespace adit::dem {

void set_stage(const ParticleStage& stage, Model& model) {
  model.present = stage.present;
  model.group = stage.group;
  model.mass = stage.mass;
  model.bonds = stage.bonds;
}

std::vector<Model> all_stages(const Model& model) {
  std::vector<Model> models{model};
  models.front().stages.clear();
  for (const ParticleStage& stage : model.stages) {
    models.push_back(models.front());
    set_stage(stage, models.back());
  }
  return models;
}

void require_overlap_stays(const Model& model) {
  const auto require = [&](bool changes, std::size_t i, const std::string& when) {
    if (changes && model.weight[i] != 1)
      throw protocol::UserError(
          "particles.excavations",
          fmt::format(
              "or groups change the particle at ({:.6g}, {:.6g}) m {}, where the interface joins it to "
              "the continuum; keep what changes away from the overlap",
              model.discs.x[i], model.discs.y[i], when));
  };
  for (std::size_t i = 0; i < model.present.size(); ++i) require(!model.present[i], i, "in the beginning");
  const std::vector<bool>* before = &model.present;
  for (const ParticleStage& stage : model.stages) {
    for (std::size_t i = 0; i < model.discs.size(); ++i) {
      const bool vanishes = !stage.present[i] && (before->empty() || (*before)[i]);
      require(vanishes || stage.fresh[i], i, fmt::format("in stage {}", stage.number));
    }
    before = &stage.present;
  }
}

}  // namespace adit::dem
