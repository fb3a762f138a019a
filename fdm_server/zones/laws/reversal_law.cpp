#include "fdm_server/zones/laws/reversal_law.hpp"

#include <algorithm>
#include <utility>

namespace adit::fdm {
namespace {

ZoneStrain weights_of(const std::array<double, 4>& areas) {
  const double area = (areas[0] + areas[1]) + (areas[2] + areas[3]);
  ZoneStrain weights;
  for (std::size_t k = 0; k < 4; ++k) weights[k] = weights[4 + k] = areas[k] / area;
  weights[8] = 0.75;
  return weights;
}

// Of a zone's pressure, which is elastic.
double pressure(double mean, double across) {
  return (2 * mean + across) / 3;
}

// Fields of the inner pieces.
enum InnerField : std::size_t { kStrain = 0, kDrift = kZoneStrains, kRadius = 2 * kZoneStrains, kEnd };

}  // namespace

ReversalLaw::ReversalLaw(const Elasticity& elasticity, const Polyline& backbone, std::size_t zones,
                         bool large_strain)
    : ZoneLaw(elasticity),
      backbone_(backbone),
      inner_(zones),
      outer_(zones),
      summed_(zones),
      axes_(zones, large_strain) {
  inner_.fill(kEnd, kVirgin.end);
  if (backbone_.narrowed()) std::ranges::fill(narrow_.emplace(zones)[0], kVirgin.share);
}

void ReversalLaw::advance(const LawStep& step) {
  const PolylineView line = backbone_.view();
  InnerView inner{};
  for (std::size_t i = 0; i < kZoneStrains; ++i) {
    inner.strain[i] = &inner_.at(kStrain + i, step.first);
    inner.drift[i] = &inner_.at(kDrift + i, step.first);
  }
  inner.radius = &inner_.at(kRadius, step.first);
  inner.end = &inner_.at(kEnd, step.first);
  if (narrow_) {
    inner.share = &(*narrow_)[0][step.first];
    inner.spring = &(*narrow_)[1][step.first];
  }
  StrainBatch turned;
  if (axes_.turns()) {
    turned = step.strains;
    axes_.turn_in(step.first, step.count, turned.difference, turned.shear);
  }
  const StrainBatch& strains = axes_.turns() ? turned : step.strains;
  Advanced to;
  const bool any = stay_on_piece(line, step.count, step.areas, strains, inner, to);
  grow(elasticity_, step.count, strains, to, axes_.view(step.first), inner, step.stresses);
  if (any) leave_pieces(step, strains, to);
  for (std::uint32_t i = 0; i < step.count; ++i) step.dissipated[i] += elasticity_.shear * to.dissipated[i];
}

void ReversalLaw::leave_pieces(const LawStep& step, const StrainBatch& strains, Advanced& to) {
  const auto& [mean, across, difference, shear] = step.stresses;
  for (std::uint32_t i = 0; i < step.count; ++i) {
    if (!to.leaves[i]) continue;
    const std::size_t zone = step.first + i;
    ZoneStrain strain;
    std::array<double, 4> areas;
    for (std::size_t k = 0; k < 4; ++k) {
      strain[k] = strains.difference[k][i];
      strain[4 + k] = strains.shear[k][i];
      areas[k] = step.areas[k][i];
    }
    strain[8] = -2 * strains.volume[i] / 3;
    ZoneMemory memory{inner_piece(zone), std::move(outer_[zone])};
    const auto [growth, dissipated] = fdm::advance(backbone_.view(), weights_of(areas), strain, memory);
    set_inner_piece(zone, memory.inner);
    outer_[zone] = std::move(memory.outer);
    summed_[zone].known = false;
    to.dissipated[i] = dissipated * ((areas[0] + areas[1]) + (areas[2] + areas[3]));
    const double modulus = elasticity_.shear;
    const double cosine = axes_.cosine(zone), sine = axes_.sine(zone);
    for (std::size_t k = 0; k < 4; ++k) {
      difference[k][i] += modulus * (cosine * growth[k] - sine * growth[4 + k]);
      shear[k][i] += modulus * (cosine * growth[4 + k] + sine * growth[k]);
    }
    mean[i] -= modulus * growth[8] / 2;
    across[i] += modulus * growth[8];
  }
}

InnerPiece ReversalLaw::inner_piece(std::size_t zone) const {
  InnerPiece piece = kVirgin;
  for (std::size_t i = 0; i < kZoneStrains; ++i) {
    piece.strain[i] = inner_.at(kStrain + i, zone);
    piece.drift[i] = inner_.at(kDrift + i, zone);
  }
  piece.radius = inner_.at(kRadius, zone);
  piece.end = inner_.at(kEnd, zone);
  if (narrow_) {
    piece.share = (*narrow_)[0][zone];
    piece.spring = (*narrow_)[1][zone];
  }
  return piece;
}

void ReversalLaw::set_inner_piece(std::size_t zone, const InnerPiece& piece) {
  for (std::size_t i = 0; i < kZoneStrains; ++i) {
    inner_.at(kStrain + i, zone) = piece.strain[i];
    inner_.at(kDrift + i, zone) = piece.drift[i];
  }
  inner_.at(kRadius, zone) = piece.radius;
  inner_.at(kEnd, zone) = piece.end;
  if (!narrow_) return;
  (*narrow_)[0][zone] = piece.share;
  (*narrow_)[1][zone] = piece.spring;
}

void ReversalLaw::exchange(state::Archive& archive) {
  inner_.exchange(archive);
  if (narrow_) narrow_->exchange(archive);
  std::vector<std::uint32_t> counts;
  std::vector<OuterPiece> pieces;
  for (const auto& outer : outer_) {
    counts.push_back(static_cast<std::uint32_t>(outer.size()));
    pieces.insert(pieces.end(), outer.begin(), outer.end());
  }
  archive("reversals", std::span(counts));
  archive("pieces", pieces);
  axes_.exchange(archive);
  if (!archive.reads()) return;
  std::size_t at = 0;
  for (std::size_t zone = 0; zone < outer_.size(); ++zone) {
    state::require_of_model(counts[zone] <= pieces.size() - at, "pieces");
    const auto from = pieces.begin() + static_cast<std::ptrdiff_t>(at);
    outer_[zone].assign(from, from + counts[zone]);
    summed_[zone].known = false;
    at += counts[zone];
  }
  state::require_of_model(at == pieces.size(), "pieces");
}

const OuterSum& ReversalLaw::sum_of_outer(std::size_t zone, const ZoneStrain& weights,
                                          const InnerPiece& inner) const {
  static constexpr OuterSum kNone{};
  if (outer_[zone].empty()) return kNone;
  auto& [sum, known] = summed_[zone];
  if (!known) {
    if (!sum) sum = std::make_unique<OuterSum>();
    *sum = sum_of(backbone_.view(), weights, inner, outer_[zone]);
    known = true;
  }
  return *sum;
}

// Beside what the memory stores: the initial stress over the strains since, and the change of volume.
void ReversalLaw::find_energies(std::size_t first, std::uint32_t count, const PointValues& areas,
                                const ConstStressView& stresses, BatchValues& energies) const {
  const double modulus = elasticity_.shear;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::size_t zone = first + i;
    const std::array<double, 4> area{areas[0][i], areas[1][i], areas[2][i], areas[3][i]};
    const ZoneStrain weights = weights_of(area);
    const double across = stresses.across[i], mean = pressure(stresses.mean[i], across);
    const double cosine = axes_.cosine(zone), sine = axes_.sine(zone);
    const InnerPiece inner = inner_piece(zone);
    const Held held = fdm::held(backbone_.view(), weights, inner, sum_of_outer(zone, weights, inner));
    double energy = modulus * held.energy;
    const auto add = [&](std::size_t c, double initial_and_held) {
      energy += weights[c] * (initial_and_held - modulus * held.stress[c]) * held.strain[c];
    };
    for (std::size_t k = 0; k < 4; ++k) {
      const double difference = stresses.difference[k][i], shear = stresses.shear[k][i];
      add(k, cosine * difference + sine * shear);
      add(4 + k, cosine * shear - sine * difference);
    }
    add(8, across - mean);
    energies[i] =
        ((area[0] + area[1]) + (area[2] + area[3])) * (energy + mean * mean / (2 * elasticity_.bulk));
  }
}

}  // namespace adit::fdm
