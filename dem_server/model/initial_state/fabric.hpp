// The network of a model's links and how it answers to stress.
#pragma once

#include <Eigen/Dense>
#include <span>
#include <vector>

#include "dem_server/model/initial_state/faces.hpp"
#include "dem_server/model/initial_state/network.hpp"
#include "dem_server/model/initial_state/outside.hpp"

namespace adit::dem {

class Fabric {
 public:
  // UserError at initial_stress where the links enclose no area.
  Fabric(const Model& model, std::span<const Pair> touching, const StressAt& stated);

  // Forces of the links under the stated stress where they are. UserError at initial_stress for a stress that
  // they do not resist.
  std::vector<PairForces> stated_forces() const;

  bool in_balance(const std::vector<PairForces>& forces) const;

  // Makes them balance, with the mean of the stated stress.
  void balance(std::vector<PairForces>& forces) const;

  // Makes the forces balance again where some links have become softer than they were.
  void balance(std::span<const Link> softened, std::vector<PairForces>& forces) const;

  std::span<const Link> links() const { return links_; }

 private:
  using Vector = Eigen::VectorXd;  // xx, yy, xy

  void find_unit_forces();
  Strain strain_for(const Vector& stress) const;
  Vector mean_stress(const std::vector<PairForces>& forces) const;
  Vector mean_stated() const;

  const Model& model_;
  const StressAt& stated_;
  std::vector<Link> links_;
  Faces faces_;
  double area_ = 0;
  std::vector<bool> held_;
  std::vector<double> external_;
  std::vector<PairForces> unit_forces_[3];  // under unit strains xx, yy, xy, the border held
  Eigen::MatrixXd stiffness_;
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> compliance_;
};

}  // namespace adit::dem
