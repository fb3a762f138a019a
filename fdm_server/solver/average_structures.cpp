#include <algorithm>
#include <cmath>
#include <limits>

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
  contacts_.move(averaged_contacts_, step.dt, step.from_rest(), points);
  if (averaged_contacts_.empty())
    average_->accelerate(forces);
  else
    average_contacts(points);
  average_->add_forces(forces);
}

// Newton's method for contacts that share points with others or with structures (interfaces/contacts.hpp).
// Where nothing changes between sticking, sliding and open, which is so for most contacts in
// most steps, one trial finds it.
void Continuum::average_contacts(const PointView& points) {
  constexpr int kMost = 60;
  constexpr double kSame = 1e-10;  // of the largest force
  const Actions forces{points_[kFx].data(), points_[kFy].data(), structures_.couples().data()};
  std::vector<std::array<double, 2>> leads;
  std::vector<Contacts::Bearing> bearings;
  for (const auto i : averaged_contacts_) {
    leads.push_back(contacts_.lead(i));
    bearings.push_back(contacts_.bear(i, leads.back()));
  }
  double missed_before = std::numeric_limits<double>::infinity();
  double part = 1;  // of the way to what is found: friction lags behind pressure, which may run in a circle
  for (int trial = 0; trial < kMost; ++trial) {
    for (std::size_t k = 0; k < leads.size(); ++k) {
      const auto& [normal, shear, of_normal, of_shear] = bearings[k];
      const std::size_t strain = first_contact_strain_ + 2 * k;
      average_->resist(strain, of_normal.by_normal);
      average_->resist(strain + 1, of_shear.by_shear);
      average_->load(strain, normal - average_->resistance(strain) * leads[k][0]);
      average_->load(strain + 1, shear - average_->resistance(strain + 1) * leads[k][1]);
    }
    average_->accelerate(forces);
    double missed = 0, largest = 0;
    for (std::size_t k = 0; k < leads.size(); ++k) {
      const std::size_t strain = first_contact_strain_ + 2 * k;
      std::array<double, 2> lead{average_->lead(strain), average_->lead(strain + 1)};
      for (std::size_t along = 0; along < 2; ++along)
        lead[along] = leads[k][along] + part * (lead[along] - leads[k][along]);
      const auto found = contacts_.bear(averaged_contacts_[k], lead);
      missed = std::max({missed, std::abs(found.normal - average_->bears(strain)),
                         std::abs(found.shear - average_->bears(strain + 1))});
      largest = std::max({largest, std::abs(found.normal), std::abs(found.shear)});
      leads[k] = lead;
      bearings[k] = found;
    }
    if (missed <= kSame * largest) break;
    if (missed > missed_before / 2) part = std::max(0.25, part / 2);
    missed_before = missed;
  }
  for (std::size_t k = 0; k < leads.size(); ++k) contacts_.follow(averaged_contacts_[k], leads[k], points);
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
