#include "fdm_server/participant/participant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <span>
#include <utility>

#include "fdm_server/grid/interpolation.hpp"
#include "fdm_server/grid/samples.hpp"
#include "fdm_server/materials/wave_speeds.hpp"
#include "fdm_server/model/boundaries/base_motion.hpp"
#include "fdm_server/model/boundaries/boundaries.hpp"
#include "fdm_server/model/boundaries/foundations.hpp"
#include "fdm_server/model/damping.hpp"
#include "fdm_server/model/grid/read_grid.hpp"
#include "fdm_server/model/grid/zone_stages.hpp"
#include "fdm_server/model/ground.hpp"
#include "fdm_server/model/initial_stress.hpp"
#include "fdm_server/model/motions.hpp"
#include "fdm_server/model/resolution.hpp"
#include "fdm_server/model/supports/meetings.hpp"
#include "fdm_server/model/supports/supports.hpp"
#include "fdm_server/model/water/water.hpp"
#include "fdm_server/participant/critical_element.hpp"
#include "fdm_server/participant/demand_figures.hpp"
#include "fdm_server/participant/dowel_figures.hpp"
#include "fdm_server/participant/interface_figures.hpp"
#include "fdm_server/participant/joint_figures.hpp"
#include "fdm_server/participant/large_motion.hpp"
#include "fdm_server/participant/lining_figures.hpp"
#include "fdm_server/participant/snapshot.hpp"
#include "fdm_server/solver/deformed_grid.hpp"
#include "fdm_server/zones/zone_set.hpp"
#include "protocol/errors.hpp"
#include "protocol/foundation/read.hpp"
#include "protocol/ground/stages.hpp"
#include "protocol/messages/spans.hpp"

