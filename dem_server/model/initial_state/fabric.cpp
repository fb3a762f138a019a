#include "dem_server/model/initial_state/fabric.hpp"

#include <fmt/format.h>

#include <optional>

#include "dem_server/model/initial_state/equilibrium.hpp"
#include "protocol/errors.hpp"

namespace adit::dem {
namespace {

using protocol::UserError;

constexpr double kUnresisted = 1e-6;  // share of a stress

Eigen::VectorXd vector_of(double xx, double yy, double xy) {
  Eigen::VectorXd vector(3);
  vector << xx, yy, xy;
  return vector;
}

std::vector<bool> with_border(std::vector<bool> held, const std::vector<bool>& border) {
  for (std::size_t i = 0; i < border.size(); ++i)
    if (border[i]) held[3 * i] = held[3 * i + 1] = held[3 * i + 2] = true;
  return held;
}

Eigen::VectorXd components(const protocol::GroundStress& stress) {
  return vector_of(stress.xx, stress.yy, stress.xy);
}

}  // namespace

Fabric::Fabric(const Model& model, std::span<const Pair> touching, const StressAt& stated)
    : model_(model),
      stated_(stated),
      links_(links_of(model, touching)),
      faces_(find_faces(model.discs, links_)),
      held_(held_motions(model, faces_.border, stated)),
      external_(external_forces(model)) {
  for (const Face& face : faces_.inside) area_ += face.area;
  if (!(area_ > 0))
    throw UserError("initial_stress",
                    "is given, but no area lies between the particles; give a packing of two rows and more "
                    "whose particles touch, or leave it out");
  find_unit_forces();
}

void Fabric::find_unit_forces() {
  const std::vector<double> nothing(external_.size(), 0.0);
  const std::vector<bool> held = with_border(held_, faces_.border);
  std::optional<Equilibrium> inside;
  stiffness_.resize(3, 3);
  const Strain units[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int k = 0; k < 3; ++k) {
    for (const Link& link : links_) unit_forces_[k].push_back(forces_under(units[k], link));
    if (!dem::in_balance(links_, nothing, held, unit_forces_[k])) {
      if (!inside) inside.emplace(links_, model_.discs, held);
      inside->balance(links_, nothing, unit_forces_[k]);
    }
    stiffness_.col(k) = mean_stress(unit_forces_[k]);
  }
  compliance_.compute(stiffness_);
}

Strain Fabric::strain_for(const Vector& stress) const {
  const Vector strain = compliance_.solve(stress);
  if (!((stiffness_ * strain - stress).norm() <= kUnresisted * stress.norm()))
    throw UserError("initial_stress",
                    fmt::format("is ({:g}, {:g}, {:g}) Pa (xx, yy, xy), which the particles do not resist; "
                                "give bonds or contacts a shear stiffness",
                                stress[0], stress[1], stress[2]));
  return {strain[0], strain[1], strain[2]};
}

std::vector<PairForces> Fabric::stated_forces() const {
  std::vector<PairForces> forces;
  forces.reserve(links_.size());
  for (const Link& link : links_)
    forces.push_back(forces_under(strain_for(components(stated_(link.at_x, link.at_y))), link));
  return forces;
}

bool Fabric::in_balance(const std::vector<PairForces>& forces) const {
  return dem::in_balance(links_, external_, held_, forces);
}

void Fabric::balance(std::vector<PairForces>& forces) const {
  const Equilibrium equilibrium(links_, model_.discs, held_);
  equilibrium.balance(links_, external_, forces);
  const auto [xx, yy, xy] = strain_for(mean_stated() - mean_stress(forces));
  for (std::size_t k = 0; k < forces.size(); ++k) {
    const PairForces &a = unit_forces_[0][k], &b = unit_forces_[1][k], &c = unit_forces_[2][k];
    forces[k].normal += xx * a.normal + yy * b.normal + xy * c.normal;
    forces[k].shear += xx * a.shear + yy * b.shear + xy * c.shear;
    forces[k].moment += xx * a.moment + yy * b.moment + xy * c.moment;
  }
  equilibrium.balance(links_, external_, forces);  // at free surfaces
}

void Fabric::balance(std::span<const Link> softened, std::vector<PairForces>& forces) const {
  Equilibrium(softened, model_.discs, held_).balance(softened, external_, forces);
}

Fabric::Vector Fabric::mean_stress(const std::vector<PairForces>& forces) const {
  Vector sum = Vector::Zero(3);
  for (std::size_t k = 0; k < links_.size(); ++k) {
    const auto [fx, fy] = force_on_first(links_[k], forces[k]);
    sum += faces_.share[k] *
           vector_of(fx * links_[k].x, fy * links_[k].y, (fx * links_[k].y + fy * links_[k].x) / 2);
  }
  return sum / area_;
}

Fabric::Vector Fabric::mean_stated() const {
  Vector sum = Vector::Zero(3);
  for (const Face& face : faces_.inside) sum += face.area * components(stated_(face.x, face.y));
  return sum / area_;
}

}  // namespace adit::dem
