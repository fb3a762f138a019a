// The steps at which results are written.
#pragma once

#include <cstdint>
#include <set>

#include "coupler/participants/set_up.hpp"

namespace adit::coupler {

class Schedule {
 public:
  // Throws protocol::UserError for times after the end of the run.
  explicit Schedule(const Model& model);

  bool wants_row(std::uint64_t n) const {
    return n % history_stride_ == 0 || n == last_ || fields_.contains(n);
  }
  // Whether the row of step n is one of the equally spaced ones, `interval` [s] apart.
  bool is_sample(std::uint64_t n) const { return n % history_stride_ == 0; }
  double interval() const { return interval_; }
  bool wants_fields(std::uint64_t n) const { return fields_.contains(n); }
  bool wants_peaks(std::uint64_t n) const {
    return peak_stride_ > 0 && (n % peak_stride_ == 0 || n == last_);
  }

 private:
  std::uint64_t last_, history_stride_;
  double interval_;
  std::uint64_t peak_stride_ = 0;  // 0: never
  std::set<std::uint64_t> fields_;
};

}  // namespace adit::coupler
