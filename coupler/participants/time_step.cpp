#include "coupler/participants/time_step.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

constexpr double kDefaultRows = 500;

// With 20 samples in a period, straight lines between them lower the amplitude of a sine by
// 1 - sinc^2(1/20) = 0.8 %.
constexpr double kSamplesAPeriod = 20;

constexpr double kSameStep = 1e-6;       // times this close count as one [steps]
constexpr double kRounding = 1 - 1e-12;  // so that 0.3 s in steps of 0.1 s are three steps
constexpr double kMoreSteps = 1.1;
constexpr double kMostTried = 1e5;  // a participant may name any critical step

// Whether the duration ends on a step, and how many of the times.
std::pair<bool, std::ptrdiff_t> fit(double dt, double duration, std::span<const double> times) {
  return {on_step(duration, dt), std::ranges::count_if(times, [dt](double t) { return on_step(t, dt); })};
}

using protocol::UserError;

struct Critical {  // the smallest critical step of each kind [s], and whose it is
  double continuum = std::numeric_limits<double>::infinity(), particles = continuum;
  std::string continuum_name, particles_name;

  explicit Critical(const std::vector<Participant>& participants) {
    for (const Participant& participant : participants) {
      const bool is_continuum = participant.member.role == Role::kContinuum;
      double& smallest = is_continuum ? continuum : particles;
      if (participant.model.critical_dt() >= smallest) continue;
      smallest = participant.model.critical_dt();
      (is_continuum ? continuum_name : particles_name) = participant.member.name;
    }
  }
  // The step of the particles, with m of them in one step of the continuum.
  double with(unsigned m) const { return std::min(particles, continuum / m); }
  const std::string& name_with(unsigned m) const {
    return particles <= continuum / m ? particles_name : continuum_name;
  }
};

bool joins_one_kind(const Interface& interface, const Model& model) {
  return model.participants[interface.outer].member.role == model.participants[interface.inner].member.role;
}

bool goes_with_substeps(const Model& model) {
  return !model.interfaces.empty() && std::ranges::none_of(model.interfaces, [&](const Interface& interface) {
    return joins_one_kind(interface, model);
  });
}

void require_substeps_possible(const Model& model, unsigned m) {
  if (m % 2 != 0)
    throw UserError("time.substeps",
                    fmt::format("is {}; give 1 or an even number, because the continuum moves in "
                                "the middle of the particles' steps",
                                m));
  if (model.interfaces.empty())
    throw UserError("time.substeps", "needs a continuum joined to particles; leave it out");
  for (const Interface& interface : model.interfaces)
    if (joins_one_kind(interface, model))
      throw UserError("time.substeps", fmt::format("does not go with {}, which joins two models of one kind; "
                                                   "leave it out",
                                                   interface.path));
}

// The largest even number that leaves the continuum at most this share of its own critical step: 0.05 points
// more are reflected there, and much more above.
unsigned substeps_that_cost_nothing(const Critical& critical, double dt) {
  constexpr double kShare = 0.4;
  const double pairs = std::floor(kShare * critical.continuum / dt / 2);
  return pairs >= 1 ? 2 * static_cast<unsigned>(std::min(pairs, 500.0)) : 1;
}

// By how much a step may be shortened for rows that nobody asked for.
constexpr double kShortened = 1.1;

std::string shortened(double interval, double limit, double dt) {
  return fmt::format(
      "`output.history_interval` of {:g} s shortens the time step from {:g} s to {:g} s, which divides it; "
      "with "
      "{:g} s the run takes {:.0f} % fewer steps",
      interval, limit, dt, limit * std::ceil(interval / limit), 100 * (1 - dt / limit));
}

// Steps that divide the interval between rows, where it is not shorter than they are. A given `dt` stays as
// it is. For an interval that nobody gave the step is shortened a little at most.
Steps steps_for_rows(const scene::Scene& scene, double limit, std::vector<std::string>& notes) {
  const auto& time = scene.time();
  const double duration = time.duration(), interval = row_interval(scene);
  const bool asked = scene.output().has_history_interval();
  const std::span<const double> fields(scene.output().field_times().data(),
                                       static_cast<std::size_t>(scene.output().field_times_size()));
  const Steps plain = time.has_dt() ? steps_of(limit, duration) : equal_steps(duration, limit);
  if (interval >= duration * (1 - 1e-12)) return plain;  // a row at the begin and one at the end
  if (time.has_dt() || interval < limit * (1 - 1e-12)) {
    const bool given = asked && !on_step(interval, plain.dt) && on_step(interval, limit);
    return given ? steps_of(limit, duration) : plain;
  }
  const Steps dividing = dividing_steps(duration, limit, interval, fields);
  const bool costly = dividing.dt * kShortened < plain.dt;
  if (costly && !asked) return plain;
  if (costly) notes.push_back(shortened(interval, limit, dividing.dt));
  return dividing;
}

}  // namespace

