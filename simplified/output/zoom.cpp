#include "simplified/output/zoom.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>

#include "protocol/errors.hpp"
#include "protocol/results/csv.hpp"
#include "protocol/scene/writer.hpp"
#include "simplified/scene/nearest.hpp"

namespace adit::simplified {
namespace {

// The history at one place.
std::vector<double> along_time(const Fields& fields, const std::vector<double>& table, std::size_t place) {
  std::vector<double> values;
  for (std::size_t n = 0; n < fields.time.size(); ++n)
    values.push_back(table[n * fields.chainage.size() + place]);
  return values;
}

// All grid points beyond the edge move as the tunnel does at the edge.
void add_motion(scene::Continuum& continuum, const scene::Area& where, const scene::Velocity& direction,
                const std::vector<double>& time, const std::vector<double>& value) {
  scene::GridMotion& motion = *continuum.add_motions();
  *motion.mutable_where() = where;
  *motion.mutable_velocity() = direction;
  auto& table = *motion.mutable_time()->mutable_table();
  table.mutable_time()->Add(time.begin(), time.end());
  table.mutable_value()->Add(value.begin(), value.end());
}

void write_motions(const std::filesystem::path& path, const Window& window) {
  const std::array<std::string, 5> columns = {"time_s", "begin_vx_m_per_s", "begin_vy_m_per_s",
                                              "end_vx_m_per_s", "end_vy_m_per_s"};
  results::CsvFile file(path, columns);
  for (std::size_t n = 0; n < window.time.size(); ++n)
    file.row(std::array{window.time[n], window.begin_axial[n], window.begin_lateral[n], window.end_axial[n],
                        window.end_lateral[n]});
}

void write_fragment(const std::filesystem::path& path, const Place& place, const Window& window,
                    double duration) {
  std::ofstream file(path);
  file << fmt::format(
              "# The tunnel from {} to {} m, around the largest {} of the run, {:.4g} {} at {:g} m: the "
              "motion of "
              "both edges, which do not turn.\n"
              "# Not yet a scene: write one with `extends: <this file>`, a material, and models over these "
              "chainages.\n",
              window.begin, window.end, place.name, place.value, place.unit, place.chainage)
       << protocol::to_yaml(fragment(window, duration));
}

}  // namespace

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

Window window(const Fields& fields, double chainage, double width) {
  const double first = fields.chainage.front(), last = fields.chainage.back();
  if (width > last - first)
    throw protocol::UserError(
        "simplified.zoom.width",
        fmt::format("is {:g} m, more than the {:g} m of the tunnel", width, last - first));
  const double wanted = std::clamp(chainage - width / 2, first, last - width);
  const std::size_t begin = nearest(fields.chainage, wanted), end = nearest(fields.chainage, wanted + width);
  return {fields.chainage[begin],
          fields.chainage[end],
          fields.time,
          along_time(fields, fields.axial_velocity, begin),
          along_time(fields, fields.lateral_velocity, begin),
          along_time(fields, fields.axial_velocity, end),
          along_time(fields, fields.lateral_velocity, end)};
}

scene::Scene fragment(const Window& window, double duration) {
  scene::Scene scene;
  scene.mutable_time()->set_duration(duration);
  scene::Continuum& continuum = *scene.mutable_continuum();
  // A motion has one course in time for all components, so each direction of each edge is a motion of its
  // own.
  scene::Velocity axial, lateral;
  axial.set_x(1);
  lateral.set_y(1);
  scene::Area begin, end;
  begin.set_x_max(window.begin);
  end.set_x_min(window.end);
  add_motion(continuum, begin, axial, window.time, window.begin_axial);
  add_motion(continuum, begin, lateral, window.time, window.begin_lateral);
  add_motion(continuum, end, axial, window.time, window.end_axial);
  add_motion(continuum, end, lateral, window.time, window.end_lateral);
  return scene;
}

void write_zoom(const std::filesystem::path& directory, const Response& response, const scene::Zoom& zoom,
                double duration) {
  std::filesystem::create_directories(directory);
  for (const Place& place : largest_responses(response)) {
    const Window around = window(response.fields, place.chainage, zoom.width());
    write_motions(directory / (place.name + ".csv"), around);
    write_fragment(directory / (place.name + ".yaml"), place, around, duration);
  }
}

}  // namespace adit::simplified
