#include "coupler/bridging/multipliers.hpp"

#include "coupler/bridging/consistent.hpp"
#include "coupler/bridging/lumped.hpp"
#include "protocol/errors.hpp"

namespace adit::coupler {

std::unique_ptr<MultiplierSolve> make_multiplier_solve(scene::Solve kind, const Interpolation& continuum,
                                                       const Interpolation& particles) {
  if (!particles.is_selection())
    throw protocol::UserError("particles",
                              "has coupling points that are no particles of its own; the solves expect one "
                              "particle at each coupling point");
  for (std::size_t i = 0; i < particles.own_points(); ++i)
    if (particles.inverse_mass(i, 0) == 0 || particles.inverse_mass(i, 1) == 0)
      throw protocol::UserError(
          "interface.overlap",
          "holds a particle whose motion is prescribed, so that both would fight for its "
          "velocity; move the overlap or the motion");
  if (kind == scene::LUMPED) return std::make_unique<LumpedSolve>(continuum, particles);
  return std::make_unique<ConsistentSolve>(continuum, particles);
}

}  // namespace adit::coupler
