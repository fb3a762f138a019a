#include "coupler/participants/constraint.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "coupler/bridging/solves/split.hpp"
#include "protocol/errors.hpp"
#include "protocol/wire/content/finite.hpp"

namespace adit::coupler {
namespace {

using protocol::UserError;

bool interpolates(const Participant& participant) {
  return std::any_of(participant.segments.begin(), participant.segments.end(),
                     [](const Segment& s) { return s.coarse; });
}

// Own points of the participants that interpolate, in one numbering: the number of each participant's first
// point.
std::vector<std::size_t> number_own_points(const std::vector<Participant>& participants) {
  std::vector<std::size_t> first = {0};
  for (const Participant& participant : participants)
    first.push_back(first.back() + (interpolates(participant) ? participant.interpolation->own_points() : 0));
  return first;
}

// N of the coarse sides, over all coupling points.
Interpolation coarse_operator(const std::vector<Participant>& participants,
                              const std::vector<Interface>& interfaces) {
  const std::vector<std::size_t> first = number_own_points(participants);
  std::vector<std::uint32_t> row_starts = {0}, columns;
  std::vector<double> values, inverse_masses;
  for (const Interface& interface : interfaces) {
    const Participant& participant = participants[interface.coarse];
    const Segment& segment = participant.segment_from(interface.begin);
    for (std::size_t k = 0; k < segment.count; ++k) {
      for (const std::uint32_t column : participant.interpolation->columns(segment.begin + k))
        columns.push_back(static_cast<std::uint32_t>(first[interface.coarse] + column));
      const auto row = participant.interpolation->values(segment.begin + k);
      values.insert(values.end(), row.begin(), row.end());
      row_starts.push_back(static_cast<std::uint32_t>(columns.size()));
    }
  }
  for (const Participant& participant : participants)
    if (interpolates(participant)) {
      const double square = participant.step_ratio * participant.step_ratio;
      for (const double inverse_mass : participant.interpolation->inverse_masses())
        inverse_masses.push_back(square * inverse_mass);
    }
  return {std::move(row_starts), std::move(columns), std::move(values), std::move(inverse_masses)};
}

// Masses of the fine points. Each must be a point of its own: of its participant, and of the constraint.
std::vector<double> fine_masses(const std::vector<Participant>& participants,
                                const std::vector<Interface>& interfaces, std::span<const double> points) {
  std::vector<double> masses(points.size());
  std::map<std::pair<std::size_t, std::uint32_t>, const Interface*> used;  // participant and own point
  const auto refuse = [&](const Interface& interface, std::size_t k, const Interface& other) {
    throw UserError(
        interface.path + ".overlap",
        fmt::format("ties the point ({:g}, {:g}) m of `{}`, which {} ties already; move the "
                    "overlaps apart",
                    points[2 * k], points[2 * k + 1], participants[interface.fine].member.name, other.path));
  };
  const auto each_row = [&](const Interface& interface, std::size_t s, auto&& visit) {
    for (const Segment& segment : participants[s].segments)
      if (segment.global == interface.begin)
        for (std::size_t k = 0; k < segment.count; ++k) visit(segment.global + k, segment.begin + k);
  };
  for (const Interface& interface : interfaces) {
    const Interpolation& n = *participants[interface.fine].interpolation;
    const double square = participants[interface.fine].step_ratio * participants[interface.fine].step_ratio;
    each_row(interface, interface.fine, [&](std::size_t k, std::size_t row) {
      if (n.columns(row).size() != 1 || n.values(row)[0] != 1.0)
        throw protocol::PeerLost(participants[interface.fine].connection->name(),
                                 "sent an operator that interpolates at a point that it offered itself");
      const std::uint32_t own = n.columns(row)[0];
      const auto [other, first] = used.try_emplace({interface.fine, own}, &interface);
      if (!first && other->second == &interface)
        throw protocol::PeerLost(participants[interface.fine].connection->name(),
                                 "sent an operator in which two coupling points are one point of its own");
      if (!first) refuse(interface, k, *other->second);
      for (const int component : {0, 1})
        masses[2 * k + component] = 1.0 / (square * n.inverse_masses()[2 * own + component]);
    });
  }
  for (const Interface& interface : interfaces)
    each_row(interface, interface.coarse, [&](std::size_t k, std::size_t row) {
      for (const std::uint32_t own : participants[interface.coarse].interpolation->columns(row))
        if (const auto other = used.find({interface.coarse, own}); other != used.end())
          refuse(interface, k, *other->second);
    });
  return masses;
}

scene::Solve common_solve(const std::vector<Interface>& interfaces) {
  for (const Interface& interface : interfaces)
    if (interface.given.solve() != interfaces[0].given.solve())
      throw UserError(interface.path + ".solve",
                      fmt::format("differs from that of {}; all interfaces of a scene are solved together, "
                                  "state the same for all",
                                  interfaces[0].path));
  return interfaces[0].given.solve();
}

// The rate that the scene gives, or the one that suits the waves of the fine side [1/s].
double decay_rate(const Interface& interface, const Participant& fine) {
  if (interface.given.has_decay_rate()) return interface.given.decay_rate();
  const double wave_speed = fine.model.p_wave_speed();
  if (!(wave_speed > 0))
    throw UserError(
        interface.path + ".decay_rate",
        fmt::format("is missing, and {} does not say how fast waves run in `{}`; give the rate, or "
                    "choose another solve than `split`",
                    fine.connection->name(), fine.member.name));
  return default_decay_rate(wave_speed, interface.overlap.width());
}

// Share of the fine motion that the split solve removes in one step at each coupling point.
std::vector<double> decay(const std::vector<Participant>& participants,
                          const std::vector<Interface>& interfaces, std::span<const double> points,
                          double dt) {
  std::vector<double> shares;
  for (const Interface& interface : interfaces) {
    const double rate = decay_rate(interface, participants[interface.fine]);
    std::vector<double> across;
    for (std::size_t k = interface.begin; k < interface.end; ++k) {
      const double depth = interface.overlap.depth(points[2 * k], points[2 * k + 1]);
      across.push_back(interface.fine == interface.inner ? depth : 1 - depth);
    }
    const auto per_step = decay_per_step(across, rate, dt);
    shares.insert(shares.end(), per_step.begin(), per_step.end());
  }
  return shares;
}

}  // namespace

Constraint::Constraint(const std::vector<Participant>& participants, const std::vector<Interface>& interfaces,
                       std::span<const double> points, double dt)
    : coarse_(coarse_operator(participants, interfaces)),
      own_(2 * coarse_.own_points()),
      at_points_(points.size()) {
  const scene::Solve kind = common_solve(interfaces);
  try {
    solve_ = make_multiplier_solve(
        kind, coarse_, fine_masses(participants, interfaces, points),
        kind == scene::SPLIT ? decay(participants, interfaces, points, dt) : std::vector<double>{});
  } catch (const UserError& error) {  // which speaks of the only interface that it knows
    throw UserError(error.path() == "interface.overlap" ? interfaces.back().path + ".overlap" : error.path(),
                    error.what());
  }
}

void Constraint::read(const std::vector<Participant>& participants, Part part,
                      std::vector<double> Participant::*velocities, std::span<double> at_points) const {
  for (const Participant& participant : participants)
    for (const Segment& segment : participant.segments)
      if (segment.coarse == (part == Part::kCoarse))
        for (std::size_t i = 0; i < 2 * segment.count; ++i)
          at_points[2 * segment.global + i] =
              participant.step_ratio * (participant.*velocities)[2 * segment.begin + i];
}

void Constraint::solve(std::span<const double> coarse, std::span<const double> fine,
                       std::span<double> multipliers) {
  solve_->solve(coarse, fine, multipliers);
  for (const auto& [begin, end] : idle_)
    std::ranges::fill(multipliers.subspan(2 * begin, 2 * (end - begin)), 0.0);
  if (protocol::all_finite(multipliers)) return;
  const auto largest = [](std::span<const double> velocities) {
    return std::abs(std::ranges::max(velocities, {}, [](double v) { return std::abs(v); }));
  };
  throw protocol::Unstable(
      fmt::format("the coupling impulses overflowed: the velocities of the models reach {:g} and {:g} m/s at "
                  "the coupling points; choose a smaller time.dt_factor",
                  largest(coarse), largest(fine)));
}

void Constraint::assign(std::span<const double> multipliers, double factor, Part part,
                        std::vector<Participant>& participants) const {
  const double signed_factor = part == Part::kCoarse ? -factor : factor;
  for (Participant& participant : participants)
    for (const Segment& segment : participant.segments) {
      if (segment.coarse != (part == Part::kCoarse)) continue;
      const std::span<double> impulses = participant.correction.renew().subspan(2 * segment.begin);
      for (std::size_t i = 0; i < 2 * segment.count; ++i)
        impulses[i] = signed_factor * participant.step_ratio * multipliers[2 * segment.global + i];
    }
}

void Constraint::set_idle(std::size_t begin, std::size_t end, bool idle) {
  if (idle)
    idle_[begin] = end;
  else
    idle_.erase(begin);
}

void Constraint::close_idle(std::span<const double> coarse, std::span<double> fine) const {
  for (const auto& [begin, end] : idle_)
    std::ranges::copy(coarse.subspan(2 * begin, 2 * (end - begin)),
                      fine.begin() + static_cast<std::ptrdiff_t>(2 * begin));
}

void Constraint::correct_coarse(std::span<const double> multipliers, std::span<double> velocities) {
  coarse_.gather(multipliers, own_);
  coarse_.divide_by_mass(own_);
  coarse_.interpolate(own_, at_points_);
  for (std::size_t i = 0; i < velocities.size(); ++i) velocities[i] -= at_points_[i];
}

}  // namespace adit::coupler
