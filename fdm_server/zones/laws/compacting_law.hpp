// A law whose ground compacts under cyclic shear (materials/compaction.hpp). Its stresses are the effective
// ones. The shear strain that counts is the mean over the zone's area, from the beginning of time on: the
// ways of statics to their rest are none of the ground's.
//
// The skeleton is strained by what the ground is strained and by what the compaction takes, one third of
// d(ev) in each direction. Under every law the volume changes elastically and by itself: the strain of the
// compaction adds K d(ev) to all three normal stresses, before the law takes the strain of the ground.
// Compaction ends where the skeleton has no pressure left; where it cannot lose volume the ground has
// liquefied.
//
// Energy: with p the mean of the three normal stresses, s* the stress after the compaction and dv the strain
// of the volume, the compaction stores (p(n) + p*)/2 d(ev), and the law accounts for (s* + s(n+1))/2 : de. Of
// (s(n) + s(n+1))/2 : de what is left is
//   -(p(n) + K (d(ev) + dv)/2) d(ev),
// the pressure at the half step on the compaction: dissipated, and never less than 0.
#pragma once

#include <memory>

#include "fdm_server/materials/compaction.hpp"
#include "fdm_server/zones/batch/zone_fields.hpp"
#include "fdm_server/zones/laws/zone_law.hpp"

namespace adit::fdm {

class CompactingLaw final : public ZoneLaw {
 public:
  // `law`: that of the skeleton, for as many zones and with these elastic constants.
  CompactingLaw(std::unique_ptr<ZoneLaw> law, const Elasticity& elasticity, const Compaction& compaction,
                std::size_t zones)
      : ZoneLaw(elasticity), law_(std::move(law)), compaction_(compaction), memory_(zones) {}

  void advance(const LawStep& step) override;
  void prefetch(std::size_t first) const override {
    law_->prefetch(first);
    memory_.read_ahead(first);
  }
  void turn(std::size_t first, std::uint32_t count, const HalfTurns& turns) override;
  void set_stress(std::size_t zone, std::size_t point, const PointStress& stress) override {
    law_->set_stress(zone, point, stress);
  }
  void begin_time() override {
    law_->begin_time();
    counts_ = true;
  }
  void set_time(double time) override { law_->set_time(time); }
  void exchange(state::Archive& archive) override {
    law_->exchange(archive);
    memory_.exchange(archive);
    archive("counts", counts_);
  }
  void find_energies(std::size_t first, std::uint32_t count, const PointValues& areas,
                     const ConstStressView& stresses, BatchValues& energies) const override {
    law_->find_energies(first, count, areas, stresses, energies);
  }
  double plastic_shear_strain(std::size_t zone, std::size_t point) const override {
    return law_->plastic_shear_strain(zone, point);
  }
  unsigned yields(std::size_t zone, std::size_t point) const override { return law_->yields(zone, point); }
  double demand(std::size_t zone, std::size_t point, const PointStress& stress) const override {
    return law_->demand(zone, point, stress);
  }
  double compaction(std::size_t zone) const { return memory_.at(kCompaction, zone); }  // ev

 private:
  // HalfCycle in its order; ev at the last reversal, d(ev)/dW, ev.
  enum Field : std::size_t {
    kT,
    kS,
    kFromT,
    kFromS,
    kFarT,
    kFarS,
    kDistance,
    kLargest,
    kBefore,
    kSettled,
    kByWay,
    kCompaction,
    kFields
  };
  double* field(Field which, std::size_t first) { return &memory_.at(which, first); }

  std::unique_ptr<ZoneLaw> law_;
  Compaction compaction_;
  bool counts_ = false;
  ZoneFields<kFields> memory_;
};

}  // namespace adit::fdm
