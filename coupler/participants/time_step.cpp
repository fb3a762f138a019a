#include "coupler/participants/time_step.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

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

void require_substeps_possible(const Model& model, unsigned m) {
  if (m % 2 != 0)
    throw UserError("time.substeps",
                    fmt::format("is {}; give 1 or an even number, because the continuum moves in "
                                "the middle of the particles' steps",
                                m));
  if (model.interfaces.empty())
    throw UserError("time.substeps", "needs a continuum joined to particles; leave it out");
  for (const Interface& interface : model.interfaces)
    if (model.participants[interface.outer].member.role == model.participants[interface.inner].member.role)
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

}  // namespace

void choose_time_step(Model& model) {
  const Critical critical(model.participants);
  const auto& time = model.scene.time();
  unsigned m = time.substeps();
  if (m == 0) {
    const double dt = time.has_dt() ? time.dt() : time.dt_factor() * critical.with(1);
    m = model.interfaces.empty() ? 1 : substeps_that_cost_nothing(critical, dt);
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
  const double wanted = m * (time.has_dt() ? time.dt() : time.dt_factor() * model.critical_dt);
  const double steps = std::ceil(time.duration() / wanted);
  if (steps > 1e15)
    throw UserError("time.duration", fmt::format("takes {:g} steps of {:g} s; shorten it", steps, wanted));
  model.steps = static_cast<std::uint64_t>(std::max(steps, 1.0));
  model.dt = time.duration() / static_cast<double>(model.steps);
}

}  // namespace adit::coupler
