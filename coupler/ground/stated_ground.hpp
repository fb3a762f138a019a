// The ground of a model by place, as the scene states it.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "protocol/geometry/selection.hpp"
#include "protocol/messages/scene.pb.h"
#include "protocol/scatter/scattering.hpp"

namespace adit::coupler {

// The places of an area of zones, as areas without `group`: those of the blocks of that name. None where only
// the grid knows them: of groups of a mesh, and of blocks that neither box, polygon nor annulus describes.
std::optional<std::vector<scene::Area>> by_place(const scene::Area& area, const scene::Continuum& continuum);

struct Ground {
  std::string path;  // of its material in the scene
  // Absent where the particles have it otherwise: by stiffnesses of bonds, or by a table of discs, whose
  // masses are those of the discs alone.
  struct Stiffness {
    double young, shear;  // moduli [Pa]
  };
  std::optional<Stiffness> stiffness;
  std::optional<double> density;  // [kg/m^3]
  bool assumed;                   // of particles: the scene's material, for want of their own
};

class StatedGround {
 public:
  // `part`: the scene with this model only, as `continuum` or `particles`; it must outlive this. `path`: of
  // the model in the whole scene.
  StatedGround(const scene::Scene& part, std::string path);

  // Whether the scene alone tells the place of each of its materials.
  bool is_known() const { return known_; }

  // At a place [m], where is_known(). Zones are as they are at first; the groups of all stages count.
  Ground at(double x, double y) const;
  // What a material is there, with the factors of `scatter`.
  Ground scattered(Ground ground, double x, double y) const;

 private:
  void add_zones();
  void add_groups();
  void add(const scene::Area& where, const Ground& ground);

  const scene::Scene& part_;
  std::string path_;
  protocol::Scattering stiffness_;
  bool known_ = true;
  Ground own_;
  std::vector<std::pair<protocol::Places, Ground>> others_;  // the last one that holds a place has it
};

// That of zones whose material has this number in snapshots: 0 is the continuum's own.
Ground ground_of_zones(const scene::Scene& part, const std::string& path, std::size_t number);

}  // namespace adit::coupler
