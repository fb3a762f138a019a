// What becomes of the zones from stage to stage: excavations take them away, materials of later stages change
// them or fill their places. In each stage excavations come first. Errors: UserError with the scene's path.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/solver/continuum.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::fdm {

class ZoneStages {
 public:
  struct Renewed {
    std::uint32_t zone, material;  // number of the material (ground.hpp)
  };
  // Each by zone, ascending. Stage 0: what is not there before a later stage.
  struct Stage {
    std::vector<Continuum::Excavated> excavated;
    std::vector<Renewed> renewed;
  };

  // Nothing changes.
  ZoneStages() = default;
  // `of_zone`: the number of each zone's first material; of columns, too, which no stage changes.
  ZoneStages(const scene::Scene& scene, const Grid& grid, std::span<const std::uint32_t> of_zone);

  // Those in which zones change.
  const std::map<std::uint32_t, Stage>& stages() const { return stages_; }
  // Whether each zone is there when this stage has begun, and after the last.
  std::vector<bool> there(std::uint32_t stage) const;
  std::vector<bool> there_at_last() const;

 private:
  std::size_t zones_ = 0;
  std::map<std::uint32_t, Stage> stages_;
};

// The zones that are changed have the stage's materials from now on.
void renew(const ZoneStages::Stage& stage, std::span<std::uint32_t> of_zone);

}  // namespace adit::fdm
