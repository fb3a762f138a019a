#include "coupler/stepping/condensed_regions.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

#include "protocol/errors.hpp"
#include "protocol/log/waiting.hpp"
#include "protocol/messages/spans.hpp"
#include "protocol/wire/bounds.hpp"

namespace adit::coupler {
namespace {

constexpr std::size_t kNowhere = ~std::size_t{0};
constexpr double kSafety = 3;  // of the largest rate of the demand so far
// What they take on a core of 2023 [s]: a number of a matrix with the exchange that it makes wait, a step of
// a cell; and what is little beside a round trip.
constexpr double kNumber = 1.6e-9, kParticleStep = 0.15e-6, kLittle = 0.2e-3;

Eigen::Map<const Eigen::VectorXd> as_vector(const google::protobuf::RepeatedField<double>& values) {
  return {values.data(), values.size()};
}

Eigen::MatrixXd from_lower(const google::protobuf::RepeatedField<double>& values, Eigen::Index size) {
  Eigen::MatrixXd matrix(size, size);
  int next = 0;
  for (Eigen::Index row = 0; row < size; ++row)
    for (Eigen::Index column = 0; column <= row; ++column) matrix(row, column) = values[next++];
  return matrix.selfadjointView<Eigen::Lower>();
}

void assign(google::protobuf::RepeatedField<double>& field, const Eigen::VectorXd& values) {
  std::ranges::copy(values, protocol::resize(field, static_cast<std::size_t>(values.size())).begin());
}

}  // namespace

double seconds_to_move(std::size_t masters) {
  const double size = 2 * static_cast<double>(masters);
  return 2 * size * size * kNumber;
}

CondensedRegions::CondensedRegions(Model& model, Ledger& ledger, StepCost& cost)
    : model_(model), ledger_(ledger), cost_(cost) {
  for (std::size_t s = 0; s < model.participants.size(); ++s) {
    const Participant& participant = model.participants[s];
    if (participant.member.role != Role::kParticles) continue;
    const scene::Particles& particles = particles_of(model.scene, participant.member);
    if (!particles.has_begin()) continue;
    std::vector<const Interface*> joined;
    for (const Interface& interface : model.interfaces)
      if (interface.fine == s || interface.coarse == s) joined.push_back(&interface);
    if (joined.size() != 1 || model.participants[joined[0]->coarse].member.role != Role::kContinuum)
      throw protocol::UserError(participant.member.path + ".begin",
                                "is for particles that one interface joins to a continuum; leave it out");
    Region& region = regions_.emplace_back();
    region.particles = s;
    region.grid = joined[0]->coarse;
    region.begin = joined[0]->begin;
    region.end = joined[0]->end;
    region.share = particles.begin().demand();
  }
}

bool CondensedRegions::any_wait() const {
  return std::ranges::any_of(regions_, &Region::waits);
}

bool CondensedRegions::nothing_but_they_move() const {
  return any_wait() && std::ranges::all_of(model_.participants, [](const Participant& participant) {
           return participant.member.role != Role::kParticles || participant.waits;
         });
}

// All are asked before the first answer is read.
void CondensedRegions::condense() {
  condensed_ = true;
  for (Region& region : regions_) {
    if (!region.waits) continue;
    Participant& particles = model_.participants[region.particles];
    find_masters(region, *particles.request.mutable_condense());
    for (const std::string& reason : {why_not_moved(region), costs_more(region)})
      if (!reason.empty() && region.waits) begin(region, {0, 1, reason});
  }
  for (const Region& region : regions_) {
    if (!region.waits) continue;
    Participant& particles = model_.participants[region.particles];
    particles.drift.reset();
    particles.connection->post(particles.request);
  }
  for (Region& region : regions_) {
    if (!region.waits) continue;
    Participant& particles = model_.participants[region.particles];
    const protocol::Waiting waiting(fmt::format("{} condenses its model", particles.connection->name()),
                                    [&] { return particles.connection->progress(); });
    collect(particles, wire::Frame::kCondensed);
    const wire::Condensed& told = particles.reply.condensed();
    if (!told.reason().empty()) {
      begin(region, {0, 1, told.reason()});
      continue;
    }
    read(region, told);
    set_waits(region, true);
  }
}

void CondensedRegions::begin(Region& region, const Beginning& beginning) {
  region.beginning = beginning;
  set_waits(region, false);
}

void CondensedRegions::set_waits(Region& region, bool waits) {
  region.waits = model_.participants[region.particles].waits = waits;
  model_.constraint->set_idle(region.begin, region.end, waits);
}

// The masters are numbered as they come in the rows of N.
void CondensedRegions::find_masters(Region& region, wire::Condense& request) const {
  const Participant& grid = model_.participants[region.grid];
  std::map<std::uint32_t, std::uint32_t> number;  // of a master, by its number among the grid's own points
  request.Clear();
  request.add_row_starts(0);
  region.own.clear();
  const Segment& segment = grid.segment_from(region.begin);
  for (std::size_t row = segment.begin; row < segment.begin + segment.count; ++row) {
    const auto columns = grid.interpolation->columns(row);
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const auto [found, added] = number.try_emplace(columns[k], static_cast<std::uint32_t>(number.size()));
      if (added) region.own.push_back(columns[k]);
      request.add_columns(found->second);
      request.add_values(grid.interpolation->values(row)[k]);
    }
    request.add_row_starts(static_cast<std::uint32_t>(request.columns_size()));
  }
  request.set_masters(static_cast<std::uint32_t>(region.own.size()));
  std::map<std::size_t, std::size_t> place;  // of a grid's own point, among its coupling points
  for (std::size_t k = grid.nodes_begin; k < grid.places.size() / 2; ++k)
    place[grid.interpolation->columns(k)[0]] = k;
  region.place.clear();
  for (const std::size_t own : region.own)
    region.place.push_back(place.contains(own) ? place[own] : kNowhere);
}

