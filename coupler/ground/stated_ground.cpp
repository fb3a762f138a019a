#include "coupler/ground/stated_ground.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <limits>

namespace adit::coupler {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

scene::Area cut_to(scene::Area area, const scene::Box& box) {
  area.set_x_min(std::max(area.has_x_min() ? area.x_min() : -kInfinity, box.x_min()));
  area.set_x_max(std::min(area.has_x_max() ? area.x_max() : kInfinity, box.x_max()));
  area.set_y_min(std::max(area.has_y_min() ? area.y_min() : -kInfinity, box.y_min()));
  area.set_y_max(std::min(area.has_y_max() ? area.y_max() : kInfinity, box.y_max()));
  return area;
}

// The part of an area in a block; none where one area cannot say it.
std::optional<scene::Area> in_block(scene::Area area, const scene::GridBlock& block) {
  area.clear_group();
  if (block.has_rectangle()) return cut_to(std::move(area), block.rectangle());
  if (block.has_quadrilateral() && block.quadrilateral().arcs().empty() && !area.has_polygon()) {
    *area.mutable_polygon()->mutable_corners() = block.quadrilateral().corners();
    return area;
  }
  if (block.ring().has_inner_radius() && block.ring().has_outer_radius() && !area.has_annulus()) {
    *area.mutable_annulus()->mutable_centre() = block.ring().centre();
    area.mutable_annulus()->set_inner_radius(block.ring().inner_radius());
    area.mutable_annulus()->set_outer_radius(block.ring().outer_radius());
    return area;
  }
  return std::nullopt;
}

// Of a group of particles; a ring within ground selects its lining by itself.
std::optional<scene::Area> where_of(const scene::ParticleGroup& group, const scene::Particles& particles) {
  if (group.has_where()) return group.where();
  if (group.has_number()) return std::nullopt;
  scene::Area ring;
  *ring.mutable_annulus()->mutable_centre() = particles.ring().centre();
  ring.mutable_annulus()->set_inner_radius(particles.ring().inner_radius());
  ring.mutable_annulus()->set_outer_radius(particles.ring().outer_radius());
  return ring;
}

Ground::Stiffness stiffness_of(const scene::Material& material) {
  return {material.young_modulus(), material.young_modulus() / (2 * (1 + material.poisson_ratio()))};
}

Ground ground_of_particles(const std::string& path, const scene::Material& material,
                           const scene::Particles& particles, const scene::Bonds& bonds) {
  Ground ground{path, stiffness_of(material), material.density(), false};
  if (bonds.has_normal_stiffness() || bonds.has_parallel()) ground.stiffness.reset();
  if (particles.has_placed()) ground.density.reset();
  return ground;
}

}  // namespace

std::optional<std::vector<scene::Area>> by_place(const scene::Area& area, const scene::Continuum& continuum) {
  if (!area.has_group()) return std::vector{area};
  if (continuum.has_mesh()) return std::nullopt;
  std::vector<scene::Area> areas;
  for (const auto& block : continuum.blocks()) {
    if (block.name() != area.group()) continue;
    const auto part = in_block(area, block);
    if (!part) return std::nullopt;
    areas.push_back(*part);
  }
  return areas;
}

Ground ground_of_zones(const scene::Scene& part, const std::string& path, std::size_t number) {
  const auto& continuum = part.continuum();
  const auto ground = [](const std::string& its_path, const scene::Material& material) {
    return Ground{its_path, stiffness_of(material), material.density(), false};
  };
  if (number > 0)
    return ground(fmt::format("{}.materials[{}]", path, number - 1),
                  continuum.materials(static_cast<int>(number) - 1).material());
  return continuum.has_material() ? ground(path + ".material", continuum.material())
                                  : ground("material", part.material());
}

StatedGround::StatedGround(const scene::Scene& part, std::string path)
    : part_(part),
      path_(std::move(path)),
      stiffness_(part.has_continuum() ? part.continuum().scatter() : part.particles().scatter(),
                 scene::Scatter::STIFFNESS, path_ + ".scatter") {
  if (part.has_continuum())
    add_zones();
  else
    add_groups();
}

void StatedGround::add_zones() {
  own_ = ground_of_zones(part_, path_, 0);
  for (int k = 0; k < part_.continuum().materials_size(); ++k) {
    if (part_.continuum().materials(k).stage() > 0) continue;  // never where models meet
    const auto areas = by_place(part_.continuum().materials(k).where(), part_.continuum());
    known_ = known_ && areas;
    for (const auto& area : areas.value_or(std::vector<scene::Area>{}))
      add(area, ground_of_zones(part_, path_, static_cast<std::size_t>(k) + 1));
  }
}

void StatedGround::add_groups() {
  const auto& particles = part_.particles();
  const bool its_own = particles.has_material();
  const scene::Material& material = its_own ? particles.material() : part_.material();
  own_ =
      ground_of_particles(its_own ? path_ + ".material" : "material", material, particles, particles.bonds());
  own_.assumed = !its_own;
  for (int k = 0; k < particles.groups_size(); ++k) {
    const auto& group = particles.groups(k);
    const auto where = where_of(group, particles);
    known_ = known_ && where;
    if (!where) continue;
    Ground ground = ground_of_particles(
        group.has_material() ? fmt::format("{}.groups[{}].material", path_, k) : own_.path,
        group.has_material() ? group.material() : material, particles,
        group.has_bonds() ? group.bonds() : particles.bonds());
    ground.assumed = !group.has_material() && own_.assumed;
    add(*where, ground);
  }
}

void StatedGround::add(const scene::Area& where, const Ground& ground) {
  others_.emplace_back(protocol::Places(where, "where", 0), ground);
}

Ground StatedGround::at(double x, double y) const {
  for (auto other = others_.rbegin(); other != others_.rend(); ++other)
    if (other->first.hold(x, y)) return scattered(other->second, x, y);
  return scattered(own_, x, y);
}

Ground StatedGround::scattered(Ground ground, double x, double y) const {
  if (ground.stiffness) {
    const double factor = stiffness_.at(x, y);
    ground.stiffness->young *= factor;
    ground.stiffness->shear *= factor;
  }
  return ground;
}

}  // namespace adit::coupler
