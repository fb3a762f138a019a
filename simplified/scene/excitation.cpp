#include "simplified/scene/excitation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "protocol/errors.hpp"
#include "protocol/motion/errors_at.hpp"
#include "protocol/motion/excitation/stations.hpp"
#include "protocol/motion/processing/processing.hpp"
#include "protocol/stop_signals.hpp"
#include "simplified/scene/liquefaction.hpp"
#include "simplified/scene/tunnel.hpp"

namespace adit::simplified {
namespace {

using motion::Motion;
using protocol::UserError;

void resize(Shaking& shaking, std::size_t places, std::size_t steps) {
  shaking.places = places;
  for (auto* table : {&shaking.displacement, &shaking.velocity, &shaking.acceleration})
    table->assign(places * (steps + 1), 0.0);
}

// The motions act on the tunnel's surroundings directly.
Shaking direct(const std::vector<Motion>& motions, double factor, std::size_t steps) {
  Shaking shaking;
  resize(shaking, motions.size(), steps);
  for (std::size_t p = 0; p < motions.size(); ++p) {
    const motion::Course path = motion::integrate(motions[p]);
    for (std::size_t n = 0; n <= steps; ++n) {
      const std::size_t at = n * motions.size() + p;
      shaking.displacement[at] = factor * path.displacement[n];
      shaking.velocity[at] = factor * path.velocity[n];
      shaking.acceleration[at] = factor * motions[p].acceleration[n];
    }
  }
  return shaking;
}

// The places whose shear stress raises the pressure of a layer; in columns without wet sand, the surface,
// which has none.
std::vector<column::JoinedColumns::Place> places_in_sand(const scene::Ground& scene, int layer,
                                                         const std::vector<column::Column>& columns,
                                                         const column::JoinedColumns& ground) {
  std::vector<column::JoinedColumns::Place> places;
  for (std::size_t j = 0; j < columns.size(); ++j) {
    const auto sand = wet_sand(scene, profile_at(scene, columns[j].chainage), layer);
    places.push_back(ground.place(j, sand ? sand->middle() : 0));
  }
  return places;
}

// The motions are those of the rock; soil columns transmit them to the depth of the tunnel.
Shaking through_ground(const scene::Simplified& scene, const std::vector<column::Column>& columns,
                       const std::vector<Motion>& motions, double factor, std::size_t steps,
                       const std::vector<int>& sands) {
  column::JoinedColumns ground(columns, scene.ground().joined(), motions[0].dt, "simplified.ground.profiles");
  std::vector<column::JoinedColumns::Place> places;
  for (std::size_t j = 0; j < columns.size(); ++j)
    places.push_back(ground.place(j, axis_depth(scene.tunnel(), columns[j].chainage)));
  std::vector<std::vector<column::JoinedColumns::Place>> in_sand;
  for (const int layer : sands) in_sand.push_back(places_in_sand(scene.ground(), layer, columns, ground));
  Shaking shaking;
  resize(shaking, columns.size(), steps);
  shaking.stress.assign(sands.size(), std::vector<double>(columns.size() * (steps + 1)));
  for (std::size_t n = 0; n <= steps; ++n)
    for (const Motion& motion : motions) shaking.rock.push_back(factor * motion.acceleration[n]);
  // Row 0 of the ground's motion stays zero: the columns begin at rest.
  for (std::size_t n = 1; n <= steps; ++n) {
    protocol::end_if_stopped();
    ground.step({shaking.rock.data() + n * columns.size(), columns.size()});
    for (std::size_t j = 0; j < columns.size(); ++j) {
      const std::size_t at = n * columns.size() + j;
      shaking.displacement[at] = ground.displacement(places[j]);
      shaking.velocity[at] = ground.velocity(places[j]);
      shaking.acceleration[at] = ground.acceleration(places[j]);
      for (std::size_t k = 0; k < in_sand.size(); ++k) shaking.stress[k][at] = ground.stress(in_sand[k][j]);
    }
  }
  return shaking;
}

// The places at which the motion is computed: those of the soil columns, or as close together as the shortest
// wave of interest needs.
std::vector<double> places_along(const scene::Simplified& scene, double begin, double end) {
  std::vector<double> places;
  if (scene.has_ground()) {
    // Chainages of the columns are the same in every direction.
    for (const auto& column : columns(scene.ground(), begin, end, kLateral))
      places.push_back(column.chainage);
    return places;
  }
  constexpr int kGaps = 200;
  for (int i = 0; i <= kGaps; ++i) places.push_back(begin + (end - begin) * i / kGaps);
  return places;
}

}  // namespace

GroundField shake(const scene::Simplified& scene, const Motion& motion, double begin, double end,
                  std::size_t steps) {
  const scene::Excitation& excitation = scene.excitation();
  const std::array<double, kDirections> factors = {excitation.axial(), excitation.lateral(),
                                                   excitation.vertical()};
  if (std::ranges::all_of(factors, [](double f) { return f == 0; }))
    throw UserError("simplified.excitation",
                    "has no direction; give `axial`, `lateral` or `vertical`, such as "
                    "`lateral: 1`");
  if (excitation.through_ground() && !scene.has_ground())
    throw UserError("simplified.excitation.through_ground", "needs the scene's `ground`, which is missing");

  GroundField field;
  field.chainage = places_along(scene, begin, end);
  const scene::Incidence& incidence = excitation.incidence();
  auto motions = motion::errors_at("simplified.excitation.incidence", [&] {
    return motion::station_motions(motion, field.chainage,
                                   {.apparent_velocity = incidence.apparent_velocity(),
                                    .drift = incidence.coherency().drift(),
                                    .seed = incidence.coherency().seed()});
  });
  for (Motion& station : motions) station = motion::lasting(station, motion.dt * static_cast<double>(steps));
  const std::vector<int> sands = scene.has_ground() ? liquefiable_layers(scene.ground()) : std::vector<int>{};
  for (const Direction direction : {kAxial, kLateral, kVertical}) {
    if (factors[direction] == 0) continue;
    field.shaking[direction] =
        excitation.through_ground()
            ? through_ground(scene, columns(scene.ground(), begin, end, direction), motions,
                             factors[direction], steps, direction == kVertical ? std::vector<int>{} : sands)
            : direct(motions, factors[direction], steps);
  }
  for (const int layer : sands)
    field.pressure.push_back({layer, std::vector<double>(field.chainage.size() * (steps + 1))});
  raise_pressure(scene, field);
  return field;
}

}  // namespace adit::simplified
