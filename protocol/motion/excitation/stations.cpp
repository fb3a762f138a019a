#include "protocol/motion/excitation/stations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "protocol/errors.hpp"
#include "protocol/motion/excitation/coherency.hpp"
#include "protocol/motion/processing/processing.hpp"

namespace adit::motion {
namespace {

using protocol::UserError;

constexpr double kMostValues = 1e9;  // for all stations together: 8 GB

void check_excitation(std::span<const double> chainages, const NonUniform& excitation) {
  if (chainages.empty()) throw UserError("", "there are no stations; give at least one chainage");
  for (std::size_t i = 0; i < chainages.size(); ++i)
    if (!std::isfinite(chainages[i]))
      throw UserError(
          "", fmt::format("the chainage of station {} is {}; give a finite one", i + 1, chainages[i]));
  if (excitation.apparent_velocity == 0 || std::isnan(excitation.apparent_velocity))
    throw UserError(
        "", fmt::format("the apparent velocity is {}; give one other than 0, or `inf` for all stations at "
                        "once",
                        excitation.apparent_velocity));
  if (!(excitation.drift >= 0 && std::isfinite(excitation.drift)))
    throw UserError("",
                    fmt::format("the drift of the coherency is {} s/m; give 0 or more", excitation.drift));
}

}  // namespace

std::vector<Motion> station_motions(const Motion& motion, std::span<const double> chainages,
                                    const NonUniform& excitation) {
  check(motion);
  check_excitation(chainages, excitation);
  std::vector<double> delays;
  for (const double chainage : chainages) delays.push_back(chainage / excitation.apparent_velocity);
  const auto [first, last] = std::ranges::minmax_element(delays);
  const double earliest = *first;
  const double longer = std::ceil((*last - earliest) / motion.dt - 1e-9);
  const double values = static_cast<double>(motion.acceleration.size()) + std::max(0.0, longer);
  if (!(values * static_cast<double>(chainages.size()) <= kMostValues))
    throw UserError(
        "", fmt::format("the wave needs {:.6g} s from the first station to the last, too long to keep all "
                        "motions; give a larger apparent velocity",
                        *last - earliest));

  const auto reference = static_cast<std::size_t>(first - delays.begin());
  std::vector<Motion> motions = excitation.drift > 0 ? incoherent_motions(motion, chainages, reference,
                                                                          excitation.drift, excitation.seed)
                                                     : std::vector<Motion>(chainages.size(), motion);
  for (std::size_t j = 0; j < motions.size(); ++j)
    motions[j] = delayed(motions[j], delays[j] - earliest, static_cast<std::size_t>(values));
  return motions;
}

}  // namespace adit::motion
