// Hexagonal lattices of contact-bonded discs as models, made without a scene.
#pragma once

#include <cstdint>
#include <numbers>

#include "dem_server/engines/lattice/assembly.hpp"
#include "dem_server/model/lattice.hpp"
#include "dem_server/model/model.hpp"
#include "dem_server/model/weigh.hpp"
#include "dem_server/packing/regular.hpp"

namespace adit::dem::test {

// What fits into the box: touching discs of one mass, all bonded by `law`, contacts without friction.
inline Model lattice_in(const geometry::BoundingBox& box, double radius, double mass = 1,
                        const ContactBond& law = {{1, 1}}) {
  Model model;
  HexagonalLattice lattice = pack_hexagonally(box, radius);
  model.discs = std::move(lattice.discs);
  model.extent = lattice.cells;
  model.mass.assign(model.discs.size(), mass);
  model.weight.assign(model.discs.size(), 1);
  model.group.assign(model.discs.size(), 0);
  for (std::uint32_t i = 0; i < model.discs.size(); ++i) model.id.push_back(i);
  model.group_names = {"particles"};
  model.density = {mass / (2 * std::numbers::sqrt3 * radius * radius)};
  model.contacts = {{law.stiffness.normal, law.stiffness.shear, 0}};
  model.contact_bonds = {law};
  for (const Pair& pair : pairs_within(model.discs, 1e-6 * radius))
    model.bonds.push_back({pair.first, pair.second, Bond::Law::kContactBond, 0});
  sort_by_rows(model);
  return model;
}

// Particles and bonds of the lattice engine, all of this mass.
inline Assembly assemble(Model model, double mass) {
  model.mass.assign(model.discs.size(), mass);
  return dem::assemble(model);
}
inline Assembly assemble(const Model& model, double mass, const SampledWeights& weights) {
  return assemble(weigh(model, weights), mass);
}

}  // namespace adit::dem::test
