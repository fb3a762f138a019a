#include "simplified/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "protocol/errors.hpp"
#include "protocol/results/disk/reserve.hpp"
#include "protocol/scene/hash.hpp"
#include "protocol/standard_streams.hpp"
#include "protocol/stop_signals.hpp"
#include "simplified/output/results.hpp"
#include "simplified/run_summary.hpp"
#include "simplified/scene/joint.hpp"
#include "simplified/scene/liquefaction.hpp"
#include "simplified/zoom/write.hpp"

namespace adit::simplified {
namespace {

using protocol::UserError;
using Scene = scene::Simplified;

constexpr double kDefaultHistoryRows = 500;

// More steps would need more memory for the ground motion than machines have.
constexpr double kMostSteps = 1e7;

void refuse_other_models(const scene::Scene& scene) {
  if (!scene.has_simplified())
    throw UserError("", "has no `simplified`; continuum and particles are computed by `coupler`");
  const char* other = scene.has_continuum()         ? "continuum"
                      : scene.has_particles()       ? "particles"
                      : scene.regions_size() > 0    ? "regions"
                      : scene.has_interface()       ? "interface"
                      : scene.interfaces_size() > 0 ? "interfaces"
                      : scene.has_water()           ? "water"
                                                    : nullptr;
  if (other)
    throw UserError(
        other, "is given beside `simplified`, but a scene is computed by one program; leave one of them out");
  const char* unwritten = scene.output().has_peaks()          ? "output.peaks"
                          : scene.output().spectra_size() > 0 ? "output.spectra"
                                                              : nullptr;
  if (unwritten)
    throw UserError(unwritten, "is for the models of `coupler`; leave it out, peaks are in envelopes.csv");
}

Clock clock_of(const scene::Scene& scene) {
  if (!scene.time().has_dt())
    throw UserError("time.dt",
                    "is missing; the implicit models have no critical step, write for example `dt: 10 ms`");
  const double duration = scene.time().duration();
  // The last step ends on the duration, or less than a step after it. The small factor keeps a rounding error
  // from adding one.
  const double steps = std::max(1.0, std::ceil(duration / scene.time().dt() * (1 - 1e-12)));
  if (steps > kMostSteps)
    throw UserError("time.dt", fmt::format("makes {:g} steps; at most {:g} are computed", steps, kMostSteps));
  Clock clock{.dt = scene.time().dt(), .steps = static_cast<std::uint64_t>(steps), .stride = 1};
  const auto& output = scene.output();
  const double interval =
      output.has_history_interval() ? output.history_interval() : duration / kDefaultHistoryRows;
  clock.stride = static_cast<std::uint64_t>(std::clamp(std::round(interval / clock.dt), 1.0, steps));
  return clock;
}

void check_stations(const Scene& scene, double begin, double end) {
  for (int i = 0; i < scene.stations_size(); ++i) {
    const double chainage = scene.stations(i).chainage();
    if (chainage < begin || chainage > end)
      throw UserError(fmt::format("simplified.stations[{}].chainage", i),
                      fmt::format("is {:g} m, outside the model from {:g} to {:g} m", chainage, begin, end));
  }
}

void set_up_tunnel(Setup& setup) {
  const Scene& scene = *setup.scene;
  if (!scene.has_tunnel())
    throw UserError("simplified.tunnel", "is missing; the models beam and chain need it");
  for (int g = 0; g < scene.tunnel().joints_size(); ++g)
    check(scene.tunnel().joints(g), fmt::format("simplified.tunnel.joints[{}]", g));
  setup.line = divide(scene.tunnel());
  setup.begin = setup.line.nodes.front();
  setup.end = setup.line.nodes.back();
  // Making the model finds what this model cannot do.
  if (scene.model() == Scene::BEAM)
    beam_model(scene, setup.line);
  else
    chain_model(scene, setup.line);
}

void set_up_column(Setup& setup) {
  const Scene& scene = *setup.scene;
  if (!scene.has_ground())
    throw UserError("simplified.ground", "is missing; the model column computes the ground");
  if (!scene.excitation().through_ground())
    throw UserError("simplified.excitation.through_ground",
                    "must be true, because the model column computes how the "
                    "motion of the rock rises through the ground");
  setup.begin = scene.ground().profiles(0).chainage();
  setup.end = scene.ground().profiles(scene.ground().profiles_size() - 1).chainage();
}

}  // namespace

Setup set_up(const scene::Scene& scene) {
  refuse_other_models(scene);
  Setup setup;
  setup.scene = &scene.simplified();
  setup.clock = clock_of(scene);
  if (setup.scene->has_ground()) check(setup.scene->ground());
  check_liquefaction(*setup.scene);
  if (setup.scene->model() == Scene::COLUMN)
    set_up_column(setup);
  else
    set_up_tunnel(setup);
  check_stations(*setup.scene, setup.begin, setup.end);
  setup.motion = motion::ground_motion(setup.scene->excitation().motion(), "simplified.excitation.motion",
                                       {.dt = setup.clock.dt, .duration = scene.time().duration()});
  if (const auto note = motion::note_on_peak(setup.scene->excitation().motion(), setup.motion))
    setup.motion.notes.push_back(*note);
  return setup;
}

GroundField shake(const Setup& setup) {
  return shake(*setup.scene, setup.motion.motion, setup.begin, setup.end, setup.clock.steps);
}

Response solve(const Setup& setup, const GroundField& ground) {
  switch (setup.scene->model()) {
    case Scene::CHAIN:
      return solve_chain(*setup.scene, setup.line, ground, setup.clock);
    case Scene::COLUMN:
      return solve_column(*setup.scene, ground, setup.clock);
    case Scene::BEAM:
      break;
  }
  return solve_beam(*setup.scene, setup.line, ground, setup.clock);
}

void run(const scene::Scene& scene, const std::string& case_name, const protocol::Origin& origin,
         const std::filesystem::path& directory, const std::string& zoom) {
  const auto started = std::chrono::steady_clock::now();
  const auto elapsed = [started] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  };
  const Setup setup = set_up(scene);
  results::Reserve reserve(directory);
  const protocol::StopSignals signals;
  try {
    const GroundField ground = shake(setup);
    const Response response = solve(setup, ground);
    const double wall_s = elapsed();
    write_tables(directory, *setup.scene, response);
    write_motion(directory, motion::lasting(setup.motion.motion, scene.time().duration()));
    if (setup.scene->has_zoom() && !response.fields.time.empty())
      write_zoom(directory / "zoom", setup, ground, response, scene.time().duration(), zoom);
    reserve.release();
    summarize(scene, case_name, origin, setup, response, wall_s, directory);
  } catch (const std::exception& error) {
    reserve.release();
    summarize_end(scene, case_name, origin, setup, error.what(), elapsed(), directory);
    throw;
  }
}

void check(const scene::Scene& scene) {
  for (const std::string& note : set_up(scene).motion.notes) protocol::print(fmt::format("note: {}\n", note));
}

}  // namespace adit::simplified
