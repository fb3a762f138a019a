#include "fdm_server/structures/mean_acceleration.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace adit::fdm {

MeanAcceleration::MeanAcceleration(std::span<const StrainForm> strains, std::size_t structures, double dt,
                                   const std::function<double(const Freedom&)>& inverse_mass)
    : dt_(dt), structures_(structures), load_(strains.size() - structures, 0.0) {
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
    forms_.push_back({dt * dt / 4 * strain.stiffness, begin, static_cast<std::uint32_t>(shares_.size()), 0});
  }
  acceleration_.assign(freedoms_.size(), 0.0);
  force_ = acceleration_;
  if (free_ == 0) return;
  find_pattern(inverse_mass);
  factor();
}

void MeanAcceleration::find_pattern(const std::function<double(const Freedom&)>& inverse_mass) {
  const auto for_each_product = [&](const Form& form, const auto& take) {
    for (const Share& row : shares(form))
      for (const Share& column : shares(form))
        if (row.freedom < free_ && column.freedom < free_)
          take(static_cast<int>(row.freedom), static_cast<int>(column.freedom));
  };
  std::vector<Eigen::Triplet<double>> places;
  for (std::size_t i = 0; i < free_; ++i) {
    mass_.push_back(1 / inverse_mass(freedoms_[i]));
    places.emplace_back(static_cast<int>(i), static_cast<int>(i), 0.0);
  }
  for (const Form& form : forms_)
    for_each_product(form, [&](int row, int column) { places.emplace_back(row, column, 0.0); });
  const auto size = static_cast<Eigen::Index>(free_);
  matrix_.resize(size, size);
  matrix_.setFromTriplets(places.begin(), places.end());
  const auto place_of = [&](int row, int column) {
    return static_cast<std::uint32_t>(&matrix_.coeffRef(row, column) - matrix_.valuePtr());
  };
  for (int i = 0; i < static_cast<int>(free_); ++i) diagonal_.push_back(place_of(i, i));
  for (Form& form : forms_) {
    form.entries = static_cast<std::uint32_t>(entries_.size());
    for_each_product(form, [&](int row, int column) { entries_.push_back(place_of(row, column)); });
  }
  factor_.analyzePattern(matrix_);
  ordered_.resize(size);
}

void MeanAcceleration::factor() {
  double* values = matrix_.valuePtr();
  std::fill_n(values, matrix_.nonZeros(), 0.0);
  for (std::size_t i = 0; i < free_; ++i) values[diagonal_[i]] = mass_[i];
  skew_ = false;
  for (std::size_t k = 0; k < forms_.size(); ++k) {
    const Form& form = forms_[k];
    // The other strain of a contact is of the same freedoms, in the same order.
    const bool coupled = form.across != 0;
    const auto other = coupled ? shares(forms_[structures_ + ((k - structures_) ^ 1)]) : shares(form);
    skew_ = skew_ || coupled;
    const std::uint32_t* entry = entries_.data() + form.entries;
    for (const Share& row : shares(form))
      for (std::size_t c = 0; c < other.size(); ++c) {
        const Share& column = shares(form)[c];
        if (row.freedom >= free_ || column.freedom >= free_) continue;
        values[*entry++] += row.factor * (form.stiff * column.factor + form.across * other[c].factor);
      }
  }
  bool factored = false;
  if (skew_) {
    factored = skew_factor_.factor(matrix_);
  } else {
    factor_.factorize(matrix_);
    factored = factor_.info() == Eigen::Success;
  }
  if (!factored)
    throw std::logic_error(
        "the mass of linings, bolts and interfaces with the stiffness of a step cannot be factored");
  changed_ = false;
}

void MeanAcceleration::bear(std::size_t strain, const Bears& contact) {
  for (std::size_t k = 0; k < 2; ++k) {
    Form& form = forms_[strain + k];
    const double stiff = dt_ * dt_ / 4 * contact.along[k], across = dt_ * dt_ / 4 * contact.across[k];
    changed_ = changed_ || form.stiff != stiff || form.across != across;
    form.stiff = stiff;
    form.across = across;
    load_[strain + k - structures_] = contact.load[k];
  }
}

double MeanAcceleration::largest(const Actions& forces) const {
  double largest = 0;
  for (const Freedom& freedom : freedoms_)
    largest = std::max(largest, std::abs(forces[freedom.kind][freedom.number]));
  return largest;
}

void MeanAcceleration::accelerate(const Actions& forces) {
  std::ranges::fill(force_, 0.0);
  std::fill_n(acceleration_.begin(), free_, 0.0);
  if (free_ == 0) return;
  if (free_ < freedoms_.size()) subtract_inertia(forms_);  // of what is prescribed
  for (std::size_t k = 0; k < load_.size(); ++k)
    for (const auto& [freedom, factor] : shares(forms_[structures_ + k]))
      force_[freedom] -= load_[k] * factor;
  if (changed_) factor();
  solve(forces);
}

double MeanAcceleration::lead(std::size_t strain) const {
  return dt_ * dt_ / 4 * acceleration_of(forms_[strain]);
}

void MeanAcceleration::add_forces(const Actions& forces) {
  std::ranges::fill(force_, 0.0);
  subtract_inertia(std::span(forms_).first(structures_));
  for (std::size_t i = 0; i < freedoms_.size(); ++i)
    forces[freedoms_[i].kind][freedoms_[i].number] += force_[i];
}

// The solver's own solve() takes memory at every call.
void MeanAcceleration::solve(const Actions& forces) {
  if (skew_) {
    for (std::size_t i = 0; i < free_; ++i)
      ordered_[static_cast<Eigen::Index>(i)] = forces[freedoms_[i].kind][freedoms_[i].number] + force_[i];
    skew_factor_.solve(ordered_);
    std::copy_n(ordered_.data(), free_, acceleration_.begin());
    return;
  }
  const auto& place = factor_.permutationP().indices();
  for (std::size_t i = 0; i < free_; ++i)
    ordered_[place[static_cast<Eigen::Index>(i)]] =
        forces[freedoms_[i].kind][freedoms_[i].number] + force_[i];
  factor_.matrixL().solveInPlace(ordered_);
  factor_.matrixU().solveInPlace(ordered_);
  for (std::size_t i = 0; i < free_; ++i) acceleration_[i] = ordered_[place[static_cast<Eigen::Index>(i)]];
}

void MeanAcceleration::subtract_inertia(std::span<const Form> forms) {
  for (const Form& form : forms) {
    const double acceleration = acceleration_of(form);
    for (const auto& [freedom, factor] : shares(form)) force_[freedom] -= form.stiff * acceleration * factor;
  }
}

double MeanAcceleration::acceleration_of(const Form& form) const {
  double sum = 0;
  for (const auto& [freedom, factor] : shares(form)) sum += factor * acceleration_[freedom];
  return sum;
}

double MeanAcceleration::rate(const Form& form, const Motions& motions) const {
  double sum = 0;
  for (const auto& [freedom, factor] : shares(form))
    sum += factor * motions[freedoms_[freedom].kind][freedoms_[freedom].number];
  return sum;
}

double MeanAcceleration::twice_kinetic_energy(const Motions& before, const Motions& after) const {
  double sum = 0;
  for (const Form& form : std::span(forms_).first(structures_))
    sum += form.stiff * rate(form, before) * rate(form, after);
  return sum;
}

}  // namespace adit::fdm