namespace adit::fdm {
namespace {

using protocol::Step;
using protocol::view;

constexpr std::uint64_t kFiniteCheckInterval = 100;  // steps
constexpr std::uint64_t kShapeCheckInterval = 1000;  // steps; costs as much as some tens

// One weight a zone from the wire's samples; all 1 where there are none.
std::vector<double> read_weights(const wire::Weights& weights, const Grid& grid) {
  if (weights.weights().empty()) return std::vector<double>(grid.zones.size(), 1.0);
  const auto in_range = [](double value) { return value >= 0 && value <= 1; };
  if (!std::ranges::all_of(weights.weights(), in_range) || !in_range(weights.floor()))
    throw protocol::RequestError("got a weight or a floor outside [0, 1]");
  return zone_weights(grid, view(weights.weights()), weights.floor());
}

void fill_inverse_masses(const Continuum& continuum, std::span<const std::uint32_t> points,
                         google::protobuf::RepeatedField<double>& values) {
  for (const auto point : points) {
    values.Add(continuum.inverse_mass_x()[point]);
    values.Add(continuum.inverse_mass_y()[point]);
  }
}

}  // namespace

void FdmParticipant::set_up(const wire::Setup& setup, wire::Model& model) {
  scene_ = setup.scene();
  setup_ = read_setup(scene_);
  require_statics_for_motions(scene_);
  grid_ = read_grid(scene_.continuum());
  assign_zones(scene_.continuum(), grid_, setup_.ground);
  fill_pores(scene_, grid_, setup_.ground);
  require_water(scene_, grid_, setup_.ground, setup.alone());
  Grid grid = grid_;  // with what interfaces add
  const Supports supports = resolve_supports(scene_, setup_.ground, {}, grid);
  damping_ = resolve_damping(scene_.continuum());
  base_accelerations_ = base_accelerations(scene_.continuum().base(), scene_.time().duration());
  const KnownEarly early = known_early(supports, grid, setup.alone());
  const auto critical_in = [&](const Ground& ground) {
    return critical_element(setup_.kind, grid, ground, supports, early, damping_,
                            foundation::largest_stiffness(scene_.continuum().foundations()) +
                                spring_stiffness(scene_.continuum(), grid_, ground));
  };
  Ground last = setup_.ground;  // of time; of statics each stage's counts
  CriticalElement critical = critical_in(last);
  const ZoneStages changes(scene_, grid_, last.stated_of_zones());
  for (const auto& [number, stage] : changes.stages()) {
    if (stage.renewed.empty()) continue;
    renew(stage, last.of_zone);
    const double before = critical.static_step;
    critical = critical_in(last);
    critical.static_step = std::min(before, critical.static_step);
  }
  critical_dt_ = critical.step;
  critical_static_dt_ = critical.static_step;
  if (!(critical_dt_ > 0) || !std::isfinite(critical_dt_))
    throw protocol::UserError("material",
                              fmt::format("makes a critical time step of {} s; check the units of the "
                                          "stiffness and of the density",
                                          critical_dt_));
  model.set_critical_dt(critical_dt_);
  model.set_critical_static_dt(critical_static_dt_);
  model.set_scales_masses(can_scale_masses());
  model.set_slows(true);
  model.set_critical_element(critical.name);
  model.set_critical_x(critical.place[0]);
  model.set_critical_y(critical.place[1]);
  const WaveSpeeds speeds = wave_speeds(last);
  model.set_p_wave_speed(speeds.p);
  model.set_s_wave_speed(speeds.s);
  for (const std::string& note : base_accelerations_.along.notes)
    model.add_notes("base.acceleration: " + note);
  for (const std::string& note : base_accelerations_.across.notes) model.add_notes("base.across: " + note);
  for (const std::string& note : notes_on_meetings(supports, grid)) model.add_notes(note);
  if (const auto note = note_on_ratio(scene_.continuum(), damping_)) model.add_notes(*note);
  if (const auto note = note_on_stiffening(scene_.continuum(), damping_)) model.add_notes(*note);
  if (const auto note = note_on_shared_motion(damping_, base_accelerations_.along.motion))
    model.add_notes(*note);
  if (const auto warning = warn_of_imbalance(scene_, grid_, setup_.ground)) model.add_notes(*warning);
  for (const std::string& note : notes_on_strength(setup_.ground)) model.add_notes(note);
  for (const std::string& note : notes_on_water(scene_, setup_.ground)) model.add_notes(note);
  if (setup.alone())
    if (const auto note = note_on_fracture(setup_.ground)) model.add_notes(*note);
  for (const std::string& note : notes_on_loops(scene_, setup_.ground)) model.add_notes(note);
  for (const std::string& note : notes_on_resistance(scene_, setup_.ground)) model.add_notes(note);
  const Resolution resolution = fdm::resolution(grid_, last);
  model.set_highest_frequency(resolution.frequency);
  if (const auto note = note_on_resolution(resolution, scene_.continuum(), base_accelerations_.along.motion))
    model.add_notes(*note);
  const auto box = bounds(grid_);
  model.set_x_min(box.x_min);
  model.set_x_max(box.x_max);
  model.set_y_min(box.y_min);
  model.set_y_max(box.y_max);
  model.add_groups("");  // of zones in no group
  for (const Group& group : grid_.groups) model.add_groups(group.name);
  model.add_materials(scene_.continuum().has_material() ? "continuum.material" : "material");
  for (int i = 0; i < scene_.continuum().materials_size(); ++i)
    model.add_materials(fmt::format("continuum.materials[{}].material", i));
  const auto samples = sample_points(grid_);
  model.mutable_sample_points()->Assign(samples.begin(), samples.end());
}

// Coupling points are not known yet, and foundations may hold any point. Local damping pushes on what turns
// back in every step, as stiff structures would.
// Contacts keep away from the interface (couple).
KnownEarly FdmParticipant::known_early(const Supports& supports, const Grid& grid, bool alone) const {
  const bool all = scene_.continuum().foundations_size() > 0 || damping_.local > 0;
  const bool structures = !supports.structures.beams().empty() || !supports.structures.bars().empty();
  if (all || (!structures && supports.contacts.empty())) {
    const std::vector<bool> every(grid.x.size(), all);
    return {every, every};
  }
  const auto bearing = find_bearing_points(scene_.continuum(), base_accelerations_, grid);
  return {alone ? bearing : std::vector<bool>(grid.x.size(), true), bearing};
}

void FdmParticipant::weigh(const wire::Weights& weights, wire::Interface& interface) {
  weights_ = read_weights(weights, grid_);
  if (!weights.weights().empty()) {
    slivers_ = drop_slivers(grid_, view(weights.weights()), weights_);
    side_shares_ = side_shares(grid_, view(weights.weights()), weights_);
  }
  compact(setup_.ground, weights_);
  compact(grid_, weights_);
  if (grid_.zones.empty())
    throw protocol::UserError(
        "interface.overlap",
        "leaves no zone of the continuum, whose weight is 0 everywhere; let the block reach into the overlap "
        "and beyond it on the continuum's own side");
  supports_ = resolve_supports(scene_, setup_.ground, weights_, grid_);
  const auto& conditions = scene_.continuum();
  make_continuum();
  zone_stages_ = ZoneStages(scene_, grid_, setup_.ground.stated_of_zones());
  require_free_field_stays();
  require_renewed_apart();
  if (zone_stages_.stages().contains(0)) begin_stage(0);
  peak_shapes_.emplace(grid_, supports_.linings);
  histories_.emplace(conditions, supports_, grid_, zone_kinds(), setup_.ground.materials, damping_);
  if (!weights.weights().empty()) offer_grid_points(weights, interface);
  interface.set_zones(grid_.zones.size());
  interface.set_grid_points(grid_.x.size());
  interface.set_mass(std::accumulate(continuum_->masses().begin(), continuum_->masses().end(), 0.0));
}

// The columns follow their side.
void FdmParticipant::make_continuum() {
  const auto& conditions = scene_.continuum();
  const auto edges = outline(grid_);
  columns_ = add_columns(conditions, edges, grid_);
  for (const auto& column : columns_)
    for (const auto& edge : column.edges) setup_.ground.add_zone(setup_.ground, edge.zone);
  weights_.resize(grid_.zones.size(), 1.0);
  zones_there_ = grid_.zones.size();

  auto motions = resolve_motions(conditions, grid_);
  for (auto& motion : motions)
    for (const auto& column : columns_) extend_to_column(column, motion.points);
  auto boundaries = resolve_boundaries(
      conditions, base_accelerations_, grid_, edges, columns_,
      [this](std::uint32_t zone) {
        const Ground& ground = setup_.ground;
        return impedance(ground.undrained_law(zone), ground.material(zone).density, weights_[zone]);
      },
      motions);
  std::ranges::move(boundaries.motions, std::back_inserter(motions));
  base_loads_ = std::move(boundaries.loads);
  absorbing_.assign(grid_.zones.size(), false);
  for (const Dashpot& dashpot : boundaries.dashpots)
    for (const DashpotShare& share : dashpot.shares) absorbing_[share.zone] = true;

  ZoneSet zones(setup_.kind, grid_, setup_.ground, weights_);
  if (scene_.has_water()) zones.set_rest(water_at_rest().pressures());
  if (scene_.has_initial_stress()) set_initial_stress(scene_, grid_, zones);
  const auto masses = this->masses();
  continuum_ = std::make_unique<Continuum>(std::move(zones), masses, loads(masses), std::move(motions),
                                           threads_ > 0 ? threads_ : useful_threads(grid_.zones.size()),
                                           supports_.structures, supports_.contacts);
  continuum_->set_dashpots(std::move(boundaries.dashpots),
                           scene_.has_statics() || scene_.has_initial_stress());
  continuum_->set_damping(damping_);
  continuum_->set_foundations(resolve_foundations(conditions, grid_, weights_));
  if (!scene_.has_statics()) begin_time();
}

void FdmParticipant::begin_time() {
  continuum_->zones().begin_time();
  if (auto flow = this->flow()) continuum_->set_flow(std::move(*flow));
}

std::optional<Flow> FdmParticipant::flow() const {
  if (!scene_.has_water()) return std::nullopt;
  return resolve_flow(scene_, grid_, setup_.ground, stage_, weights_, side_shares_, columns_,
                      supports_.linings);
}

WaterAtRest FdmParticipant::water_at_rest() const {
  return {scene_.water(), grid_, columns_, stage_};
}

std::vector<Load> FdmParticipant::loads(std::span<const double> masses) const {
  auto loads = resolve_loads(scene_.continuum(), grid_, masses, columns_);
  if (scene_.has_water())
    loads.push_back(weight_of_sea(water_at_rest(), grid_, weights_, side_shares_, columns_));
  loads.insert(loads.end(), base_loads_.begin(), base_loads_.end());
  return loads;
}

std::vector<double> FdmParticipant::masses() const {
  auto masses = lumped_masses(grid_, weights_, zone_densities(setup_.ground));
  supports_.structures.add_masses(masses, stage_);
  return masses;
}

// In large strain the zones' shapes change, and with them their steps.
bool FdmParticipant::can_scale_masses() const {
  return !setup_.ground.large_strain;
}

std::vector<double> FdmParticipant::scaled_masses() const {
  std::vector<double> densities = zone_densities(setup_.ground);
  for (std::size_t z = 0; z < densities.size(); ++z)
    densities[z] *= std::pow(critical_static_dt_ / zone_steps_[z], 2);
  auto masses = lumped_masses(grid_, weights_, densities);
  Structures structures = supports_.structures;
  structures.scale_masses(critical_static_dt_);
  structures.add_masses(masses, stage_);
  return masses;
}

void FdmParticipant::scale_masses(bool scaled) {
  if (scaled == scaled_) return;
  scaled_ = scaled;
  if (scaled && zone_steps_.empty())
    zone_steps_ = static_zone_steps(setup_.kind, grid_, setup_.ground,
                                    foundation::largest_stiffness(scene_.continuum().foundations()));
  set_masses();
}

void FdmParticipant::set_masses() {
  auto masses = scaled_ ? scaled_masses() : this->masses();
  if (relaxes_) {
    continuum_->contacts().add_masses(masses, critical_static_dt_);
    continuum_->structures().add_masses_of_dowels(masses, critical_static_dt_);
  }
  continuum_->set_masses(masses, scaled_ ? critical_static_dt_ : 0);
}

void FdmParticipant::offer_grid_points(const wire::Weights& box, wire::Interface& interface) const {
  for (std::size_t i = 0; i < grid_.places(); ++i) {
    if (grid_.x[i] < box.x_min() || grid_.x[i] > box.x_max() || grid_.y[i] < box.y_min() ||
        grid_.y[i] > box.y_max())
      continue;
    interface.add_points(grid_.x[i]);
    interface.add_points(grid_.y[i]);
  }
}

void FdmParticipant::couple(const wire::Couple& couple, wire::Operator& op) {
  if (couple.points_size() % 2 != 0 ||
      !std::ranges::all_of(couple.points(), [](double value) { return std::isfinite(value); }))
    throw protocol::RequestError("got coupling points that are no finite pairs x y");
  if (setup_.ground.large_strain)
    throw protocol::UserError("continuum.large_strain",
                              "moves the grid away from the places where an interface joins it to another "
                              "model; leave one of the two out");
  operator_ = protocol::InterfaceOperator(interpolate(grid_, view(couple.points()), slivers_));
  require_interface_stays();
  require_apart_from_contacts();
  continuum_->set_interface(operator_.points());
  operator_.fill(op);
  histories_->tie(operator_.points());
  fill_inverse_masses(*continuum_, operator_.points(), *op.mutable_inverse_masses());
  if (!scene_.has_statics() || !can_scale_masses()) return;
  scale_masses(true);
  auto& scaled = *op.mutable_scaled_inverse_masses();
  fill_inverse_masses(*continuum_, operator_.points(), scaled);
  scale_masses(false);
  for (std::size_t j = 0; j < operator_.points().size(); ++j) {
    const auto held = continuum_->held_in_statics(operator_.points()[j]);
    for (const int axis : {0, 1})
      if (held[axis]) scaled[static_cast<int>(2 * j) + axis] = 0;
  }
}

void FdmParticipant::correct(std::span<const double> impulses) {
  const auto own = operator_.gather(impulses);
  for (std::size_t j = 0; j < operator_.points().size(); ++j)
    continuum_->push(operator_.points()[j], own[2 * j], own[2 * j + 1]);
}

void FdmParticipant::measure_unrest(const Step& last, wire::Relaxation& answer) {
  if (!relaxation_) relaxation_.emplace(grid_, weights_);
  const Unrest unrest = relaxation_->measure(*continuum_, last.kick(), last.local_damping);
  if (!std::isfinite(unrest.unbalanced_force)) check_grid(last);
  answer.set_unbalanced_force(unrest.unbalanced_force);
  answer.set_internal_force(unrest.internal_force);
  answer.set_points(grid_.x.size());
  answer.set_largest_unbalanced_force(unrest.largest);
  answer.set_x(grid_.x[unrest.at]);
  answer.set_y(grid_.y[unrest.at]);
  const protocol::IndexRange own{0, static_cast<std::uint32_t>(grid_.own_points())};
  const Vector net = relaxation_->net(*continuum_, own), drag = continuum_->drag(own);
  answer.set_net_x(net.x);
  answer.set_net_y(net.y);
  answer.set_drag_x(drag.x);
  answer.set_drag_y(drag.y);
  answer.set_elements(grid_.zones.size());
  if (!travel_) travel_.emplace(continuum_->ux(), continuum_->uy());
  if (last.number % protocol::kTravelInterval == 0) tell_travel(answer);
}

void FdmParticipant::tell_travel(wire::Relaxation& answer) {
  const auto [distance, at] = travel_->farthest(continuum_->ux(), continuum_->uy());
  answer.set_largest_displacement(distance);
  answer.set_moved_x(grid_.x[at]);
  answer.set_moved_y(grid_.y[at]);
  answer.set_moved(name_of(static_cast<std::uint32_t>(at)));
}

std::string FdmParticipant::name_of(std::uint32_t point) const {
  if (point >= grid_.own_points()) return "the free field";
  const auto found = [&](const std::vector<Lining>& chains, const auto& stated) {
    for (std::size_t i = 0; i < chains.size(); ++i)
      if (stated[static_cast<int>(i)].stage() <= stage_ &&
          std::ranges::find(chains[i].path.points, point) != chains[i].path.points.end())
        return chains[i].name;
    return std::string();
  };
  if (const auto name = found(supports_.linings, scene_.continuum().linings()); !name.empty())
    return "lining " + name;
  if (const auto name = found(supports_.members, scene_.continuum().members()); !name.empty())
    return "member " + name;
  for (const Group& group : grid_.groups)
    for (const std::uint32_t zone : group.zones)
      if (weights_[zone] > 0 && std::ranges::find(grid_.zones[zone], point) != grid_.zones[zone].end())
        return "group " + group.name;
  return "";
}

double FdmParticipant::kinetic_energy() const {
  return fdm::kinetic_energy(*continuum_);
}

void FdmParticipant::slow(double factor) {
  continuum_->slow(factor);
  relaxation_->slowed(factor);
}

void FdmParticipant::start_over(const protocol::Drift& drift) {
  continuum_->settle({0, static_cast<std::uint32_t>(grid_.own_points())}, drift);
  for (const FreeFieldColumn& column : columns_) {  // each stands by itself
    const protocol::IndexRange points{column.point(0), column.point(column.side.size())};
    const Vector net = relaxation_->net(*continuum_, points), drag = continuum_->drag(points);
    continuum_->settle(points, {drag.x > 0 ? net.x / drag.x : 0, drag.y > 0 ? net.y / drag.y : 0});
  }
  relaxation_.reset();
  travel_.reset();
  continuum_->start_over();
  begin_time();
  const protocol::CountedFrom counted = protocol::counted_from(scene_.statics());
  if (!counted.stage_given || stage_ < counted.stage) continuum_->reset_displacements();
}

void FdmParticipant::remember_for_peaks() {
  if (!peaks_) peaks_.emplace(grid_, setup_.ground);
  peaks_->remember(*continuum_);
}

void FdmParticipant::take_peaks(const Step& step) {
  peaks_->take(*continuum_, step);
}

void FdmParticipant::prepare(const Step& step, const wire::Advance& wanted) {
  const double critical = step.relax ? critical_static_dt_ : critical_dt_;
  if (step.dt > critical && !scene_.time().beyond_critical())
    throw protocol::UserError("time.dt", fmt::format("is {} s, above the continuum's critical step of {} s; "
                                                     "give at most that",
                                                     step.dt, critical));
  if (step.relax != relaxes_) {
    relaxes_ = step.relax;
    if (!continuum_->contacts().empty()) set_masses();
  }
  histories_->remember(*continuum_);
  if (wanted.want_energies()) continuum_->remember_velocities();
}

void FdmParticipant::step_interface(const Step& step) {
  continuum_->step_interface(step);
  check_interface(step);
}

void FdmParticipant::step_interior(const Step& step) {
  continuum_->step_interior(step);
  histories_->follow(*continuum_, step);
  if (!step.from_rest()) {
    ++steps_done_;
    updates_ += zones_there_;
  }
  if (!step.relax) {
    peak_forces_.take(supports_.linings, continuum_->structures(), step.time());
    contact_peaks_.take(continuum_->contacts(), step.time());
    peak_use_.take(supports_.linings, continuum_->structures(), step.time());
    member_forces_.take(supports_.members, continuum_->structures(), step.time());
    member_use_.take(supports_.members, continuum_->structures(), step.time());
    peak_joints_.take(supports_.linings, continuum_->structures(), step.time());
    peak_dowels_.take(continuum_->structures().dowels(), step.time());
    peak_shapes_->take(continuum_->ux(), continuum_->uy(), step.time());
  }
  if (step.number % kFiniteCheckInterval == 0) check_grid(step);
  if (setup_.ground.large_strain && !step.from_rest() && steps_done_ % kShapeCheckInterval == 0 &&
      !scene_.time().beyond_critical())
    require_stable_shapes(setup_.kind, grid_, setup_.ground, step.relax ? DampingLaw{} : damping_, weights_,
                          *continuum_, step);
}

void FdmParticipant::check_interface(const Step& step) const {
  const auto finite = [this](std::uint32_t point) {
    return std::isfinite(continuum_->vx()[point]) && std::isfinite(continuum_->vy()[point]);
  };
  if (!std::ranges::all_of(operator_.points(), finite)) check_grid(step);
}

void FdmParticipant::check_grid(const Step& step) const {
  const Continuum& continuum = *continuum_;
  const auto point = continuum.first_non_finite();
  if (!point) return;
  throw protocol::Unstable(fmt::format(
      "step {}: the velocity of the grid point at ({}, {}) m is ({}, {}) m/s; lower time.dt and look at the "
      "loads",
      step.number, grid_.x[*point], grid_.y[*point], continuum.vx()[*point], continuum.vy()[*point]));
}

void FdmParticipant::read_velocities(std::span<double> velocities) const {
  operator_.velocities(continuum_->vx(), continuum_->vy(), velocities);
}

void FdmParticipant::read_energies(const Step& step, wire::Energies& answer) {
  const Energies energies = continuum_->energies(step);
  if (!std::isfinite(energies.kinetic) || !std::isfinite(energies.strain)) {
    check_grid(step);
    throw protocol::Unstable(
        fmt::format("step {}: the continuum's energy is not finite (kinetic {} J, strain {} J); lower "
                    "time.dt and look at "
                    "the loads",
                    step.number, energies.kinetic, energies.strain));
  }
  answer.set_kinetic(energies.kinetic);
  answer.set_strain(energies.strain);
  answer.set_external_work(energies.external_work);
  answer.set_dissipated(energies.dissipated);
}

void FdmParticipant::read_histories(const Step& step, google::protobuf::RepeatedField<double>& values) {
  histories_->read(grid_, supports_, *continuum_, step, values);
}

void FdmParticipant::draw(wire::Snapshot& snapshot) {
  fill_snapshot(grid_, *continuum_, weights_, snapshot);
  add_ground(grid_, setup_.ground, continuum_->zones(), weights_, *snapshot.mutable_pieces(0));
  if (peaks_) add_peaks(*peaks_, weights_, *snapshot.mutable_pieces(0));
  add_supports(grid_, *continuum_, supports_, {peak_forces_, peak_use_, peak_joints_},
               {member_forces_, member_use_, PeakJoints{}}, snapshot);
  add_interfaces(grid_, *continuum_, supports_.interfaces, contact_peaks_, snapshot);
}

void FdmParticipant::exchange_solver(state::Archive& archive) {
  std::uint32_t stage = stage_;
  archive("stage", stage);
  if (archive.reads()) excavate(stage);  // builds what stands in this stage
  if (scene_.has_water()) {
    bool flows = continuum_->flows();
    archive("flows", flows);
    if (archive.reads() && flows)
      if (auto flow = this->flow()) continuum_->set_flow(std::move(*flow));
  }
  continuum_->exchange(archive);
  peak_forces_.exchange(supports_.linings, archive);
  contact_peaks_.exchange(supports_.contacts.size(), archive);
  peak_use_.exchange(supports_.linings, archive);
  member_forces_.exchange(supports_.members, archive);
  member_use_.exchange(supports_.members, archive);
  peak_joints_.exchange(supports_.linings, archive);
  peak_dowels_.exchange(supports_.structures.dowels().size(), archive);
  peak_shapes_->exchange(archive);
  histories_->exchange(archive);
  archive("peaks", peaks_, [this] { return Peaks(grid_, setup_.ground); });
  archive("relaxation", relaxation_, [this] { return Relaxation(grid_, weights_); });
  archive("travel", travel_, [this] { return protocol::Travel(continuum_->ux(), continuum_->uy()); });
  archive("steps_done", steps_done_);
  archive("updates", updates_);
  archive("relaxes", relaxes_);
}

void FdmParticipant::finish(wire::Bye& bye) {
  bye.set_updates(updates_);
  if (!continuum_) return;  // a run may end before it is weighed
  add_figures(grid_, "lining", supports_.linings, peak_forces_, peak_use_, bye);
  add_figures(grid_, "member", supports_.members, member_forces_, member_use_, bye);
  add_figures(grid_, supports_.linings, peak_joints_, bye);
  add_figures(grid_, supports_.linings, peak_dowels_, bye);
  add_figures(supports_.linings, *peak_shapes_, bye);
  if (!supports_.members.empty()) add_failures(grid_, supports_.members, continuum_->structures(), bye);
  add_figures(grid_, supports_.interfaces, supports_.contacts, contact_peaks_, bye);
  if (peaks_) add_largest_demand(grid_, *peaks_, bye);
  if (!setup_.ground.large_strain)
    warn_of_large_motion(grid_, weights_, continuum_->ux(), continuum_->uy(), bye);
}

}  // namespace adit::fdm
