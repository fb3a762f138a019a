// The tunnel as a beam on springs, as the user describes it, in plain numbers and SI units.
//
// x runs along the axis (chainage), y to the left (lateral), z upward (vertical). Displacements of the tube
// count from the installed state, in which the compressed gaskets balance the water pressure on the ends.
// check() and all functions that take a Tunnel throw UserError with a path relative to the Tunnel, for
// example "sections[2].from" or "joints[4].gaskets[0].compression[3]".
#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "simplified/beam/model/curve.hpp"

namespace adit::simplified::beam {

enum Direction : int { kAxial = 0, kLateral = 1, kVertical = 2 };

// The lining between two chainages. Sections follow each other without gap or overlap.
struct Section {
  double from = 0, to = 0;          // [m]
  double youngs_modulus = 0;        // [Pa]
  double area = 0;                  // [m²]
  double inertia_lateral = 0;       // [m⁴] second moment for bending sideways (about z)
  double inertia_vertical = 0;      // [m⁴] for bending up and down (about y)
  double shear_modulus = 0;         // [Pa] used where a shear area is given
  double shear_area_lateral = 0;    // [m²] 0: Euler–Bernoulli; else Timoshenko, with rotary inertia
  double shear_area_vertical = 0;   // [m²]
  double mass = 0;                  // [kg/m]
  double half_width = 0;            // [m] from the axis to the outer fibre sideways: strains only
  double half_height = 0;           // [m] and to the outer fibre upward
  std::array<double, 3> load = {};  // [N/m] static: weight less buoyancy is load[kVertical]
};

// The ground's spring for one metre of tunnel in one direction: an elastic spring of stiffness h k beside a
// spring of (1−h) k that slips, so that the force leaves k e at `slip_force` and goes on with slope h k
// (kinematic hardening, Masing loops). A dashpot acts beside it.
struct SoilSpring {
  double stiffness = 0;                                         // [N/m²] k
  double slip_force = std::numeric_limits<double>::infinity();  // [N/m] infinite: linear
  double hardening = 0;                                         // h in [0, 1)
  double dashpot = 0;                                           // [N s/m²]
};

// The ground at a chainage; with the pressure ratio its springs and dashpots weaken linearly, to the share
// `liquefied` at 1, and a load grows, to `uplift` at 1. Linear between stations, a jump is two stations at
// one chainage. Stations are in order and reach from portal to portal.
struct SoilStation {
  double chainage = 0;
  std::array<SoilSpring, 3> springs;  // by Direction
  double liquefied = 1;               // share of stiffness, slip force and dashpot
  double uplift = 0;                  // [N/m], downward if negative
};

// A joint across which the tube is cut: springs in parallel, at points of the cross-section.
struct Joint {
  struct Gasket {                         // GINA: a run of gasket around one point of the perimeter
    double y = 0, z = 0;                  // [m]
    double length = 0;                    // [m] of gasket
    std::vector<CurvePoint> compression;  // load curve per metre of gasket, see curve.hpp
  };
  struct Spring {  // along the axis at a point: cable(), linear() or any monotone curve [N]
    double y = 0, z = 0;
    Curve curve;
  };
  double chainage = 0;
  double hydrostatic_force = 0;  // [N] compresses all gaskets by the same amount in the installed state
  std::vector<Gasket> gaskets;
  std::vector<Spring> springs;
  Curve lateral, vertical;                                       // [N] shear keys; no points: none
  double omega_limit = std::numeric_limits<double>::infinity();  // [m] opening the Omega seal bears
};

// Gasket around a rectangle of the given outer size, as `per_side` equal runs on each side.
std::vector<Joint::Gasket> rectangular_gasket(double width, double height, int per_side,
                                              const std::vector<CurvePoint>& compression);

enum class Portal { kFree, kFixed };  // fixed: moves with the ground there and does not turn

struct Tunnel {
  std::vector<Section> sections;  // in order of chainage
  std::vector<SoilStation> soil;
  std::vector<Joint> joints;  // in order, strictly inside the tunnel
  Portal start = Portal::kFree, end = Portal::kFree;
  double element_length = 0;  // [m] no element is longer; a joint or a change of section starts a new one
  bool inertia = true;        // false: the tube follows without mass
};

void check(const Tunnel& tunnel);

}  // namespace adit::simplified::beam
