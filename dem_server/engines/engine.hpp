// What computes the particles of a run. The participant drives an engine and knows no other.
//
// Particles need not lie in this process: what an engine is asked for are points, velocities at the coupling
// points, counts, sums, events and pieces of a snapshot.
//
// A step has two parts. The interface's gives the velocities at the coupling points, the interior's the rest;
// results do not depend on when the second is computed. Errors that end a run are protocol::Unstable.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "dem_server/condensation/substructure.hpp"
#include "dem_server/engines/answers.hpp"
#include "dem_server/engines/crack.hpp"
#include "dem_server/observe/crack_paths.hpp"
#include "protocol/geometry/bounding_box.hpp"
#include "protocol/participant/interface/interface_operator.hpp"
#include "protocol/participant/step.hpp"
#include "protocol/state/archive.hpp"

namespace adit::scene {
class Particles;
}
namespace adit::wire {
class Snapshot;
}

namespace adit::dem {

class Engine {
 public:
  virtual ~Engine() = default;

  virtual Counts counts() const = 0;
  virtual CriticalElement critical_element() const = 0;  // its step is proven, without weights
  double critical_step() const { return critical_element().step; }

  // The scene's histories and sections. UserError for one that cannot be told.
  virtual void watch(const scene::Particles& scene) = 0;

  // Centres at rest inside or on the box, x0 y0 x1 y1 … [m]
  virtual std::vector<double> offer(const geometry::BoundingBox& box) = 0;
  // Ties the particles to the coupling points [m]: N, which says how they follow. UserError where they do not
  // reach.
  virtual const protocol::InterfaceOperator& tie(std::span<const double> places) = 0;
  // 1/M of the particles that N names, for x and for y [1/kg]; 0 where the motion is prescribed.
  virtual std::span<const double> tied_inverse_masses() const = 0;
  // Adds N^T impulse / mass to the velocities predicted last; one pair [N s] a coupling point.
  virtual void correct(std::span<const double> impulses) = 0;

  // Before a step: notes the velocities that its histories, its energies where they are wanted, and its peaks
  // need.
  virtual void prepare(bool energies) = 0;
  virtual void remember_for_peaks() = 0;
  virtual void step_interface(const protocol::Step& step) = 0;
  virtual void step_interior(const protocol::Step& step) = 0;
  virtual void took(double /*seconds*/) {}  // the whole step, after it

  virtual void read_velocities(std::span<double> velocities) const = 0;  // at the coupling points [m/s]
  virtual std::span<const Crack> broken() const = 0;                     // in the last whole step
  virtual Strongest strongest() const = 0;                               // likewise
  virtual Energies energies(const protocol::Step& step) = 0;
  virtual double kinetic_energy() const = 0;  // of the present velocities, weighted [J]
  virtual void read_histories(const protocol::Step& step, std::vector<double>& values) = 0;  // adds to them

  // Both ask for a step whose velocities are corrected.
  virtual void take_peaks(const protocol::Step& step) = 0;
  virtual Unrest unrest(const protocol::Step& step) = 0;
  // All velocities become 0.
  virtual void stop() = 0;
  // All velocities are multiplied by this factor, of an engine that can.
  virtual bool slows() const { return false; }
  virtual void slow(double /*factor*/) {}
  // After a stop: what changes with the stages of excavation up to this one does, and masses are true.
  virtual void begin_stage(std::uint32_t /*stage*/) {}
  // After a stop, of an engine that can: from now on masses follow from the stiffness of what pulls on a
  // particle (CriticalElement), and loads know nothing of them; 0: masses are true.
  virtual bool scales_masses() const { return false; }
  virtual void scale_masses(double /*mass_per_stiffness*/) {}
  // Displacements count from here, also when time begins.
  virtual void count_displacements() = 0;
  // The first step that does not relax is next: displacements, energies and work count from here. What held
  // quiet edges holds them against this drift of the model beside.
  virtual void start_over(const protocol::Drift& drift) = 0;

  // Condensation of an engine that can: at rest, or with nothing stored if a run is resumed that waited.
  // `ties`: how the coupling points follow the masters. Returns why the particles cannot be condensed as they
  // are: their demand reaches this share, or they are not linear.
  virtual std::variant<Condensed, std::string> condense(const protocol::SparseRows& /*ties*/,
                                                        std::size_t /*masters*/, double /*share*/) {
    return "this engine condenses none";
  }
  // The particles follow masters that have moved like this, `dt` [s] between both velocities: they get the
  // velocities of half a step before, and by arrive() everything else, and those of half a step later.
  virtual void follow(const MastersMotion& /*masters*/, double /*dt*/) {}
  virtual void arrive(const protocol::Step& /*step*/) {}
  // The first step follows that is no motion of masters.
  virtual void go_on() {}
  // The largest share of its strength that anything uses, 1 where it breaks, slides or opens.
  virtual double demand() const { return 0; }
  virtual std::vector<std::string> warnings() const { return {}; }  // for the end of the run

  // What changes from step to step (protocol/state/archive.hpp), of an engine that has reached the same
  // stage.
  virtual void exchange(state::Archive& archive) = 0;

  virtual void snapshot(wire::Snapshot& snapshot) const = 0;         // observe/snapshot.hpp, with the peaks
  virtual std::uint64_t fragments() const = 0;                       // bodies that whole bonds hold together
  virtual std::vector<CrackPath> crack_paths() const { return {}; }  // as they are, the longest first
  virtual std::vector<Figure> figures() const = 0;                   // for the summary of the run
};

}  // namespace adit::dem
