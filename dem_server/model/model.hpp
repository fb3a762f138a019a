// What the particles of a scene describe, at rest: discs, what joins them, what they touch, what acts on
// them. The scene is read into it (reading/read_model.hpp), an overlap weighs it (weigh.hpp), engines compute
// it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dem_server/laws/contact_bond.hpp"
#include "dem_server/laws/facet.hpp"
#include "dem_server/laws/linear_contact.hpp"
#include "dem_server/laws/pair_kinematics.hpp"
#include "dem_server/laws/parallel_bond.hpp"
#include "dem_server/laws/smooth_joint.hpp"
#include "dem_server/model/bars.hpp"
#include "dem_server/model/calibration.hpp"
#include "dem_server/model/group_pairs.hpp"
#include "dem_server/packing/discs.hpp"
#include "dem_server/packing/voronoi/voronoi_cells.hpp"
#include "protocol/foundation/springs.hpp"
#include "protocol/geometry/bounding_box.hpp"
#include "protocol/springs/force_curve.hpp"

namespace adit::dem {

// The factor of a load or a motion at a time [s].
using TimeFactor = std::function<double(double time)>;

// What joins two discs, first < second. Exactly one law is given beside the contact that remains when it
// breaks.
struct Bond {
  std::uint32_t first, second;
  enum class Law : std::uint8_t { kContactBond, kParallelBond, kSmoothJoint, kFacet } law;
  std::uint32_t number;   // of the law among the model's laws of its kind
  double nx = 0, ny = 0;  // of a smooth joint: its plane's unit normal, from the first to the second side
  double weight = 1;      // energy weight
  // Before anything moves, unweighted: of the bond, and of the contact beside a parallel bond.
  PairForces at_rest{};
  double contact_normal = 0, contact_shear = 0;  // [N]
};

// Between two cells of Voronoi (laws/facet.hpp). A cell is a disc about its nucleus, as large as lies inside
// it, to all that it is not joined to.
struct FacetBond {
  double nx, ny;         // unit normal, from the first nucleus to the second
  double half_distance;  // of the nuclei [m]
  double skew;           // of the facet's middle to the left of the line of nuclei, over their distance
  double length;         // [m]
  double stiffness;      // k [Pa/m]
  std::uint32_t law;     // among the model's
  FacetBond turned() const { return {-nx, -ny, half_distance, -skew, length, stiffness, law}; }
};

// Two discs that touch without a bond, first < second, and press on each other before anything moves [N].
struct TouchingPair {
  std::uint32_t first, second;
  double normal, shear;
};

// Rigid, straight, between two ends; discs touch it from either side.
struct MovingWall {
  std::string name;
  double x_1, y_1, x_2, y_2;  // at rest [m]
  LinearContact contact;
  double vx, vy;  // [m/s], times
  TimeFactor time;
};

// Between two discs (engines/general/forces/spring_forces.hpp): N = pretension + stiffness · opening, at
// least 0 where it knows tension only; or a curve.
struct Spring {
  std::uint32_t first, second;
  double stiffness;  // [N/m]; of a curve: where it is steepest
  bool tension_only;
  double pretension, strength;  // [N]
  std::string name = {};
  double clearance = 0;                       // [m]
  std::optional<PlaneVector> direction = {};  // unit vector; along the line of centres where absent
  std::shared_ptr<const protocol::ForceCurve> curve =
      {};                   // where given, in place of pretension and stiffness
  std::uint32_t stage = 0;  // with which it is installed
};

// Forces -c_n v.n and -c_s v.t on the disc that leave the model through a side.
struct EdgeDashpot {
  std::uint32_t disc;
  double damping_x, damping_y;  // [N s/m]
};

// On some discs, times a factor: a force that they share equally, or an acceleration of each.
struct Load {
  enum class Kind : std::uint8_t { kForce, kAcceleration } kind;
  std::vector<std::uint32_t> discs;  // ascending
  double x, y;                       // [N] or [m/s^2]
  TimeFactor time;
  std::string path;     // in the scene
  bool steady = false;  // the factor never changes
};

enum class Component : std::uint8_t { kX, kY, kSpin };

// Some discs have this velocity [m/s] or spin [rad/s], times a factor. No component of a disc is prescribed
// twice.
struct PrescribedMotion {
  Component component;
  std::vector<std::uint32_t> discs;  // ascending
  double amplitude;
  TimeFactor time;
  std::string path;  // in the scene
};

// The particles from the beginning of a stage of excavation on.
struct ParticleStage {
  std::uint32_t number;
  std::vector<bool> present;         // of each disc
  std::vector<std::uint32_t> group;  // of each disc
  std::vector<double> held;          // of each disc: the share of its forces that stays where it vanishes
  std::vector<bool> fresh{};         // of each disc: it begins here, free of stress at its present place
  std::vector<double> mass{};        // of each disc, without weight [kg]
  std::vector<Bond> bonds{};         // all of them
};

// Springs between the cells of some discs and ground that moves by itself, in one direction.
struct Foundation {
  foundation::Direction direction;
  foundation::SpringLaw law;  // per area of the cells
  std::shared_ptr<const foundation::GroundCourse> ground;
  std::vector<std::uint32_t> discs;  // ascending
  std::string path;                  // in the scene
};

struct Model {
  Discs discs;
  std::vector<double> mass;             // without weight [kg]
  std::vector<double> weight;           // energy weight of each disc
  std::vector<double> gyration_square;  // of each cell's area, about its nucleus [m^2]; empty: of discs
  std::vector<CellOutline> outlines;    // of each cell; empty: of discs
  std::vector<std::uint32_t> id;        // of each disc: its place in the packing
  std::vector<std::uint32_t> group;     // of each disc, in group_names; 0 is the model's own
  std::vector<std::string> group_names;
  std::vector<double> density;     // of each group, of its cells [kg/m^3]
  geometry::BoundingBox extent{};  // of the solid [m]