// What shares a point of the grid would have to be solved for together.
std::string CondensedRegions::why_not_moved(const Region& region) const {
  if (std::ranges::find(region.place, kNowhere) != region.place.end())
    return "its overlap is narrower than a zone, and grid points that move it lie beyond its width";
  const Participant& grid = model_.participants[region.grid];
  const auto moves_it = [&](std::size_t own) {
    return std::ranges::find(region.own, own) != region.own.end();
  };
  for (const Segment& segment : grid.segments) {
    if (segment.global == region.begin) continue;
    for (std::size_t row = segment.begin; row < segment.begin + segment.count; ++row)
      if (std::ranges::any_of(grid.interpolation->columns(row), moves_it))
        return fmt::format("the same grid points move it and `{}`", other_side(region.grid, segment));
  }
  return {};
}

// The participant that an interface of this one joins to it.
const std::string& CondensedRegions::other_side(std::size_t participant, const Segment& segment) const {
  const auto joining = std::ranges::find(model_.interfaces, segment.global, &Interface::begin);
  return model_.participants[joining->coarse == participant ? joining->fine : joining->coarse].member.name;
}

// A step of full matrices against as many steps of the particles as it replaces.
std::string CondensedRegions::costs_more(const Region& region) const {
  const Participant& particles = model_.participants[region.particles];
  if (protocol::condensed_bytes(region.own.size()) > protocol::kMaxFrameBytes)
    return fmt::format("the matrices of {} grid points in its overlap are longer than a message may be",
                       region.own.size());
  const auto count = static_cast<double>(particles.counts.particles());
  if (seconds_to_move(region.own.size()) <= std::max(kLittle, count * model_.substeps * kParticleStep))
    return {};
  return fmt::format("{} grid points in its overlap would cost more than its {} particles in {} substeps",
                     region.own.size(), particles.counts.particles(), model_.substeps);
}

