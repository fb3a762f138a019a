#include <algorithm>

#include "fdm_server/solver/continuum.hpp"

namespace adit::fdm {

void Continuum::average_structures(const protocol::Step& step) {
  if (!average_ || average_->dt() != step.dt) plan_average(step.dt);
  for (const auto& [freedom, motion] : driven_) {
    const Prescribed& driver = interior_.motions[motion];
    average_->prescribe(freedom, (driver.after - driver.before) / step.dt);
  }
  average_->add_forces({points_[kFx].data(), points_[kFy].data(), structures_.couples().data()});
}

void Continuum::plan_average(double dt) {
  std::vector<bool> known_early(points_.size(), false);
  for (const Dashpot& dashpot : interior_.dashpots) known_early[dashpot.point] = true;
  for (const foundation::Springs& springs : interior_.foundations) springs.mark(known_early);
  Structures::Part averaged = interior_.structures;
  structures_.take(averaged, known_early);

  average_.emplace(structures_.strains(averaged), dt, [this](const Freedom& freedom) {
    switch (freedom.kind) {
      case Freedom::kX:
        return points_[kInverseMassX][freedom.number];
      case Freedom::kY:
        return points_[kInverseMassY][freedom.number];
      default:
        return structures_.inverse_inertia(freedom.number);
    }
  });

  driven_.clear();  // held rotations are driven by nothing
  const auto prescribed = average_->prescribed();
  for (std::size_t freedom = 0; freedom < prescribed.size(); ++freedom)
    for (std::size_t k = 0; k < interior_.motions.size(); ++k) {
      const PrescribedMotion& motion = interior_.motions[k].motion;
      if (prescribed[freedom].kind == (motion.axis == Axis::kX ? Freedom::kX : Freedom::kY) &&
          std::ranges::binary_search(motion.points, prescribed[freedom].number))
        driven_.push_back({freedom, k});
    }
}

double Continuum::twice_kinetic_energy_of_average(const protocol::Step& step) const {
  if (!average_ || !averages(step)) return 0;
  const Motions after{points_[kVx].data(), points_[kVy].data(), structures_.rates().data()};
  const Motions before{points_[kLastVx].data(), points_[kLastVy].data(), structures_.rates_before().data()};
  // From rest the half step before the start mirrors the one after it, as for the points.
  return step.from_rest() ? -average_->twice_kinetic_energy(after, after)
                          : average_->twice_kinetic_energy(before, after);
}

}  // namespace adit::fdm
