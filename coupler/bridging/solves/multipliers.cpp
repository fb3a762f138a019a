#include "coupler/bridging/solves/multipliers.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "coupler/bridging/solves/consistent.hpp"
#include "coupler/bridging/solves/lumped.hpp"
#include "coupler/bridging/solves/split.hpp"
#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

using protocol::UserError;

void require_free(std::span<const double> fine_masses) {
  if (!std::ranges::all_of(fine_masses, [](double mass) { return std::isfinite(mass); }))
    throw UserError(
        "interface.overlap",
        "holds a point whose motion is prescribed, so that both would fight for its velocity; move "
        "the overlap or the motion");
}

// A coarse point is held by the coupling points that see it (an entry of N that is not 0). In a plane each
// zone's corner is seen from four zones: with one coupling point in each zone it is seen four times, with
// zones half as large as the distance of the coupling points about once. Then the constraint falls apart into
// ties of single points: it is solvable, but most motions of the coarse side end freely in the overlap. The
// factor leaves room for the edges of narrow overlaps; of very few points nothing can be said. A coarse point
// that is a coupling point itself is held fully: models with matching points are well posed.
void require_coarse(const Interpolation& coarse) {
  constexpr double kLeastSightings = 4.0 / 3.0;
  constexpr std::size_t kFew = 4;
  std::vector<bool> held(coarse.own_points()), seen(coarse.own_points());
  for (std::size_t k = 0; k < coarse.coupling_points(); ++k)
    if (coarse.columns(k).size() == 1) held[coarse.columns(k)[0]] = true;
  std::size_t sightings = 0;
  for (std::size_t k = 0; k < coarse.coupling_points(); ++k)
    for (std::size_t e = 0; e < coarse.columns(k).size(); ++e)
      if (coarse.values(k)[e] != 0 && !held[coarse.columns(k)[e]]) {
        ++sightings;
        seen[coarse.columns(k)[e]] = true;
      }
  const auto points = static_cast<std::size_t>(std::ranges::count(seen, true));
  if (coarse.coupling_points() >= kFew && sightings < kLeastSightings * points)
    throw UserError(
        "interface.overlap",
        fmt::format("has only {} coupling points for {} points of the grid between them: the grid is "
                    "finer than the points that it is to follow; make its zones at least as large "
                    "as their distance",
                    coarse.coupling_points(), points));
}

}  // namespace

std::unique_ptr<MultiplierSolve> make_multiplier_solve(scene::Solve kind, const Interpolation& coarse,
                                                       std::span<const double> fine_masses,
                                                       std::span<const double> decay) {
  require_free(fine_masses);
  require_coarse(coarse);
  if (kind == scene::LUMPED) return std::make_unique<LumpedSolve>(coarse, fine_masses);
  if (kind == scene::SPLIT) return std::make_unique<SplitSolve>(coarse, fine_masses, decay);
  return std::make_unique<ConsistentSolve>(coarse, fine_masses);
}

}  // namespace adit::coupler
