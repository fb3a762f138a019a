#include "simplified/zoom/window.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "protocol/errors.hpp"
#include "protocol/results/csv.hpp"
#include "simplified/scene/along_chainage.hpp"

namespace adit::simplified {
namespace {

// The history at one place.
std::vector<double> along_time(const Fields& fields, const std::vector<double>& table, std::size_t place) {
  std::vector<double> values;
  for (std::size_t n = 0; n < fields.time.size(); ++n)
    values.push_back(table[n * fields.chainage.size() + place]);
  return values;
}

Edge edge(const Fields& fields, double chainage) {
  const std::size_t place = nearest(fields.chainage, chainage);
  return {fields.chainage[place], along_time(fields, fields.axial_velocity, place),
          along_time(fields, fields.lateral_velocity, place), along_time(fields, fields.spin, place)};
}

std::string table_of(const std::string& name, const char* end) {
  return name + "_" + end + ".csv";
}

void write(const std::filesystem::path& path, const std::vector<double>& time, const Edge& edge) {
  const std::array<std::string, 4> columns = {"time_s", "vx_m_per_s", "vy_m_per_s", "spin_rad_per_s"};
  results::CsvFile file(path, columns);
  for (std::size_t n = 0; n < time.size(); ++n)
    file.row(std::array{time[n], edge.axial[n], edge.lateral[n], edge.spin[n]});
}

}  // namespace

Window window(const Fields& fields, double chainage, double width) {
  const double first = fields.chainage.front(), last = fields.chainage.back();
  if (width > last - first)
    throw protocol::UserError(
        "simplified.zoom.width",
        fmt::format("is {:g} m, more than the {:g} m of the tunnel", width, last - first));
  const double wanted = std::clamp(chainage - width / 2, first, last - width);
  return {fields.time, edge(fields, wanted), edge(fields, wanted + width)};
}

scene::Scene fragment(const Window& window, const std::string& name, double duration) {
  scene::Scene scene;
  scene.mutable_time()->set_duration(duration);
  // All grid points beyond an edge move as the section does there.
  const auto add = [&](const char* end, const Edge& edge) -> scene::Area& {
    scene::GridMotion& motion = *scene.mutable_continuum()->add_motions();
    motion.mutable_body()->mutable_centre()->set_x(edge.chainage);
    motion.mutable_body()->mutable_centre()->set_y(0);
    motion.mutable_body()->set_path(table_of(name, end));
    return *motion.mutable_where();
  };
  add("begin", window.begin).set_x_max(window.begin.chainage);
  add("end", window.end).set_x_min(window.end.chainage);
  return scene;
}

void write_edges(const std::filesystem::path& directory, const std::string& name, const Window& window) {
  write(directory / table_of(name, "begin"), window.time, window.begin);
  write(directory / table_of(name, "end"), window.time, window.end);
}

}  // namespace adit::simplified
