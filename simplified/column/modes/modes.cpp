#include "simplified/column/modes/modes.hpp"

#include <cmath>
#include <numbers>

#include "simplified/column/modes/harmonic.hpp"

// Pruefer's phase theta of a wave that is free of stress at the surface: in a layer of impedance Z = rho V,
// phi = R cos(theta) and G phi' = -omega Z R sin(theta), where theta grows by omega h / V over the layer. At
// an interface phi and G phi' are continuous, so tan(theta) is multiplied by Z_above/Z_below and theta stays
// in its quadrant. Each of these steps increases with omega, so theta at the rock increases strictly, and phi
// = 0 there means theta = (n - 1/2) pi for mode n (Sturm). An interface changes theta by less than pi/2.
// Hence |theta - omega sum h/V| < (layers - 1) pi/2, which brackets every mode.

namespace adit::simplified::column {

namespace {

constexpr double kPi = std::numbers::pi;

struct Phase {
  double value, slope;  // theta at the rock [rad], d theta / d omega [s]
};

Phase phase_at_rock(const Deposit& deposit, double frequency) {
  Phase phase{0, 0};
  for (std::size_t i = 0; i < deposit.layers.size(); ++i) {
    const Layer& layer = deposit.layers[i];
    if (i > 0) {
      const double ratio = deposit.layers[i - 1].impedance() / layer.impedance();
      // atan2 knows the angle within one turn only. The change at the interface is less than pi/2, so adding
      // the change to the whole phase keeps the number of turns.
      const double angle = std::remainder(phase.value, 2 * kPi);
      const double c = std::cos(angle), s = std::sin(angle);
      phase.value += std::atan2(ratio * s, c) - angle;
      phase.slope *= ratio / (c * c + ratio * ratio * s * s);
    }
    phase.value += frequency * layer.thickness / layer.wave_velocity;
    phase.slope += layer.thickness / layer.wave_velocity;
  }
  return phase;
}

// Newton's iteration, kept within a shrinking bracket.
double frequency_of_mode(const Deposit& deposit, std::size_t number) {
  double travel_time = 0;
  for (const Layer& layer : deposit.layers) travel_time += layer.thickness / layer.wave_velocity;
  const double target = (static_cast<double>(number) - 0.5) * kPi;
  const double margin = static_cast<double>(deposit.layers.size() - 1) * kPi / 2;
  double low = std::max(0.0, target - margin) / travel_time, high = (target + margin) / travel_time;
  double frequency = target / travel_time;
  for (int i = 0; i < 200; ++i) {
    const Phase phase = phase_at_rock(deposit, frequency);
    (phase.value < target ? low : high) = frequency;
    double next = frequency - (phase.value - target) / phase.slope;
    if (!(next > low && next < high)) next = (low + high) / 2;
    // 1e-15 is a few rounding errors. Halving alone settles in far fewer than 200 rounds.
    const bool settled = std::abs(next - frequency) <= 1e-15 * frequency;
    frequency = next;
    if (settled) break;
  }
  return frequency;
}

// The amplitude of each layer, R exp(i theta) at its top: the real part is phi, the imaginary part -G
// phi'/(omega Z).
std::vector<std::complex<double>> amplitudes_of(const Deposit& deposit, double frequency) {
  std::vector<std::complex<double>> amplitudes;
  std::complex<double> amplitude = 1;
  for (std::size_t i = 0; i < deposit.layers.size(); ++i) {
    const Layer& layer = deposit.layers[i];
    if (i > 0) amplitude.imag(amplitude.imag() * deposit.layers[i - 1].impedance() / layer.impedance());
    amplitudes.push_back(amplitude);
    amplitude *= std::polar(1.0, frequency * layer.thickness / layer.wave_velocity);
  }
  return amplitudes;
}

Mode mode_of(const Deposit& deposit, double frequency) {
  Mode mode{frequency, 0, 0, 0, amplitudes_of(deposit, frequency)};
  double load = 0, mass = 0, energy = 0, loss = 0;
  for (std::size_t i = 0; i < deposit.layers.size(); ++i) {
    const Layer& layer = deposit.layers[i];
    const Harmonic phi{mode.amplitudes[i], frequency / layer.wave_velocity};
    const Harmonic strain = derivative(phi);
    const double layer_energy = layer.modulus() * integral(strain, strain, layer.thickness);
    load += layer.density * integral(phi, layer.thickness);
    mass += layer.density * integral(phi, phi, layer.thickness);
    energy += layer_energy;
    loss += layer.damping * layer_energy;
  }
  mode.damping = loss / energy;
  mode.participation = load / mass;
  mode.effective_mass = load * load / mass;
  return mode;
}

struct WaveAt {
  Harmonic wave;  // with s counted from the depth
  double modulus;
};

// Within the deposit; zero at the rock and below.
WaveAt wave_at(const Deposit& deposit, const Mode& mode, double depth) {
  double top = 0;
  for (std::size_t i = 0; i < deposit.layers.size(); ++i) {
    const Layer& layer = deposit.layers[i];
    if (depth < top + layer.thickness)
      return {further_down({mode.amplitudes[i], mode.frequency / layer.wave_velocity}, depth - top),
              layer.modulus()};
    top += layer.thickness;
  }
  return {};
}

}  // namespace

std::vector<Mode> modes(const Deposit& deposit, std::size_t count) {
  std::vector<Mode> result;
  for (std::size_t n = 1; n <= count; ++n) result.push_back(mode_of(deposit, frequency_of_mode(deposit, n)));
  return result;
}

double shape(const Deposit& deposit, const Mode& mode, double depth) {
  return wave_at(deposit, mode, depth).wave.amplitude.real();
}

double stress(const Deposit& deposit, const Mode& mode, double depth) {
  const WaveAt at = wave_at(deposit, mode, depth);
  return at.modulus * derivative(at.wave).amplitude.real();
}

}  // namespace adit::simplified::column
