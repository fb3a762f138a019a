#include "dem_server/lining/ovals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "dem_server/lining/median.hpp"

namespace adit::dem {
namespace {

using std::numbers::pi;

constexpr double kFewestSectors = 8, kMostSectors = 72;
constexpr double kOnLine = 1e-9;  // of a sector, beyond the rounding of places

// A multiple of four, so that lines between sectors lie on both axes: a ring that is mirrored at them, or
// turned by a quarter, has the same diameters.
std::size_t number_of_sectors(double mean_radius, double largest_particle) {
  const double quarter = pi / 2 * mean_radius;
  return static_cast<std::size_t>(
      std::clamp(4 * std::floor(quarter / (4 * largest_particle)), kFewestSectors, kMostSectors));
}

}  // namespace

Oval::Oval(std::string name, const geometry::Point& centre, double inner_radius, double outer_radius,
           const Particles& p)
    : name_(std::move(name)), centre_(centre) {
  const double largest = p.radius.empty() ? 0 : std::ranges::max(p.radius);
  sectors_.resize(number_of_sectors((inner_radius + outer_radius) / 2, largest));
  const auto count = static_cast<double>(sectors_.size());
  for (std::uint32_t i = 0; i < p.size(); ++i) {
    const double x = p.x[i] - centre.x, y = p.y[i] - centre.y, distance = std::hypot(x, y);
    if (distance < inner_radius || distance > outer_radius) continue;
    // A particle on the line between two sectors is of both: a mirrored ring has the same diameters.
    const double place = std::atan2(y, x) / (2 * pi) * count;
    const std::size_t sector = sector_at(place - kOnLine), next = sector_at(place + kOnLine);
    sectors_[sector].push_back(i);
    if (next != sector) sectors_[next].push_back(i);
  }
}

// `place`: of an angle, in sectors from x.
std::size_t Oval::sector_at(double place) const {
  const auto count = static_cast<double>(sectors_.size());
  return static_cast<std::size_t>(place - std::floor(place / count) * count) % sectors_.size();
}

bool Oval::is_whole() const {
  return std::ranges::none_of(sectors_, [](const auto& sector) { return sector.empty(); });
}

double Oval::middle_of(std::size_t sector) const {
  return 2 * pi * (static_cast<double>(sector) + 0.5) / static_cast<double>(sectors_.size());
}

geometry::Point Oval::translation(const Particles& p) const {
  std::vector<double> x, y;
  for (const auto& sector : sectors_)
    for (const std::uint32_t i : sector) {
      if (!p.is_there(i)) continue;
      x.push_back(p.ux[i] - p.settled_x[i]);
      y.push_back(p.uy[i] - p.settled_y[i]);
    }
  return x.empty() ? geometry::Point{0, 0} : geometry::Point{median(std::move(x)), median(std::move(y))};
}

double Oval::outwards(std::size_t sector, const geometry::Point& moved, const Particles& p) const {
  std::vector<double> values;
  for (const std::uint32_t i : sectors_[sector]) {
    if (!p.is_there(i)) continue;
    const double x = p.x[i] - centre_.x, y = p.y[i] - centre_.y;
    const double ux = p.ux[i] - p.settled_x[i] - moved.x, uy = p.uy[i] - p.settled_y[i] - moved.y;
    values.push_back((ux * x + uy * y) / std::hypot(x, y));
  }
  return values.empty() ? std::numeric_limits<double>::quiet_NaN() : median(std::move(values));
}

DiameterChange Oval::change(const Particles& particles) const {
  const geometry::Point moved = translation(particles);
  double mean = 0, a = 0, b = 0;
  for (std::size_t k = 0; k < sectors_.size(); ++k) {
    const double u = outwards(k, moved, particles);
    mean += u;
    a += 2 * u * std::cos(2 * middle_of(k));
    b += 2 * u * std::sin(2 * middle_of(k));
  }
  const auto count = static_cast<double>(sectors_.size());
  const double oval = std::hypot(a, b);
  return {2 * (mean + oval) / count, 2 * (mean - oval) / count, std::atan2(b, a) / 2};
}

void OvalEnvelope::take(std::span<const DiameterChange> changes, double time) {
  const bool first = largest_.empty();
  for (std::size_t k = 0; k < changes.size(); ++k) {
    const auto [most, least, direction] = changes[k];
    const Extreme now{most, time, direction};
    const Extreme across{least, time, direction > 0 ? direction - pi / 2 : direction + pi / 2};
    if (first) {
      largest_.push_back(now);
      smallest_.push_back(across);
      continue;
    }
    if (now.value > largest_[k].value) largest_[k] = now;
    if (across.value < smallest_[k].value) smallest_[k] = across;
  }
}

}  // namespace adit::dem
