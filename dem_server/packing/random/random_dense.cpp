#include "dem_server/packing/random/random_dense.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>

#include "dem_server/packing/random/pressed_discs.hpp"
#include "dem_server/packing/useful_threads.hpp"
#include "protocol/motion/random.hpp"
#include "protocol/threads/team.hpp"

namespace adit::dem {

using protocol::Progress;

namespace {

constexpr double kStartScale = 0.5;
constexpr int kGrowthSteps = 20;
constexpr std::uint32_t kStepsWhileGrowing = 100, kStepsToRest = 200000;
constexpr double kAtRest = 1e-3;  // mean unbalanced over mean contact force
constexpr double kStressTolerance = 0.01;
constexpr int kStressTrials = 60;
// Change of stress, over the normal stiffness, with the logarithm of the radii: a lattice of six contacts a
// disc has sqrt(3), one that has just jammed little.
constexpr double kStiffest = 1.7, kSoftest = 0.2;
constexpr double kLargestGrowth = 0.02, kLooseGrowth = 0.002;
// Discs that press the walls by a smaller share of the stress than this are still loose.
constexpr double kJammed = 1e-3;
constexpr std::uint32_t kFewestContacts = 3;

double area(const geometry::BoundingBox& box) {
  return (box.x_max - box.x_min) * (box.y_max - box.y_min);
}

double area(const Discs& discs) {
  double sum = 0;
  for (const double r : discs.radius) sum += std::numbers::pi * r * r;
  return sum;
}

// Strip by strip, each from below to above: what is near in the box lies near in memory.
void put_in_strips(Discs& discs) {
  const double width = 32 * std::ranges::max(discs.radius);
  std::vector<std::uint32_t> order(discs.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(
      order, {}, [&](std::uint32_t i) { return std::tuple(std::floor(discs.x[i] / width), discs.y[i], i); });
  for (auto* column : {&discs.x, &discs.y, &discs.radius}) {
    const std::vector<double> drawn = *column;
    std::ranges::transform(order, column->begin(), [&](std::uint32_t i) { return drawn[i]; });
  }
}

Discs draw(const RandomPacking& wanted) {
  motion::Random random(wanted.seed);
  const auto between = [&random](double low, double high) { return low + (high - low) * random.uniform(); };
  const double solid = (1 - wanted.porosity) * area(wanted.box);
  Discs discs;
  for (double sum = 0; sum < solid;) {
    const double r = between(wanted.radius_min, wanted.radius_max);
    sum += std::numbers::pi * r * r;
    discs.radius.push_back(r);
    discs.x.push_back(between(wanted.box.x_min + r, wanted.box.x_max - r));
    discs.y.push_back(between(wanted.box.y_min + r, wanted.box.y_max - r));
  }
  put_in_strips(discs);
  return discs;
}

void grow(PressedDiscs& pressed, const Progress& progress) {
  const double factor = std::pow(1 / kStartScale, 1.0 / kGrowthSteps);
  for (int step = 1; step <= kGrowthSteps; ++step) {
    // Between growth steps the discs need not come to rest; a few steps part those that overlap most.
    pressed.relax(kAtRest, kStepsWhileGrowing);
    pressed.scale_radii(factor);
    progress(fmt::format("growing {} discs: step {} of {}", pressed.size(), step, kGrowthSteps));
  }
}

double mean_stress(const PressedDiscs& pressed) {
  const auto [across, up] = pressed.wall_stress();
  return (across + up) / 2;
}

// Changes all radii until the walls feel the stress: secants of stress over the logarithm of the radii.
// Returns the factor of the radii, no value where the stress is not reached.
std::optional<double> install_stress(double stress, PressedDiscs& pressed, const Progress& progress) {
  double stiffness = kStiffest, growth = 0, total = 0, before = 0;
  for (int trial = 0; trial < kStressTrials; ++trial) {
    if (!pressed.relax(kAtRest, kStepsToRest)) return std::nullopt;
    const double reached = mean_stress(pressed);
    progress(fmt::format("isotropic stress {:.4g} of {:.4g} times the normal stiffness", reached, stress));
    if (std::abs(reached - stress) <= kStressTolerance * stress) return std::exp(total);
    // Loose discs press hardly at all, so their stress says nothing about the stiffness: the radii grow by a
    // fixed small share until the discs touch.
    const bool jammed = reached > kJammed * stress;
    // A secant needs two jammed states; its slope is kept between bounds, because two states close to each
    // other give any slope.
    if (jammed && before > 0) stiffness = std::clamp((reached - before) / growth, kSoftest, kStiffest);
    before = jammed ? reached : 0;
    growth =
        jammed ? std::clamp((stress - reached) / stiffness, -kLargestGrowth, kLargestGrowth) : kLooseGrowth;
    pressed.scale_radii(std::exp(growth));
    total += growth;
  }
  return std::nullopt;
}

std::vector<bool> holders(const PressedDiscs& pressed) {
  return without_floaters(pressed.size(), pressed.contacts(), pressed.wall_contacts(), kFewestContacts);
}

// Mean number of contacts, walls included, among the discs that are kept.
double coordination(const PressedDiscs& pressed, const std::vector<bool>& keep) {
  std::size_t ends = 0;
  for (const auto [i, j] : pressed.contacts())
    if (keep[i] && keep[j]) ends += 2;
  const auto walls = pressed.wall_contacts();
  for (std::size_t i = 0; i < keep.size(); ++i)
    if (keep[i]) ends += walls[i];
  const auto held = std::ranges::count(keep, true);
  return held > 0 ? static_cast<double>(ends) / static_cast<double>(held) : 0;
}

}  // namespace

double count_random(const RandomPacking& wanted) {
  const double a = wanted.radius_min, b = wanted.radius_max;
  return (1 - wanted.porosity) * area(wanted.box) / (std::numbers::pi * (a * a + a * b + b * b) / 3);
}

std::optional<GrownPacking> pack_randomly(const RandomPacking& wanted, const Growing& growing) {
  const Progress& progress = growing.progress;
  const Discs drawn = draw(wanted);
  protocol::Team team(growing.threads > 0 ? growing.threads : useful_threads(drawn.size()));
  PressedDiscs pressed(drawn, wanted.box, team);
  pressed.scale_radii(kStartScale);
  grow(pressed, progress);
  auto factor = install_stress(wanted.stress, pressed, progress);
  if (!factor) return std::nullopt;
  GrownPacking grown;
  grown.state.porosity = 1 - area(pressed.discs()) / area(wanted.box);

  auto keep = holders(pressed);
  const auto floaters = [&keep] { return static_cast<std::size_t>(std::ranges::count(keep, false)); };
  grown.state.floaters = floaters();
  // A disc squeezed between two others is not quite a floater: without it the rest moves, which may make
  // others.
  while (wanted.stands && !wanted.keep_floaters && floaters() > 0) {
    Discs held = pressed.discs();
    keep_only(keep, held);
    if (held.size() == 0) return std::nullopt;
    pressed = PressedDiscs(held, wanted.box, team);
    const auto again = install_stress(wanted.stress, pressed, progress);
    if (!again) return std::nullopt;
    *factor *= *again;
    keep = holders(pressed);
    grown.state.floaters += floaters();
  }
  const auto [across, up] = pressed.wall_stress();
  grown.state.stress_x = across;
  grown.state.stress_y = up;
  grown.state.coordination = coordination(pressed, keep);
  grown.state.radius_factor = *factor;
  grown.discs = pressed.discs();
  if (!wanted.keep_floaters) keep_only(keep, grown.discs);
  if (grown.discs.size() == 0) return std::nullopt;
  return grown;
}

}  // namespace adit::dem
