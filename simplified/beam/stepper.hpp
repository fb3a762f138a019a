// The equation of motion of the tube on its springs, step by step:
//     M a + K u + Σ Nᵀ f_soil(N u − u_g) + Σ Nᵀ m c (N v − v_g) + Σ Bᵀ f_joint(B u) = p + Σ Nᵀ r_u p_uplift.
// Each step is solved for the displacement at its end by Newton's method with the consistent tangent. All
// forces rise with elongation, so a step minimizes a convex function, and a line search makes Newton's method
// converge. The matrix is factored again only if Newton's method is slow with the old factor, and then only
// from the first link along the tunnel whose springs changed their tangents.
#pragma once

#include <vector>

#include "simplified/beam/elements/joint_springs.hpp"
#include "simplified/beam/elements/soil_springs.hpp"
#include "simplified/beam/elements/structure.hpp"
#include "simplified/beam/energy.hpp"
#include "simplified/beam/model/ground_motion.hpp"
#include "simplified/beam/model/scheme.hpp"

namespace adit::simplified::beam {

class Stepper {
 public:
  // At time 0 the tube is at rest, in equilibrium with the static loads and with the ground's displacement at
  // time 0. The tunnel must outlive the stepper. Throws UserError if nothing holds the tube in some
  // direction.
  Stepper(const Tunnel& tunnel, const GroundMotion& motion, const Scheme& scheme, double dt);

  void step();  // throws Unstable if Newton's method does not converge

  double time() const { return static_cast<double>(steps_) * dt_; }
  std::span<const double> displacement() const { return u0_; }
  const Structure& structure() const { return structure_; }
  const JointSprings& joints() const { return joints_; }
  const SoilSprings& soil() const { return soil_; }
  const Energy& energy() const { return energy_; }
  long newton_iterations() const { return newton_iterations_; }
  long factorizations() const { return factorizations_; }

 private:
  void read_ground(double time);
  void settle();
  void start_accelerations();
  void prescribe_portals(std::vector<double>& u, const std::array<std::vector<double>, 3>& ground) const;
  void derive_motion();  // v₁, a₁ from u₁
  void evaluate();       // residual_ and reactions_ at u₁
  void refactor();
  void newton();
  void search_line(double slope);
  double scaled_norm() const;
  double rounding() const;
  void commit();

  Structure structure_;
  GroundMotion motion_;
  Scheme scheme_;
  double dt_;
  long steps_ = 0;
  bool moving_ = false;  // false while the static state is being found
  SoilSprings soil_;
  JointSprings joints_;
  std::vector<double> supports_;  // chainages of the start portal, the soil points, the end portal
  GroundState ground_;

  std::vector<double> u0_, v0_, a0_, u1_, v1_, a1_;  // at the step's start and end
  std::vector<double> blended_, product_, residual_, correction_;
  std::vector<double> reaction0_, reaction1_;  // at prescribed nodes
  BlockTridiagonal constant_, tangent_;        // without and with the tangents of springs
  BlockCholesky factor_;
  bool factored_ = false;
  std::vector<double> scaling_;  // 1 / diagonal of the tangent at its first assembly
  double residual_scale_ = 0;    // largest first residual so far
  Energy energy_;
  double kinetic_start_ = 0, strain_start_ = 0;
  long newton_iterations_ = 0, factorizations_ = 0;
};

}  // namespace adit::simplified::beam
