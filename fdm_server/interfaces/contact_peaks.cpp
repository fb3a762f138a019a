#include "fdm_server/interfaces/contact_peaks.hpp"

#include <cmath>

namespace adit::fdm {

void ContactPeaks::take(const Contacts& contacts, double time) {
  for (auto* peaks : {&offset_, &opening_, &pressure_, &shear_stress_}) peaks->resize(contacts.size());
  for (std::uint32_t i = 0; i < contacts.size(); ++i) {
    const auto [normal, shear, opening, offset] = contacts.read(i);
    if (std::abs(offset) > std::abs(offset_[i].value)) offset_[i] = {offset, time};
    if (opening > opening_[i].value) opening_[i] = {opening, time};
    if (-normal > pressure_[i].value) pressure_[i] = {-normal, time};
    if (std::abs(shear) > std::abs(shear_stress_[i].value)) shear_stress_[i] = {shear, time};
  }
}

}  // namespace adit::fdm
