#include "dem_server/engines/general/facets/facets.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dem_server/laws/pair_kinematics.hpp"
#include "dem_server/model/model.hpp"

namespace adit::dem {
namespace {

std::pair<std::uint32_t, std::uint32_t> range(std::size_t block, std::size_t count) {
  return {static_cast<std::uint32_t>(block * kFacetBlock),
          static_cast<std::uint32_t>(std::min<std::size_t>((block + 1) * kFacetBlock, count))};
}

// Where each number begins in an ascending list.
std::vector<std::uint32_t> starts_of(const std::vector<std::uint32_t>& numbers, std::size_t count) {
  std::vector<std::uint32_t> starts(count + 1, 0);
  for (const std::uint32_t i : numbers) ++starts[i + 1];
  for (std::size_t i = 0; i < count; ++i) starts[i + 1] += starts[i];
  return starts;
}

void list_by_second(FacetSet& set) {
  set.first_starts = starts_of(set.first, set.cells());
  set.second_starts = starts_of(set.second, set.cells());
  std::vector<std::uint32_t> next(set.second_starts.begin(), set.second_starts.end() - 1);
  set.as_second.resize(set.size());
  for (std::uint32_t k = 0; k < set.size(); ++k) set.as_second[next[set.second[k]]++] = k;
}

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
    const CellElasticity& elasticity = model.cell_elasticity[model.group[i]];
    const double area = model.cell_area(i);
    const double free = std::max(0.0, 2 - doubled[i] / area);
    set.bulk[i] =
        elasticity.lambda * model.weight[i] / (area * (1 + elasticity.lambda / elasticity.stiffness * free));
    set.any_bulk = set.any_bulk || set.bulk[i] != 0;
  }
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
    set.share_1.push_back(share_of(mean / model.cell_elasticity[model.group[bond.first]].stiffness));
    set.share_2.push_back(share_of(mean / model.cell_elasticity[model.group[bond.second]].stiffness));
  }
  if (set.size() == 0) return set;
  for (auto* column : {&set.start_n, &set.start_t, &set.start_turn}) column->assign(set.size(), 0.0);
  for (auto* column : {&set.turn, &set.sine, &set.versine}) column->assign(model.discs.size(), 0.0);
  set.worn.resize(set.blocks());
  list_by_second(set);
  set_bulk(model, set);
  set.find_plain();
  return set;
}

void FacetSet::find_plain() {
  const auto all = [](const std::vector<double>& values, double value) {
    return std::ranges::all_of(values, [value](double one) { return one == value; });
  };
  plain = all(weight, 1) && all(share_1, 1) && all(share_2, 1);
  for (const auto* column : {&start_n, &start_t, &start_turn, &rest_n, &rest_t})
    plain = plain && all(*column, 0);
}

void FacetSet::exchange(state::Archive& archive) {
  if (size() == 0) return;
  archive("facet_start_n", std::span(start_n));
  archive("facet_start_t", std::span(start_t));
  archive("facet_start_turn", std::span(start_turn));
  archive("cell_turn", std::span(turn));
  std::vector<WornFacet> all;
  for (const auto& block : worn) all.insert(all.end(), block.begin(), block.end());
  archive("worn_facets", all);
  if (!archive.reads()) return;
  find_plain();
  for (auto& block : worn) block.clear();
  for (const WornFacet& one : all) {
    state::require_below(std::array{one.facet}, size(), "worn_facets");
    worn[one.facet / kFacetBlock].push_back(one);
  }
}

Facets::Facets(const Model& model) : set_(facets_of(model)) {
  make_room();
}

void Facets::make_room() {
  results_.resize(set_.blocks());
  for (auto* column :
       {&motion_.jump_n, &motion_.jump_t, &motion_.turn, &motion_.nx, &motion_.ny, &motion_.cosine})
    column->assign(set_.size(), 0.0);
  motion_.spread.assign(2 * set_.size(), 0.0);
  motion_.actions.assign(4 * set_.size(), 0.0);
  motion_.pressure.assign(set_.cells(), 0.0);
  joining_.clear();
  touching_.clear();
  for (std::uint32_t k = 0; k < set_.size(); ++k)
    (set_.laws[set_.law[k]].joined ? joining_ : touching_).push_back(k);
}

void Facets::mark(std::vector<bool>& discs) const {
  for (const auto* ends : {&set_.first, &set_.second})
    for (const std::uint32_t i : *ends) discs[i] = true;
}

