// What the contacts went through since time began.
#pragma once

#include <vector>

#include "fdm_server/interfaces/contacts.hpp"
#include "protocol/state/archive.hpp"

namespace adit::fdm {

class ContactPeaks {
 public:
  // An extreme value and its time [s].
  struct Peak {
    double value = 0, time = 0;
  };

  // Takes the peaks of a step whose forces are known.
  void take(const Contacts& contacts, double time);
  bool empty() const { return offset_.empty(); }
  // One a contact: the offset of the largest size, with its sign; the largest opening; the largest pressure;
  // the shear stress of the largest size, with its sign.
  const std::vector<Peak>& offset() const { return offset_; }
  const std::vector<Peak>& opening() const { return opening_; }
  const std::vector<Peak>& pressure() const { return pressure_; }
  const std::vector<Peak>& shear_stress() const { return shear_stress_; }

  void exchange(std::size_t contacts, state::Archive& archive) {
    archive.all_or_none("contact_peaks", {&offset_, &opening_, &pressure_, &shear_stress_}, contacts);
  }

 private:
  std::vector<Peak> offset_, opening_, pressure_, shear_stress_;
};

}  // namespace adit::fdm
