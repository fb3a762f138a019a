// Hysteresis with a memory of reversals (hysteresis/reversals.hpp) for zones: one memory a zone. Zones that
// go on as before, or inside the first sphere, are computed together; those that turn back or meet an older
// piece one by one.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "fdm_server/hysteresis/reversals.hpp"
#include "fdm_server/zones/batch/zone_fields.hpp"
#include "fdm_server/zones/laws/hysteretic_axes.hpp"
#include "fdm_server/zones/laws/reversal_kernels.hpp"
#include "fdm_server/zones/laws/zone_law.hpp"

namespace adit::fdm {

class ReversalLaw final : public ZoneLaw {
 public:
  ReversalLaw(const Elasticity& elasticity, const Polyline& backbone, std::size_t zones, bool large_strain);

  void advance(const LawStep& step) override;
  void prefetch(std::size_t first) const override { inner_.read_ahead(first); }
  void turn(std::size_t first, std::uint32_t count, const HalfTurns& turns) override {
    axes_.turn(first, count, turns);
  }
  void exchange(state::Archive& archive) override;
  void find_energies(std::size_t first, std::uint32_t count, const PointValues& areas,
                     const ConstStressView& stresses, BatchValues& energies) const override;
  unsigned yields(std::size_t /*zone*/, std::size_t /*point*/) const override { return kHysteretic; }

 private:
  InnerPiece inner_piece(std::size_t zone) const;
  void set_inner_piece(std::size_t zone, const InnerPiece& piece);
  // Zones that leave their piece, one by one.
  void leave_pieces(const LawStep& step, const StrainBatch& strains, Advanced& to);

  Polyline backbone_;
  // Of each zone: strain, drift, radius and end of its inner piece; share and spring where loops are
  // narrower.
  ZoneFields<2 * kZoneStrains + 2> inner_;
  std::optional<FieldArrays<2>> narrow_;
  std::vector<std::vector<OuterPiece>> outer_;
  // What the outer pieces of a zone hold, where its energy was asked for since it left a piece.
  struct Summed {
    std::unique_ptr<OuterSum> sum;
    bool known = false;
  };
  const OuterSum& sum_of_outer(std::size_t zone, const ZoneStrain& weights, const InnerPiece& inner) const;
  mutable std::vector<Summed> summed_;
  HystereticAxes axes_;
};

}  // namespace adit::fdm
