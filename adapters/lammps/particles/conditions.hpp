// The loads and prescribed motions of a rank's own particles. Rank 0 knows how they change with time and
// tells their factors; each rank adds its forces and counts its work.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "adapters/lammps/particles/part.hpp"
#include "adapters/lammps/ranks/orders.hpp"
#include "dem_server/model/model.hpp"
#include "dem_server/particles/loads.hpp"
#include "dem_server/particles/prescribed_motions.hpp"
#include "protocol/participant/step.hpp"

namespace adit::lammps {

// Loads and motions that act on the same particles make a set; a particle carries the number of its set.
class ConditionSets {
 public:
  explicit ConditionSets(const dem::Model& model);
  double of(std::size_t disc) const { return set_of_disc_[disc]; }
  Values told() const { return told_; }  // to Conditions
  static Values factors(const dem::Model& model, const protocol::Step& step);

 private:
  std::vector<double> set_of_disc_;
  Values told_;
};

class Conditions {
 public:
  Conditions() = default;
  explicit Conditions(std::span<const double> told);

  // After particles changed their places.
  void renew(const Part& part);
  std::size_t size() const { return model_.loads.size() + model_.motions.size(); }
  void set_factors(std::span<const double> factors) { factors_->assign(factors.begin(), factors.end()); }
  void load(const protocol::Step& step, dem::Particles& particles) { loads_.apply(step, particles); }
  void impose(const protocol::Step& step, dem::Particles& particles) { motions_.impose(step, particles); }

  const dem::Loads::Work& work_of_loads() const { return loads_.work(); }
  double work_of_motions() const { return motions_.work(); }
  double kinetic_energy_of_motions() const { return motions_.kinetic_energy(); }

 private:
  struct Whole {
    double x, y, particles;  // of a load on all ranks
  };
  static void share(const Whole& whole, dem::Load& load);

  std::vector<Whole> whole_;
  dem::Model model_;                              // loads and motions alone
  std::vector<std::vector<std::uint32_t>> sets_;  // numbers of loads, and beyond these of motions
  std::shared_ptr<Values> factors_ = std::make_shared<Values>();
  dem::Loads loads_;
  dem::PrescribedMotions motions_;
  bool began_ = false;
};

}  // namespace adit::lammps
