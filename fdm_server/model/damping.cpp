#include "fdm_server/model/damping.hpp"

#include <fmt/format.h>

#include <cmath>

#include "protocol/errors.hpp"
#include "protocol/motion/measures.hpp"

namespace adit::fdm {

using protocol::UserError;

DampingLaw resolve_damping(const scene::Continuum& scene) {
  if (!scene.has_damping()) return {};
  const scene::Damping& damping = scene.damping();
  switch (damping.kind_case()) {
    case scene::Damping::kRayleigh:
      return rayleigh(damping.rayleigh().ratio(), damping.rayleigh().low_frequency(),
                      damping.rayleigh().high_frequency());
    case scene::Damping::kMaxwell: {
      const scene::MaxwellDamping& given = damping.maxwell();
      if (given.high_frequency() > kWidestBand * given.low_frequency())
        throw UserError(
            "continuum.damping.maxwell.high_frequency",
            fmt::format("is {:g} times low_frequency, but three elements keep the ratio over a band "
                        "of at most {:g}; raise low_frequency, or lower this one",
                        given.high_frequency() / given.low_frequency(), kWidestBand));
      return maxwell(given.ratio(), given.low_frequency(), given.high_frequency());
    }
    case scene::Damping::kLocal:
      return {.local = damping.local().alpha()};
    case scene::Damping::KIND_NOT_SET:
      break;
  }
  throw UserError("continuum.damping",
                  "names no kind; give `rayleigh`, `maxwell` or `local`, or leave it out");
}

std::optional<std::string> note_on_ratio(const scene::Continuum& scene, const DampingLaw& law) {
  constexpr double kLittle = 0.05;
  if (!scene.damping().has_rayleigh()) return std::nullopt;
  const scene::RayleighDamping& given = scene.damping().rayleigh();
  const double low = given.low_frequency(), high = given.high_frequency(), middle = std::sqrt(low * high);
  if (damping_ratio(law, middle) >= (1 - kLittle) * given.ratio()) return std::nullopt;
  return fmt::format(
      "damping.rayleigh: the ratio is {:.3g} at {:g} Hz, {:.3g} at {:.3g} Hz and {:.3g} at {:g} Hz; "
      "damping.maxwell keeps one ratio over a band",
      damping_ratio(law, low), low, damping_ratio(law, middle), middle, damping_ratio(law, high), high);
}

std::optional<std::string> note_on_stiffening(const scene::Continuum& scene, const DampingLaw& law) {
  if (!scene.damping().has_maxwell()) return std::nullopt;
  const scene::MaxwellDamping& given = scene.damping().maxwell();
  return fmt::format(
      "damping.maxwell: the ground is {:.3g} % stiffer in waves of {:g} Hz than under slow loads, "
      "and {:.3g} % in those of {:g} Hz; state a modulus that is lower by as much where it was "
      "measured by waves",
      100 * (stiffening(law, given.low_frequency()) - 1), given.low_frequency(),
      100 * (stiffening(law, given.high_frequency()) - 1), given.high_frequency());
}

std::optional<std::string> note_on_shared_motion(const DampingLaw& law, const motion::Motion& base) {
  constexpr double kLittle = 0.05;
  if (law.alpha == 0 || base.acceleration.empty()) return std::nullopt;
  const motion::Peaks peaks = motion::peaks(base);
  if (law.alpha * peaks.velocity <= kLittle * peaks.acceleration) return std::nullopt;
  return fmt::format(
      "damping.rayleigh: its part of the masses also brakes the motion that all the ground shares, by up to "
      "{:.2g} m/s^2 at the base's {:.2g} m/s, {:.0f} % of the base's largest acceleration; strains of the "
      "ground are as far from those of its material damping: choose damping.maxwell, or a much lower "
      "low_frequency",
      law.alpha * peaks.velocity, peaks.velocity, 100 * law.alpha * peaks.velocity / peaks.acceleration);
}

}  // namespace adit::fdm
