#include "protocol/foundation/read.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "protocol/errors.hpp"
#include "protocol/foundation/columns.hpp"
#include "protocol/motion/errors_at.hpp"

namespace adit::foundation {
namespace {

using protocol::UserError;

// The number of rows that the first time has.
std::size_t places_of(const std::vector<double>& time) {
  std::size_t places = 1;
  while (places < time.size() && time[places] == time[0]) ++places;
  return places;
}

void require_same_places(const std::vector<double>& time, const std::vector<double>& x, std::size_t places,
                         const std::string& file) {
  for (std::size_t row = 0; row < x.size(); ++row) {
    const std::size_t first = row / places * places;
    if (time[row] != time[first] || x[row] != x[row - first] || x.size() % places != 0)
      throw UserError(
          "", fmt::format("{}: the row of the time {:g} s and the place {:g} m does not go on as the {} "
                          "rows of the first time; give for each time the same places",
                          file, time[row], x[row], places));
  }
}

GroundCourse read_table(const scene::GroundAlongX& ground) {
  const std::array<std::string, 4> names{"time_s", "x_m", "vx_m_per_s", "vy_m_per_s"};
  auto columns = read_columns(ground.path(), ground.content(), names);
  const std::size_t places = places_of(columns[0]);
  require_same_places(columns[0], columns[1], places, ground.path());
  std::vector<double> time;
  for (std::size_t row = 0; row < columns[0].size(); row += places) time.push_back(columns[0][row]);
  columns[1].resize(places);
  return {std::move(time), std::move(columns[1]), std::move(columns[2]), std::move(columns[3]),
          ground.path()};
}

SpringLaw law_of(const scene::FoundationSpring& spring) {
  return {spring.stiffness(), spring.dashpot(), spring.slip_stress(), spring.hardening()};
}

}  // namespace

std::vector<DirectedLaw> read_laws(const scene::Foundation& foundation, const std::string& path) {
  std::vector<DirectedLaw> laws;
  if (foundation.has_x()) laws.push_back({Direction::kX, law_of(foundation.x())});
  if (foundation.has_y()) laws.push_back({Direction::kY, law_of(foundation.y())});
  if (laws.empty())
    throw protocol::UserError(
        path, "has springs in no direction; give `x` or `y`, such as `y: {stiffness: 4 MPa/m}`");
  return laws;
}

std::shared_ptr<const GroundCourse> read_ground(const scene::Foundation& foundation,
                                                const std::string& path) {
  if (!foundation.has_ground()) return std::make_shared<const GroundCourse>();
  return motion::errors_at(path + ".ground.path", [&] {
    return std::make_shared<const GroundCourse>(read_table(foundation.ground()));
  });
}

}  // namespace adit::foundation
