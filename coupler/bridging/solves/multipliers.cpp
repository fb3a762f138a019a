#include "coupler/bridging/solves/multipliers.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "coupler/bridging/solves/consistent.hpp"
#include "coupler/bridging/solves/lumped.hpp"
#include "coupler/bridging/solves/split.hpp"
#include "protocol/errors.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::coupler {
namespace {

using protocol::UserError;

void require_free(std::span<const double> fine_masses) {
  if (!std::ranges::all_of(fine_masses, [](double mass) { return std::isfinite(mass); }))
    throw UserError("interface.overlap",
                    "contains a particle whose motion is prescribed, which the coupling cannot change; move "
                    "the overlap or the prescribed motion");
}

// Checks that the grid is not finer than the points that it is to follow. A coarse point is tied by each
// coupling point whose row of N has an entry for it. In the plane a grid point is a corner of four zones:
// with one coupling point in each zone it is tied four times, and with zones half as large as the distance
// between coupling points about once. Then the constraint falls apart into ties of single points: it can be
// solved, but most motions of the coarse side are free in the overlap. The factor leaves room for the edges
// of narrow overlaps, and very few points are not judged. A coarse point that is itself a coupling point is
// tied fully, so models with matching points are well posed.
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
