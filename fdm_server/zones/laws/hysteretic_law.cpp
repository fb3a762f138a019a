#include "fdm_server/zones/laws/hysteretic_law.hpp"

#include <algorithm>
#include <limits>

namespace adit::fdm {

HystereticLaw::HystereticLaw(const Elasticity& elasticity, const IwanElements& chain, std::size_t zones,
                             bool large_strain)
    : ZoneLaw(elasticity), stiffness_(chain.stiffness), limit_(chain.limit), axes_(zones, large_strain) {
  const std::size_t whole = (chain.limit.size() + kElementBlock - 1) / kElementBlock * kElementBlock;
  stiffness_.resize(whole, 0.0);
  limit_.resize(whole, std::numeric_limits<double>::infinity());
  const std::size_t groups = (zones + kGroup - 1) / kGroup;
  strains_.resize(9 * groups);
  paths_.resize(groups);
  wakes_.resize(whole / kElementBlock * groups);
  flows_.resize(kElementValues * whole * groups);
}

void HystereticLaw::advance(const LawStep& step) {
  const std::size_t last = step.first + step.count;
  for (std::size_t from = step.first; from < last;) {
    const std::size_t to = std::min((from / kGroup + 1) * kGroup, last);
    advance_group(step, from, to);
    from = to;
  }
}

// Zones `from` … `to`, which are of one group.
void HystereticLaw::advance_group(const LawStep& step, std::size_t from, std::size_t to) {
  const auto& [mean, across, difference, shear] = step.stresses;
  const double bulk = elasticity_.bulk, modulus = elasticity_.shear;
  const std::size_t number = from / kGroup;
  GroupStep group;
  group.begin = from - number * kGroup;
  group.end = to - number * kGroup;
  const std::size_t at = from - step.first;  // the first one's place in the batch
  for (std::size_t l = group.begin, i = at; l < group.end; ++l, ++i) {
    const std::size_t zone = step.first + i;
    const double cosine = axes_.cosine(zone), sine = axes_.sine(zone);
    for (std::size_t k = 0; k < 4; ++k) {
      const double d = step.strains.difference[k][i], s = step.strains.shear[k][i];
      group.growth[k][l] = cosine * d + sine * s;
      group.growth[4 + k][l] = cosine * s - sine * d;
    }
    group.growth[8][l] = (step.across ? 2 * step.across[i] : 0) - 2 * step.strains.volume[i] / 3;
  }
  fdm::advance_group({elements() / kElementBlock, stiffness_.data(), limit_.data()}, this->group(number),
                     group);
  for (std::size_t l = group.begin, i = at; l < group.end; ++l, ++i) {
    const std::size_t zone = step.first + i;
    const double cosine = axes_.cosine(zone), sine = axes_.sine(zone);
    double area = 0, deviator = 0, twice = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const double d = group.growth[k][l], s = group.growth[4 + k][l];
      difference[k][i] += modulus * (cosine * d - sine * s);
      shear[k][i] += modulus * (sine * d + cosine * s);
      area += step.areas[k][i];
      deviator += step.areas[k][i] * group.across[k][l];
      twice += step.areas[k][i] * group.twice[k][l];
    }
    deviator *= modulus / area;
    mean[i] += bulk * step.strains.volume[i] - deviator / 2;
    across[i] += bulk * step.strains.volume[i] + deviator;
    step.dissipated[i] += modulus * twice / 2;
  }
}

void HystereticLaw::exchange(state::Archive& archive) {
  archive("strains", std::span(strains_));
  archive("paths", std::span(paths_));
  archive("wakes", std::span(wakes_));
  archive("flows", std::span(flows_));
  axes_.exchange(archive);
}

// Of the elements and of the change of volume, and that of the initial stress over the strains since.
void HystereticLaw::find_energies(std::size_t first, std::uint32_t count, const PointValues& areas,
                                  const ConstStressView& stresses, BatchValues& energies) const {
  const double modulus = elasticity_.shear;
  GroupHeld held;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::size_t zone = first + i, number = zone / kGroup, l = zone % kGroup;
    const GroupValues* strain = &strains_[9 * number];
    if (i == 0 || l == 0)
      find_held({elements() / kElementBlock, stiffness_.data(), limit_.data()}, strain,
                &flows_[kElementValues * elements() * number], held);
    const double cosine = axes_.cosine(zone), sine = axes_.sine(zone), z = strain[8][l];
    const double across = stresses.across[i], mean = (2 * stresses.mean[i] + across) / 3;
    double sum = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const double difference = stresses.difference[k][i], shear = stresses.shear[k][i];
      const double initial_t = cosine * difference + sine * shear - modulus * held.stress[k][l];
      const double initial_s = cosine * shear - sine * difference - modulus * held.stress[4 + k][l];
      const double initial_z = across - mean - modulus * held.stress[8 + k][l];
      sum += areas[k][i] * (modulus * held.twice[k][l] / 2 +
                            (initial_t * strain[k][l] + initial_s * strain[4 + k][l] + 0.75 * initial_z * z) +
                            mean * mean / (2 * elasticity_.bulk));
    }
    energies[i] = sum;
  }
}

}  // namespace adit::fdm