void CondensedRegions::read(Region& region, const wire::Condensed& told) {
  const Participant& particles = model_.participants[region.particles];
  const Participant& grid = model_.participants[region.grid];
  const auto size = static_cast<Eigen::Index>(2 * region.own.size());
  if (told.stiffness_size() != size * (size + 1) / 2 || told.mass_size() != told.stiffness_size() ||
      told.force_size() != size)
    throw protocol::PeerLost(
        particles.connection->name(),
        fmt::format("condensed its model to another number of points than {}", size / 2));
  const double dt = model_.dt;
  region.stiffness = from_lower(told.stiffness(), size);
  region.inertia = from_lower(told.mass(), size) + 0.25 * dt * dt * region.stiffness;
  region.force = as_vector(told.force());
  region.strain_at_rest = told.strain_energy();
  region.mass.resize(size);
  for (Eigen::Index k = 0; k < size; ++k)
    region.mass[k] =
        1 / grid.interpolation->inverse_masses()[2 * region.own[static_cast<std::size_t>(k / 2)] +
                                                 static_cast<std::size_t>(k % 2)];
  Eigen::MatrixXd sum = region.inertia;
  for (Eigen::Index k = 0; k < size; ++k) {
    if (std::isfinite(region.mass[k])) {
      sum(k, k) += region.mass[k];
      continue;
    }
    sum.row(k).setZero();
    sum.col(k).setZero();
    sum(k, k) = 1;
  }
  const Eigen::LLT<Eigen::MatrixXd> factor(sum);
  region.inverse = factor.solve(Eigen::MatrixXd::Identity(size, size));
  if (factor.info() != Eigen::Success)
    throw protocol::PeerLost(particles.connection->name(),
                             "condensed its model to masses that are not positive");
  region.any_prescribed = !region.mass.allFinite();
  region.restoring.setZero(size);
  region.kick.setZero(size);
  const bool goes_on = region.q.size() > 0;
  for (auto* vector : {&region.q, &region.before, &region.velocities, &region.impulses, &region.q_told}) {
    if (!goes_on) vector->setZero(size);
    state::require_of_model(vector->size() == size, "region_motion");
  }
  region.restoring_told = region.stiffness * region.q_told;
  if (!goes_on) region.demand = region.largest_demand = told.demand();
}

void CondensedRegions::step(std::uint64_t n, Wanted wanted) {
  fill_request(request_, n, model_.dt, wanted);
  const auto each_grid = [this](auto&& visit) {
    for (Participant& participant : model_.participants)
      if (participant.member.role == Role::kContinuum) visit(participant);
  };
  {
    const Stopwatch waiting(cost_.wait);
    each_grid([this](Participant& grid) { post_advance(grid, request_); });
    each_grid(receive_prediction);
  }
  each_grid([](Participant& grid) { std::ranges::fill(grid.correction.renew(), 0.0); });
  move(n);
  book_grids(wanted);
}

void CondensedRegions::move(std::uint64_t n) {
  const Stopwatch solving(cost_.solve);
  for (Region& region : regions_)
    if (region.waits) move(region, n);
}

void CondensedRegions::look(std::uint64_t n, Wanted wanted) {
  if (!any_wait()) return;
  const bool near =
      std::ranges::any_of(regions_, [](const Region& region) { return region.waits && may_be_near(region); });
  const bool due = n % kLookInterval == 0 || (n < kLookInterval && std::has_single_bit(n));
  reached_ = n;
  told_ = false;
  if (due || near || wanted.histories || wanted.peaks) follow(wanted);
  if (!wanted.energies) return;
  for (const Region& region : regions_)
    if (region.waits) ledger_.take_condensed(region.particles, energies_of(region));
}

std::vector<GridMotion> CondensedRegions::begin_near(std::uint64_t n) {
  std::vector<GridMotion> motions;
  for (Region& region : regions_) {
    if (!region.waits || region.demand < region.share) continue;
    begin(region, {n, region.demand});
    motions.push_back(begin_moving(region));
  }
  return motions;
}

