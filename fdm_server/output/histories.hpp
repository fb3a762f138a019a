// Quantities over time at places of the continuum and its linings.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/materials/damping_law.hpp"
#include "fdm_server/output/damped_stress.hpp"
#include "fdm_server/output/grid_sections.hpp"
#include "fdm_server/output/interface_probe.hpp"
#include "fdm_server/output/lining_probe.hpp"
#include "fdm_server/output/zone_fit.hpp"
#include "fdm_server/solver/continuum.hpp"
#include "protocol/messages/scene.pb.h"
#include "protocol/participant/history.hpp"
#include "protocol/state/archive.hpp"

namespace adit::fdm {

class Histories {
 public:
  // `zone_kinds` as in zone_fit.hpp: numbers of `materials`; `damping` that of the ground.
  // protocol::UserError for a place outside all zones of ground, or off the lining whose force is asked for,
  // for a section that cannot be, and for the demand on a material without a strength.
  Histories(const scene::Continuum& scene, const Supports& supports, const Grid& grid,
            std::span<const std::uint32_t> zone_kinds, std::span<const Material> materials,
            const DampingLaw& damping);

  // The velocities of these points await the correction by another model after every step.
  void tie(std::span<const std::uint32_t> points);

  // Before every step, after the correction of the step before.
  void remember(const Continuum& continuum);

  // After every step.
  void follow(const Continuum& continuum, const protocol::Step& step) {
    stress_.follow(continuum.zones(), step);
    sections_.follow(continuum.zones(), step);
  }

  // Values at the step just made, in the scene's order and as scene.proto defines them.
  void read(const Grid& grid, const Supports& supports, const Continuum& continuum,
            const protocol::Step& step, google::protobuf::RepeatedField<double>& values) const;

  void exchange(state::Archive& archive) {
    for (Probe& probe : probes_) archive("history_velocity", probe.velocity);
    stress_.exchange(archive);
    sections_.exchange(archive);
  }

 private:
  // A grid point's share of a motion: bilinear at a place, negative at the one that it counts against.
  struct PointShare {
    std::uint32_t point;
    double share;
  };
  struct Probe {
    scene::Quantity quantity;
    std::vector<PointShare> motion{};
    ZoneShares zones{};  // of stress and strain; of a demand the one zone that it is of
    bool tied = false;
    protocol::HalfStepVelocity velocity{};  // its component
    std::optional<LiningProbe> lining{};    // of a lining's force
    std::size_t section{};                  // of a force without
    std::optional<InterfaceProbe> interface {};
  };
  static double at(std::span<const PointShare> motion, std::span<const double> field);
  double value(const Probe& probe, const Grid& grid, const Supports& supports, const Continuum& continuum,
               const protocol::Step& step) const;
  std::vector<std::uint32_t> zones_of_stress() const;

  std::vector<Probe> probes_;
  GridSections sections_;
  DampedStress stress_;  // of all zones of which a probe asks for stress
};

}  // namespace adit::fdm
