#include "simplified/column/modes/mode_count.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "protocol/errors.hpp"
#include "simplified/column/modes/wave_theory.hpp"

namespace adit::simplified::column {

namespace {

// The amplification at a series of frequencies, while modes are added one by one.
class Study {
 public:
  // Takes eight samples within half the width of the sharpest peak, which is the first.
  Study(const Deposit& deposit, const Mode& first, double highest_frequency, double depth)
      : deposit_(deposit), depth_(depth) {
    // The least damping of 0.005 limits the number of samples for a deposit that is hardly damped.
    const double spacing = first.frequency * std::max(first.damping, 0.005) / 8;
    const auto samples = static_cast<std::size_t>(std::ceil(highest_frequency / spacing));
    for (std::size_t i = 1; i <= samples; ++i) {
      const double frequency = highest_frequency * static_cast<double>(i) / static_cast<double>(samples);
      samples_.push_back({frequency, std::abs(wave_transfer(deposit, frequency, depth)), 1, deposit.mass()});
      largest_ = std::max(largest_, samples_.back().exact);
    }
  }

  void add(const Mode& mode) {
    const double psi = mode.participation * shape(deposit_, mode, depth_);
    for (Sample& sample : samples_) {
      const auto q = oscillator_over_base(mode, sample.frequency);
      sample.over_base += psi * q;
      sample.base_mass += mode.effective_mass * q;
    }
  }

  double error() const {
    double worst = 0;
    for (const Sample& sample : samples_) {
      const double f = sample.frequency;
      const auto modal = sample.over_base * base_over_given(deposit_, f, -f * f * sample.base_mass);
      worst = std::max(worst, std::abs(std::abs(modal) - sample.exact));
    }
    return worst / largest_;
  }

 private:
  struct Sample {
    double frequency, exact;
    std::complex<double> over_base, base_mass;  // base_stiffness / -omega^2
  };
  const Deposit& deposit_;
  double depth_, largest_ = 0;
  std::vector<Sample> samples_;
};

}  // namespace

double amplification_error(const ModalColumn& column, double highest_frequency, double depth) {
  Study study(column.deposit, column.modes.front(), highest_frequency, depth);
  for (const Mode& mode : column.modes) study.add(mode);
  return study.error();
}

std::size_t modes_needed(const Deposit& deposit, double highest_frequency, double error, double depth) {
  const std::vector<Mode> candidates = modes(deposit, kMostModes);
  // Modes are added to the sums one at a time, so that trying N modes costs N passes and not N^2 / 2.
  Study study(deposit, candidates.front(), highest_frequency, depth);
  double least = 1;
  for (std::size_t n = 0; n < candidates.size(); ++n) {
    study.add(candidates[n]);
    const double reached = study.error();
    if (reached <= error) return n + 1;
    least = std::min(least, reached);
  }
  throw protocol::UserError(
      "",
      fmt::format("the modal soil column does not reach an error of {:.3g} up to {:.3g} Hz with {} modes: "
                  "the smallest is {:.3g}; allow that, lower the highest frequency or give the layers "
                  "damping ratios that differ less",
                  error, highest_frequency / (2 * std::numbers::pi), kMostModes, least));
}

}  // namespace adit::simplified::column
