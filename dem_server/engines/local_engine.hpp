// An engine whose particles lie in this process's arrays: how they follow the coupling points and what is
// observed of them, whatever computes their forces.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dem_server/coupling/coupling_points.hpp"
#include "dem_server/engines/engine.hpp"
#include "dem_server/engines/relaxation.hpp"
#include "dem_server/lining/envelope.hpp"
#include "dem_server/lining/lining.hpp"
#include "dem_server/lining/use_peaks.hpp"
#include "dem_server/observe/bar_peaks.hpp"
#include "dem_server/observe/crack_paths.hpp"
#include "dem_server/observe/histories.hpp"
#include "dem_server/observe/joint_peaks.hpp"
#include "dem_server/observe/observable.hpp"
#include "dem_server/observe/widest_crack.hpp"
#include "dem_server/particles/energy.hpp"
#include "protocol/participant/peak_motion.hpp"
#include "protocol/participant/travel.hpp"

namespace adit::dem {

class LocalEngine : public Engine, public Observable {
 public:
  using Observable::particles;
  virtual Particles& particles() = 0;
  virtual std::size_t threads() const = 0;  // that share a step
  std::span<const std::uint32_t> group() const final { return group_; }
  std::span<const std::string> group_names() const final { return group_names_; }
  std::span<const double> settled_turn() const final { return settled_turn_; }
  std::vector<double> cell_areas() const final;

  void watch(const scene::Particles& scene) final;
  std::vector<double> offer(const geometry::BoundingBox& box) final;
  void prepare(bool energies) final;
  void remember_for_peaks() final;
  void read_velocities(std::span<double> velocities) const final;
  double kinetic_energy() const final { return dem::kinetic_energy(particles()); }
  void read_histories(const protocol::Step& step, std::vector<double>& values) final;
  void take_peaks(const protocol::Step& step) final;
  Unrest unrest(const protocol::Step& step) final;
  void begin_stage(std::uint32_t stage) override;
  std::span<const double> tied_inverse_masses() const final { return coupling_.inverse_masses(); }
  void stop() override;
  bool slows() const final { return true; }
  void slow(double factor) final;
  void start_over(const protocol::Drift& drift) override;
  void count_displacements() final;
  void exchange(state::Archive& archive) override;
  void snapshot(wire::Snapshot& snapshot) const final;
  std::uint64_t fragments() const final;
  std::vector<CrackPath> crack_paths() const final { return paths_of(cracks()).paths; }
  std::vector<Figure> figures() const override;
  std::span<const std::uint32_t> tied() const { return coupling_.particles(); }
  const protocol::InterfaceOperator& coupling() const { return coupling_.interpolation(); }

 protected:
  explicit LocalEngine(const Model& model);
  // The groups, and which particles are there, become those of the model.
  void take_stage(const Model& model);

  const protocol::InterfaceOperator& tie_particles(std::span<const double> places, const BondEnds& bonds,
                                                   const PrescribedMotions& motions);
  void push(std::span<const double> impulses, PrescribedMotions& motions) {
    coupling_.push(impulses, kick_, particles(), motions);
  }
  // The particles have other masses from now on.
  void renew_tied_masses() { coupling_.take_masses(particles()); }
  // Before every step.
  void begin(const protocol::Step& step);
  // In the form that the scheme keeps (energy.hpp), of the step made last. `motions`: the kinetic energy of
  // what is prescribed.
  double kinetic_energy_of(const protocol::Step& step, double motions) const {
    return dem::kinetic_energy(particles(), before_, step.from_rest()) + (step.from_rest() ? motions : 0);
  }

  virtual double internal_force() const = 0;  // sum over bonds and contacts of |force|, weighted [N]
  virtual std::size_t elements() const = 0;   // of them

 private:
  Unrest::Farthest farthest() const;
  // Displacements and turns count from here.
  void settle();
  // The forces in all sections, the diameters of ovals, the motions of smooth joints, the width of cracks and
  // the forces of bars enter their extremes.
  void take_envelope(const protocol::Step& step);

  std::vector<std::uint32_t> group_;
  std::vector<std::string> group_names_;
  std::vector<double> density_;     // of each group
  std::size_t present_ = 0;         // particles that are there
  bool counts_from_stage_ = false;  // displacements do, not from the beginning of time
  std::vector<EdgeDashpot> edges_;
  bool held_x_, held_y_;  // by walls, foundations or prescribed motions
  CouplingPoints coupling_;
  double kick_ = 0;  // of the last step [s]
  Lining lining_;
  std::optional<Histories> histories_;
  Envelope envelope_;  // of the sections of the lining
  UsePeaks use_peaks_;
  OvalEnvelope oval_envelope_;
  JointPeaks joint_peaks_;
  WidestCrack widest_crack_;
  BarPeaks bar_peaks_;
  std::vector<double> settled_turn_;  // of cells [rad]
  Velocities before_;
  std::optional<protocol::PeakMotion> peaks_;  // once wanted
  std::optional<Relaxation> relaxation_;       // in statics
  std::optional<protocol::Travel> travel_;     // of a stage of them
};

}  // namespace adit::dem
