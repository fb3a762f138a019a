// Axes in which hysteretic zones remember their strain: in large strain they turn with the ground.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "fdm_server/zones/batch/batch.hpp"
#include "fdm_server/zones/batch/zone_kernels.hpp"
#include "protocol/state/archive.hpp"

namespace adit::fdm {

// Cosine and sine of twice the angles by which axes have turned.
struct AxesView {
  const double *cosine, *sine;
};

class HystereticAxes {
 public:
  HystereticAxes(std::size_t zones, bool large_strain) {
    if (large_strain) std::ranges::fill(twice_.emplace(zones)[0], 1.0);
  }

  bool turns() const { return twice_.has_value(); }
  // Cosine and sine of twice the angle by which a zone's axes have turned.
  double cosine(std::size_t zone) const { return twice_ ? (*twice_)[0][zone] : 1; }
  double sine(std::size_t zone) const { return twice_ ? (*twice_)[1][zone] : 0; }

  void turn(std::size_t first, std::uint32_t count, const HalfTurns& turns) {
    if (!twice_) return;
    double *cosine = &(*twice_)[0][first], *sine = &(*twice_)[1][first];
    for (std::uint32_t i = 0; i < count; ++i) {
      const double c = turns.cosine[i] * cosine[i] - turns.sine[i] * sine[i];
      sine[i] = turns.sine[i] * cosine[i] + turns.cosine[i] * sine[i];
      cosine[i] = c;
    }
  }

  // From a zone on; none where axes do not turn.
  AxesView view(std::size_t first) const {
    return twice_ ? AxesView{&(*twice_)[0][first], &(*twice_)[1][first]} : AxesView{};
  }

  // Turns differences and shears of zones from `first` on into axes that turn.
  void turn_in(std::size_t first, std::uint32_t count, PointValues& difference, PointValues& shear) const {
    const auto [cosine, sine] = view(first);
    for (std::size_t k = 0; k < 4; ++k)
      for (std::uint32_t i = 0; i < count; ++i) {
        const double d = difference[k][i], s = shear[k][i];
        difference[k][i] = cosine[i] * d + sine[i] * s;
        shear[k][i] = cosine[i] * s - sine[i] * d;
      }
  }

  void exchange(state::Archive& archive) {
    if (twice_) twice_->exchange(archive);
  }

 private:
  std::optional<FieldArrays<2>> twice_;
};

}  // namespace adit::fdm
