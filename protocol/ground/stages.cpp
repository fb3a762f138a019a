#include "protocol/ground/stages.hpp"

#include <fmt/format.h>

#include "protocol/errors.hpp"

namespace adit::protocol {

void require_statics(const scene::Scene& scene, std::uint32_t stage, const std::string& path) {
  if (stage == 0 || scene.has_statics()) return;
  throw UserError(path + ".stage",
                  fmt::format("is {}, but stages begin when the ground is at rest, and the scene has no "
                              "statics; give `statics: {{unbalanced_ratio: 1e-5}}`, or stage 0",
                              stage));
}

CountedFrom counted_from(const scene::Statics& statics) {
  return {statics.has_count_from_stage() || statics.keep_displacements(),
          statics.has_count_from_stage() ? statics.count_from_stage() : 1};
}

}  // namespace adit::protocol
