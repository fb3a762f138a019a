// The water in the pores of zones of one material: its pressure in each zone, and the forces by which it
// pushes the corners apart. The stress of the zones' law is the effective stress; the ground bears this less
// the pressure (Terzaghi 1943; grains do not yield, so that Biot's coefficient is 1).
//
// The pressure p = p_rest + u is one number a zone, as is the change of volume that the points of a zone
// share (sampling_shape.hpp). Sealed in, water follows the volume of the pores and what flows in:
//   du = M (dz - dA/A),   M = K_w / n,
// dz being the volume of the inflow over that of the zone. Until the water is sealed in, u stays 0. The
// zones' kernel takes p off the mean effective stress, so that what pulls on the corners is the total stress.
// In large strain, where its stress is Kirchhoff's, that is p times the area over the undeformed one; the
// change of area comes from the shape half way, which is exact; A stays that of the beginning.
//
// For energies, and forces that are asked for: with the diagonals d = x_2 - x_0 and e = x_3 - x_1,
//   A = (d_x e_y - e_x d_y)/2,   dA/dx_0 = -e_y/2,   dA/dx_1 = d_y/2,   dA/dy_0 = e_x/2,   dA/dy_1 = -d_x/2,
// and corners 2 and 3 have the negatives of 0 and 1; the corner forces are w p dA/dx_c, w the zone's weight.
// In small strain the diagonals are those of the grid.
//
// Energy: with corner forces of both ends the scheme books the work of (p(n) + p(n+1))/2 against the change
// of area. Of it A u^2/(2 M) is stored; p_rest times the growth of the area since displacements were 0 is
// work from outside, of the water around; and inflow brings A (u(n) + u(n+1))/2 dz, which the flow between
// zones loses. The ledger closes to rounding, in large strain to second order in dt.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "fdm_server/grid/field_arrays.hpp"
#include "fdm_server/grid/grid.hpp"
#include "fdm_server/zones/batch/batch.hpp"
#include "fdm_server/zones/kernel/zone_runs.hpp"
#include "protocol/state/archive.hpp"
#include "protocol/threads/index_ranges.hpp"

namespace adit::fdm {

class PoreWater {
 public:
  // `stiffness`: M [Pa]; 0: the pressure never changes. `weights`: one a zone. `shares`: what the kernel's
  // stress is of the stress, one a zone; empty: 1.
  PoreWater(const Grid& grid, double stiffness, std::span<const double> weights,
            std::span<const double> shares, bool large_strain);

  // The pressure of water at rest [Pa].
  void set_rest(std::size_t zone, double pressure) { fields_[kRest][zone] = pressure; }
  // From now on water comes and leaves by inflow only. `vertical`: the effective pressure of each zone [Pa].
  void seal(std::span<const double> vertical);
  // Volume of water that comes in during the next step over that of the zone.
  void set_inflow(std::size_t zone, double inflow) { fields_[kInflow][zone] = inflow; }
  // Some zone will have an inflow.
  void begin_flow() { flows_ = true; }

  // A step in which zones `first` … `first + count` grew by these shares of their area: the pressures at its
  // end, as shares of the kernel's stress.
  void advance(std::size_t first, std::uint32_t count, const BatchValues& growths, BatchValues& pressures);

  // As ZoneKernel explains them.
  void follow(const double* ux, const double* uy);
  void remove(const std::vector<bool>& gone);
  void start_over();
  void exchange(state::Archive& archive);
  double strain_energy(const protocol::IndexRange& zones) const;
  double dissipated() const;     // by flow
  double external_work() const;  // of the pressure at rest, since displacements were 0 [J]
  ZoneForces forces(std::size_t zone) const;

  // 0 of a zone that was taken away [Pa].
  double pressure(std::size_t zone) const;
  double excess(std::size_t zone) const { return fields_[kExcess][zone]; }
  // Of the excess to the effective vertical pressure when the water was sealed in.
  double ratio(std::size_t zone) const;

 private:
  enum Field { kRest, kExcess, kInflow, kLost, kVertical, kWeight, kArea, kDx, kDy, kEx, kEy, kFields };
  struct Diagonals {
    double dx, dy, ex, ey;
    double area() const { return (dx * ey - ex * dy) / 2; }
  };
  Diagonals of_grid(std::size_t zone) const;
  Diagonals moved(std::size_t zone) const;  // by displacements
  // Since displacements were 0 [m^2].
  double growth(std::size_t zone) const;

  double stiffness_;
  bool large_strain_, sealed_ = false, flows_ = false;
  FieldArrays<kFields> fields_;  // kLost: over the area
  std::vector<double> shares_;   // empty: all 1
  BatchValues ones_;
  std::vector<ZonePoints> points_;
  const double *ux_ = nullptr, *uy_ = nullptr;
};

}  // namespace adit::fdm
