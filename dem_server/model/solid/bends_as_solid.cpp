#include "dem_server/model/solid/bends_as_solid.hpp"

#include <fmt/format.h>

#include "dem_server/model/solid/thin_strip.hpp"
#include "protocol/errors.hpp"

namespace adit::dem {
namespace {

[[noreturn]] void refuse(const std::string& why) {
  throw protocol::UserError("particles.packing.bends_as_solid",
                            "is set, but " + why +
                                "; it is possible for a full rectangle of at least three rows, all joined by "
                                "contact bonds of one law; change that, or leave it out");
}

void refuse_other_features(const scene::Scene& scene) {
  const auto& particles = scene.particles();
  if (particles.has_within()) refuse("`within` cuts the packing");
  if (particles.has_ring()) refuse("`ring` cuts the packing");
  if (particles.remove_floaters()) refuse("`remove_floaters` may take particles out of the rows");
  if (particles.groups_size() > 0) refuse("`groups` give bonds of several laws");
  if (particles.joints_size() > 0) refuse("`joints` cut the rows");
  if (particles.excavations_size() > 0) refuse("`excavations` cut the rows");
  if (particles.bonds().has_parallel()) refuse("parallel bonds join the particles");
  if (!particles.has_bonds() && particles.has_contacts()) refuse("no bonds join the particles");
  if (scene.has_initial_stress()) refuse("the model starts under an initial stress");
}

}  // namespace

void bend_as_solid(const scene::Scene& scene, Model& model) {
  refuse_other_features(scene);
  const std::uint32_t rows = rows_of(model.discs);
  if (rows < kFewestRows) refuse(fmt::format("the packing has {} row(s)", rows));
  const BondStiffness& stiffness = model.contact_bonds.front().stiffness;
  const auto [outermost, second] = strip_factors(rows, stiffness);
  if (!(second.stiffness > 0))
    refuse(fmt::format(
        "with three rows the bonds' shear stiffness must be less than 3 times the normal one, and "
        "is {:.4g} times",
        stiffness.shear / stiffness.normal));
  stiffen_outer_rows(model);
  model.notes.push_back(
      fmt::format("the strip of {} rows bends and stretches as the solid: bonds along its outermost rows "
                  "have {:.4f} times "
                  "the normal stiffness and {:.4f} times the tensile strength of the others, along the "
                  "second rows {:.4f} "
                  "times both",
                  rows, outermost.stiffness, outermost.strength, second.stiffness));
}

}  // namespace adit::dem
