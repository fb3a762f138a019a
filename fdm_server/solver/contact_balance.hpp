// What contacts bear that share points with others or with structures, all together
// (interfaces/contacts.hpp).
//
// Newton's method: the structures and the tangents of all contacts give accelerations, these give leads, and
// these what the contacts bear. Where nothing changes between sticking, sliding and open, which is so for
// most contacts in most steps, one trial finds it. Where statuses change, the way to what a trial finds is
// shortened until less is missed than before. Where that goes round in circles, the slopes of faces that
// stick take the place of the tangents: none is larger, so that each trial misses less, if only by a share.
// At the part t of it, contacts have been missed by (1 - t) of what was missed and of what they bore, and t
// of what the tangents say, less what they bear there.
#pragma once

#include <array>
#include <vector>

#include "fdm_server/interfaces/contacts.hpp"
#include "fdm_server/structures/mean_acceleration.hpp"

namespace adit::fdm {

class ContactBalance {
 public:
  // The strains of these contacts are the last of `average`, two each.
  ContactBalance(const Contacts& contacts, const Contacts::Part& part, std::size_t first_strain,
                 MeanAcceleration& average);

  // Finds the leads of the contacts, in the order of the part, and the accelerations under these forces.
  std::vector<std::array<double, 2>> find(const Actions& forces);

 private:
  struct Tried {
    std::array<double, 2> lead;  // [m]
    Contacts::Bearing bearing;
    std::array<double, 2> missed;  // [N]

    std::array<double, 2> bears() const { return {bearing.normal, bearing.shear}; }
  };
  // Their present slopes, or those of faces that stick.
  void take_tangents();
  void take_stiffest();
  void take(std::size_t k, MeanAcceleration::Bears tangent);
  // A contact at this part of the way to the leads that the accelerations give.
  Tried go(std::size_t k, double way) const;
  // Goes there with all contacts, and returns the most that is missed.
  double go(double way, std::vector<Tried>& there) const;
  double largest() const;  // force [N]

  const Contacts& contacts_;
  const Contacts::Part& part_;
  std::size_t first_strain_;
  MeanAcceleration& average_;
  std::vector<Tried> at_;
  std::vector<MeanAcceleration::Bears> tangents_;
  std::vector<StrainForm> strains_;  // of the contacts, once the slopes of faces that stick are asked for
};

}  // namespace adit::fdm
