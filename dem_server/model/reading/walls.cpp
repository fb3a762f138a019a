#include "dem_server/model/reading/walls.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "dem_server/model/reading/conditions.hpp"
#include "protocol/errors.hpp"
#include "protocol/text.hpp"

namespace adit::dem {

using protocol::UserError;

std::vector<MovingWall> read_walls(const scene::Particles& particles, const Group& own) {
  std::vector<MovingWall> walls;
  for (int k = 0; k < particles.walls_size(); ++k) {
    const auto& wall = particles.walls(k);
    const std::string path = "particles.walls[" + std::to_string(k) + "]";
    if (std::ranges::find(walls, wall.name(), &MovingWall::name) != walls.end())
      throw UserError(path + ".name", fmt::format("is {}, as that of an earlier wall; give each its own",
                                                  protocol::quote(wall.name())));
    if (wall.from().x() == wall.to().x() && wall.from().y() == wall.to().y())
      throw UserError(path + ".to", "is the same place as `from`; give a wall two ends");
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

}  // namespace adit::dem
