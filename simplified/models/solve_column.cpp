#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "simplified/column/modes/modes.hpp"
#include "simplified/models/solve.hpp"
#include "simplified/scene/along_chainage.hpp"

namespace adit::simplified {
namespace {

const char* const kNames[kDirections] = {"axial", "lateral", "vertical"};

// The least and the greatest value at each place over all steps.
Envelope envelope(const std::string& name, const char* unit, const std::vector<double>& table,
                  std::size_t places) {
  Envelope envelope{name, unit, std::vector<double>(places), std::vector<double>(places)};
  for (std::size_t i = 0; i < table.size(); ++i) {
    // The ground begins at rest, so the initial 0 is a value of the motion.
    double &least = envelope.least[i % places], &greatest = envelope.greatest[i % places];
    least = std::min(least, table[i]);
    greatest = std::max(greatest, table[i]);
  }
  return envelope;
}

Envelope fundamental_frequencies(const scene::Ground& ground, const std::vector<double>& chainages) {
  Envelope envelope{"fundamental_frequency", "Hz", {}, {}};
  for (const auto& column : columns(ground, chainages.front(), chainages.back(), kLateral))
    envelope.least.push_back(column::modes(column.deposit, 1)[0].frequency / (2 * std::numbers::pi));
  envelope.greatest = envelope.least;
  return envelope;
}

// Of the layer, counted from 1 as in soil_profile.csv.
std::string pressure_name(const LayerPressure& layer) {
  return "pressure_ratio_layer_" + std::to_string(layer.number + 1);
}

// The steps of the rows: every `stride`, and the last.
std::vector<std::uint64_t> rows_of(const Clock& clock) {
  std::vector<std::uint64_t> rows;
  for (std::uint64_t n = 0; n < clock.steps; n += clock.stride) rows.push_back(n);
  rows.push_back(clock.steps);
  return rows;
}

}  // namespace

Response solve_column(const scene::Simplified& scene, const GroundField& ground, const Clock& clock) {
  Response response;
  response.chainage = ground.chainage;
  response.envelopes = {fundamental_frequencies(scene.ground(), ground.chainage)};
  response.histories.columns = {"time_s"};
  const std::vector<std::uint64_t> rows = rows_of(clock);
  for (const std::uint64_t n : rows)
    response.histories.rows.emplace_back(1, static_cast<double>(n) * clock.dt);
  for (int d = 0; d < kDirections; ++d) {
    const Shaking& shaking = ground.shaking[d];
    if (shaking.places == 0) continue;
    const std::string name = kNames[d];
    response.envelopes.push_back(envelope(name + "_displacement", "m", shaking.displacement, shaking.places));
    response.envelopes.push_back(envelope(name + "_velocity", "m_per_s", shaking.velocity, shaking.places));
    response.envelopes.push_back(
        envelope(name + "_acceleration", "m_per_s2", shaking.acceleration, shaking.places));
    for (const scene::Station& station : scene.stations()) {
      const std::size_t place = nearest(ground.chainage, station.chainage());
      response.histories.columns.insert(response.histories.columns.end(),
                                        {station.name() + "_" + name + "_displacement_m",
                                         station.name() + "_" + name + "_acceleration_m_per_s2"});
      for (std::size_t row = 0; row < rows.size(); ++row) {
        const std::size_t at = rows[row] * shaking.places + place;
        response.histories.rows[row].insert(response.histories.rows[row].end(),
                                            {shaking.displacement[at], shaking.acceleration[at]});
      }
    }
  }
  for (const LayerPressure& layer : ground.pressure) {
    const std::size_t places = ground.chainage.size();
    response.envelopes.push_back(envelope(pressure_name(layer), "", layer.ratio, places));
    for (const scene::Station& station : scene.stations()) {
      response.histories.columns.push_back(station.name() + "_" + pressure_name(layer));
      for (std::size_t row = 0; row < rows.size(); ++row)
        response.histories.rows[row].push_back(
            layer.ratio[rows[row] * places + nearest(ground.chainage, station.chainage())]);
    }
  }
  response.figures = {{"columns", static_cast<double>(ground.chainage.size())}};
  return response;
}

}  // namespace adit::simplified
