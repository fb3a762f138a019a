#include "fdm_server/supports/peak_dowels.hpp"

namespace adit::fdm {

void PeakDowels::take(std::span<const Dowel> dowels, double time) {
  forces_.resize(dowels.size(), {-1, time});
  offsets_.resize(dowels.size(), {-1, time});
  for (std::size_t i = 0; i < dowels.size(); ++i) {
    if (dowels[i].force() > forces_[i].size) forces_[i] = {dowels[i].force(), time};
    if (dowels[i].offset() > offsets_[i].size) offsets_[i] = {dowels[i].offset(), time};
  }
}

void PeakDowels::exchange(std::size_t dowels, state::Archive& archive) {
  if (dowels > 0) archive.all_or_none("peak_dowels", {&forces_, &offsets_}, dowels);
}

}  // namespace adit::fdm
