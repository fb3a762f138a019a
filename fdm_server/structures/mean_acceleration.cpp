#include "fdm_server/structures/mean_acceleration.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace adit::fdm {

MeanAcceleration::MeanAcceleration(std::span<const StrainForm> strains, double dt,
                                   const std::function<double(const Freedom&)>& inverse_mass)
    : dt_(dt) {
  std::map<Freedom, std::uint32_t> numbers;
  for (const StrainForm& strain : strains)
    for (const StrainForm::Share& share : strain.shares) numbers[share.of] = 0;
  const auto list = [&](bool free) {
    for (auto& [freedom, number] : numbers) {
      if ((inverse_mass(freedom) > 0) != free) continue;
      number = static_cast<std::uint32_t>(freedoms_.size());
      freedoms_.push_back(freedom);
    }
  };
  list(true);
  free_ = freedoms_.size();
  list(false);

  for (const StrainForm& strain : strains) {
    const auto begin = static_cast<std::uint32_t>(shares_.size());
    for (const auto& [freedom, factor] : strain.shares) shares_.push_back({numbers[freedom], factor});
    forms_.push_back({dt * dt / 4 * strain.stiffness, begin, static_cast<std::uint32_t>(shares_.size())});
  }
  acceleration_.assign(freedoms_.size(), 0.0);
  force_ = acceleration_;
  if (free_ > 0) factor(inverse_mass);
}

void MeanAcceleration::factor(const std::function<double(const Freedom&)>& inverse_mass) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](std::size_t row, std::size_t column, double value) {
    entries.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
  };
  for (std::size_t i = 0; i < free_; ++i) add(i, i, 1 / inverse_mass(freedoms_[i]));
  for (const Form& form : forms_)
    for (const Share& row : shares(form))
      for (const Share& column : shares(form))
        if (row.freedom < free_ && column.freedom < free_)
          add(row.freedom, column.freedom, form.inertia * row.factor * column.factor);
  const auto size = static_cast<Eigen::Index>(free_);
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  factor_.compute(matrix);
  if (factor_.info() != Eigen::Success)
    throw std::logic_error(
        "the mass of linings and bolts with the stiffness of a step is not positive definite");
  ordered_.resize(size);
}

void MeanAcceleration::add_forces(const Actions& forces) {
  std::ranges::fill(force_, 0.0);
  std::fill_n(acceleration_.begin(), free_, 0.0);
  if (free_ < freedoms_.size()) subtract_inertia();  // of what is prescribed
  if (free_ > 0) solve(forces);
  std::ranges::fill(force_, 0.0);
  subtract_inertia();
  for (std::size_t i = 0; i < freedoms_.size(); ++i)
    forces[freedoms_[i].kind][freedoms_[i].number] += force_[i];
}

// The solver's own solve() takes memory at every call.
void MeanAcceleration::solve(const Actions& forces) {
  const auto& place = factor_.permutationP().indices();
  for (std::size_t i = 0; i < free_; ++i)
    ordered_[place[static_cast<Eigen::Index>(i)]] =
        forces[freedoms_[i].kind][freedoms_[i].number] + force_[i];
  factor_.matrixL().solveInPlace(ordered_);
  factor_.matrixU().solveInPlace(ordered_);
  for (std::size_t i = 0; i < free_; ++i) acceleration_[i] = ordered_[place[static_cast<Eigen::Index>(i)]];
}

void MeanAcceleration::subtract_inertia() {
  for (const Form& form : forms_) {
    double sum = 0;
    for (const auto& [freedom, factor] : shares(form)) sum += factor * acceleration_[freedom];
    for (const auto& [freedom, factor] : shares(form)) force_[freedom] -= form.inertia * sum * factor;
  }
}

double MeanAcceleration::rate(const Form& form, const Motions& motions) const {
  double sum = 0;
  for (const auto& [freedom, factor] : shares(form))
    sum += factor * motions[freedoms_[freedom].kind][freedoms_[freedom].number];
  return sum;
}

double MeanAcceleration::twice_kinetic_energy(const Motions& before, const Motions& after) const {
  double sum = 0;
  for (const Form& form : forms_) sum += form.inertia * rate(form, before) * rate(form, after);
  return sum;
}

}  // namespace adit::fdm
