#include "simplified/zoom/places.hpp"

#include <algorithm>
#include <array>

namespace adit::simplified {

std::vector<Place> largest_responses(const Response& response) {
  std::vector<Place> places;
  const auto joint = std::ranges::max_element(response.joints, {}, &JointResponse::opening);
  if (joint != response.joints.end()) places.push_back({"opening", "m", joint->chainage, joint->opening});
  const std::array<std::array<const char*, 3>, 3> wanted = {
      {{"moment", "moment_lateral", "N m"}, {"shear", "shear_lateral", "N"}, {"strain", "strain", ""}}};
  for (const auto& [name, envelope, unit] : wanted) {
    if (const Envelope* found = find(response, envelope)) {
      const Peak top = peak(response.chainage, *found);
      places.push_back({name, unit, top.chainage, top.value});
    }
  }
  return places;
}

}  // namespace adit::simplified