void Facets::add_forces(double dt, Particles& p, protocol::Team& team) {
  cracked_.clear();
  if (empty()) return;
  team.run(set_.cell_blocks(), [&](std::size_t block, std::size_t) {
    const auto [begin, end] = range(block, set_.cells());
    turn_cells(dt, begin, end, p.spin, set_);
  });
  team.run(set_.blocks(), [&](std::size_t block, std::size_t) {
    find_jumps(static_cast<std::uint32_t>(block), p.ux, p.uy, set_, motion_);
  });
  if (set_.any_bulk)
    team.run(set_.cell_blocks(), [&](std::size_t block, std::size_t) {
      const auto [begin, end] = range(block, set_.cells());
      find_pressures(begin, end, set_, motion_);
    });
  team.run(set_.blocks(), [&](std::size_t block, std::size_t) {
    find_actions(static_cast<std::uint32_t>(block), set_, motion_, results_[block]);
  });
  team.run(set_.cell_blocks(), [&](std::size_t block, std::size_t) {
    const auto [begin, end] = range(block, set_.cells());
    gather_actions(begin, end, set_, motion_, p.fx.data(), p.fy.data(), p.moment.data());
  });
  for (const FacetResult& result : results_) {
    fracture_ += result.fracture;
    cracked_.insert(cracked_.end(), result.cracked.begin(), result.cracked.end());
  }
}

void Facets::find_linear_forces(Particles& p, protocol::Team& team) {
  std::ranges::fill(set_.turn, 0.0);
  add_forces(1, p, team);
}

std::vector<Pair> Facets::parted_now() const {
  std::vector<Pair> pairs;
  for (const FacetResult& result : results_)
    for (const std::uint32_t k : result.parted) pairs.push_back({set_.first[k], set_.second[k]});
  return pairs;
}

std::vector<Pair> Facets::parted() const {
  std::vector<Pair> pairs;
  for (const auto& block : set_.worn)
    for (const WornFacet& worn : block)
      if (worn.parted) pairs.push_back({set_.first[worn.facet], set_.second[worn.facet]});
  return pairs;
}

Crack Facets::crack(std::uint32_t k, const Particles& p) const {
  const std::uint32_t i = set_.first[k], j = set_.second[k];
  const double nx = set_.nx[k], ny = set_.ny[k], h = set_.half_distance[k];
  const PlaneVector middle = vector_of(nx, ny, h, 2 * h * set_.skew[k]);
  return {state(k, p).state,         p.x[i] + middle.x,          p.y[i] + middle.y,         set_.length[k],
          crack_orientation(nx, ny), std::min(p.id[i], p.id[j]), std::max(p.id[i], p.id[j])};
}

Strongest Facets::strongest(const Particles& p) const {
  if (empty()) return {};
  double largest = 0;
  std::size_t block = 0;
  for (std::size_t b = 0; b < results_.size(); ++b)
    if (!(results_[b].max_normal <= largest)) {
      largest = results_[b].max_normal;
      block = b;
    }
  const auto [begin, end] = range(block, set_.size());
  std::uint32_t strongest = begin;
  for (std::uint32_t k = begin; k < end; ++k)
    if (!(std::abs(normal_force(k, set_, motion_)) <= std::abs(normal_force(strongest, set_, motion_))))
      strongest = k;
  const std::uint32_t i = set_.first[strongest], j = set_.second[strongest];
  return {std::abs(normal_force(strongest, set_, motion_)), (p.x[i] + p.x[j]) / 2, (p.y[i] + p.y[j]) / 2};
}

FacetState Facets::state(std::uint32_t k, const Particles& p) const {
  const double *action = &motion_.actions[4 * std::size_t{k}], w = set_.weight[k];
  const double nx = motion_.nx[k], ny = motion_.ny[k];
  const double fx = action[0] / w, fy = action[1] / w;
  // The first cell's place of the middle, and half the jump.
  const std::uint32_t i = set_.first[k];
  const double h = set_.half_distance[k];
  const PlaneVector at_rest = vector_of(set_.nx[k], set_.ny[k], h, 2 * h * set_.skew[k]),
                    turned = vector_of(1 - set_.versine[i], set_.sine[i], at_rest.x, at_rest.y),
                    jump = vector_of(nx, ny, motion_.jump_n[k] + set_.start_n[k],
                                     motion_.jump_t[k] + set_.start_t[k]);
  const double arm_x = turned.x + 0.5 * jump.x, arm_y = turned.y + 0.5 * jump.y;
  FacetState state{nx,
                   ny,
                   p.x[i] + p.ux[i] + arm_x,
                   p.y[i] + p.uy[i] + arm_y,
                   along(nx, ny, fx, fy),
                   across(nx, ny, fx, fy),
                   action[2] / w - (arm_x * fy - arm_y * fx),
                   0,
                   0,
                   BondState::kIntact};
  const auto& worn = set_.worn[k / kFacetBlock];
  const auto found = std::ranges::lower_bound(worn, k, {}, &WornFacet::facet);
  if (found == worn.end() || found->facet != k) return state;
  for (const WornFacet::End& end : found->ends) {
    state.opening = std::max(state.opening, end.lost_n);
    if (std::abs(end.lost_t) > std::abs(state.slip)) state.slip = end.lost_t;
  }
  if (found->cracked) state.state = found->opened ? BondState::kTensileCrack : BondState::kShearCrack;
  return state;
}

double Facets::internal_force() const {
  double sum = 0;
  for (std::uint32_t k = 0; k < size(); ++k)
    sum += std::hypot(motion_.actions[4 * std::size_t{k}], motion_.actions[4 * std::size_t{k} + 1]);
  return sum;
}

