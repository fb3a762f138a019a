#include "fdm_server/model/boundaries/base_motion.hpp"

#include <string>

#include "protocol/errors.hpp"
#include "protocol/motion/errors_at.hpp"
#include "protocol/motion/excitation/stations.hpp"
#include "protocol/motion/velocity_history.hpp"
#include "protocol/participant/time_function.hpp"

namespace adit::fdm {
namespace {

using protocol::UserError;

// For BaseVelocity and BaseStress.
template <class Given>
TimeFactor scaled(const Given& given) {
  return [given](double t) { return given.amplitude() * protocol::evaluate(given.time(), t); };
}

std::vector<TimeFactor> shaken(const scene::Base& base, std::span<const double> places,
                               const motion::UsedMotion& used) {
  if (!base.has_incidence()) return {motion::VelocityHistory(used.acting())};
  const scene::Incidence& incidence = base.incidence();
  return motion::errors_at(kBasePath + ".incidence", [&] {
    std::vector<TimeFactor> histories;
    for (const auto& here : motion::station_motions(used.motion, places,
                                                    {.apparent_velocity = incidence.apparent_velocity(),
                                                    .drift = incidence.coherency().drift(),
                                                    .seed = incidence.coherency().seed()}))
      histories.emplace_back(motion::VelocityHistory(used.acting(here)));
    return histories;
  });
}

}  // namespace

BaseAccelerations base_accelerations(const scene::Base& base, double duration) {
  BaseAccelerations found;
  if (base.has_acceleration())
    found.along = motion::ground_motion(base.acceleration(), kBasePath + ".acceleration", duration);
  if (base.has_across()) {
    protocol::require(base.has_acceleration(), kBasePath + ".across",
                      "goes beside `acceleration` only; give the motion along the direction so, too");
    found.across = motion::ground_motion(base.across(), kBasePath + ".across", duration);
  }
  return found;
}

std::vector<TimeFactor> base_histories(const scene::Base& base, std::span<const double> places,
                                       const motion::UsedMotion& acceleration) {
  if (base.has_incidence() && !base.has_acceleration())
    throw UserError(kBasePath + ".incidence",
                    "goes with `acceleration` only; leave it out, or give the motion so");
  switch (base.motion_case()) {
    case scene::Base::kAcceleration:
      return shaken(base, places, acceleration);
    case scene::Base::kVelocity:
      return {scaled(base.velocity())};
    case scene::Base::kStress:
      if (base.kind() == scene::Base::RIGID)
        throw UserError(kBasePath + ".stress",
                        "is given to a rigid base, whose motion is prescribed; give its "
                        "`acceleration` or `velocity`, or `kind: compliant`");
      return {scaled(base.stress())};
    case scene::Base::MOTION_NOT_SET:
      break;
  }
  throw UserError(kBasePath, "has no motion; give one of acceleration, velocity, stress");
}

}  // namespace adit::fdm
