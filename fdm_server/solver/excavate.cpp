#include <algorithm>

#include "fdm_server/solver/continuum.hpp"

namespace adit::fdm {

void Continuum::excavate(std::span<const std::uint32_t> zones, std::span<const double> masses,
                         std::vector<Load> loads, std::uint32_t stage) {
  std::vector<bool> gone(zones_.count(), false);
  for (const auto zone : zones) gone[zone] = true;
  zones_.remove(gone);
  for (std::size_t i = 0; i < masses.size(); ++i) {
    points_[kMass][i] = masses[i];
    for (const Field inverse : {kInverseMassX, kInverseMassY})
      if (points_[inverse][i] != 0) points_[inverse][i] = masses[i] > 0 ? 1 / masses[i] : 0;
    if (masses[i] == 0) points_[kVx][i] = points_[kVy][i] = 0;
  }
  for (Part* part : {&interface_, &interior_}) {
    part->loads.clear();
    for (auto& one : part->motions) one.mass = prescribed(one.motion).mass;
  }
  for (const Field steady : {kSteadyX, kSteadyY}) std::ranges::fill(points_[steady], 0.0);
  structures_.install(stage);
  place(std::move(loads));
  plan(of_interface());
}

}  // namespace adit::fdm
