#include "simplified/beam/run.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "protocol/errors.hpp"
#include "protocol/stop_signals.hpp"
#include "simplified/beam/recorder.hpp"
#include "simplified/beam/stepper.hpp"

namespace adit::simplified::beam {
namespace {

void check(const RunOptions& options) {
  if (!(options.dt > 0) || !std::isfinite(options.dt))
    throw protocol::UserError("dt", fmt::format("the time step must be positive, got {:g} s", options.dt));
  if (options.steps < 0)
    throw protocol::UserError("steps",
                              fmt::format("the number of steps must not be negative, got {}", options.steps));
  if (options.history_every < 1)
    throw protocol::UserError("history_every",
                              fmt::format("must be at least 1, got {}", options.history_every));
  const Scheme& s = options.scheme;
  // The conditions of unconditional stability (Chung & Hulbert 1993), with room for rounding errors.
  if (!(s.alpha_f >= 0 && s.alpha_f <= 0.5 && s.alpha_m <= s.alpha_f && s.beta > 0 &&
        s.gamma >= 0.5 - s.alpha_m + s.alpha_f - 1e-12 &&
        s.beta >= 0.25 * (1 - s.alpha_m + s.alpha_f) - 1e-12))
    throw protocol::UserError("scheme",
                              fmt::format("alpha_m {:g}, alpha_f {:g}, beta {:g}, gamma {:g} is not "
                                          "unconditionally stable: use Newmark with "
                                          "beta >= 1/4, gamma >= 1/2, or HHT with alpha in [0, 1/3]",
                                          s.alpha_m, s.alpha_f, s.beta, s.gamma));
}

}  // namespace

Results run(const Tunnel& tunnel, const GroundMotion& motion, const RunOptions& options) {
  check(options);
  const auto start = std::chrono::steady_clock::now();
  Stepper stepper(tunnel, motion, options.scheme, options.dt);
  Results results;
  Recorder recorder(stepper, options, results);
  recorder.record(0);
  for (long step = 1; step <= options.steps; ++step) {
    protocol::end_if_stopped();
    stepper.step();
    recorder.record(step);
  }
  recorder.finish();
  results.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return results;
}

}  // namespace adit::simplified::beam
