#include "coupler/time/row_interval.hpp"

#include <algorithm>

namespace adit::coupler {
namespace {

constexpr double kDefaultRows = 500;

// With 20 samples in a period, straight lines between them lower the amplitude of a sine by
// 1 - sinc^2(1/20) = 0.8 %.
constexpr double kSamplesAPeriod = 20;

}  // namespace

double sampling_interval(const scene::Spectra& spectra) {
  return spectra.shortest_period() / kSamplesAPeriod;
}

double row_interval(const scene::Scene& scene) {
  const scene::Output& output = scene.output();
  if (output.has_history_interval()) return output.history_interval();
  double interval = scene.time().duration() / kDefaultRows;
  for (const auto& spectra : output.spectra()) interval = std::min(interval, sampling_interval(spectra));
  return interval;
}

}  // namespace adit::coupler
