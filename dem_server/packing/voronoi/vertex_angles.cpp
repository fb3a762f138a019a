#include "dem_server/packing/voronoi/vertex_angles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace adit::dem {
namespace {

constexpr double kNarrow = 1.4;                          // of the narrowest sector
constexpr double kBlunt = 150 * std::numbers::pi / 180;  // has room for two nuclei
constexpr double kLeastRest = 0.25;                      // of the narrowest sector
constexpr double kTheSame = 1e-10;                       // [rad]

// Writes the angles of a run of rays with one nucleus in each sector between them. The first, x, gives the
// others: w_1 - x, w_2 - w_1 + x, ... The least of them is as large as possible; but a run of an odd number
// of rays that closes around the vertex has one x. A ray alone has a quarter of the narrower sector beside
// it.
void set_run(const std::vector<double>& sectors, std::size_t first, std::size_t rays, bool closes,
             std::vector<double>& beside) {
  const std::size_t count = sectors.size();
  const auto at = [&](std::size_t k) -> double& { return beside[(first + k) % count]; };
  double least_plus = 0, least_minus = std::numeric_limits<double>::infinity();
  at(0) = 0;
  for (std::size_t k = 1; k < rays; ++k) {
    at(k) = sectors[(first + k - 1) % count] - at(k - 1);
    double& least = k % 2 == 0 ? least_plus : least_minus;
    least = std::min(least, at(k));
  }
  double x = (least_minus - least_plus) / 2;
  if (rays == 1) x = std::min(sectors[first % count], sectors[(first + count - 1) % count]) / 4;
  if (closes && rays % 2 == 1) x = (sectors[(first + rays - 1) % count] - at(rays - 1)) / 2;
  for (std::size_t k = 0; k < rays; ++k) at(k) += k % 2 == 0 ? x : -x;
}

}  // namespace

std::vector<bool> sectors_with_one_nucleus(const std::vector<double>& sectors) {
  const double wide = std::min(kNarrow * *std::ranges::min_element(sectors), kBlunt);
  std::vector<bool> narrow, none(sectors.size(), false);
  for (const double sector : sectors) narrow.push_back(sector < wide);
  const auto least = [&](const std::vector<bool>& with_one) {
    return least_between_nuclei(sectors, angles_beside_rays(sectors, with_one));
  };
  return least(narrow) > least(none) ? narrow : none;
}

std::vector<double> angles_beside_rays(const std::vector<double>& sectors,
                                       const std::vector<bool>& with_one) {
  const std::size_t count = sectors.size();
  std::size_t first = 0;  // the first ray after a sector with two nuclei
  while (first < count && with_one[(first + count - 1) % count]) ++first;
  const bool closes = first == count;
  std::vector<double> beside(count);
  for (std::size_t done = 0, rays; done < count; done += rays) {
    rays = 1;
    while (done + rays < count && with_one[(first + done + rays - 1) % count]) ++rays;
    set_run(sectors, first + done, rays, closes, beside);
  }
  const double narrowest = *std::ranges::min_element(sectors);
  if (closes && least_between_nuclei(sectors, beside) < kLeastRest * narrowest)
    return angles_beside_rays(sectors, std::vector<bool>(count, false));
  return beside;
}

double least_between_nuclei(const std::vector<double>& sectors, const std::vector<double>& beside) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < sectors.size(); ++k) {
    const double apart = sectors[k] - beside[k] - beside[(k + 1) % sectors.size()];
    least = std::min(least, 2 * beside[k]);
    if (std::abs(apart) > kTheSame) least = std::min(least, apart);
  }
  return least;
}

}  // namespace adit::dem
