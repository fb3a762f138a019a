#include "simplified/column/modes/deposit.hpp"

#include <fmt/format.h>

#include <cmath>

#include "protocol/errors.hpp"

namespace adit::simplified::column {

using protocol::UserError;

double Deposit::thickness() const {
  double sum = 0;
  for (const Layer& layer : layers) sum += layer.thickness;
  return sum;
}

double Deposit::mass() const {
  double sum = 0;
  for (const Layer& layer : layers) sum += layer.density * layer.thickness;
  return sum;
}

namespace {

void check_positive(double value, const std::string& path, const char* quantity, const char* unit) {
  if (!(value > 0 && std::isfinite(value)))
    throw UserError(path, fmt::format("{} is {}{}: give a value above 0", quantity, value, unit));
}

}  // namespace

void check(const Deposit& deposit, const std::string& path) {
  if (deposit.layers.empty()) throw UserError(path + ".layers", "no soil layer: give at least one");
  for (std::size_t i = 0; i < deposit.layers.size(); ++i) {
    const Layer& layer = deposit.layers[i];
    const std::string where = fmt::format("{}.layers[{}]", path, i);
    check_positive(layer.thickness, where + ".thickness", "the layer's thickness", " m");
    check_positive(layer.density, where + ".density", "the layer's density", " kg/m^3");
    check_positive(layer.wave_velocity, where + ".wave_velocity", "the layer's wave velocity", " m/s");
    check_positive(layer.modulus_ratio, where + ".modulus_ratio", "the layer's modulus ratio", "");
    if (!(layer.damping >= 0 && layer.damping < 0.5))
      throw UserError(
          where + ".damping",
          fmt::format("the layer's damping ratio is {}: give a value from 0 to below 0.5", layer.damping));
  }
  if (deposit.rock) {
    check_positive(deposit.rock->density, path + ".rock.density", "the rock's density", " kg/m^3");
    check_positive(deposit.rock->wave_velocity, path + ".rock.wave_velocity", "the rock's wave velocity",
                   " m/s");
    check_positive(deposit.rock->modulus_ratio, path + ".rock.modulus_ratio", "the rock's modulus ratio", "");
  }
}

}  // namespace adit::simplified::column
