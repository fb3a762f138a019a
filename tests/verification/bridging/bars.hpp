// Bars along x that consist of several pieces of grid and of lattice.
#pragma once

#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>
#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "protocol/messages/scene.pb.h"

namespace adit::test {

// Six rows of particles of 0.1 m or twelve of 0.05 m fill the height; ν = 1/3, because for any other ν the
// free surfaces of a lattice strain otherwise than those of a continuum.
constexpr double kLength = 8, kHeight = 0.6 * std::numbers::sqrt3;
constexpr double kYoung = 1e9, kDensity = 2000, kPoisson = 1.0 / 3;

struct Stretch {
  enum Kind { kGrid, kLattice } kind;
  double begin, end;  // [m]
  double size;        // of a zone, or a particle's radius [m]
};

// The overlap of stretches `outer` and `inner`: the first one ends at `outer_ends`, the second at
// `inner_ends`. A ring lies around the middle of the bar from `outer_ends` by `width` to both sides.
struct Joint {
  std::size_t outer, inner;
  double inner_ends, outer_ends;
  double ring_ends = 0;  // the ring's shape reaches from `outer_ends` to here
  bool is_ring() const { return ring_ends > 0; }
};

struct Bar {
  std::string name;
  std::vector<Stretch> stretches;
  std::vector<Joint> joints;
};

inline std::string name_of(std::size_t stretch) {
  return fmt::format("stretch_{}", stretch);
}

inline void set_stretch(const Stretch& stretch, scene::Region& region) {
  const auto set_box = [&](auto& box) {
    box.set_x_min(stretch.begin);
    box.set_x_max(stretch.end);
    box.set_y_min(0);
    box.set_y_max(kHeight);
  };
  if (stretch.kind == Stretch::kGrid) {
    auto& block = *region.mutable_continuum()->mutable_block();
    set_box(block);
    block.set_zones_x(static_cast<std::uint32_t>(std::lround((stretch.end - stretch.begin) / stretch.size)));
    block.set_zones_y(static_cast<std::uint32_t>(std::max(1L, std::lround(kHeight / stretch.size))));
  } else {
    auto& packing = *region.mutable_particles()->mutable_packing();
    set_box(packing);
    packing.set_radius(stretch.size);
  }
}

inline void set_joint(const Joint& joint, scene::Interface& interface) {
  interface.set_outer(name_of(joint.outer));
  interface.set_inner(name_of(joint.inner));
  auto& overlap = *interface.mutable_overlap();
  if (joint.is_ring()) {
    auto& box = *overlap.mutable_around()->mutable_box();
    box.set_x_min(joint.outer_ends);
    box.set_x_max(joint.ring_ends);
    box.set_y_min(-10 * kHeight);
    box.set_y_max(10 * kHeight);
    overlap.set_width(joint.outer_ends - joint.inner_ends);
  } else {
    overlap.mutable_particles_begin()->set_x(joint.inner_ends);
    overlap.mutable_particles_begin()->set_y(0);
    overlap.mutable_continuum_ends()->set_x(joint.outer_ends);
    overlap.mutable_continuum_ends()->set_y(0);
  }
}

inline scene::Scene scene_of(const Bar& bar, scene::Solve solve = scene::CONSISTENT) {
  scene::Scene scene;
  scene.set_plane(scene::PLANE_STRESS);
  scene.mutable_material()->set_young_modulus(kYoung);
  scene.mutable_material()->set_poisson_ratio(kPoisson);
  scene.mutable_material()->set_density(kDensity);
  scene.mutable_time()->set_duration(0.02);
  for (std::size_t i = 0; i < bar.stretches.size(); ++i) {
    auto& region = *scene.add_regions();
    region.set_name(name_of(i));
    set_stretch(bar.stretches[i], region);
  }
  for (const Joint& joint : bar.joints) {
    auto& interface = *scene.add_interfaces();
    set_joint(joint, interface);
    interface.set_solve(solve);
  }
  return scene;
}

// Half a sine on the left end, as a total force.
struct Push {
  double x, y;  // [N]
  double end;   // [s]
  double factor(double t) const { return t <= end ? std::sin(std::numbers::pi * t / end) : 0; }
};

inline void push_left_end(const Push& push, const Bar& bar, scene::Scene& scene) {
  const auto set_load = [&](scene::Load& load, double reach) {
    load.mutable_where()->set_x_max(reach);
    load.mutable_force()->set_x(push.x);
    load.mutable_force()->set_y(push.y);
    load.mutable_time()->mutable_sine()->set_frequency(0.5 / push.end);
    load.mutable_time()->mutable_sine()->set_end(push.end);
  };
  for (int i = 0; i < scene.regions_size(); ++i) {
    const Stretch& stretch = bar.stretches[i];
    if (stretch.begin > 0) continue;
    if (stretch.kind == Stretch::kGrid)
      set_load(*scene.mutable_regions(i)->mutable_continuum()->add_edge_loads(), 0);
    else
      set_load(*scene.mutable_regions(i)->mutable_particles()->add_loads(), 1.1 * stretch.size);
  }
}

inline void watch_right_end(const Bar& bar, scene::Quantity quantity, scene::Scene& scene) {
  for (int i = 0; i < scene.regions_size(); ++i) {
    if (bar.stretches[i].end < kLength) continue;
    auto& region = *scene.mutable_regions(i);
    auto& history = region.has_continuum() ? *region.mutable_continuum()->add_histories()
                                           : *region.mutable_particles()->add_histories();
    history.set_name("right");
    history.set_quantity(quantity);
    history.mutable_at()->set_x(kLength);
    history.mutable_at()->set_y(kHeight / 2);
  }
}

}  // namespace adit::test
