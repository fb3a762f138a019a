// The zones of a grid of one or several materials, by number in the grid. One kernel computes those of each
// material: dry elastic ones in small strain the fast kernel (elastic/), others the general one (nonlinear/).
// Runs carry the number of their part, so that the choice costs one virtual call for many zones.
//
// Zones of one material may differ in stiffness and in strength by factors (Ground). Every law bears f times
// the stress at the same strain where its stiffness is multiplied by f and its strength is, too. So kernels
// compute the stress over f, weights times f make of it what the zone pulls with and stores, and of a
// strength s times the material's the kernel sees s / f. This costs no more than zones of one stiffness that
// are weighted.
//
// Where the pores of a material hold water, its kernel computes effective stresses and pulls with the total
// ones (PoreWater): what goes in and out here is total.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "fdm_server/materials/material.hpp"
#include "fdm_server/zones/kernel/zone_kernel.hpp"
#include "fdm_server/zones/water/pore_water.hpp"
#include "protocol/threads/team.hpp"

namespace adit::fdm {

class ZoneSet {
 public:
  // One weight a zone; it multiplies the zone's forces.
  ZoneSet(ZoneKind kind, const Grid& grid, const Ground& ground, std::span<const double> weights);
  // Elastic zones of one law, in small strain; their stress across the plane is not known and reads 0.
  ZoneSet(ZoneKind kind, const Grid& grid, const PlaneLaw& law, std::span<const double> weights);

  // These are as ZoneKernel explains them.
  std::size_t count() const { return places_.size(); }
  std::span<const ZoneRun> runs() const { return runs_; }
  void follow(const double* ux, const double* uy);
  void add_forces(std::span<const ZoneRun> runs, double dt, const PointView& points);
  // The forces of those zones alone whose flag is set.
  void add_forces_of(const std::vector<bool>& zones, double dt, const PointView& points);
  void set_stress(std::size_t zone, const Stress& stress);
  void set_stress_zz(std::size_t zone, double zz);
  void remove(const std::vector<bool>& gone);
  // These zones, ascending and of weight 1, are of the ground's materials from now on, in small strain: where
  // the points are now, those that are there bear what they bore, those that were taken away nothing.
  void renew(ZoneKind kind, const Grid& grid, const Ground& ground, std::span<const std::uint32_t> zones,
             const double* ux, const double* uy);
  void start_over();
  // The pressure of water at rest in each zone [Pa], of which those of dry zones do not count: before
  // stresses are set. Effective stresses stay as they are.
  void set_rest(std::span<const double> pressures);
  // Time begins: from now on the water follows the volume of the pores, and ground may compact.
  void begin_time();
  void set_time(double time);
  void exchange(state::Archive& archive);
  // This and the internal force, the sum over the zones of |stress| · size, |stress| its Frobenius norm, are
  // summed by the team, in the same order whoever computes what.
  double strain_energy(protocol::Team& team) const;
  double dissipated() const;
  // Of the pressure of water at rest since displacements were 0.
  double external_work() const;
  Stress stress(std::size_t zone) const;
  ZoneForces forces(std::size_t zone) const;
  double internal_force(protocol::Team& team, std::span<const double> sizes) const;
  double demand(std::size_t zone) const;
  double field(std::size_t zone, ZoneField field) const;
  double pore_pressure(std::size_t zone) const;                  // [Pa]; 0 of dry ground
  std::optional<double> water_pressure(std::size_t zone) const;  // the same; nothing of dry ground
  bool any_water() const;
  // What flow asks and tells: the growth of the pressure since time began [Pa], 0 of dry ground; the volume
  // of water that comes into each zone in the next step, over that of the zone.
  void read_excess(protocol::Team& team, std::span<double> excess) const;
  void set_inflow(protocol::Team& team, std::span<const double> inflow);
  // The growth over the effective vertical pressure when time began.
  double pressure_ratio(std::size_t zone) const;
  // The team calls see(numbers, stresses) for the stresses of these zones, batch by batch for all zones.
  template <class See>
  void see_stresses(protocol::Team& team, const See& see) const {
    team.run(pieces_.size(), [&](std::size_t i, std::size_t) { see_stresses(pieces_[i], see); });
  }

 private:
  struct Place {
    std::uint32_t part, zone;  // number in the part
  };
  struct Part {
    std::unique_ptr<ZoneKernel> kernel;
    std::vector<std::uint32_t> numbers;     // of its zones in the grid
    std::vector<double> stiffness;          // factors of its zones; empty: all 1
    std::unique_ptr<PoreWater> water = {};  // which the kernel holds

    // Flags of the grid's zones as flags of the part's, whose kernel and runs count zones from 0.
    std::vector<bool> own(const std::vector<bool>& zones) const;
    double factor(std::size_t zone) const { return stiffness.empty() ? 1 : stiffness[zone]; }
    void follow(const double* ux, const double* uy);
    void remove(const std::vector<bool>& gone);
    double pressure(std::size_t zone) const { return water ? water->pressure(zone) : 0; }
    // Of a batch, from what its kernel computes: its stiffness, and the water's pressure.
    void complete(const protocol::IndexRange& batch, PlaneStresses& stresses) const;
  };
  double factor(std::size_t zone) const { return parts_[places_[zone].part].factor(places_[zone].zone); }
  void add_part(Part part);
  // A part for each material of the chosen zones.
  void add_parts(ZoneKind kind, const Grid& grid, const Ground& ground, std::span<const double> weights,
                 const std::vector<bool>& chosen);
  BorneStress borne(std::size_t zone) const;
  void collect_runs();
  void collect_pieces();
  struct Piece {
    std::uint32_t part;
    protocol::IndexRange zones;  // numbers in the part
  };
  // The sum of of(piece) over all pieces.
  double sum(protocol::Team& team, const auto& of) const;
  void see_stresses(const Piece& piece, const auto& see) const {
    const Part& part = parts_[piece.part];
    PlaneStresses stresses;
    for (std::uint32_t begin = piece.zones.begin; begin < piece.zones.end; begin += kBatch) {
      const protocol::IndexRange batch{begin, std::min(begin + kBatch, piece.zones.end)};
      part.kernel->find_stresses(batch, stresses);
      part.complete(batch, stresses);
      see(std::span(part.numbers).subspan(batch.begin, batch.end - batch.begin), stresses);
    }
  }

  std::vector<Part> parts_;
  std::vector<Piece> pieces_;  // all zones, each piece worth a thread's call
  std::vector<Place> places_;  // of each zone, in the part that has it now
  std::vector<ZoneRun> runs_;
};

// The zones of one material of the ground, among the same points.
Grid zones_of_material(const Grid& grid, const Ground& ground, std::size_t material);

}  // namespace adit::fdm
