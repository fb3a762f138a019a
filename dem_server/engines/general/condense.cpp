// The general engine while its particles wait, condensed (condensation/substructure.hpp): they are put where
// they have followed their masters, from the state in which they began to wait, in one step by the code of
// every step.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "dem_server/condensation/tangent.hpp"
#include "dem_server/engines/general/general_engine.hpp"

namespace adit::dem {
namespace {

constexpr std::uint64_t kMostParts = 1024;  // of a state
constexpr double kLinear = 1e-3;            // of the forces, by which both signs of a motion may differ
constexpr double kMissed = 0.2;             // of a strength, by stresses that are not seen
constexpr double kMissedMotion = 0.15;      // of the energy; of motions from this share of a strength on:
constexpr double kMotion = 0.1;

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
  return waiting_ && misses_motion() ? 1 : std::min(most_used().share, 1.0);
}

// The particles' own oscillations, which they leave out while they wait, grow with the square of the
// frequency: in a region that is tied all round they are a sixth of this share of the motion, and all of it
// in one that is tied on one side. Of motion that is quicker than they are, stresses grow with the frequency.
bool GeneralEngine::misses_motion() const {
  if (!(waiting_->largest_kinetic > 0)) return false;
  const double missed = waiting_->largest_lag / waiting_->largest_kinetic,
               used = waiting_->fastest / waiting_->breaking_speed;
  return std::min(missed, std::sqrt(missed)) * used > kMissed || (missed > kMissedMotion && used > kMotion);
}

// v = f_t / sqrt(E' rho): the stress of a plane wave is sqrt(E' rho) v.
double GeneralEngine::breaking_speed() const {
  const FacetSet& set = solver_.facets().set();
  double mass = 0, area = 0, slowest = std::numeric_limits<double>::infinity();
  for (const double one : particles().mass) mass += one;
  for (std::size_t k = 0; k < set.size(); ++k) area += set.weight[k] * set.length[k] * set.half_distance[k];
  for (std::size_t k = 0; k < set.size(); ++k)
    if (const FacetLaw& law = set.laws[set.law[k]]; law.breaks())
      slowest = std::min(slowest, law.tensile_strength /
                                      std::sqrt(2 * set.half_distance[k] * set.stiffness[k] * mass / area));
  return slowest;
}

std::vector<std::string> GeneralEngine::warnings() const {
  if (!waves_too_short_) return {};
  return {
      "they waited no longer, because the waves are short beside the region, or it is tied on one side only: "
      "what oscillates in it by itself was missing until then; leave out `begin` where that matters"};
}

// What softened in statics is on its way to crack: it counts by how far it has come. A spring counts whole
// where it has left the straight piece of its law on which it was at rest, as a bolt does that becomes slack.
GeneralEngine::Used GeneralEngine::most_used() const {
  Used most;
  const Particles& p = particles();
  const auto uses = [&](double share, const char* what, std::uint32_t first, std::uint32_t second) {
    if (share > most.share)
      most = {share, what, (p.x[first] + p.x[second]) / 2, (p.y[first] + p.y[second]) / 2};
  };
  const FacetSet& set = solver_.facets().set();
  for (const std::uint32_t k : solver_.facets().joining()) {
    const WornFacet* worn = set.worn_facet(k);
    if (worn && waiting_ && std::ranges::binary_search(waiting_->softened, k))
      for (const WornFacet::End& end : worn->ends)
        uses(end.point.wear / kCracked, "the facet", set.first[k], set.second[k]);
    else
      see_facet(k, [&](const ObservedPair& pair) {
        uses(pair.demand.value_or(0), "the facet", pair.first, pair.second);
      });
  }
  for (const std::uint32_t k : solver_.facets().touching()) {
    const WornFacet* worn = set.worn_facet(k);
    uses(worn ? share_of_friction(*worn, set.laws[set.law[k]]) : 1, "the faces that touch", set.first[k],
         set.second[k]);
  }
  for (const CellContacts::Contact& contact : solver_.cells().contacts())
    uses(contact.touch.stiffness > 0 ? 1 : 0, "the cells that touch", contact.first, contact.second);
  for (const Joints::Joint& joint : solver_.joints().joints())
    uses(share_of_friction(joint.normal, joint.springs.shear, joint.law.friction), "the smooth joint",
         joint.first, joint.second);
  const SpringForces& springs = solver_.springs();
  for (std::size_t k = 0; k < springs.springs().size(); ++k) {
    const bool left =
        waiting_ && !waiting_->spring_pieces.empty() && springs.piece(k) != waiting_->spring_pieces[k];
    const Spring& spring = springs.springs()[k];
    uses(left ? 1 : springs.forces()[k] / spring.strength, "the spring", spring.first, spring.second);
  }
  return most;
}

std::variant<Condensed, std::string> GeneralEngine::condense(const protocol::SparseRows& ties,
                                                             std::size_t masters, double share) {
  std::vector<std::uint32_t> tied;  // of each coupling point
  for (std::size_t k = 0; k < coupling().rows(); ++k) {
    if (coupling().matrix().columns(k).size() != 1) return "other models interpolate its coupling points";
    tied.push_back(coupling().points()[coupling().matrix().columns(k)[0]]);
  }
  state::Archive now;
  exchange_mechanics(now);
  const state::Parts present = now.take();
  if (!waiting_) waiting_ = Waiting{.rest = present};
  put_mechanics(waiting_->rest);
  waiting_->softened.clear();
  for (const std::uint32_t k : solver_.facets().joining())
    if (solver_.facets().set().worn_facet(k)) waiting_->softened.push_back(k);
  waiting_->breaking_speed = breaking_speed();
  waiting_->spring_pieces.clear();
  for (std::size_t k = 0; k < solver_.springs().springs().size(); ++k)
    waiting_->spring_pieces.push_back(solver_.springs().piece(k));
  const Used used = most_used();
  const double strain_energy = solver_.strain_energy().sum();
  if (used.share >= share) {
    waiting_.reset();
    return used.share < 1
               ? fmt::format("{} at ({:.4g}, {:.4g}) m: {:.2g} of the strength is used at rest already",
                             used.what, used.x, used.y, used.share)
               : fmt::format("{} at ({:.4g}, {:.4g}) m: cracked, sliding or open at rest", used.what, used.x,
                             used.y);
  }
  const FacetSet& set = solver_.facets().set();
  std::vector<std::uint32_t> first(set.first.begin(), set.first.end()),
      second(set.second.begin(), set.second.end());
  for (const Joints::Joint& joint : solver_.joints().joints()) {
    first.push_back(joint.first);
    second.push_back(joint.second);
  }
  for (const Spring& spring : solver_.springs().springs()) {
    first.push_back(spring.first);
    second.push_back(spring.second);
  }
  const Particles& p = particles();
  std::vector<double> reached(kFreedoms * p.size(), 0.0);
  const auto forces_after = [&](std::span<const double> motion) {
    for (std::size_t k = 0; k < reached.size(); ++k) reached[k] = motion[k] - reached[k];
    displace(reached);
    reached.assign(motion.begin(), motion.end());
    return forces();
  };
  const Tangent tangent = tangent_of(p.radius, neighbourhood_of(p.size(), first, second), forces_after);
  std::vector<double> masses;
  for (std::size_t i = 0; i < p.size(); ++i)
    masses.insert(masses.end(), {p.mass[i], p.mass[i], p.inertia[i]});
  std::variant<Condensed, std::string> answer;
  if (tangent.one_sidedness > kLinear) {
    answer = "its forces by a motion and by its reverse differ: something touches, slides or opens";
  } else {
    try {
      waiting_->substructure.emplace(tangent, std::move(masses), tied, ties, masters);
      Condensed condensed = waiting_->substructure->condense();
      condensed.strain_energy = strain_energy;
      condensed.demand = used.share;
      answer = std::move(condensed);
    } catch (const Substructure::NotHeld&) {
      answer = "parts of it are held by nothing, or soften";
    }
  }
  put_mechanics(present);
  if (std::holds_alternative<std::string>(answer)) waiting_.reset();
  return answer;
}

void GeneralEngine::follow(const MastersMotion& masters, double dt) {
  waiting_->motion = waiting_->substructure->recover(masters, dt);
  const ParticlesMotion& motion = waiting_->motion;
  waiting_->largest_lag = std::max(waiting_->largest_lag, motion.lag_energy);
  waiting_->largest_kinetic = std::max(waiting_->largest_kinetic, motion.kinetic_energy);
  for (std::size_t i = 0; i < motion.velocities.size(); i += kFreedoms)
    waiting_->fastest =
        std::max(waiting_->fastest, std::hypot(motion.velocities[i], motion.velocities[i + 1]));
  set_velocities(waiting_->motion.velocities_before);
}

void GeneralEngine::arrive(const protocol::Step& step) {
  put_mechanics(waiting_->rest);  // so that it is the same wherever they were put in between
  displace(waiting_->motion.displacements);
  require_finite(step);
  note_cracks();
  set_velocities(waiting_->motion.velocities);
}

void GeneralEngine::go_on() {
  waves_too_short_ = waiting_ && misses_motion();
  waiting_.reset();
}

void GeneralEngine::exchange_mechanics(state::Archive& archive) {
  solver_.particles().exchange(archive);
  solver_.exchange(archive);
  loads_.exchange(archive);
  motions_.exchange(archive);
}

void GeneralEngine::put_mechanics(const state::Parts& state) {
  state::Archive archive(state);
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
  archive("waves_too_short", waves_too_short_);
  if (!waits) return waiting_.reset();
  if (archive.reads()) waiting_ = Waiting{};
  std::uint64_t parts = waiting_->rest.size();
  archive("rest_parts", parts);
  state::require_of_model(parts <= kMostParts, "rest_parts");
  waiting_->rest.resize(parts);
  for (std::string& part : waiting_->rest) archive("rest", part);
  archive("largest_lag", waiting_->largest_lag);
  archive("largest_kinetic", waiting_->largest_kinetic);
  archive("fastest", waiting_->fastest);
}

}  // namespace adit::dem
