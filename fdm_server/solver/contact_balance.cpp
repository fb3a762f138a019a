#include "fdm_server/solver/contact_balance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace adit::fdm {

ContactBalance::ContactBalance(const Contacts& contacts, const Contacts::Part& part, std::size_t first_strain,
                               MeanAcceleration& average)
    : contacts_(contacts),
      part_(part),
      first_strain_(first_strain),
      average_(average),
      tangents_(part.size()) {
  for (const auto i : part) {
    const auto& lead = contacts.lead(i);
    at_.push_back({lead, contacts.bear(i, lead), {0, 0}});
  }
}

std::vector<std::array<double, 2>> ContactBalance::find(const Actions& forces) {
  constexpr int kNewton = 6, kMost = 300;  // trials
  constexpr double kSame = 1e-10;          // of the largest force
  constexpr double kShortest = 1.0 / 64;
  // Contacts may bear next to nothing of what acts, as before a wave arrives.
  constexpr double kRounding = 1e-14;
  const double rounding = kRounding * average_.largest(forces);
  double missed_before = std::numeric_limits<double>::infinity();
  for (int trial = 0; trial < kMost; ++trial) {
    const bool newton = trial < kNewton;
    newton ? take_tangents() : take_stiffest();
    average_.accelerate(forces);
    std::vector<Tried> there(at_.size());
    double missed = go(1, there);
    if (newton)
      for (double way = 0.5; missed >= missed_before && way >= kShortest; way /= 2) missed = go(way, there);
    at_ = std::move(there);
    if (missed <= std::max(kSame * largest(), rounding)) break;
    missed_before = missed;
  }
  std::vector<std::array<double, 2>> leads;
  for (const Tried& one : at_) leads.push_back(one.lead);
  return leads;
}

void ContactBalance::take(std::size_t k, MeanAcceleration::Bears tangent) {
  const auto by_lead = tangent.at(at_[k].lead), bears = at_[k].bears();
  tangent.load = {bears[0] - by_lead[0], bears[1] - by_lead[1]};
  tangents_[k] = tangent;
  average_.bear(first_strain_ + 2 * k, tangent);
}

void ContactBalance::take_tangents() {
  for (std::size_t k = 0; k < at_.size(); ++k) {
    const auto& [normal, shear, of_normal, of_shear] = at_[k].bearing;
    take(k, {{0, 0}, {of_normal.by_normal, of_shear.by_shear}, {of_normal.by_shear, of_shear.by_normal}});
  }
}

void ContactBalance::take_stiffest() {
  if (strains_.empty()) strains_ = contacts_.strains(part_);
  for (std::size_t k = 0; k < at_.size(); ++k)
    take(k, {{0, 0}, {strains_[2 * k].stiffness, strains_[2 * k + 1].stiffness}, {0, 0}});
}

ContactBalance::Tried ContactBalance::go(std::size_t k, double way) const {
  const Tried& from = at_[k];
  const std::size_t strain = first_strain_ + 2 * k;
  const std::array<double, 2> end{average_.lead(strain), average_.lead(strain + 1)};
  Tried there{};
  for (std::size_t along = 0; along < 2; ++along)
    there.lead[along] = from.lead[along] + way * (end[along] - from.lead[along]);
  there.bearing = contacts_.bear(part_[k], there.lead);
  const auto bore = from.bears(), by_tangent = tangents_[k].at(end), bears = there.bears();
  for (std::size_t along = 0; along < 2; ++along)
    there.missed[along] =
        (1 - way) * (from.missed[along] + bore[along]) + way * by_tangent[along] - bears[along];
  return there;
}

double ContactBalance::go(double way, std::vector<Tried>& there) const {
  double missed = 0;
  for (std::size_t k = 0; k < at_.size(); ++k) {
    there[k] = go(k, way);
    for (const double force : there[k].missed) missed = std::max(missed, std::abs(force));
  }
  return missed;
}

double ContactBalance::largest() const {
  double largest = 0;
  for (const Tried& one : at_)
    for (const double force : one.bears()) largest = std::max(largest, std::abs(force));
  return largest;
}

}  // namespace adit::fdm