// At the prescribed points of the grid the region is moved; what that takes is told to the grid as well.
void CondensedRegions::move(Region& region, std::uint64_t n) {
  Participant& grid = model_.participants[region.grid];
  const double dt = n == 0 ? model_.dt / 2 : model_.dt;
  const auto size = region.mass.size();
  if (n > 0) {
    region.before = region.velocities;
    region.q += dt * region.before;
  }
  region.restoring.noalias() = region.stiffness * region.q;
  for (Eigen::Index k = 0; k < size; ++k) region.kick[k] = grid.predicted[region.at(k)] - region.before[k];
  const Eigen::VectorXd force = dt * (region.force - region.restoring);
  Eigen::VectorXd prescribed = Eigen::VectorXd::Zero(size), change = force;
  for (Eigen::Index k = 0; k < size; ++k)
    if (region.prescribed(k)) prescribed[k] = region.kick[k];
  if (region.any_prescribed) change -= region.inertia * prescribed;
  for (Eigen::Index k = 0; k < size; ++k)
    change[k] = region.prescribed(k) ? prescribed[k] : change[k] + region.mass[k] * region.kick[k];
  change = region.inverse * change;
  Eigen::VectorXd impulses(size);
  for (Eigen::Index k = 0; k < size; ++k)
    impulses[k] = region.prescribed(k) ? region.inertia.col(k).dot(change) - force[k]
                                       : region.mass[k] * (region.kick[k] - change[k]);
  if (n == 0) {
    region.velocities = change;
    region.before = -change;
    region.kick *= 2;
    region.impulses = 2 * impulses;
  } else {
    region.velocities = region.before + change;
    region.work += 0.5 * region.before.dot(region.impulses + impulses);
    region.impulses = impulses;
  }
  const std::span<double> corrections = grid.correction.impulses_from(0);
  for (Eigen::Index k = 0; k < size; ++k) corrections[region.at(k)] = -impulses[k];
}

void CondensedRegions::book_grids(Wanted wanted) {
  for (std::size_t s = 0; s < model_.participants.size(); ++s) {
    Participant& participant = model_.participants[s];
    if (participant.member.role != Role::kContinuum) continue;
    correct_velocities(participant);
    if (wanted.energies) ledger_.take_energies(s, participant);
    ledger_.close_step(s, participant);
  }
}

ParticipantEnergies CondensedRegions::energies_of(const Region& region) {
  const double followed = 0.5 * region.q.dot(region.restoring) - region.q.dot(region.force);
  return {.kinetic = 0.5 * region.before.dot(region.inertia * region.velocities),
          .strain = region.strain_at_rest + followed + region.external_work,
          .external_work = region.external_work,
          .multiplier_work = region.work};
}

bool CondensedRegions::may_be_near(const Region& region) {
  return region.demand + kSafety * region.rate * std::sqrt(std::max(0.0, region.square_since_told())) >=
         region.share;
}

// The particles' velocities are those half of their own step before and later.
void CondensedRegions::follow(Wanted wanted) {
  wanted.energies = true;
  told_ = true;
  fill_request(request_, reached_ * model_.substeps, particles_dt(), wanted);
  const double share = 0.5 / model_.substeps;
  for (const Region& region : regions_) {
    if (!region.waits) continue;
    Participant& particles = model_.participants[region.particles];
    particles.correction.withhold();
    wire::Following& following = *request_.mutable_follow();
    assign(*following.mutable_displacements(), region.q);
    assign(*following.mutable_velocities_before(), region.velocities_after(-share));
    assign(*following.mutable_velocities(), region.velocities_after(share));
    post_advance(particles, request_);
  }
  const Stopwatch waiting(cost_.wait);
  for (Region& region : regions_) {
    if (!region.waits) continue;
    Participant& particles = model_.participants[region.particles];
    receive_prediction(particles);
    particles.corrected = particles.predicted;
    const wire::Predicted& told = particles.prediction();
    region.external_work = told.energies().external_work();
    if (const double square = region.square_since_told(); square > 0)
      region.rate = std::max(region.rate, std::abs(told.demand() - region.demand) / std::sqrt(square));
    region.demand = told.demand();
    region.largest_demand = std::max(region.largest_demand, region.demand);
    region.q_told = region.q;
    region.restoring_told = region.restoring;
  }
  ++followings_;
}

