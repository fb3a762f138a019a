#include "fdm_server/model/interfaces/law.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "protocol/errors.hpp"

namespace adit::fdm {

ContactLaw read_law(const scene::InterfaceLaw& law, const std::string& path) {
  using protocol::require;
  const double friction = std::tan(law.friction_angle()), apex = law.cohesion() / friction;
  require(
      law.dilation_angle() <= law.friction_angle(), path + ".dilation_angle",
      fmt::format("is {:.4g} rad, larger than the friction angle of {:.4g} rad; faces would make energy as "
                  "they slip, give at most that",
                  law.dilation_angle(), law.friction_angle()));
  require(
      friction == 0 || law.tension() <= apex, path + ".tension",
      fmt::format("is {:.4g} Pa, above cohesion / tan(friction_angle) = {:.4g} Pa, where the faces slip by "
                  "themselves; give at most that",
                  law.tension(), apex));
  const ContactStrength peak{law.cohesion(), friction, std::tan(law.dilation_angle()), law.tension()};
  ContactStrength residual = peak;
  residual.tension = 0;
  const auto take = [&](bool given, double value, double& of, const std::string& key) {
    if (!given) return;
    require(
        value <= of, path + ".residual." + key,
        fmt::format("is {:.4g}, above the {:.4g} that the interface has before it slips; give at most that",
                    value, of));
    of = value;
  };
  const auto& left = law.residual();
  take(left.has_cohesion(), left.cohesion(), residual.cohesion, "cohesion");
  take(left.has_friction_angle(), std::tan(left.friction_angle()), residual.tan_friction, "friction_angle");
  take(left.has_dilation_angle(), std::tan(left.dilation_angle()), residual.tan_dilation, "dilation_angle");
  return {law.normal_stiffness(), law.shear_stiffness(), peak, residual,
          law.has_residual() ? left.slip() : std::numeric_limits<double>::infinity()};
}

ContactLaw with_stiffness(ContactLaw law, double open) {
  if (law.normal == 0) law.normal = open;
  if (law.shear == 0) law.shear = law.normal;
  return law;
}

}  // namespace adit::fdm
