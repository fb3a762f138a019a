// Several fields over zones that kernels take batch by batch: what a batch has of all fields lies together.
// A step then reads one stream of memory, which a processor follows by itself, instead of one for each field.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "fdm_server/zones/kernel/zone_runs.hpp"
#include "protocol/kernels/prefetch.hpp"
#include "protocol/state/archive.hpp"

namespace adit::fdm {

template <std::size_t kFields>
class ZoneFields {
 public:
  explicit ZoneFields(std::size_t zones) : batches_((zones + kBatch - 1) / kBatch) {}

  // The value of a zone; those of the zones that follow it in its batch follow it in memory.
  double& at(std::size_t field, std::size_t zone) {
    return batches_[zone / kBatch].values[field][zone % kBatch];
  }
  const double& at(std::size_t field, std::size_t zone) const {
    return batches_[zone / kBatch].values[field][zone % kBatch];
  }

  void fill(std::size_t field, double value) {
    for (Batch& batch : batches_) batch.values[field].fill(value);
  }

  // The batch of a zone, if there is one, comes into the cache.
  void read_ahead(std::size_t zone) const {
    if (zone / kBatch >= batches_.size()) return;
    for (const auto& values : batches_[zone / kBatch].values) protocol::read_ahead(values);
  }

  void exchange(state::Archive& archive) { archive("fields", std::span(batches_)); }

 private:
  struct Batch {
    alignas(64) std::array<std::array<double, kBatch>, kFields> values{};
  };
  std::vector<Batch> batches_;
};

}  // namespace adit::fdm
