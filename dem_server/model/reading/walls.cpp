#include "dem_server/model/reading/walls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dem_server/model/nearest_on_wall.hpp"
#include "dem_server/model/placement/scene_checks.hpp"
#include "dem_server/model/reading/conditions.hpp"
#include "protocol/errors.hpp"
#include "protocol/text.hpp"

namespace adit::dem {

using protocol::UserError;

namespace {

constexpr double kTouching = 1e-6;  // of a radius: gaps below are none

double distance(const MovingWall& wall, double x, double y) {
  const auto [to_x, to_y] = to_wall(wall, x - wall.x_1, y - wall.y_1);
  return std::hypot(to_x, to_y);
}

}  // namespace

std::vector<MovingWall> read_walls(const scene::Particles& particles, const Group& own) {
  std::vector<MovingWall> walls;
  for (int k = 0; k < particles.walls_size(); ++k) {
    const auto& wall = particles.walls(k);
    const std::string path = "particles.walls[" + std::to_string(k) + "]";
    if (std::ranges::find(walls, wall.name(), &MovingWall::name) != walls.end())
      throw UserError(path + ".name", fmt::format("is {}, as that of an earlier wall; give each its own",
                                                  protocol::quote(wall.name())));
    require_two_ends(wall.from(), wall.to(), path, "wall");
    const LinearContact contact =
        wall.has_contacts() ? read_contact(wall.contacts(),
                                           [&own] {
                                             const LinearContact law = own.contact();
                                             return BondStiffness{law.normal_stiffness, law.shear_stiffness};
                                           })
                            : own.contact();
    walls.push_back({wall.name(), wall.from().x(), wall.from().y(), wall.to().x(), wall.to().y(), contact,
                     wall.velocity().x(), wall.velocity().y(), factor_of(wall.velocity().time())});
  }
  return walls;
}

void refuse_walls_that_bear(const Model& model) {
  const Discs& d = model.discs;
  for (std::size_t k = 0; k < model.walls.size(); ++k)
    for (std::size_t i = 0; i < d.size(); ++i) {
      if (!model.is_there(i) || distance(model.walls[k], d.x[i], d.y[i]) > (1 + kTouching) * d.radius[i])
        continue;
      throw UserError(fmt::format("particles.walls[{}]", k),
                      fmt::format("touches the particle at ({:.6g}, {:.6g}) m, and a wall cannot bear its "
                                  "part of initial_stress; hold the outermost particles by "
                                  "particles.motions instead, or move the wall away from them",
                                  d.x[i], d.y[i]));
    }
}

}  // namespace adit::dem
