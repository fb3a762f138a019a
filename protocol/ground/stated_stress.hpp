// The stress that the scene states for the ground before anything acts (scene.proto, Stress).
//
// Every component is piecewise linear in y. Layers: from the surface downwards the vertical pressure grows by
// the weight of each layer, from the surcharge on; both horizontal pressures are k0 times the vertical one.
// The last layer goes on below its lower side. Above the surface the ground bears the surcharge alone.
//
// Where the pores hold water, k0 is that of the effective stress: the vertical pressure less that of the
// water, times k0, and the water's again. Water that stands on the surface weighs on it, by the level of the
// place there.
//
// Below a line instead of a level surface, each place bears the layers between it and the line above it.
// Layers end at the line, which may lie below some of them; the sea is as deep as the line is there. Beside
// the line's slopes this is not in equilibrium: the horizontal pressure changes along x, and nothing bears it
// but shear, which statics find.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "protocol/geometry/selection.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::protocol {

// Of the layers' weight [m/s^2].
inline constexpr double kStandardGravity = 9.80665;

// Tension positive [Pa].
struct GroundStress {
  double xx, yy, xy;
  std::optional<double> zz;  // where it is stated
};

class StatedStress {
 public:
  // Of a scene, below its water.
  explicit StatedStress(const scene::Scene& scene)
      : StatedStress(scene.initial_stress(), scene.has_water() ? &scene.water() : nullptr) {}
  // `water`: null where there is none. UserError at initial_stress for layers beside components, or out of
  // order, and for a line that is none.
  explicit StatedStress(const scene::Stress& stress, const scene::Water* water = nullptr);

  // `pore_pressure`: of the water in the ground there [Pa], which components do not see.
  GroundStress at(double x, double y, double pore_pressure = 0) const;

 private:
  struct Linear {
    double at_zero = 0, per_metre = 0;
    double at(double y) const { return at_zero + per_metre * y; }
  };
  struct Piece {
    double bottom;  // y [m]
    double weight;  // of a layer, that is its growth of yy [N/m^3]
    double k0;
    Linear xx, yy, xy;
    std::optional<Linear> zz;
  };
  const Piece& piece_at(double y) const;
  void read_sea(const scene::Water& water);
  // Vertical pressure on a surface there: the surcharge, and the sea's.
  double load_on(double x, double y) const;
  GroundStress below_level(double y) const;
  GroundStress below_line(double x, double y) const;

  std::vector<Piece> pieces_;  // downwards
  double surface_, surcharge_;
  std::optional<scene::Water> water_;
  struct Sea {
    Places where;
    double level;
  };
  std::vector<Sea> seas_;                        // of places that have a level from the beginning on
  std::vector<std::pair<double, double>> line_;  // from left to right; none: the surface is level
};

}  // namespace adit::protocol
