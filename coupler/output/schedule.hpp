// The steps at which results are written.
#pragma once

#include <cstdint>
#include <set>

#include "coupler/exchange/round_trip.hpp"
#include "coupler/participants/set_up.hpp"

namespace adit::coupler {

class Schedule {
 public:
  // Throws protocol::UserError for times after the end of the run. `stride`: the steps between two rows of a
  // run that goes on, 0 of one that begins.
  explicit Schedule(const Model& model, std::uint64_t stride = 0);

  bool wants_row(std::uint64_t n) const {
    return n % history_stride_ == 0 || n == last_ || fields_.contains(n);
  }
  // Whether the row of step n is one of the equally spaced ones, `interval` [s] apart.
  bool is_sample(std::uint64_t n) const { return n % history_stride_ == 0; }
  double interval() const { return interval_; }
  std::uint64_t stride() const { return history_stride_; }
  std::uint64_t row_count() const;
  std::uint64_t peak_count() const { return peak_stride_ > 0 ? last_ / peak_stride_ + 1 : 0; }
  bool wants_fields(std::uint64_t n) const { return fields_.contains(n); }
  std::size_t field_count() const { return fields_.size(); }
  // Says where the times of rows and fields are not those stated.
  void compare(Model& model) const;
  bool wants_peaks(std::uint64_t n) const {
    return peak_stride_ > 0 && (n % peak_stride_ == 0 || n == last_);
  }
  // Whether the energy is compared with the work done at step n.
  bool watches(std::uint64_t n) const { return wants_row(n) || n % kWatchInterval == 0; }
  Wanted wanted(std::uint64_t n) const {
    return {.energies = watches(n), .histories = wants_row(n), .peaks = wants_peaks(n)};
  }

 private:
  // Steps between two checks of the energy. At 1 % above the critical time step the fastest motion grows from
  // rounding errors to a size that the ledger sees within about 70 steps. A check is not free: in its step
  // the servers cannot compute the interior during the exchange.
  static constexpr std::uint64_t kWatchInterval = 50;

  std::uint64_t last_, history_stride_;
  double interval_;
  std::uint64_t peak_stride_ = 0;  // 0: never
  std::set<std::uint64_t> fields_;
};

}  // namespace adit::coupler
