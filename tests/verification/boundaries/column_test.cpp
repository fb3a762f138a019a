// Requirement: a column under vertical shear waves has the transfer function of theory. The grid carries waves of 10 zones
// slower by about 1 %, which moves its resonances: so its amplitude must be within 1 % of the theory's at a
// frequency within 1 %, down to wavelengths of 10 zones; and at the frequency itself down to 20 zones.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/unit/fdm_server/boundary_scenes.hpp"
#include "tests/verification/boundaries/shear_column.hpp"

namespace adit::fdm::test {
namespace {

using std::numbers::pi;

constexpr double kRatio = 0.05, kLow = 2, kHigh = 20;  // Rayleigh damping [Hz]
constexpr double kWavelet = 15, kDelay = 0.2;          // [Hz], [s]
constexpr double kFinest = 40;                         // [Hz]: waves of 10 zones in every layer

// Velocity of the wavelet whose acceleration has the peak 1 m/s².
double wavelet(double t) {
  const double x = pi * kWavelet * (t - kDelay);
  return x / (pi * kWavelet) * std::exp(-x * x);
}

// Layers from the surface down, each a block of zones of a tenth of its shortest wave, all in one row.
std::string column(const std::vector<SoilLayer>& layers, const std::string& kind, const std::string& others) {
  std::string blocks, materials;
  double top = 0, width = 0;
  for (const auto& layer : layers) width = std::max(width, 4 * layer.shear_velocity / (10 * kFinest));
  for (const auto& [thickness, velocity, density] : layers) {
    const double bottom = top - thickness;
    const auto zones = static_cast<int>(std::round(thickness / (velocity / (10 * kFinest))));
    blocks += fmt::format("blocks {{ rectangle {{ x_min: 0 x_max: {} y_min: {} y_max: {} }} along {{ zones: 1 }} "
                          "across {{ zones: {} }} }} ",
                          width, bottom, top, zones);
    materials += fmt::format("materials {{ where {{ y_min: {} y_max: {} }} material {{ young_modulus: {} "
                             "poisson_ratio: 0.25 density: {} }} }} ",
                             bottom, top, 2.5 * density * velocity * velocity, density);
    top = bottom;
  }
  const std::string sideways = kind == "RIGID" ? fmt::format("y_min: {}", top + 0.01) : "";
  return blocks + materials +
         fmt::format("motions {{ where {{ {} }} velocity {{ y: 0 }} }} base {{ kind: {} acceleration {{ ricker {{ "
                     "frequency: {} time: {} }} baseline: false }} }} histories {{ name: 's' quantity: VELOCITY_X at "
                     "{{ x: 0 y: 0 }} }} histories {{ name: 'm' quantity: VELOCITY_X at {{ x: 0 y: {} }} }} ",
                     sideways, kind, kWavelet, kDelay, top / 2) +
         others;
}

struct Case {
  std::string name, kind;
  std::vector<SoilLayer> layers;
};

class Column : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(
    Columns, Column,
    testing::Values(Case{"uniform_rigid", "RIGID", {{30, 200, 2000}}},
                    Case{"uniform_compliant", "COMPLIANT", {{30, 200, 2000}}},
                    Case{"layered_rigid", "RIGID", {{8, 160, 1800}, {14, 280, 1900}, {8, 400, 2000}}},
                    Case{"layered_compliant", "COMPLIANT", {{8, 160, 1800}, {14, 280, 1900}, {12, 600, 2200}}}),
    [](const auto& test) { return test.param.name; });

TEST_P(Column, HasTheTransferFunctionOfTheory) {
  const auto& [name, kind, layers] = GetParam();
  const DampingLaw law = rayleigh(kRatio, kLow, kHigh);
  const SoilLayer* half_space = kind == "COMPLIANT" ? &layers.back() : nullptr;
  GroundRun run(column(layers, kind, fmt::format("damping {{ rayleigh {{ ratio: {} low_frequency: {} high_frequency: "
                                                 "{} }} }}",
                                                 kRatio, kLow, kHigh)),
                15, 1);
  std::vector<double> frequencies;
  for (double f = 0.5; f <= kFinest; f += 0.5) frequencies.push_back(f);
  std::vector<std::complex<double>> surface(frequencies.size()), base(frequencies.size());
  for (std::uint64_t n = 0; n <= run.steps(); ++n) {
    const double v = run.advance().histories(0), t = (static_cast<double>(n) - 0.5) * run.dt;
    for (std::size_t k = 0; k < frequencies.size(); ++k) {
      const auto wave = std::polar(1.0, -2 * pi * frequencies[k] * t);
      surface[k] += v * wave;
      base[k] += wavelet(t) * wave;
    }
  }
  double moved = 0, at_place = 0;
  for (std::size_t k = 0; k < frequencies.size(); ++k) {
    const double measured = std::abs(surface[k] / base[k]);
    const auto error = [&](double f) {
      return std::abs(measured / std::abs(transfer(layers, law, half_space, f)) - 1);
    };
    double nearest = 1;
    for (double shift = 0.99; shift <= 1.01; shift += 5e-4) nearest = std::min(nearest, error(shift * frequencies[k]));
    moved = std::max(moved, nearest);
    if (frequencies[k] <= kFinest / 2) at_place = std::max(at_place, error(frequencies[k]));
  }
  RecordProperty("largest_error_within_1_percent_of_frequency", std::to_string(moved));
  RecordProperty("largest_error_to_20_zones", std::to_string(at_place));
  EXPECT_LE(moved, 0.01);
  EXPECT_LE(at_place, 0.01);
}

// Outcrop: the wave that rises is half of the outcrop's motion, the free surface doubles it again, each within 1 %; and
// the base takes all that comes back.
TEST(CompliantBase, SurfaceMovesAsTheOutcrop) {
  GroundRun run(column({{30, 200, 2000}}, "COMPLIANT", ""), 0.8, 0.5);
  const double largest = wavelet(kDelay + 1 / (pi * kWavelet * std::sqrt(2.0)));
  double surface = 0, middle_rising = 0, last = 0, most = 0;
  for (std::uint64_t n = 0; n <= run.steps(); ++n) {
    const auto& answer = run.advance();
    const double t = (static_cast<double>(n) - 0.5) * run.dt;
    surface = std::max(surface, std::abs(answer.histories(0)));
    if (t < kDelay + 0.075 + 0.06) middle_rising = std::max(middle_rising, std::abs(answer.histories(1)));
    last = answer.energies().kinetic() + answer.energies().strain();
    most = std::max(most, last);
  }
  EXPECT_NEAR(surface / largest, 1, 0.01);
  EXPECT_NEAR(middle_rising / largest, 0.5, 0.005);
  EXPECT_LT(last, 1e-4 * most);
}

}  // namespace
}  // namespace adit::fdm::test
