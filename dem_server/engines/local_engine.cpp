#include "dem_server/engines/local_engine.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "dem_server/engines/figures.hpp"
#include "dem_server/lining/read_lining.hpp"
#include "dem_server/observe/branches.hpp"
#include "dem_server/observe/cell_pieces.hpp"
#include "dem_server/observe/fragments.hpp"
#include "dem_server/observe/snapshot.hpp"

namespace adit::dem {

LocalEngine::LocalEngine(const Model& model)
    : group_names_(model.group_names),
      density_(model.density),
      edges_(model.edges),
      held_x_(!model.walls.empty()),
      held_y_(held_x_) {
  take_stage(model);
  for (const PrescribedMotion& motion : model.motions) {
    held_x_ = held_x_ || motion.component == Component::kX;
    held_y_ = held_y_ || motion.component == Component::kY;
  }
  for (const Foundation& foundation : model.foundations)
    (foundation.direction == foundation::Direction::kX ? held_x_ : held_y_) = true;
}

void LocalEngine::begin(const protocol::Step& step) {
  kick_ = step.kick();
  if (step.local_damping == 0) return;
  Particles& p = particles();
  for (auto* tie : {&p.tie_x, &p.tie_y}) tie->resize(p.size(), 0.0);
}

std::vector<double> LocalEngine::cell_areas() const {
  const Particles& p = particles();
  std::vector<double> areas;
  for (std::size_t i = 0; i < p.size(); ++i) areas.push_back(p.mass[i] / (p.weight[i] * density_[group_[i]]));
  return areas;
}

void LocalEngine::settle() {
  Particles& p = particles();
  p.settled_x = p.ux;
  p.settled_y = p.uy;
  settled_turn_.assign(turn().begin(), turn().end());
}

void LocalEngine::watch(const scene::Particles& scene) {
  lining_ = read_lining(scene, particles(), all_bonds(*this));
  histories_.emplace(scene, *this, lining_);
}

std::vector<double> LocalEngine::offer(const geometry::BoundingBox& box) {
  return coupling_.offer(particles(), box);
}

const protocol::InterfaceOperator& LocalEngine::tie_particles(std::span<const double> places,
                                                              const BondEnds& bonds,
                                                              const PrescribedMotions& motions) {
  coupling_.tie(places, particles(), bonds, motions);
  if (histories_) histories_->tie(coupling_.particles());
  return coupling_.interpolation();
}

void LocalEngine::prepare(bool energies) {
  if (histories_) histories_->remember(particles());
  if (energies) remember(particles(), before_);
}

void LocalEngine::remember_for_peaks() {
  const Particles& p = particles();
  if (!peaks_) peaks_.emplace(p.size());
  peaks_->remember({p.vx, p.vy});
}

void LocalEngine::read_velocities(std::span<double> velocities) const {
  coupling_.read_velocities(particles(), velocities);
}

void LocalEngine::read_histories(const protocol::Step& step, std::vector<double>& values) {
  if (histories_) histories_->read(*this, lining_, step, values);
  take_envelope(step);
}

void LocalEngine::take_envelope(const protocol::Step& step) {
  joint_peaks_.take(joints());
  const double time = static_cast<double>(step.number) * step.dt;
  std::vector<DiameterChange> diameters;
  for (const Oval& oval : lining_.ovals) diameters.push_back(oval.change(particles()));
  oval_envelope_.take(diameters, time);
  widest_crack_.take(cracks(), time);
  bar_peaks_.take(bars(), time);
  if (lining_.sections.cuts().empty()) return;
  const auto forces = section_forces(*this, lining_.sections);
  envelope_.take(forces, time);
  use_peaks_.take(lining_.sections.cuts(), forces, time);
}

void LocalEngine::take_peaks(const protocol::Step& step) {
  const Particles& p = particles();
  const auto displacement = [&p](std::size_t i) {
    return std::array{p.ux[i] - p.settled_x[i], p.uy[i] - p.settled_y[i]};
  };
  peaks_->take(displacement, {p.vx, p.vy}, step);
  take_envelope(step);
}

void LocalEngine::take_stage(const Model& model) {
  group_ = model.group;
  present_ = model.present.empty() ? model.discs.size()
                                   : static_cast<std::size_t>(std::ranges::count(model.present, true));
  // Sections know the bonds that cross them by their numbers, which are others now.
  if (const auto& cuts = lining_.sections.cuts(); !cuts.empty())
    lining_.sections = Sections({cuts.begin(), cuts.end()}, particles(), all_bonds(*this));
}

Unrest LocalEngine::unrest(const protocol::Step& step) {
  const Particles& p = particles();
  if (!relaxation_) relaxation_.emplace(p);
  Unrest unrest = relaxation_->measure(p, step.kick(), step.local_damping, edges_);
  unrest.internal_force = internal_force();
  unrest.particles = present_;
  unrest.elements = elements();
  constexpr double kHeld = std::numeric_limits<double>::infinity();
  if (held_x_) unrest.drag_x = kHeld;
  if (held_y_) unrest.drag_y = kHeld;
  if (!travel_) travel_.emplace(p.ux, p.uy);
  if (step.number % protocol::kTravelInterval == 0) unrest.farthest = farthest();
  return unrest;
}

Unrest::Farthest LocalEngine::farthest() const {
  const Particles& p = particles();
  const auto [distance, at] = travel_->farthest(p.ux, p.uy);
  const Fragments bodies = fragments_of(p.size(), whole_bonds(*this));
  return {distance, p.x[at], p.y[at], group_[at], bodies.size[bodies.number[at]]};
}

void LocalEngine::begin_stage(std::uint32_t /*stage*/) {
  travel_.reset();
}

void LocalEngine::stop() {
  dem::stop(particles());
  if (relaxation_) relaxation_->slowed(particles());
}

void LocalEngine::slow(double factor) {
  Particles& p = particles();
  for (auto* velocities : {&p.vx, &p.vy, &p.spin})
    for (double& velocity : *velocities) velocity *= factor;
  if (relaxation_) relaxation_->slowed(p);
}

void LocalEngine::start_over(const protocol::Drift& /*drift*/) {
  Particles& p = particles();
  dem::stop(p);
  p.tie_x.clear();
  p.tie_y.clear();
  relaxation_.reset();
  travel_.reset();
  if (!counts_from_stage_) settle();
}

void LocalEngine::count_displacements() {
  counts_from_stage_ = true;
  settle();
}

void LocalEngine::exchange(state::Archive& archive) {
  particles().exchange(archive);
  archive("counts_from_stage", counts_from_stage_);
  archive("kick", kick_);
  if (histories_) histories_->exchange(archive);
  envelope_.exchange(lining_.sections.cuts().size(), archive);
  if (any_strength(lining_.sections.cuts())) use_peaks_.exchange(lining_.sections.cuts().size(), archive);
  oval_envelope_.exchange(lining_.ovals.size(), archive);
  joint_peaks_.exchange(joints().size(), archive);
  if (!turn().empty()) {
    archive.all_or_none("settled_turn", {&settled_turn_}, turn().size());
    archive("widest_crack", widest_crack_);
  }
  if (!bars().empty()) archive("bar_peaks", bar_peaks_);
  archive("peaks", peaks_, [this] { return protocol::PeakMotion(particles().size()); });
  archive("relaxation", relaxation_, [this] { return Relaxation(particles()); });
  archive("travel", travel_, [this] { return protocol::Travel(particles().ux, particles().uy); });
}

void LocalEngine::snapshot(wire::Snapshot& snapshot) const {
  write_snapshot(*this, snapshot);
  add_sections(*this, lining_.sections, envelope_, use_peaks_, snapshot);
  add_joints(*this, joint_peaks_, snapshot);
  add_cells(*this, snapshot);
  add_cracks(*this, snapshot);
  add_bars(*this, snapshot);
  if (peaks_) protocol::add_peak_fields(*peaks_, *snapshot.mutable_pieces(0)->mutable_point_fields());
}

std::vector<Figure> LocalEngine::figures() const {
  std::vector<Figure> figures = figures_of(lining_.sections, envelope_);
  for (const Figure& figure : figures_of(lining_.sections, use_peaks_)) figures.push_back(figure);
  for (const Figure& figure : figures_of(lining_.ovals, oval_envelope_)) figures.push_back(figure);
  for (const Figure& figure : figures_of(widest_crack_)) figures.push_back(figure);
  if (!bars().empty())
    for (const Figure& figure : figures_of(bar_peaks_)) figures.push_back(figure);
  return figures;
}

std::uint64_t LocalEngine::fragments() const {
  const std::size_t gone = particles().size() - present_;
  return fragments_of(particles().size(), whole_bonds(*this)).count() - gone;
}

}  // namespace adit::dem
