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
  constexpr int kMost = 60;
  constexpr double kSame = 1e-10;  // of the largest force
  constexpr double kShortest = 1.0 / 64;
  constexpr int kPatience = 3;  // trials that do not halve what is missed: rounding is left
  double halved = std::numeric_limits<double>::infinity();
  int in_vain = 0;
  double missed_before = std::numeric_limits<double>::infinity();
  for (int trial = 0; trial < kMost; ++trial) {
    take_tangents();
    average_.accelerate(forces);
    std::vector<Tried> there(at_.size());
    double missed = go(1, there);
    for (double way = 0.5; missed >= missed_before && way >= kShortest; way /= 2) missed = go(way, there);
    at_ = std::move(there);
    if (missed <= kSame * largest()) break;
    if (missed < halved / 2) {
      halved = missed;
      in_vain = 0;
    } else if (++in_vain == kPatience) {
      break;
    }
    missed_before = missed;
  }
  std::vector<std::array<double, 2>> leads;
  for (const Tried& one : at_) leads.push_back(one.lead);
  return leads;
}

void ContactBalance::take_tangents() {
  for (std::size_t k = 0; k < at_.size(); ++k) {
    const auto& [normal, shear, of_normal, of_shear] = at_[k].bearing;
    MeanAcceleration::Bears& tangent = tangents_[k];
    tangent = {{0, 0}, {of_normal.by_normal, of_shear.by_shear}, {of_normal.by_shear, of_shear.by_normal}};
    const auto by_lead = tangent.at(at_[k].lead);
    tangent.load = {normal - by_lead[0], shear - by_lead[1]};
    average_.bear(first_strain_ + 2 * k, tangent);
  }
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
