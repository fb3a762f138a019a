// What a scene with discs of any size describes, at rest: discs, what joins them, what they touch. The scene
// is read into it (read_model.hpp), the solver computes it (solver.hpp).
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "dem_server/laws/linear_contact.hpp"
#include "dem_server/laws/parallel_bond.hpp"
#include "dem_server/laws/smooth_joint.hpp"
#include "dem_server/packing/discs.hpp"
#include "protocol/messages/scene.pb.h"

namespace adit::dem {

inline constexpr double kUnbreakable = std::numeric_limits<double>::infinity();

// A contact bond: springs at the touching point, without a moment of their own.
struct ContactBond {
  double normal_stiffness, shear_stiffness;                               // [N/m]
  double tensile_strength = kUnbreakable, shear_strength = kUnbreakable;  // [N]
};

// Two joined discs, first < second. Exactly one law is given beside the contact that remains when it breaks.
struct Joined {
  std::uint32_t first, second;
  enum class Law : std::uint8_t { kContactBond, kParallelBond, kSmoothJoint } law;
  std::uint32_t number;   // of the law among the model's laws of its kind
  double nx = 0, ny = 0;  // of a smooth joint: its plane's unit normal, from the first to the second side
};

// Rigid, straight, between two ends; discs touch it from either side.
struct MovingWall {
  std::string name;
  double x_1, y_1, x_2, y_2;  // at rest [m]
  LinearContact contact;
  double vx, vy;  // [m/s], times
  scene::TimeFunction time;
};

// Between the centres of two discs; N = pretension + stiffness (L - L0), at least 0 where it knows tension
// only.
struct Spring {
  std::uint32_t first, second;
  double stiffness;  // [N/m]
  bool tension_only;
  double pretension, strength;  // [N]
};

// Forces -c_n v.n and -c_s v.t on the disc that leave the model through a side.
struct EdgeDashpot {
  std::uint32_t disc;
  double damping_x, damping_y;  // [N s/m]
};

struct Model {
  Discs discs;
  std::vector<double> mass, inertia;  // [kg], [kg m^2]
  std::vector<std::uint32_t> group;   // of each disc, in group_names; 0 is the model's own
  std::vector<std::string> group_names;

  std::vector<Joined> joined;  // ascending by first, then by second
  std::vector<ContactBond> contact_bonds;
  std::vector<ParallelBond> parallel_bonds;  // by group or joint and width: equal ones once
  std::vector<SmoothJoint> smooth_joints;

  // Contacts of discs of groups i and j: contacts[i * groups + j], symmetric.
  std::vector<LinearContact> contacts;
  // Overlaps at the start bear no force; else the contacts do, and so do contact bonds that begin compressed.
  bool overlaps_free = true;
  std::vector<MovingWall> walls;
  std::vector<Spring> springs;
  std::vector<EdgeDashpot> edges;
  double local_damping = 0, viscous_damping = 0;  // share, [1/s]
  std::vector<std::string> notes;                 // for the user: what was packed, what was taken away
};

}  // namespace adit::dem
