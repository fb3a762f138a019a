#include "dem_server/model/sample_points.hpp"

#include "dem_server/packing/meeting_place.hpp"

namespace adit::dem {

std::vector<double> sample_points(const Model& model) {
  std::vector<double> points;
  points.reserve(2 * (model.discs.size() + model.bonds.size()));
  for (std::size_t i = 0; i < model.discs.size(); ++i)
    points.insert(points.end(), {model.discs.x[i], model.discs.y[i]});
  for (const Bond& bond : model.bonds) {
    const auto [x, y] = meeting_place(model.discs, bond.first, bond.second);
    points.insert(points.end(), {x, y});
  }
  return points;
}

}  // namespace adit::dem
