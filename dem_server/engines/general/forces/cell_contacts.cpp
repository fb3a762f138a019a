#include "dem_server/engines/general/forces/cell_contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "dem_server/model/group_pairs.hpp"

namespace adit::dem {
namespace {

constexpr double kSkin = 0.1;       // of the mean side
constexpr double kFreeSide = 1e-3;  // of the perimeter: less is a facet that was left out

// Where a cell's nucleus is from another's.
PlaneVector between(std::uint32_t from, std::uint32_t to, const Particles& p) {
  return {(p.x[to] - p.x[from]) + (p.ux[to] - p.ux[from]), (p.y[to] - p.y[from]) + (p.uy[to] - p.uy[from])};
}

// A line across the way from one nucleus to the other has all corners of both on their sides.
bool are_apart(const std::vector<geometry::Point>& first, const std::vector<geometry::Point>& second,
               const PlaneVector& way) {
  double farthest = -std::numeric_limits<double>::infinity(), nearest = -farthest;
  for (const auto& corner : first) farthest = std::max(farthest, corner.x * way.x + corner.y * way.y);
  for (const auto& corner : second) nearest = std::min(nearest, corner.x * way.x + corner.y * way.y);
  return nearest >= farthest;
}

}  // namespace

CellContacts::CellContacts(const Model& model, const FacetSet& facets, const Particles& particles)
    : polygons_(model) {
  if (empty()) return;
  const auto& sides = polygons_.side;
  skin_ = kSkin * std::accumulate(sides.begin(), sides.end(), 0.0) / static_cast<double>(sides.size());
  take_stage(model);
  free_what_is_common(list(facets, particles), facets, particles);
}

void CellContacts::take_stage(const Model& model) {
  group_ = model.group;
  groups_ = model.groups();
  laws_ = model.contacts;
  slides_.assign(group_.size(), false);
  for (const Bond& bond : model.bonds)
    if (bond.law == Bond::Law::kSmoothJoint) slides_[bond.first] = slides_[bond.second] = true;
}

void CellContacts::expose(const FacetSet& facets, const Particles& p) {
  std::vector<double> covered(p.size(), 0.0);
  for (std::uint32_t k = 0; k < facets.size(); ++k) {
    const WornFacet* worn = facets.worn_facet(k);
    if (worn && (worn->cracked || worn->parted)) continue;
    covered[facets.first[k]] += facets.length[k];
    covered[facets.second[k]] += facets.length[k];
  }
  exposed_.clear();
  for (std::uint32_t i = 0; i < p.size(); ++i)
    if (p.is_there(i) && covered[i] < (1 - kFreeSide) * polygons_.perimeter[i]) exposed_.push_back(i);
}

std::vector<bool> CellContacts::list(const FacetSet& facets, const Particles& p) {
  expose(facets, p);
  Discs around;
  for (const std::uint32_t i : exposed_) {
    around.x.push_back(p.x[i] + p.ux[i]);
    around.y.push_back(p.y[i] + p.uy[i]);
    around.radius.push_back(polygons_.reach[i]);
  }
  std::vector<Contact> fresh;
  std::vector<bool> kept;
  auto old = contacts_.begin();
  std::uint32_t facet = 0;
  const auto ends = [](const auto& pair) { return std::tie(pair.first, pair.second); };
  for (const Pair& near : pairs_within(around, skin_)) {
    const Pair pair{exposed_[near.first], exposed_[near.second]};
    while (facet < facets.size() && std::tie(facets.first[facet], facets.second[facet]) < ends(pair)) ++facet;
    const bool meets =
        facet < facets.size() && std::tie(facets.first[facet], facets.second[facet]) == ends(pair);
    const WornFacet* worn = meets ? facets.worn_facet(facet) : nullptr;
    const bool parted = worn != nullptr && worn->parted;
    if (meets ? !parted : slides_[pair.first] && slides_[pair.second]) continue;
    while (old != contacts_.end() && ends(*old) < ends(pair)) ++old;
    kept.push_back(old != contacts_.end() && ends(*old) == ends(pair));
    fresh.push_back(kept.back() ? *old : Contact{.first = pair.first, .second = pair.second});
  }
  contacts_ = std::move(fresh);
  moved_ = 0;
  stale_ = false;
  ++lists_;
  return kept;
}

void CellContacts::free_what_is_common(const std::vector<bool>& kept, const FacetSet& facets,
                                       const Particles& particles) {
  for (std::size_t k = 0; k < contacts_.size(); ++k)
    if (!kept[k]) contacts_[k].free_area = overlap(contacts_[k], facets, particles).area;
}

bool CellContacts::update(double dt, double farthest_wall, const FacetSet& facets, const Particles& p) {
  if (empty()) return false;
  double fastest = 0;
  for (const std::uint32_t i : exposed_)
    fastest = std::max(
        fastest, std::sqrt(p.vx[i] * p.vx[i] + p.vy[i] * p.vy[i]) + polygons_.reach[i] * std::abs(p.spin[i]));
  moved_ += std::max(dt * fastest, farthest_wall);
  if (!stale_ && moved_ <= skin_ / 2) return false;
  free_what_is_common(list(facets, p), facets, p);
  return true;
}

void CellContacts::begin_stage(const Model& model, const std::vector<bool>& fresh, const FacetSet& facets,
                               const Particles& particles) {
  take_stage(model);
  std::erase_if(contacts_, [&](const Contact& c) { return fresh[c.first] || fresh[c.second]; });
  free_what_is_common(list(facets, particles), facets, particles);
}

const LinearContact& CellContacts::law(const Contact& contact) const {
  return laws_[group_pair_number(groups_, group_[contact.first], group_[contact.second])];
}

double CellContacts::weight(const Contact& contact, const Particles& p) const {
  return (p.weight[contact.first] + p.weight[contact.second]) / 2;
}

Overlap CellContacts::overlap(const Contact& contact, const FacetSet& facets, const Particles& p) const {
  thread_local OverlapWork work;
  thread_local std::vector<geometry::Point> first, second;
  const auto [i, j] = std::pair(contact.first, contact.second);
  const PlaneVector way = between(i, j, p);
  const double reach = polygons_.reach[i] + polygons_.reach[j];
  if (way.x * way.x + way.y * way.y >= reach * reach) return {};
  polygons_.place(i, {0, 0}, facets, first);
  polygons_.place(j, way, facets, second);
  if (are_apart(first, second, way)) return {};
  return overlap_of(first, second, work);
}

std::optional<Encounter> CellContacts::encounter(const Contact& contact, const FacetSet& facets,
                                                 const Particles& p) const {
  return encounter(contact, overlap(contact, facets, p), p);
}

std::optional<Encounter> CellContacts::encounter(const Contact& contact, const Overlap& common,
                                                 const Particles& p) const {
  if (!(common.area > contact.free_area)) return std::nullopt;
  const auto [i, j] = std::pair(contact.first, contact.second);
  const PlaneVector way = between(i, j, p), arm_1{common.x, common.y},
                    arm_2{common.x - way.x, common.y - way.y};
  const double vx = (p.vx[j] - p.spin[j] * arm_2.y) - (p.vx[i] - p.spin[i] * arm_1.y),
               vy = (p.vy[j] + p.spin[j] * arm_2.x) - (p.vy[i] + p.spin[i] * arm_1.x);
  const double share = common.chord / ((polygons_.side[i] + polygons_.side[j]) / 2);
  return Encounter{.nx = common.nx,
                   .ny = common.ny,
                   .gap = -(common.area - contact.free_area) / common.chord,
                   .arm_1 = arm_1,
                   .arm_2 = arm_2,
                   .stretch_rate = along(common.nx, common.ny, vx, vy),
                   .slip_rate = across(common.nx, common.ny, vx, vy),
                   .stiffening = share * share};
}

void CellContacts::add_forces(const protocol::Step& step, const FacetSet& facets, Particles& p) {
  const double dt = step.from_rest() ? 0 : step.dt;
  for (Contact& contact : contacts_) {
    const Overlap common = overlap(contact, facets, p);
    contact.free_area = std::min(contact.free_area, common.area);
    const std::optional<Encounter> meets = encounter(contact, common, p);
    if (!meets && contact.touch.stiffness == 0) continue;
    const auto [i, j] = std::pair(contact.first, contact.second);
    const Encounter now = meets.value_or(Encounter{});
    const LinearContact& of_time = law(contact);
    const double w = weight(contact, p);
    const auto [f, loss] = advance(
        step.relax ? without_dashpots(of_time) : of_time, now,
        {w * p.inverse_mass[i], w * p.inverse_inertia[i], w * p.inverse_mass[j], w * p.inverse_inertia[j]},
        dt, contact.touch);
    friction_ += w * loss.friction;
    dashpots_ += w * loss.dashpots;
    const PlaneVector force = vector_of(now.nx, now.ny, w * f.normal, w * f.shear);
    p.fx[i] += force.x;
    p.fy[i] += force.y;
    p.moment[i] += across(now.arm_1.x, now.arm_1.y, force.x, force.y);
    p.fx[j] -= force.x;
    p.fy[j] -= force.y;
    p.moment[j] -= across(now.arm_2.x, now.arm_2.y, force.x, force.y);
  }
}

double CellContacts::strain_energy(const Particles& p) const {
  double sum = 0;
  for (const Contact& contact : contacts_)
    sum += weight(contact, p) * adit::dem::strain_energy(law(contact), contact.touch);
  return sum;
}

void CellContacts::exchange(state::Archive& archive) {
  if (empty()) return;
  archive("exposed_cells", exposed_);
  archive("cell_contacts", contacts_);
  archive("cells_moved", moved_);
  archive("cells_stale", stale_);
  archive("cell_lists", lists_);
  archive("cell_contacts_friction", friction_);
  archive("cell_contacts_dashpots", dashpots_);
  for (const Contact& contact : contacts_)
    state::require_below(std::array{contact.first, contact.second}, group_.size(), "cell_contacts");
  state::require_below(exposed_, group_.size(), "exposed_cells");
}

}  // namespace adit::dem
