// The general engine while its particles wait, condensed (condensation/substructure.hpp): they are put where
// they have followed their masters, from the state in which they began to wait, in one step by the code of
// every step.
#include <algorithm>
#include <cmath>
#include <utility>

#include "dem_server/condensation/tangent.hpp"
#include "dem_server/engines/general/general_engine.hpp"

namespace adit::dem {
namespace {

constexpr std::uint64_t kMostParts = 1024;  // of a state
constexpr double kLinear = 1e-3;            // of the forces, by which both signs of a motion may differ

// Of faces that only touch: of the friction, 1 where they are open.
double share_of_friction(double normal, double shear, double friction) {
  if (!(normal < 0)) return 1;
  return shear == 0 ? 0 : std::abs(shear) / (-friction * normal);
}

double share_of_friction(const WornFacet& touching, const FacetLaw& law) {
  double share = 0;
  for (const WornFacet::End& end : touching.ends)
    share = std::max(share, share_of_friction(end.normal, end.shear, law.friction));
  return share;
}

}  // namespace

double GeneralEngine::demand() const {
  double largest = 0;
  for_each_bond(
      [&largest](const ObservedPair& pair) { largest = std::max(largest, pair.demand.value_or(0)); });
  const FacetSet& set = solver_.facets().set();
  for (const std::uint32_t k : solver_.facets().touching()) {
    const WornFacet* worn = set.worn_facet(k);
    largest = std::max(largest, worn ? share_of_friction(*worn, set.laws[set.law[k]]) : 1);
  }
  for (const Joints::Joint& joint : solver_.joints().joints())
    largest = std::max(largest, share_of_friction(joint.normal, joint.springs.shear, joint.law.friction));
  return std::min(largest, 1.0);
}

std::variant<Condensed, std::string> GeneralEngine::condense(const protocol::SparseRows& ties,
                                                             std::size_t masters) {
  std::vector<std::uint32_t> tied;  // of each coupling point
  for (std::size_t k = 0; k < coupling().rows(); ++k) {
    if (coupling().matrix().columns(k).size() != 1) return "other models interpolate its coupling points";
    tied.push_back(coupling().points()[coupling().matrix().columns(k)[0]]);
  }
  const bool resumed = waiting_.has_value();
  state::Archive now;  // of a run that is resumed, where the particles are by then
  exchange_mechanics(now);
  const state::Parts present = now.take();
  if (!resumed) waiting_ = Waiting{.rest = present};
  return_to_rest();
  if (demand() >= 1) {
    waiting_.reset();
    return "something breaks, slides or is open at rest already";
  }
  const FacetSet& set = solver_.facets().set();
  std::vector<std::uint32_t> first(set.first.begin(), set.first.end()),
      second(set.second.begin(), set.second.end());
  for (const Joints::Joint& joint : solver_.joints().joints()) {
    first.push_back(joint.first);
    second.push_back(joint.second);
  }
  const Particles& p = particles();
  const Tangent tangent =
      tangent_of(p.radius, neighbourhood_of(p.size(), first, second), [this](std::span<const double> motion) {
        return_to_rest();
        displace(motion);
        return forces();
      });
  std::vector<double> masses;
  for (std::size_t i = 0; i < p.size(); ++i)
    masses.insert(masses.end(), {p.mass[i], p.mass[i], p.inertia[i]});
  std::variant<Condensed, std::string> answer;
  if (tangent.one_sidedness > kLinear) {
    answer = "its forces by a motion and by its reverse differ: something touches, slides or opens";
  } else {
    try {
      waiting_->substructure.emplace(tangent, std::move(masses), tied, ties, masters);
      answer = waiting_->substructure->condense();
    } catch (const Substructure::NotHeld&) {
      answer = "parts of it are not joined to the rest";
    }
  }
  state::Archive back(present);
  exchange_mechanics(back);
  if (std::holds_alternative<std::string>(answer)) waiting_.reset();
  return answer;
}

void GeneralEngine::follow(const MastersMotion& masters, double dt) {
  waiting_->motion = waiting_->substructure->recover(masters, dt);
  return_to_rest();
  set_velocities(waiting_->motion.velocities_before);
}

void GeneralEngine::arrive(const protocol::Step& step) {
  displace(waiting_->motion.displacements);
  require_finite(step);
  note_cracks();
  set_velocities(waiting_->motion.velocities);
}

void GeneralEngine::go_on() {
  waiting_.reset();
}

void GeneralEngine::exchange_mechanics(state::Archive& archive) {
  solver_.particles().exchange(archive);
  solver_.exchange(archive);
  loads_.exchange(archive);
  motions_.exchange(archive);
}

void GeneralEngine::return_to_rest() {
  state::Archive archive(waiting_->rest);
  exchange_mechanics(archive);
}

void GeneralEngine::displace(std::span<const double> motion) {
  set_velocities(motion);
  solver_.displace(loads_, motions_);
}

std::vector<double> GeneralEngine::forces() const {
  const Particles& p = particles();
  std::vector<double> forces;
  for (std::size_t i = 0; i < p.size(); ++i) forces.insert(forces.end(), {p.fx[i], p.fy[i], p.moment[i]});
  return forces;
}

void GeneralEngine::set_velocities(std::span<const double> velocities) {
  Particles& p = particles();
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.vx[i] = velocities[kFreedoms * i];
    p.vy[i] = velocities[kFreedoms * i + 1];
    p.spin[i] = velocities[kFreedoms * i + 2];
  }
}

// The state from which they follow; how they do follows from it.
void GeneralEngine::exchange_waiting(state::Archive& archive) {
  bool waits = waiting_.has_value();
  archive("waits", waits);
  if (!waits) return waiting_.reset();
  if (archive.reads()) waiting_ = Waiting{};
  std::uint64_t parts = waiting_->rest.size();
  archive("rest_parts", parts);
  state::require_of_model(parts <= kMostParts, "rest_parts");
  waiting_->rest.resize(parts);
  for (std::string& part : waiting_->rest) archive("rest", part);
}

}  // namespace adit::dem
