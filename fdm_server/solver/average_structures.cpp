#include <algorithm>

#include "fdm_server/solver/contact_balance.hpp"
#include "fdm_server/solver/continuum.hpp"

namespace adit::fdm {

void Continuum::average_structures(const protocol::Step& step) {
  for (const auto& [freedom, motion] : driven_) {
    const Prescribed& driver = interior_.motions[motion];
    average_->prescribe(freedom, (driver.after - driver.before) / step.dt);
  }
  const Actions forces{points_[kFx].data(), points_[kFy].data(), structures_.couples().data()};
  const PointView points{points_[kVx].data(), points_[kVy].data(), points_[kFx].data(), points_[kFy].data()};
  contacts_.settle_pairs(contact_pairs_, step, points_[kInverseMassX], points);
  if (averaged_contacts_.empty()) {
    average_->accelerate(forces);
  } else {
    contacts_.move(averaged_contacts_, step.dt, step.from_rest(), points);
    const auto leads =
        ContactBalance(contacts_, averaged_contacts_, first_contact_strain_, *average_).find(forces);
    for (std::size_t k = 0; k < leads.size(); ++k) contacts_.follow(averaged_contacts_[k], leads[k], points);
  }
  average_->add_forces(forces);
}

void Continuum::plan_average(double dt) {
  std::vector<bool> known_early(points_.size(), false);
  for (const Dashpot& dashpot : interior_.dashpots) known_early[dashpot.point] = true;
  for (const foundation::Springs& springs : interior_.foundations) springs.mark(known_early);
  Structures::Part averaged = interior_.structures;
  structures_.take(averaged, known_early);
  averaged_contacts_ = interior_.contacts;
  moving_contacts_ = contacts_.take(averaged_contacts_, known_early);
  std::vector<StrainForm> strains = structures_.strains(averaged);
  std::vector<bool> shared(points_.size(), false);
  for (const StrainForm& strain : strains)
    for (const auto& [of, factor] : strain.shares)
      if (of.kind != Freedom::kRotation) shared[of.number] = true;
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (points_[kInverseMassX][i] == 0 || points_[kInverseMassY][i] == 0) shared[i] = true;
  contact_pairs_ = contacts_.take_pairs(averaged_contacts_, shared);
  first_contact_strain_ = strains.size();
  std::ranges::move(contacts_.strains(averaged_contacts_), std::back_inserter(strains));

  average_.emplace(strains, first_contact_strain_, dt, [this](const Freedom& freedom) {
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
