#include <array>
#include <cmath>

#include "protocol/results/csv.hpp"
#include "simplified/scene/along_chainage.hpp"
#include "simplified/zoom/plan_scene.hpp"

namespace adit::simplified {
namespace {

// Straight lines between places and times as close together miss a wave of 100 m, or of 10 Hz, by 5 and 2 %.
constexpr double kPlaceGap = 10, kTimeGap = 0.01;  // [m], [s]

std::vector<double> places_between(double begin, double end) {
  const int gaps = static_cast<int>(std::ceil((end - begin) / kPlaceGap));
  std::vector<double> places;
  for (int k = 0; k <= gaps; ++k) places.push_back(begin + (end - begin) * k / gaps);
  return places;
}

}  // namespace

void write_ground_along(const std::filesystem::path& path, const GroundField& ground, double dt,
                        const Window& window) {
  const std::array<std::string, 4> columns = {"time_s", "x_m", "vx_m_per_s", "vy_m_per_s"};
  results::CsvFile file(path, columns);
  const std::vector<double> places = places_between(window.begin.chainage, window.end.chainage);
  AlongChainage along(ground.chainage, places);
  std::array<std::vector<double>, 2> now{std::vector<double>(places.size()),
                                         std::vector<double>(places.size())};
  const auto every = static_cast<std::size_t>(std::max(1.0, std::floor(kTimeGap / dt + 1e-9)));
  const std::size_t count = ground.chainage.size();
  const auto rows = [&](Direction direction) { return ground.shaking[direction].velocity.size() / count; };
  for (std::size_t n = 0; n < std::max(rows(kAxial), rows(kLateral)); n += every) {
    for (const Direction direction : {kAxial, kLateral})
      if (rows(direction) > 0)
        along.interpolate(ground.shaking[direction].velocity.data() + n * count, now[direction].data());
    for (std::size_t k = 0; k < places.size(); ++k)
      file.row(std::array{static_cast<double>(n) * dt, places[k], now[0][k], now[1][k]});
  }
}

void write_joint(const std::filesystem::path& path, const Fields& fields, const JointCourse& course) {
  const std::array<std::string, 7> columns = {"time_s",        "opening_m", "offset_m", "rotation_rad",
                                              "axial_force_N", "shear_N",   "moment_Nm"};
  results::CsvFile file(path, columns);
  for (std::size_t n = 0; n < fields.time.size(); ++n)
    file.row(std::array{fields.time[n], course.opening[n], course.offset[n], course.rotation[n],
                        course.axial_force[n], course.shear[n], course.moment[n]});
}

}  // namespace adit::simplified
