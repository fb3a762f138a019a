#include "dem_server/packing/pressed_discs.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace adit::dem {
namespace {

// All discs have mass 1. A disc of six neighbours has a frequency of at most sqrt(2 · 6 kn / m): the longest
// step keeps well below 2 / sqrt(12).
constexpr double kFirstStep = 0.1, kLongestStep = 0.4;
// The published settings of the relaxation.
constexpr double kGrowth = 1.1, kShrink = 0.5, kMixing = 0.1, kMixingShrink = 0.99;
constexpr int kPatience = 5;
// Contacts whose mean overlap is this share of the smallest radius carry nothing: the discs are loose.
constexpr double kLoose = 1e-10;

}  // namespace

PressedDiscs::PressedDiscs(Discs discs, const geometry::BoundingBox& box)
    : discs_(std::move(discs)), box_(box), skin_(0.3 * *std::ranges::min_element(discs_.radius)) {
  for (auto* column : {&fx_, &fy_, &vx_, &vy_}) column->resize(discs_.size());
  list_neighbours();
}

void PressedDiscs::scale_radii(double factor) {
  for (double& radius : discs_.radius) radius *= factor;
  skin_ *= factor;
  list_neighbours();
}

void PressedDiscs::list_neighbours() {
  neighbours_ = pairs_within(discs_, skin_);
  listed_x_ = discs_.x;
  listed_y_ = discs_.y;
}

bool PressedDiscs::neighbours_are_stale() const {
  double farthest = 0;
  for (std::size_t i = 0; i < discs_.size(); ++i) {
    const double dx = discs_.x[i] - listed_x_[i], dy = discs_.y[i] - listed_y_[i];
    farthest = std::max(farthest, dx * dx + dy * dy);
  }
  // Two discs that approach each other close the skin when each has moved by half of it.
  return farthest > skin_ * skin_ / 4;
}

PressedDiscs::Forces PressedDiscs::add_forces() {
  const auto& [x, y, radius] = discs_;
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < discs_.size(); ++i) {
    const double left = std::max(0.0, radius[i] - (x[i] - box_.x_min));
    const double right = std::max(0.0, radius[i] - (box_.x_max - x[i]));
    const double below = std::max(0.0, radius[i] - (y[i] - box_.y_min));
    const double above = std::max(0.0, radius[i] - (box_.y_max - y[i]));
    fx_[i] = left - right;
    fy_[i] = below - above;
    sum += left + right + below + above;
    count += (left > 0) + (right > 0) + (below > 0) + (above > 0);
  }
  for (const auto [i, j] : neighbours_) {
    const double dx = x[j] - x[i], dy = y[j] - y[i], touch = radius[i] + radius[j];
    const double square = dx * dx + dy * dy;
    if (square >= touch * touch) continue;
    const double distance = std::sqrt(square), push = touch - distance;
    // discs at one point part along x
    const double nx = distance > 0 ? dx / distance : 1, ny = distance > 0 ? dy / distance : 0;
    fx_[i] -= push * nx;
    fy_[i] -= push * ny;
    fx_[j] += push * nx;
    fy_[j] += push * ny;
    sum += push;
    ++count;
  }
  Forces forces;
  for (std::size_t i = 0; i < discs_.size(); ++i)
    forces.unbalanced += std::sqrt(fx_[i] * fx_[i] + fy_[i] * fy_[i]);
  forces.unbalanced /= static_cast<double>(discs_.size());
  forces.contact = count > 0 ? sum / static_cast<double>(count) : 0;
  return forces;
}

bool PressedDiscs::relax(double tolerance, std::uint32_t most_steps) {
  const double radius = *std::ranges::min_element(discs_.radius);
  double dt = kFirstStep, mixing = kMixing;
  int downhill = 0;
  for (auto* velocity : {&vx_, &vy_}) std::ranges::fill(*velocity, 0.0);
  for (std::uint32_t step = 0; step < most_steps; ++step) {
    if (neighbours_are_stale()) list_neighbours();
    const Forces forces = add_forces();
    if (forces.unbalanced <= tolerance * forces.contact || forces.contact <= kLoose * radius) return true;

    const double power = std::inner_product(fx_.begin(), fx_.end(), vx_.begin(), 0.0) +
                         std::inner_product(fy_.begin(), fy_.end(), vy_.begin(), 0.0);
    // While the discs move downhill, velocities turn towards the forces; as soon as they move uphill, all
    // stop.
    if (power > 0) {
      const auto square = [](const auto& a, const auto& b) {
        return std::inner_product(a.begin(), a.end(), a.begin(), 0.0) +
               std::inner_product(b.begin(), b.end(), b.begin(), 0.0);
      };
      const double turn = mixing * std::sqrt(square(vx_, vy_) / square(fx_, fy_));
      for (std::size_t i = 0; i < discs_.size(); ++i) {
        vx_[i] = (1 - mixing) * vx_[i] + turn * fx_[i];
        vy_[i] = (1 - mixing) * vy_[i] + turn * fy_[i];
      }
      if (++downhill > kPatience) {
        dt = std::min(dt * kGrowth, kLongestStep);
        mixing *= kMixingShrink;
      }
    } else {
      for (auto* velocity : {&vx_, &vy_}) std::ranges::fill(*velocity, 0.0);
      dt *= kShrink;
      mixing = kMixing;
      downhill = 0;
    }
    for (std::size_t i = 0; i < discs_.size(); ++i) {
      // The new velocity moves the discs (semi-implicit Euler), which stays stable where the explicit rule
      // gains energy.
      vx_[i] += dt * fx_[i];
      vy_[i] += dt * fy_[i];
      discs_.x[i] += dt * vx_[i];
      discs_.y[i] += dt * vy_[i];
    }
  }
  return false;
}

std::array<double, 2> PressedDiscs::wall_stress() const {
  double across = 0, up = 0;
  for (std::size_t i = 0; i < discs_.size(); ++i) {
    const double r = discs_.radius[i];
    across += std::max(0.0, r - (discs_.x[i] - box_.x_min)) + std::max(0.0, r - (box_.x_max - discs_.x[i]));
    up += std::max(0.0, r - (discs_.y[i] - box_.y_min)) + std::max(0.0, r - (box_.y_max - discs_.y[i]));
  }
  return {across / (2 * (box_.y_max - box_.y_min)), up / (2 * (box_.x_max - box_.x_min))};
}

std::vector<Pair> PressedDiscs::contacts() const {
  return pairs_within(discs_, 0);
}

std::vector<std::uint32_t> PressedDiscs::wall_contacts() const {
  std::vector<std::uint32_t> count;
  for (std::size_t i = 0; i < discs_.size(); ++i) {
    const double r = discs_.radius[i], x = discs_.x[i], y = discs_.y[i];
    count.push_back((x - r < box_.x_min) + (x + r > box_.x_max) + (y - r < box_.y_min) +
                    (y + r > box_.y_max));
  }
  return count;
}

}  // namespace adit::dem