// What the grid gets is as if it had been stepped by the other scheme all along: with several steps of the
// particles in one of its own, its prediction is made of its velocity at the time of the step and half of its
// own kick (shared_kick.hpp).
GridMotion CondensedRegions::begin_moving(const Region& region) {
  Participant &grid = model_.participants[region.grid], &particles = model_.participants[region.particles];
  std::ranges::fill(particles.correction.renew(), 0.0);
  particles.correction.withhold();
  ledger_.begin(region.particles, particles, region.work);
  const Eigen::VectorXd velocities = region.velocities_after(0.5 / model_.substeps);
  if (model_.substeps > 1) {
    const std::span<double> corrections = grid.correction.impulses_from(0);
    grid.correction.withhold();  // the shared kick sends them
    for (Eigen::Index k = 0; k < region.mass.size(); ++k)
      if (!region.prescribed(k))
        corrections[region.at(k)] =
            region.mass[k] * (velocities[k] - region.before[k] - 0.5 * region.kick[k]);
  }
  return {region.begin, region.end, at_points(region, velocities), at_points(region, region.kick)};
}

// From the masters to the region's coupling points.
std::vector<double> CondensedRegions::at_points(const Region& region,
                                                const Eigen::VectorXd& of_masters) const {
  const Participant& grid = model_.participants[region.grid];
  std::vector<double> own(2 * grid.interpolation->own_points()), at_its(grid.places.size());
  for (std::size_t k = 0; k < region.own.size(); ++k)
    for (std::size_t component = 0; component < 2; ++component)
      own[2 * region.own[k] + component] = of_masters[static_cast<Eigen::Index>(2 * k + component)];
  grid.interpolation->interpolate(own, at_its);
  const Segment& segment = grid.segment_from(region.begin);
  const auto first = at_its.begin() + static_cast<std::ptrdiff_t>(2 * segment.begin);
  return {first, first + static_cast<std::ptrdiff_t>(2 * segment.count)};
}

std::vector<CondensedRegions::Story> CondensedRegions::stories() const {
  std::vector<Story> stories;
  for (const Region& region : regions_)
    stories.push_back(
        {model_.participants[region.particles].member.name, region.beginning, region.largest_demand});
  return stories;
}

void CondensedRegions::exchange(state::Archive& archive) {
  archive("followings", followings_);
  archive("regions_reached", reached_);
  archive("regions_told", told_);
  for (Region& region : regions_) {
    archive("region_waits", region.waits);
    bool began = region.beginning.has_value();
    archive("region_began", began);
    if (began) {
      if (!region.beginning) region.beginning.emplace();
      archive("beginning_step", region.beginning->step);
      archive("beginning_demand", region.beginning->demand);
      archive("beginning_reason", region.beginning->reason);
    }
    if (!region.waits) continue;
    for (Eigen::VectorXd* vector :
         {&region.q, &region.before, &region.velocities, &region.impulses, &region.q_told}) {
      std::vector<double> values(vector->begin(), vector->end());
      archive("region_motion", values);
      *vector = Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
    }
    archive("region_work", region.work);
    archive("region_demand", region.demand);
    archive("region_largest_demand", region.largest_demand);
    archive("region_rate", region.rate);
    archive("region_external_work", region.external_work);
  }
}

}  // namespace adit::coupler
