#include "coupler/output/motion_files.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "protocol/motion/measures.hpp"
#include "protocol/motion/spectra/response.hpp"
#include "protocol/motion/spectra/transfer.hpp"
#include "protocol/results/csv.hpp"

namespace adit::coupler {
namespace {

constexpr int kPeriods = 200;
constexpr double kUsualDamping = 0.05;

// Share of the largest smoothed amplitude of the motion below; less of it is no motion that could be
// amplified. The window of the smoothing alone leaks 0.5 %: its weight beyond its fifth zero is up to 2e-5,
// the square of that. Ground beyond elasticity makes frequencies of its own: a hysteretic site under a record
// has 5 to 8 % of the peak at all frequencies above 10 Hz, whatever comes from below.
constexpr double kNoMotion = 0.03;

std::vector<double> periods(const scene::Spectra& spectra) {
  return motion::logarithmic_periods(spectra.shortest_period(), spectra.longest_period(), kPeriods);
}

// Of the numbers among them.
double largest(const std::vector<double>& values) {
  double result = 0;
  for (const double value : values) result = value > result ? value : result;
  return result;
}

}  // namespace

void write_motion(const std::filesystem::path& path, const motion::Motion& motion, double place) {
  const motion::Course course = motion::integrate(motion);
  const std::vector<double> husid = motion::husid(motion);
  const std::vector<std::string> columns{"time_s", "acceleration_m_per_s2", "velocity_m_per_s",
                                         "displacement_m", "arias_share"};
  results::CsvFile file(path, columns);
  for (std::size_t i = 0; i < husid.size(); ++i)
    file.row(std::vector{static_cast<double>(i) * motion.dt, motion.acceleration[i], course.velocity[i],
                         place + course.displacement[i], husid[i]});
}

void write_response(const std::filesystem::path& path, const motion::Motion& motion,
                    const scene::Spectra& spectra) {
  std::vector<double> dampings(spectra.damping().begin(), spectra.damping().end());
  if (dampings.empty()) dampings.push_back(kUsualDamping);
  std::vector<std::string> columns{"period_s"};
  std::vector<std::vector<double>> rows;
  for (const double period : periods(spectra)) rows.push_back({period});
  for (const double damping : dampings) {
    const std::string percent = fmt::format("{:g}pct", 100 * damping);
    for (const auto& [kind, unit] : {std::pair{"sd", "m"},
                                     {"sv", "m_per_s"},
                                     {"sa", "m_per_s2"},
                                     {"psv", "m_per_s"},
                                     {"psa", "m_per_s2"}})
      columns.push_back(fmt::format("{}_{}_{}", kind, percent, unit));
    const auto spectrum = motion::response_spectrum(motion, periods(spectra), damping);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double w = 2 * std::numbers::pi / spectrum.period[i], u = spectrum.displacement[i];
      rows[i].insert(rows[i].end(), {u, spectrum.velocity[i], spectrum.absolute_acceleration[i], w * u,
                                     spectrum.pseudo_acceleration[i]});
    }
  }
  results::CsvFile file(path, columns);
  for (const auto& row : rows) file.row(row);
}

void write_fourier(const std::filesystem::path& path, const motion::Motion& motion) {
  const auto spectrum = motion::fourier_spectrum(motion);
  const std::vector<std::string> columns{"frequency_Hz", "amplitude_m_per_s"};
  results::CsvFile file(path, columns);
  // The line at 0 Hz is no shaking but the velocity that the motion ends with, which <motion>_motion.csv
  // tells.
  for (std::size_t k = 1; k < spectrum.frequency.size(); ++k)
    file.row(std::vector{spectrum.frequency[k], spectrum.amplitude[k]});
}

Amplification write_transfer(const std::filesystem::path& path, const motion::Motion& from,
                             const motion::Motion& to, const std::string& name_of_from,
                             const scene::Spectra& spectra) {
  std::vector<double> frequencies;
  for (const double period : periods(spectra)) frequencies.push_back(1 / period);
  std::ranges::reverse(frequencies);
  const auto below = motion::smoothed_amplitude(from, frequencies),
             above = motion::smoothed_amplitude(to, frequencies);
  auto ratio = motion::transfer_function(from, to, frequencies);
  const double least = kNoMotion * largest(below);
  for (std::size_t k = 0; k < ratio.size(); ++k)
    if (!(below[k] >= least)) ratio[k] = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::string> columns{"frequency_Hz", "amplitude_m_per_s",
                                         name_of_from + "_amplitude_m_per_s", "ratio"};
  results::CsvFile file(path, columns);
  Amplification top{frequencies[0], 0};
  for (std::size_t k = 0; k < ratio.size(); ++k) {
    file.row(std::vector{frequencies[k], above[k], below[k], ratio[k]});
    if (ratio[k] > top.ratio) top = {frequencies[k], ratio[k]};
  }
  return top;
}

}  // namespace adit::coupler
