#include "dem_server/model/reading/read_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "dem_server/model/initial_state/initial_state.hpp"
#include "dem_server/model/lattice.hpp"
#include "dem_server/model/placement/cells.hpp"
#include "dem_server/model/placement/groups.hpp"
#include "dem_server/model/placement/placement.hpp"
#include "dem_server/model/placement/scene_checks.hpp"
#include "dem_server/model/reading/bars.hpp"
#include "dem_server/model/reading/conditions.hpp"
#include "dem_server/model/reading/edges.hpp"
#include "dem_server/model/reading/join.hpp"
#include "dem_server/model/reading/scatter.hpp"
#include "dem_server/model/reading/springs.hpp"
#include "dem_server/model/reading/walls.hpp"
#include "dem_server/model/solid/bends_as_solid.hpp"
#include "dem_server/model/solid/facets_of_material.hpp"
#include "dem_server/model/solid/ring_faces.hpp"
#include "dem_server/model/solid/strength_of_material.hpp"
#include "dem_server/model/solid/wet_ground.hpp"
#include "dem_server/model/stages/read_stages.hpp"
#include "protocol/errors.hpp"
#include "protocol/participant/warnings.hpp"

namespace adit::dem {
namespace {

using protocol::UserError;

constexpr std::uint32_t kFewestNeighbours = 3;

// Discs, groups and bonds of the model, in all stages.
Joined set_particles(const scene::Scene& scene, const std::vector<Group>& groups, const Placement& placement,
                     Model& model) {
  model.discs = placement.discs;
  model.contact_bonds.clear();
  model.parallel_bonds.clear();
  model.smooth_joints.clear();
  model.facets.clear();
  model.facet_laws.clear();
  model.stages = read_stages(scene, placement);
  const Joined joined = join(scene.particles(), groups, placement, model.stages, model);
  stiffen_ring_faces(scene.particles(), groups, model);
  ParticleStage& first = model.stages.front();
  model.group = std::move(first.group);
  model.bonds = std::move(first.bonds);
  if (std::ranges::find(first.present, false) != first.present.end())
    model.present = std::move(first.present);
  model.stages.erase(model.stages.begin());
  return joined;
}

void remove_floaters(const Model& model, std::vector<std::string>& notes, Placement& placement) {
  std::vector<Pair> neighbours = pairs_within(model.discs, 0);
  for (const Bond& bond : model.bonds) neighbours.push_back({bond.first, bond.second});
  const auto by_both = [](const Pair& a, const Pair& b) {
    return std::pair(a.first, a.second) < std::pair(b.first, b.second);
  };
  std::ranges::sort(neighbours, by_both);
  neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
  const auto keep = without_floaters(model.discs.size(), neighbours, {}, kFewestNeighbours);
  const auto removed = std::ranges::count(keep, false);
  if (removed == static_cast<std::ptrdiff_t>(keep.size()))
    throw UserError(
        "particles.remove_floaters",
        "leaves no particles, because each hangs on fewer than three others in the end; leave it out");
  placement.keep_only(keep);
  if (removed > 0)
    notes.push_back(
        fmt::format("{} particles were taken away that were joined to fewer than three others", removed));
}

void set_masses(const std::vector<Group>& groups, const Placement& placement, Model& model) {
  for (const Group& group : groups) model.density.push_back(group.material.material.density());
  const auto& cells = placement.cells;
  const auto mass = [&](std::size_t i, std::uint32_t group) {
    return cells ? model.density[group] * cells->area[i]
                 : placement.mass(model.density[group], model.discs.radius[i]);
  };
  if (cells) {
    model.outlines = cells->outlines;
    for (const Group& group : groups)
      model.cell_elasticity.push_back(elasticity_of(group.material, group.plane));
    for (std::size_t i = 0; i < model.discs.size(); ++i)
      model.gyration_square.push_back(cells->polar_moment[i] / cells->area[i]);
  }
  for (ParticleStage& stage : model.stages)
    for (std::size_t i = 0; i < model.discs.size(); ++i) stage.mass.push_back(mass(i, stage.group[i]));
  for (std::size_t i = 0; i < model.discs.size(); ++i) {
    model.mass.push_back(mass(i, model.group[i]));
    model.weight.push_back(1);
    model.id.push_back(static_cast<std::uint32_t>(i));
  }
}

void set_contacts(const std::vector<Group>& groups, Model& model) {
  for (const Group& group : groups) model.group_names.push_back(group.name);
  std::vector<LinearContact> own;
  for (const Group& group : groups) own.push_back(group.contact());
  for (std::size_t i = 0; i < own.size(); ++i)
    for (std::size_t j = 0; j < own.size(); ++j)
      model.contacts.push_back(i == j ? own[i] : between(own[i], own[j]));
}

void set_damping(const scene::ParticleDamping& damping, Model& model) {
  model.local_damping = damping.local();
  model.viscous_damping = damping.viscous();
}

// In a packing of another kind the material's stiffness is only an estimate.
void note_estimates(const scene::Particles& particles, const std::vector<Group>& groups, Model& model) {
  if (particles.has_packing() || particles.has_cells()) return;
  for (const Group& group : groups) {
    if (!group.bonds || group.bonds->has_parallel() ||
        (group.bonds->has_normal_stiffness() && group.bonds->has_shear_stiffness()))
      continue;
    const auto [normal, shear] = group.stiffness();
    model.notes.push_back(fmt::format(
        "{}: {:.6g} N/m and {:.6g} N/m in shear are those of a hexagonal lattice of the material, in this "
        "packing only an estimate; `adit calibrate` finds better ones",
        group.bonds_path, normal, shear));
  }
}

void note_cut_tensions(const scene::Particles& particles, const std::vector<Group>& groups, Model& model) {
  const auto take_strength = [](const auto& kind) { return kind.bonds().strength_of_material(); };
  const bool between = particles.ring().joints().strength_of_material() ||
                       std::ranges::any_of(particles.between(), take_strength) ||
                       std::ranges::any_of(particles.joints(), take_strength);
  std::set<std::string> told;  // groups may share a material
  for (const Group& group : groups)
    if (between || (group.bonds && group.bonds->strength_of_material()))
      if (const auto note = note_on_cut_tension(group.material); note && told.insert(*note).second)
        model.notes.push_back(*note);
}

// Rows of a lattice over the thickness of a ring below which it is noticeably softer in bending.
constexpr double kRowsOfStiffRing = 8;

void note_thin_ring(const scene::Particles& particles, Model& model) {
  if (!particles.has_ring() || !particles.has_packing()) return;
  const auto& ring = particles.ring();
  const double rows =
      (ring.outer_radius() - ring.inner_radius()) / (std::numbers::sqrt3 * particles.packing().radius());
  if (rows < kRowsOfStiffRing)
    model.notes.push_back(fmt::format(
        "the ring is about {:.1f} rows of particles thick; one of fewer than {:g} rows is softer in "
        "bending than the solid, see the table of rings in docs/particles.md",
        rows, kRowsOfStiffRing));
}

void note_no_bonds(const scene::Particles& particles, Model& model) {
  if (!particles.has_contacts() || particles.has_bonds()) return;
  model.notes.push_back(
      "`contacts` is given and `bonds` is not: particles outside groups with bonds of their own only touch; "
      "write `bonds: {}` for bonds of the stiffness of the material");
}

// A model beside a continuum takes the scene's material, whose laws beyond elasticity are those of the zones.
void warn_of_laws_of_zones(const scene::Scene& scene, Model& model) {
  const scene::Particles& particles = scene.particles();
  const bool bonded = particles.has_bonds() || !particles.has_contacts();
  if (particles.has_material() || !bonded) return;
  const scene::Bonds& bonds = particles.bonds();
  std::vector<std::string> laws = laws_beyond_bonds(scene.material(), bonds, particles.has_cells());
  if (bonds.has_tensile_strength() || bonds.has_shear_strength()) std::erase(laws, "mohr_coulomb");
  if (laws.empty()) return;
  model.notes.push_back(protocol::as_warning(fmt::format(
      "`{}` of `material` does not act in the particles, which {}", fmt::join(laws, "`, `"),
      particles.has_cells()
          ? "break by `fracture` of particles.material, or stay elastic without"
          : "stay elastic; give particles.material, or set particles.bonds.strength_of_material for a "
            "strength by Mohr and Coulomb")));
}

// What a laboratory would find.
std::string laboratory_strengths(const FacetLaw& law) {
  const double sine = std::sin(std::atan(law.friction));
  return fmt::format(
      "a laboratory finds {:.4g} MPa in direct tension, {:.4g} MPa in unconfined compression, and {:.3g} of "
      "a "
      "confining pressure more",
      law.tensile_strength / 1e6, compressive_strength(law) / 1e6, (1 + sine) / (1 - sine));
}

// Of each group [m].
std::vector<double> largest_cells(const scene::CellPacking& cells, std::size_t groups, const Model& model) {
  const CellSize size = size_of(cells, "particles.cells");
  std::vector<double> largest(groups, 0.0);
  for (std::size_t i = 0; i < model.discs.size(); ++i)
    largest[model.group[i]] =
        std::max(largest[model.group[i]], size.at({model.discs.x[i], model.discs.y[i]}));
  return largest;
}

// Says what strengths cells have, and where they are too large to soften stably: a facet is as long a spring
// as its cells are apart, and must not store more than it dissipates.
void note_fracture(const scene::Particles& particles, const std::vector<Group>& groups, Model& model) {
  constexpr double kLargestShare = 0.25;
  if (!particles.has_cells()) return;
  const std::vector<double> sizes = largest_cells(particles.cells(), groups.size(), model);
  for (std::size_t k = 0; k < groups.size(); ++k) {
    const Group& group = groups[k];
    const scene::Material& material = group.material.material;
    if (!material.has_fracture() ||
        (&group != &groups.front() && &material == &groups.front().material.material))
      continue;
    const std::string path = group.material.path + ".fracture";
    const FacetLaw law = fracture_of(material.fracture(), path);
    model.notes.push_back(path + ": " + laboratory_strengths(law));
    const double length = elasticity_of(group.material, group.plane).stiffness * law.opening_energy /
                          (law.tensile_strength * law.tensile_strength);
    if (sizes[k] > kLargestShare * length)
      model.notes.push_back(protocol::as_warning(fmt::format(
          "particles.cells.size: is {:.4g} m, more than a quarter of the length E' G_f / f_t^2 = {:.3g} m of "
          "{}: facets snap, and cracks dissipate more than stated; give at most {:.3g} m",
          sizes[k], length, path, kLargestShare * length)));
  }
}

void start_under_stress(const scene::Scene& scene, Model& model) {
  if (scene.particles().random_packing().keep_stress())
    throw UserError(
        "particles.random_packing.keep_stress",
        "is set, but initial_stress says under which stress the particles start; give one of both");
  refuse_walls_that_bear(model);
  set_initial_state(stated_stress(scene), model);
}

}  // namespace

Model read_model(const scene::Scene& scene, const protocol::Progress& progress, std::size_t threads) {
  if (!scene.has_particles())
    throw UserError("particles", "is missing; a dem_server needs a scene with particles");
  const auto& particles = scene.particles();
  const auto groups = read_groups(scene);
  Model model;
  set_contacts(groups, model);
  set_damping(particles.damping(), model);
  Placement placement =
      place_discs(particles, model.contacts.front().normal_stiffness, {progress, threads}, model.notes);
  model.overlaps_free = placement.overlaps_free;
  Joined joined = set_particles(scene, groups, placement, model);
  if (particles.remove_floaters()) {
    remove_floaters(model, model.notes, placement);
    joined = set_particles(scene, groups, placement, model);
  }
  if (particles.has_packing() && groups.front().bonds != nullptr && model.bonds.empty())
    refuse_small_box(particles.packing(), model.discs.size());
  if (particles.has_packing()) sort_by_rows(model);
  if (particles.packing().bends_as_solid()) bend_as_solid(scene, model);
  model.extent = placement.extent;
  set_masses(groups, placement, model);
  scatter(particles, model);
  note_estimates(particles, groups, model);
  note_cut_tensions(particles, groups, model);
  note_thin_ring(particles, model);
  note_fracture(particles, groups, model);
  note_no_bonds(particles, model);
  warn_of_laws_of_zones(scene, model);
  for (const std::string& warning : join_warnings(particles, joined, placement.reach, model))
    model.notes.push_back(protocol::as_warning(warning));
  model.walls = read_walls(particles, groups.front());
  model.springs = read_springs(particles, model.discs);
  model.bars = read_bars(particles, groups, model);
  model.edges = read_edges(particles, groups, placement, model.group);
  model.loads = read_loads(particles, placement);
  model.motions = read_motions(particles, placement);
  model.foundations = read_foundations(particles, placement);
  require_in_water(scene, model);
  if (scene.has_initial_stress()) start_under_stress(scene, model);
  return model;
}

}  // namespace adit::dem
