#include "dem_server/engines/general/facets/facets.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "dem_server/engines/general/facets/worn_step.hpp"
#include "dem_server/laws/pair_kinematics.hpp"
#include "dem_server/model/model.hpp"

namespace adit::dem {
namespace {

// Rounding leaves cells of one stiffness alike.
double share_of(double ratio) {
  return std::abs(ratio - 1) < 1e-12 ? 1 : ratio;
}

// lambda w / (V (1 + beta)) of each cell.
void set_bulk(const Model& model, FacetSet& set) {
  set.bulk.assign(set.cells(), 0.0);
  std::vector<double> doubled(set.cells(), 0.0);  // sum of A h / 2
  for (std::uint32_t k = 0; k < set.size(); ++k)
    for (const std::uint32_t i : {set.first[k], set.second[k]})
      doubled[i] += set.length[k] * set.half_distance[k];
  for (std::uint32_t i = 0; i < set.cells(); ++i) {
    if (doubled[i] == 0 || !model.is_there(i)) continue;
    const CellElasticity elasticity = model.elasticity_of(i);
    const double area = model.cell_area(i);
    const double free = std::max(0.0, 2 - doubled[i] / area);
    set.bulk[i] =
        elasticity.lambda * model.weight[i] / (area * (1 + elasticity.lambda / elasticity.stiffness * free));
  }
}

BondState state_of(const WornFacet* worn) {
  if (worn == nullptr || !worn->cracked) return BondState::kIntact;
  return worn->opened ? BondState::kTensileCrack : BondState::kShearCrack;
}

}  // namespace

FacetSet facets_of(const Model& model) {
  FacetSet set;
  set.laws = model.facet_laws;
  for (const Bond& bond : model.bonds) {
    if (bond.law != Bond::Law::kFacet) continue;
    const FacetBond& facet = model.facets[bond.number];
    set.first.push_back(bond.first);
    set.second.push_back(bond.second);
    set.nx.push_back(facet.nx);
    set.ny.push_back(facet.ny);
    set.half_distance.push_back(facet.half_distance);
    set.skew.push_back(facet.skew);
    set.length.push_back(facet.length);
    set.stiffness.push_back(facet.stiffness);
    set.weight.push_back(bond.weight);
    set.law.push_back(facet.law);
    set.rest_n.push_back(bond.at_rest.normal / facet.length);
    set.rest_t.push_back(bond.at_rest.shear / facet.length);
    const double mean = facet.stiffness * 2 * facet.half_distance;
    set.share_1.push_back(share_of(mean / model.elasticity_of(bond.first).stiffness));
    set.share_2.push_back(share_of(mean / model.elasticity_of(bond.second).stiffness));
  }
  if (set.size() == 0 && model.outlines.empty()) return set;
  for (auto* column : {&set.start_n, &set.start_t, &set.start_turn}) column->assign(set.size(), 0.0);
  for (auto* column : {&set.turn, &set.sine, &set.versine, &set.pressure})
    column->assign(model.discs.size(), 0.0);
  set.worn.resize(blocks_of(set.cells()));
  set.worn_place.assign(set.size(), 0);
  set_bulk(model, set);
  return set;
}

std::uint32_t FacetSet::block_of(std::uint32_t facet) const {
  return first[facet] / kBlock;
}

void FacetSet::set_worn(std::uint32_t block, std::vector<WornFacet>&& facets) {
  const bool others = facets.size() != worn[block].size();  // none is mended
  worn[block].swap(facets);
  if (!others) return;
  any_worn = true;
  for (std::uint32_t place = 0; place < worn[block].size(); ++place)
    worn_place[worn[block][place].facet] = place + 1;
}

void FacetSet::exchange(state::Archive& archive) {
  if (cells() == 0) return;
  archive("facet_start_n", std::span(start_n));
  archive("facet_start_t", std::span(start_t));
  archive("facet_start_turn", std::span(start_turn));
  archive("cell_turn", std::span(turn));
  archive("cell_pressure", std::span(pressure));
  std::vector<WornFacet> all;
  for (const auto& block : worn) all.insert(all.end(), block.begin(), block.end());
  archive("worn_facets", all);
  if (!archive.reads()) return;
  std::ranges::fill(worn_place, 0u);
  for (auto& block : worn) block.clear();
  any_worn = false;
  std::vector<std::vector<WornFacet>> blocks(worn.size());
  for (const WornFacet& one : all) {
    state::require_below(std::array{one.facet}, size(), "worn_facets");
    blocks[block_of(one.facet)].push_back(one);
  }
  for (std::uint32_t block = 0; block < blocks.size(); ++block) set_worn(block, std::move(blocks[block]));
}

Facets::Facets(const Model& model, std::size_t threads) : set_(facets_of(model)), work_(threads) {
  divide();
}

void Facets::divide() {
  patches_ = patches_of(set_);
  results_.assign(patches_.size(), {});
  joining_.clear();
  touching_.clear();
  for (std::uint32_t k = 0; k < set_.size(); ++k)
    (set_.laws[set_.law[k]].joined ? joining_ : touching_).push_back(k);
}

void Facets::turn(double dt, const protocol::IndexRange& cells, std::span<const double> spin) {
  if (set_.cells() > 0) turn_cells(dt, cells.begin, cells.end, spin, set_);
}

void Facets::add_forces(std::uint32_t block, std::size_t thread, bool relax, const Particles& p,
                        BlockDiscs& discs) {
  if (!empty())
    add_facet_forces(patches_[block], p.ux, p.uy, relax, set_, work_[thread], discs, results_[block]);
}

void Facets::end_step() {
  cracked_.clear();
  internal_force_ = 0;
  for (std::uint32_t block = 0; block < results_.size(); ++block) {
    FacetResult& result = results_[block];
    set_.set_worn(block, std::move(result.worn));
    fracture_ += result.fracture;
    internal_force_ += result.internal_force;
    cracked_.insert(cracked_.end(), result.cracked.begin(), result.cracked.end());
  }
}

void Facets::find_forces(double dt, Particles& p, protocol::Team& team) {
  std::vector<BlockDiscs> discs(work_.size());
  team.run(patches_.size(), [&](std::size_t block, std::size_t) {
    const FacetPatch& patch = patches_[block];
    turn(dt, {patch.begin, patch.begin + patch.cells}, p.spin);
  });
  team.run(patches_.size(), [&](std::size_t b, std::size_t thread) {
    const auto block = static_cast<std::uint32_t>(b);
    discs[thread].clear();
    add_forces(block, thread, false, p, discs[thread]);
    discs[thread].add(block, p);
  });
  end_step();
}

void Facets::find_linear_forces(Particles& p, protocol::Team& team) {
  std::ranges::fill(set_.turn, 0.0);
  find_forces(1, p, team);
}

bool Facets::any_parted() const {
  return std::ranges::any_of(results_, [](const FacetResult& result) { return result.any_parted; });
}

Crack Facets::crack(std::uint32_t k, const Particles& p) const {
  const std::uint32_t i = set_.first[k], j = set_.second[k];
  const double nx = set_.nx[k], ny = set_.ny[k], h = set_.half_distance[k];
  const PlaneVector middle = vector_of(nx, ny, h, 2 * h * set_.skew[k]);
  return {state_of(set_.worn_facet(k)), p.x[i] + middle.x,          p.y[i] + middle.y,         set_.length[k],
          crack_orientation(nx, ny),    std::min(p.id[i], p.id[j]), std::max(p.id[i], p.id[j])};
}

Strongest Facets::strongest(const Particles& p) const {
  if (empty()) return {};
  const FacetResult& most = *std::ranges::max_element(results_, {}, [](const FacetResult& result) {
    return std::bit_cast<std::int64_t>(result.max_normal);  // what is not finite is the largest
  });
  const std::uint32_t i = set_.first[most.strongest], j = set_.second[most.strongest];
  return {most.max_normal, (p.x[i] + p.x[j]) / 2, (p.y[i] + p.y[j]) / 2};
}

FacetAction Facets::action(std::uint32_t k, const Particles& p) const {
  return action_of(k, motion_of(k, p.ux, p.uy, set_), set_);
}

FacetState Facets::state(std::uint32_t k, const Particles& p) const {
  const WornFacet* worn = set_.worn_facet(k);
  const FacetMotion motion = motion_of(k, p.ux, p.uy, set_);
  const FacetAction action = action_of(k, motion, set_);
  const double nx = motion.nx, ny = motion.ny, w = set_.weight[k];
  const double fx = action.x / w, fy = action.y / w;
  // The first cell's place of the middle, and half the jump.
  const std::uint32_t i = set_.first[k];
  const double h = set_.half_distance[k];
  const PlaneVector at_rest = vector_of(set_.nx[k], set_.ny[k], h, 2 * h * set_.skew[k]),
                    turned = vector_of(1 - set_.versine[i], set_.sine[i], at_rest.x, at_rest.y),
                    jump =
                        vector_of(nx, ny, motion.jump_n + set_.start_n[k], motion.jump_t + set_.start_t[k]);
  const double arm_x = turned.x + 0.5 * jump.x, arm_y = turned.y + 0.5 * jump.y;
  FacetState state{nx,
                   ny,
                   p.x[i] + p.ux[i] + arm_x,
                   p.y[i] + p.uy[i] + arm_y,
                   along(nx, ny, fx, fy),
                   across(nx, ny, fx, fy),
                   action.moment_1 / w - (arm_x * fy - arm_y * fx),
                   0,
                   0,
                   state_of(worn)};
  if (worn == nullptr) return state;
  for (const WornFacet::End& end : worn->ends) {
    state.opening = std::max(state.opening, end.lost_n);
    if (std::abs(end.lost_t) > std::abs(state.slip)) state.slip = end.lost_t;
  }
  return state;
}

double Facets::strain_energy(const Particles& p) const {
  double sum = 0;
  const auto add = [&](std::uint32_t k, double n, double t, double deviation, double of_points) {
    const double stiffness = set_.stiffness[k], rest_n = set_.rest_n[k], rest_t = set_.rest_t[k];
    sum += set_.weight[k] * set_.length[k] *
           (0.5 * stiffness * (n * n + t * t + deviation * deviation) + rest_n * n + rest_t * t +
            0.5 * (rest_n * rest_n + rest_t * rest_t) / stiffness + of_points);
  };
  for (std::uint32_t k = 0; k < size(); ++k) {
    const WornFacet* worn = set_.worn_facet(k);
    if (!worn) {
      const FacetMotion motion = motion_of(k, p.ux, p.uy, set_);
      add(k, motion.jump_n, motion.jump_t, motion.turn * kFacetPoint * set_.length[k], 0);
      continue;
    }
    const auto& [left, right] = worn->ends;
    const double of_points = 0.25 * (left.kept() + right.kept());
    const double half = 0.5 / set_.stiffness[k], dn = half * (left.normal - right.normal),
                 dt = half * (left.shear - right.shear);
    const double n = half * (left.normal + right.normal) - worn->added_n / set_.stiffness[k],
                 t = half * (left.shear + right.shear) - worn->added_t / set_.stiffness[k];
    add(k, n, t, std::hypot(dn, dt), of_points);
    const WornStep step(k, motion_of(k, p.ux, p.uy, set_), set_);
    const double difference = step.difference(set_.pressure[set_.first[k]], set_.pressure[set_.second[k]]);
    sum += set_.weight[k] * step.uneven_energy(difference * difference, worn->released());
  }
  for (std::uint32_t i = 0; i < set_.cells(); ++i)
    if (set_.bulk[i] > 0) sum += 0.5 * set_.pressure[i] * set_.pressure[i] / set_.bulk[i];
  return sum;
}

void Facets::begin_stage(const Model& model, const std::vector<bool>& fresh, const Particles& p) {
  FacetSet before = std::exchange(set_, facets_of(model));
  if (before.cells() > 0) {
    set_.turn = before.turn;
    set_.sine = before.sine;
    set_.versine = before.versine;
    set_.pressure = before.pressure;
  }
  const auto ends = [](const FacetSet& set, std::uint32_t k) {
    return std::pair(set.first[k], set.second[k]);
  };
  std::vector<std::vector<WornFacet>> worn(set_.worn.size());
  std::uint32_t old = 0;
  for (std::uint32_t k = 0; k < set_.size(); ++k) {
    while (old < before.size() && ends(before, old) < ends(set_, k)) ++old;
    const bool same = old < before.size() && ends(before, old) == ends(set_, k) &&
                      before.laws[before.law[old]] == set_.laws[set_.law[k]] &&
                      before.stiffness[old] == set_.stiffness[k] && !fresh[set_.first[k]] &&
                      !fresh[set_.second[k]];
    if (!same) {
      const FacetMotion motion = motion_of(k, p.ux, p.uy, set_);
      set_.start_n[k] = motion.jump_n;
      set_.start_t[k] = motion.jump_t;
      set_.start_turn[k] = motion.turn;
      set_.rest_n[k] = set_.rest_t[k] = 0;
      continue;
    }
    set_.start_n[k] = before.start_n[old];
    set_.start_t[k] = before.start_t[old];
    set_.start_turn[k] = before.start_turn[old];
    set_.rest_n[k] = before.rest_n[old];
    set_.rest_t[k] = before.rest_t[old];
    const WornFacet* of_before = before.worn_facet(old);
    if (!of_before) continue;
    std::vector<WornFacet>& of_block = worn[set_.block_of(k)];
    of_block.push_back(*of_before);
    of_block.back().facet = k;
  }
  for (std::uint32_t block = 0; block < worn.size(); ++block) set_.set_worn(block, std::move(worn[block]));
  divide();
}

void Facets::exchange(state::Archive& archive) {
  set_.exchange(archive);
  if (set_.cells() == 0) return;
  archive("fracture", fracture_);
  archive("internal_force_of_facets", internal_force_);
  if (!archive.reads()) return;
  const std::vector<double> still(set_.cells(), 0.0);
  turn_cells(0, 0, static_cast<std::uint32_t>(set_.cells()), still, set_);
  divide();
}

}  // namespace adit::dem
