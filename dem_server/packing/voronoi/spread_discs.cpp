#include "dem_server/packing/voronoi/spread_discs.hpp"

#include <algorithm>
#include <cmath>

namespace adit::dem {
namespace {

// Shares of the size.
constexpr double kLeastOffset = 0.12;  // of nuclei from the face
constexpr double kSpacing = 0.866;     // cells size deep then have the area of a hexagonal one
constexpr double kStepOfSum = 0.125;   // in which the spacing is summed up

constexpr double kOffsetOfRoom = 0.25;      // two nuclei side by side share the room between two faces
constexpr double kSpacingOfOffset = 2.6;    // at most
constexpr double kJitter = 0.15;            // of the spacing
constexpr double kJitterOfFlatness = 0.45;  // the offset then varies alike where nuclei are close to a face

}  // namespace

// Where faces meet, smaller cells would not help.
double DiscSpacing::offset(const Path::Place& place) const {
  const double of_room = kOffsetOfRoom * room_.at(place.point, place.normal, face_);
  const double most = most_offset(place.point);
  return of_room < 2 * kLeastOffset * most ? most : std::min(of_room, most);
}

double DiscSpacing::spacing(const Path::Place& place, double offset) const {
  return std::min(kSpacing * size_.at(place.point), kSpacingOfOffset * offset);
}

// The number of spacings that have passed grows along the way as 1 / spacing; the places are where it passes
// whole numbers, each moved at random.
std::vector<double> DiscSpacing::spread(const Path& path, const DiscSpan& span,
                                        motion::Random& random) const {
  const double length = span.to - span.from;
  const auto steps =
      static_cast<std::size_t>(std::ceil(std::max(length / (kStepOfSum * size_.least()), 1.0)));
  const double step = length / static_cast<double>(steps);
  std::vector<double> passed{0}, flatness;  // flatness: offset over spacing
  for (std::size_t k = 0; k < steps; ++k) {
    const Path::Place place = path.at(span.from + (static_cast<double>(k) + 0.5) * step);
    const double beside = offset(place), apart = spacing(place, beside);
    flatness.push_back(beside / apart);
    passed.push_back(passed.back() + step / apart);
  }
  const double whole = std::round(passed.back() - span.first - span.last) + 1;
  const auto count = static_cast<std::size_t>(std::max(whole, static_cast<double>(span.fewest)));
  if (count == 0) return {};
  const double stretch = passed.back() / (static_cast<double>(count) - 1 + span.first + span.last);
  const auto step_at = [&](double number) {
    return static_cast<std::size_t>(std::upper_bound(passed.begin() + 1, passed.end() - 1, number) -
                                    passed.begin() - 1);
  };
  std::vector<double> places;
  for (std::size_t k = 0; k < count; ++k) {
    double number = stretch * (static_cast<double>(k) + span.first);
    const double flat = flatness[step_at(number)];
    const double shift =
        stretch * std::min(kJitter, kJitterOfFlatness * flat * flat) * (2 * random.uniform() - 1);
    const bool fixed = (k == 0 && span.first_fixed) || (k + 1 == count && span.last_fixed);
    if (!fixed) number += shift;
    const std::size_t in = step_at(number);
    places.push_back(
        span.from + step * (static_cast<double>(in) + (number - passed[in]) / (passed[in + 1] - passed[in])));
  }
  return places;
}

}  // namespace adit::dem
