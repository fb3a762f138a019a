// One run of the mass-spring-beam model: first the static state, then the motion, with envelopes and
// histories.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "simplified/beam/elements/joint_springs.hpp"
#include "simplified/beam/energy.hpp"
#include "simplified/beam/model/ground_motion.hpp"
#include "simplified/beam/model/scheme.hpp"
#include "simplified/beam/model/tunnel.hpp"

namespace adit::simplified::beam {

struct RunOptions {
  double dt = 0;   // [s]
  long steps = 0;  // time ends at steps·dt
  Scheme scheme = energy_conserving();
  std::vector<double> stations;  // [m] chainages at which histories are recorded
  int history_every = 1;         // steps between records of histories
  int field_every = 0;  // steps between records along the whole axis (time–distance plots), 0: none
};

// Smallest and largest value of a quantity and their times, by place.
struct Envelope {
  std::vector<double> minimum, minimum_time, maximum, maximum_time;
};

// Values at one time: along the axis for fields, at the stations for histories.
struct Record {
  double time = 0;
  std::vector<double> displacement[3];  // [m] of the tube
  std::vector<double> rotation;         // [rad] of its sections in the horizontal plane, ψ_y
  std::vector<double> axial_force;      // [N]
  std::vector<double> moment_lateral;   // [N m]
  std::vector<double> moment_vertical;  // [N m]
  std::vector<double> shear_lateral;    // [N]
  std::vector<double> shear_vertical;   // [N]
  std::vector<double> pressure_ratio;   // of the ground
  std::vector<JointAction> joints;      // of every joint
};

struct JointResult {
  double chainage = 0;
  double installed_compression = 0;              // [m] of the gaskets, by the hydrostatic force
  double largest_opening = 0, opening_time = 0;  // [m] at the point that opens most, from the installed state
  double largest_compression = 0, compression_time = 0;  // [m] at the point that closes most
  double largest_offset = 0, offset_time = 0;            // [m] across the axis
  // Gaskets: first time at which some point lets go; Omega: first time at which its limit is passed.
  // Infinite: never.
  double contact_lost_time = std::numeric_limits<double>::infinity();
  double omega_exceeded_time = std::numeric_limits<double>::infinity();
};

struct Results {
  // Places are the middles of the elements. Forces count from the installed state: the axial force contains
  // the static loads, but not the pre-compression of the joints (−hydrostatic force).
  std::vector<double> chainage;
  Envelope axial_force, moment_lateral, moment_vertical, shear_lateral, shear_vertical;
  Envelope strain;  // axial strain of the outermost fibre: minimum compressive, maximum tensile
  Envelope vertical_displacement, pressure_ratio;
  std::vector<JointResult> joints;
  std::vector<Record> histories;  // by record; places are the elements and nodes nearest to the stations
  std::vector<Record> fields;     // by record; places are `chainage`
  Energy energy;                  // at the end
  double energy_error = 0;        // largest |error| over the run / largest energy moved
  double wall_s = 0;
  long newton_iterations = 0, factorizations = 0;
};

// Throws UserError if the tunnel or the options are wrong, and Unstable, with the time, if Newton's method
// does not converge or a value is not finite.
Results run(const Tunnel& tunnel, const GroundMotion& motion, const RunOptions& options);

}  // namespace adit::simplified::beam
