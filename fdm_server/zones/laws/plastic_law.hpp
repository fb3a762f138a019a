// Mohr-Coulomb, a weak plane or both (admissible.hpp) for zones. A step adds the elastic stress, finds the
// zones beyond their strength, packs them and returns their points together: to the shear plane, or
// where they are torn to the point of the cut-off, if that is enough; else to all regions of the cone in
// closed form, and what is open then one by one.
#pragma once

#include <optional>
#include <vector>

#include "fdm_server/zones/laws/plastic_kernels.hpp"
#include "fdm_server/zones/laws/zone_law.hpp"

namespace adit::fdm {

class PlasticLaw final : public ZoneLaw {
 public:
  // `strengths`: by which cohesion and tension are multiplied in each zone; empty: 1.
  PlasticLaw(const Material& material, std::size_t zones, bool large_strain,
             std::span<const double> strengths = {});

  void advance(const LawStep& step) override;
  // The second half of advance(), of stresses that hold those of the step's strain. Says whether any yields.
  bool return_to_strength(const LawStep& step);
  void turn(std::size_t first, std::uint32_t count, const HalfTurns& turns) override;
  void exchange(state::Archive& archive) override;
  double plastic_shear_strain(std::size_t zone, std::size_t point) const override {
    return strains_[point][zone];
  }
  unsigned yields(std::size_t zone, std::size_t point) const override {
    return yields_[zone] >> (8 * point) & 0xFFu;
  }
  double demand(std::size_t zone, std::size_t point, const PointStress& stress) const override;

 private:
  using Numbers = std::array<std::uint32_t, kBatch>;  // of zones in the batch
  ConeView cones(std::size_t first) const;
  DirectionView directions(std::size_t first) const;
  const double* strengths(std::size_t first) const {
    return strengths_.empty() ? ones_.data() : &strengths_[first];
  }
  double strength(std::size_t zone) const { return strengths_.empty() ? 1 : strengths_[zone]; }
  YieldCone cone(std::size_t zone, std::size_t point) const {
    return times(strength(zone), material_.mohr_coulomb->cone(strains_[point][zone]));
  }
  void pack(const LawStep& step, const Numbers& numbers, Returning& zones) const;
  void return_one_by_one(const LawStep& step, const Numbers& numbers, Returning& zones) const;
  void unpack(const LawStep& step, const Numbers& numbers, const Returning& zones);
  void soften(std::size_t zone, std::size_t point);

  Material material_;
  Plasticity law_;
  FieldArrays<4> strains_;             // plastic shear strain of each point
  std::vector<std::uint32_t> yields_;  // of each zone: bits of Yield of its points, a byte each
  std::vector<double> strengths_;      // of each zone; empty: all 1
  std::optional<ConeFields> cones_;    // where it softens
  // Of the weak plane: in large strain of each zone, else the same for all.
  std::optional<FieldArrays<2>> directions_;
  BatchValues cosine_{}, sine_{}, ones_{};
};

}  // namespace adit::fdm