double sampling_interval(const scene::Spectra& spectra) {
  return spectra.shortest_period() / kSamplesAPeriod;
}

double row_interval(const scene::Scene& scene) {
  const scene::Output& output = scene.output();
  if (output.has_history_interval()) return output.history_interval();
  double interval = scene.time().duration() / kDefaultRows;
  for (const auto& spectra : output.spectra()) interval = std::min(interval, sampling_interval(spectra));
  return interval;
}

bool on_step(double time, double dt) {
  return std::abs(time / dt - std::round(time / dt)) <= kSameStep;
}

Steps equal_steps(double duration, double limit) {
  const double count = std::max(1.0, std::ceil(duration / limit * kRounding));
  return {duration / count, static_cast<std::uint64_t>(count)};
}

Steps steps_of(double dt, double duration) {
  const double count = on_step(duration, dt) ? std::round(duration / dt) : std::ceil(duration / dt);
  return {dt, static_cast<std::uint64_t>(std::max(1.0, count))};
}

Steps dividing_steps(double duration, double limit, double interval, std::span<const double> times) {
  const double fewest = std::ceil(interval / limit * kRounding);
  const double most = std::min(kMoreSteps * fewest, fewest + kMostTried);
  double best = fewest;
  for (double k = fewest + 1; k <= most; ++k)
    if (fit(interval / k, duration, times) > fit(interval / best, duration, times)) best = k;
  return steps_of(interval / best, duration);
}

void choose_time_step(Model& model) {
  const Critical critical(model.participants);
  const auto& time = model.scene.time();
  unsigned m = time.substeps();
  if (m == 0) {
    const double dt = time.has_dt() ? time.dt() : time.dt_factor() * critical.with(1);
    m = goes_with_substeps(model) ? substeps_that_cost_nothing(critical, dt) : 1;
  }
  if (m > 1) require_substeps_possible(model, m);
  model.substeps = m;
  model.critical_dt = critical.with(m);
  if (time.has_dt() && time.dt() > model.critical_dt && !time.beyond_critical())
    throw UserError("time.dt",
                    fmt::format("is {:g} s, above {:g} s, the critical time step of the {}{}; give a smaller "
                                "one, or leave it out and state dt_factor",
                                time.dt(), model.critical_dt, critical.name_with(m),
                                m > 1 ? fmt::format(" with {} substeps", m) : ""));
  const double limit = m * (time.has_dt() ? time.dt() : time.dt_factor() * model.critical_dt);
  if (time.duration() / limit > 1e15)
    throw UserError("time.duration",
                    fmt::format("takes {:g} steps of {:g} s; shorten it", time.duration() / limit, limit));
  const Steps steps = steps_for_rows(model.scene, limit, model.notes);
  model.steps = steps.count;
  model.dt = steps.dt;
}

void keep_time_step(Model& model, double dt) {
  constexpr double kSame = 1e-12;
  if (std::abs(model.dt / dt - 1) > kSame)
    model.notes.push_back(fmt::format(
        "the run goes on with its time step of {:g} s and its rows of histories.csv; a new run of {:g} s "
        "would take steps of {:g} s, so that its results differ a little; state `time.dt` or "
        "`output.history_interval` in runs that may be lengthened",
        dt, model.scene.time().duration(), model.dt));
  const Steps steps = steps_of(dt, model.scene.time().duration());
  model.dt = steps.dt;
  model.steps = steps.count;
}

void compare_time_step(Model& model) {
  const auto& time = model.scene.time();
  add_where_it_differs(model.stated,
                       {.key = "time.duration",
                        .stated = time.duration(),
                        .acted = static_cast<double>(model.steps) * model.dt,
                        .unit = "s",
                        .why = fmt::format("the last step of {:g} s is a whole one", model.dt)});
  if (!time.has_dt_factor()) return;
  // A shorter step keeps the share: it is not warned of.
  add_where_it_differs(model.stated,
                       {.key = "time.dt_factor",
                        .stated = time.dt_factor(),
                        .acted = model.dt / model.substeps / model.critical_dt,
                        .why = time.has_dt() ? "`time.dt` is stated, too; leave one of them out" : ""});
}

namespace {

double critical_static_step(const Participant& participant) {
  const wire::Model& its = participant.model;
  return its.critical_static_dt() > 0 ? its.critical_static_dt() : its.critical_dt();
}

}  // namespace

double critical_static_step(const Model& model) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Participant& participant : model.participants)
    smallest = std::min(smallest, critical_static_step(participant));
  return smallest;
}

double choose_static_steps(Model& model, double share, bool own_steps) {
  const double smallest = critical_static_step(model);
  if (own_steps)
    for (Participant& participant : model.participants)
      participant.step_ratio = critical_static_step(participant) / smallest;
  return share * smallest;
}

}  // namespace adit::coupler
