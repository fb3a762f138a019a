// Gaskets, cables and keys of the joints: one-dimensional nonlinear-elastic springs between the two nodes of
// a joint, at points of the cross-section. A point (y, z) opens by e = Δu_x − y Δψ_y − z Δψ_z, so that
// bending opens one side and closes the other.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "simplified/beam/elements/block_tridiagonal.hpp"
#include "simplified/beam/model/mesh.hpp"
#include "simplified/beam/model/scheme.hpp"

namespace adit::simplified::beam {

// The present deformation of a joint, from the installed state.
struct JointState {
  double opening = 0;      // [m] at the point that opens most (negative: all closed)
  double compression = 0;  // [m] at the point that closes most
  double offset = 0;       // [m] across the axis
};

// What a joint does in the horizontal plane: the second face against the first, on the axis, and what the
// springs bear, from the installed state. The moment is that of Δψ, −Σ y f.
struct JointAction {
  double opening = 0, offset = 0, rotation = 0;   // [m], [m], [rad]
  double axial_force = 0, shear = 0, moment = 0;  // [N], [N], [N m]
};

// The gaskets of a joint, then its other springs along the axis, counted from the installed state [N].
std::vector<Joint::Spring> axial_springs(const Joint& joint);

class JointSprings {
 public:
  JointSprings(const Tunnel& tunnel, const Mesh& mesh);

  // As in SoilSprings: evaluate() adds the forces of the springs to `forces`, and commit() ends the step and
  // returns the change of stored energy.
  void evaluate(const Scheme& scheme, std::span<const double> u, std::span<double> forces);
  std::size_t update_tangents(BlockTridiagonal& matrix);
  void forget_tangents();
  double commit();

  std::size_t size() const { return links_.size(); }
  double installed_compression(std::size_t joint) const { return installed_[joint]; }
  JointState state(std::size_t joint, std::span<const double> u) const;
  JointAction action(std::size_t joint, std::span<const double> u) const;

 private:
  struct Spring {
    int link;
    std::array<double, kDofs> arm;             // elongation = arm · (second node − first node)
    std::size_t curve;                         // number in curves_
    Piece piece;                               // piece of the curve on which the step starts
    double elongation[2] = {}, force[2] = {};  // at the step's start and end
    double tangent = 0, assembled_tangent = 0;
  };
  struct Place {
    double y, z;
  };
  std::size_t index_of(const Curve& curve);  // number in curves_; a new curve is appended
  // The spring's force in the equations of motion; `relative` is the motion of the second node minus that of
  // the first.
  double respond(const Scheme& scheme, Spring& spring, const std::array<double, kDofs>& relative) const;
  // The mean force over the step. Most springs stay on the piece of the curve on which the step starts.
  SpringAnswer mean(const Spring& spring) const;
  Piece piece_at_end(const Spring& spring) const;
  std::vector<int> links_;  // by joint
  std::size_t link_count_;
  std::vector<double> installed_;              // [m] compression of the gaskets, by joint
  std::vector<std::vector<Place>> perimeter_;  // points at which openings are evaluated, by joint
  std::vector<Curve> curves_;                  // the different curves; they are few and stay in the cache
  std::vector<Spring> springs_;                // in order of link
};

}  // namespace adit::simplified::beam
