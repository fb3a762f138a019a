#include "dem_server/model/solid/thin_strip.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dem_server/model/lattice.hpp"

namespace adit::dem {
namespace {

constexpr double kRounding = 1e-9;  // of a weight

// Rows are counted from the lowest.
class Rows {
 public:
  explicit Rows(const Discs& discs)
      : y_(discs.y), lowest_(std::ranges::min(y_)), pitch_(std::numbers::sqrt3 * discs.radius.front()) {}
  std::uint32_t row_at(double y) const {
    return static_cast<std::uint32_t>(std::lround((y - lowest_) / pitch_));
  }
  std::uint32_t of(std::size_t disc) const { return row_at(y_[disc]); }
  std::uint32_t count() const { return row_at(std::ranges::max(y_)) + 1; }

 private:
  const std::vector<double>& y_;
  double lowest_, pitch_;
};

}  // namespace

StripFactors strip_factors(std::uint32_t rows, const BondStiffness& stiffness) {
  const double n = rows, k = stiffness.shear / stiffness.normal, a = 2 * k / (3 + k);
  const double moment = n * (1 + a * (3 * n - 2)) / 12, second_height = (n - 3) / 2;
  const double d1 = (moment - second_height * second_height * a) / (2 * (n - 2));
  const double d2 = (a - 2 * d1) / (rows == 3 ? 1 : 2);
  return {{1 + d1, (1 + d1) * (n - 1) / n}, {1 + d2, 1 + d2}};
}

std::uint32_t rows_of(const Discs& discs) {
  return Rows(discs).count();
}

void stiffen_outer_rows(Model& model) {
  const Rows rows(model.discs);
  const std::uint32_t count = rows.count();
  const ContactBond law = model.contact_bonds.front();
  const auto [outermost, second] = strip_factors(count, law.stiffness);
  model.contact_bonds = {law, law, law};
  model.contact_bonds[1].factors = outermost;
  model.contact_bonds[2].factors = second;
  for (Bond& bond : model.bonds) {
    if (direction_of(model, bond) != Direction::kAlongRow) continue;
    const std::uint32_t row = rows.of(bond.first), from_face = std::min(row, count - 1 - row);
    if (from_face < 2) bond.number = from_face + 1;
  }
}

bool faces_are_free(const Discs& discs, std::span<const double> weights) {
  const Rows rows(discs);
  bool lowest = false, highest = false;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    if (weights[i] < 1 - kRounding) continue;
    lowest |= rows.of(i) == 0;
    highest |= rows.of(i) + 1 == rows.count();
  }
  return lowest && highest;
}

}  // namespace adit::dem