  std::vector<bool> present;          // of each disc: it was not taken away; empty: none was
  std::vector<ParticleStage> stages;  // after the beginning, ascending

  std::vector<Bond> bonds;  // of a hexagonal packing row by row, in a row by direction; else ascending
  std::vector<TouchingPair> touching;  // that bear a stress at rest; ascending
  std::vector<ContactBond> contact_bonds;
  std::vector<ParallelBond> parallel_bonds;  // by group or joint and width: equal ones once
  std::vector<SmoothJoint> smooth_joints;
  std::vector<FacetBond> facets;  // one a bond of this law, from its first cell to its second
  std::vector<FacetLaw> facet_laws;
  std::vector<CellElasticity> cell_elasticity;  // of each group; empty without cells
  std::vector<double> cell_stiffness;  // of each cell: by which that of its group is multiplied; empty: all 1

  std::vector<LinearContact> contacts;  // of discs of two groups, see contact()
  // Overlaps at the start bear no force; else the contacts do, and so do contact bonds that begin compressed.
  bool overlaps_free = true;
  // The stated initial stress balances as it is: each link bears its part of it, and nothing was added.
  bool stress_balances = false;
  std::vector<MovingWall> walls;
  std::vector<Spring> springs;
  std::vector<Bar> bars;
  std::vector<EdgeDashpot> edges;
  std::vector<Load> loads;  // forces, then accelerations
  std::vector<PrescribedMotion> motions;
  std::vector<Foundation> foundations;
  double local_damping = 0, viscous_damping = 0;  // share, [1/s]
  std::vector<std::string> notes;                 // for the user: what was packed, what was taken away

  std::uint32_t groups() const {
    return group_names.empty() ? 1 : static_cast<std::uint32_t>(group_names.size());
  }
  // Number in `contacts` of the law between discs of two groups; the table is symmetric.
  std::uint32_t contact_number(std::uint32_t group_1, std::uint32_t group_2) const {
    return group_pair_number(groups(), group_1, group_2);
  }
  bool is_there(std::size_t disc) const { return present.empty() || present[disc]; }
  // Area of the cell that a disc stands for, without its weight [m^2].
  double cell_area(std::size_t disc) const { return mass[disc] / density[group[disc]]; }
  CellElasticity elasticity_of(std::size_t cell) const {
    const auto& [stiffness, lambda] = cell_elasticity[group[cell]];
    const double factor = cell_stiffness.empty() ? 1 : cell_stiffness[cell];
    return {factor * stiffness, factor * lambda};
  }
  // Moment of inertia of a disc without its weight [kg m^2]: m R^2 / 2, or that of the cell.
  double inertia(std::size_t disc) const { return inertia(disc, mass[disc]); }
  // If it had this mass [kg].
  double inertia(std::size_t disc, double its_mass) const {
    if (!gyration_square.empty()) return its_mass * gyration_square[disc];
    return its_mass * discs.radius[disc] * discs.radius[disc] / 2;
  }
};

}  // namespace adit::dem
