#include "simplified/zoom/window.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "protocol/errors.hpp"
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

}  // namespace

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

}  // namespace adit::simplified