double Facets::strain_energy() const {
  double sum = 0;
  const auto add = [&](std::uint32_t k, double n, double t, double deviation, double of_points) {
    const double stiffness = set_.stiffness[k], rest_n = set_.rest_n[k], rest_t = set_.rest_t[k];
    sum += set_.weight[k] * set_.length[k] *
           (0.5 * stiffness * (n * n + t * t + deviation * deviation) + rest_n * n + rest_t * t +
            0.5 * (rest_n * rest_n + rest_t * rest_t) / stiffness + of_points);
  };
  for (std::size_t block = 0; block < set_.blocks(); ++block) {
    auto worn = set_.worn[block].begin();
    const auto [begin, end] = range(block, set_.size());
    for (std::uint32_t k = begin; k < end; ++k) {
      if (worn == set_.worn[block].end() || worn->facet != k) {
        add(k, motion_.jump_n[k], motion_.jump_t[k], motion_.turn[k] * kFacetPoint * set_.length[k], 0);
        continue;
      }
      // Of what an open point has lost, half is stored: it unloads towards its origin.
      const auto& [left, right] = worn->ends;
      const double of_points =
          0.25 * (std::max(left.normal, 0.0) * left.lost_n + std::max(right.normal, 0.0) * right.lost_n);
      const double half = 0.5 / set_.stiffness[k], dn = half * (left.normal - right.normal),
                   dt = half * (left.shear - right.shear);
      const double n = half * (left.normal + right.normal) - worn->added_n / set_.stiffness[k],
                   t = half * (left.shear + right.shear) - worn->added_t / set_.stiffness[k];
      add(k, n, t, std::hypot(dn, dt), of_points);
      ++worn;
    }
  }
  for (std::uint32_t i = 0; i < set_.cells(); ++i)
    if (set_.bulk[i] > 0) sum += 0.5 * motion_.pressure[i] * motion_.pressure[i] / set_.bulk[i];
  return sum;
}

void Facets::find_motion(const Particles& p) {
  for (std::uint32_t block = 0; block < set_.blocks(); ++block) find_jumps(block, p.ux, p.uy, set_, motion_);
}

void Facets::begin_stage(const Model& model, const std::vector<bool>& fresh, const Particles& p) {
  FacetSet before = std::exchange(set_, facets_of(model));
  make_room();
  if (empty()) return;
  if (before.size() > 0) {
    set_.turn = before.turn;
    set_.sine = before.sine;
    set_.versine = before.versine;
  }
  find_motion(p);
  const auto ends = [](const FacetSet& set, std::uint32_t k) {
    return std::pair(set.first[k], set.second[k]);
  };
  std::uint32_t old = 0;
  for (std::uint32_t k = 0; k < set_.size(); ++k) {
    while (old < before.size() && ends(before, old) < ends(set_, k)) ++old;
    const bool same = old < before.size() && ends(before, old) == ends(set_, k) &&
                      before.laws[before.law[old]] == set_.laws[set_.law[k]] &&
                      before.stiffness[old] == set_.stiffness[k] && !fresh[set_.first[k]] &&
                      !fresh[set_.second[k]];
    if (!same) {
      set_.start_n[k] = motion_.jump_n[k];
      set_.start_t[k] = motion_.jump_t[k];
      set_.start_turn[k] = motion_.turn[k];
      set_.rest_n[k] = set_.rest_t[k] = 0;
      continue;
    }
    set_.start_n[k] = before.start_n[old];
    set_.start_t[k] = before.start_t[old];
    set_.start_turn[k] = before.start_turn[old];
    set_.rest_n[k] = before.rest_n[old];
    set_.rest_t[k] = before.rest_t[old];
    const auto& worn = before.worn[old / kFacetBlock];
    const auto found = std::ranges::lower_bound(worn, old, {}, &WornFacet::facet);
    if (found == worn.end() || found->facet != old) continue;
    set_.worn[k / kFacetBlock].push_back(*found);
    set_.worn[k / kFacetBlock].back().facet = k;
  }
  set_.find_plain();
}

void Facets::exchange(state::Archive& archive) {
  set_.exchange(archive);
  if (empty()) return;
  archive("facet_jump_n", std::span(motion_.jump_n));
  archive("facet_jump_t", std::span(motion_.jump_t));
  archive("facet_relative_turn", std::span(motion_.turn));
  archive("facet_nx", std::span(motion_.nx));
  archive("facet_ny", std::span(motion_.ny));
  archive("facet_actions", std::span(motion_.actions));
  archive("cell_pressure", std::span(motion_.pressure));
  archive("fracture", fracture_);
  if (!archive.reads()) return;
  const std::vector<double> still(set_.cells(), 0.0);
  for (std::size_t block = 0; block < set_.cell_blocks(); ++block) {
    const auto [begin, end] = range(block, set_.cells());
    turn_cells(0, begin, end, still, set_);
  }
}

}  // namespace adit::dem
