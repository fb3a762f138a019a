// One bar along its own axis: truss elements between nodes that slip in their particles. It has no mass, so
// that it neither carries waves nor shortens the step: in each step its slips are those of equilibrium.
//
// Node k slips by s_k along the path against its particle; element k, from node k to the next, is as long as
// the places of both are apart, and grows by g_k as they move. With A the area of the bars, U their perimeter
// and l_k the length that a node bonds,
//   e_k = g_k + s_(k+1) - s_k,   N_k = A sigma(e_k / L_k),   B_k = U l_k tau(s_k),
//   N_k - N_(k-1) = B_k   at every node,
// where the energy of elements and bonds, with what yielding and sliding take, is least for the given g.
// Newton's method finds it: a tridiagonal system in each round. After some rounds stiffnesses are the elastic
// ones, which are the largest, so that the energy falls in any case; where bonds soften, what is left
// unbalanced after the last round is balanced in later steps.
//
// Then the particles' work on the bar, sum N_k dg_k, is that on elements and bonds, sum N_k de_k + sum B_k
// ds_k.
#pragma once

#include <span>
#include <vector>

#include "dem_server/engines/general/bars/tridiagonal.hpp"
#include "dem_server/model/bars.hpp"
#include "protocol/state/archive.hpp"

namespace adit::dem {

class BarChain {
 public:
  explicit BarChain(const Bar& bar);

  // Takes the elements' growths [m], of those that are whole.
  void stretch(std::span<const double> growths);
  // Elements and bonds of which no particle is left bear nothing from now on.
  void cut(std::size_t element);
  void loosen(std::size_t node);

  bool whole(std::size_t element) const { return whole_[element]; }
  double force(std::size_t element) const { return bar_.area * steel_[element].stress; }  // N_k [N]
  double stress(std::size_t element) const { return steel_[element].stress; }             // [Pa]
  double strain(std::size_t element) const { return strain_[element]; }
  double slip(std::size_t node) const { return slip_[node]; }                // s_k [m]
  double bond_stress(std::size_t node) const { return bond_[node].stress; }  // tau [Pa]
  double stored() const;                                                     // [J]
  double yielded() const { return yielded_; }  // taken by yielding since the start [J]
  double slipped() const { return slipped_; }  // by sliding
  void start_over() { yielded_ = slipped_ = 0; }

  const Bar& bar() const { return bar_; }
  std::span<const double> rest_lengths() const { return length_; }

  void exchange(state::Archive& archive) {
    archive("bar_slips", std::span(slip_));
    archive("bar_strains", std::span(strain_));
    archive("bar_steel", std::span(steel_));
    archive("bar_bonds", std::span(bond_));
    archive("bar_whole", whole_);
    archive("bar_bonded", bonded_);
    archive("bar_yielded", yielded_);
    archive("bar_slipped", slipped_);
  }

 private:
  // Finds states for the slips; returns the largest unbalanced force over the largest one.
  double find(std::span<const double> growths, bool elastic);
  double approach(std::span<const double> growths, bool elastic);
  void weaken();
  void break_steel();
  void take();

  Bar bar_;
  std::vector<double> length_;  // of elements at rest [m]
  std::vector<double> slip_, strain_;
  std::vector<protocol::SteelState> steel_;
  std::vector<BarBondState> bond_;
  std::vector<bool> whole_, bonded_;
  double yielded_ = 0, slipped_ = 0;
  // In work.
  std::vector<BarBondLaw> bond_law_;
  std::vector<double> next_slip_, next_strain_, unbalanced_, way_, from_;
  std::vector<protocol::SteelState> next_steel_;
  std::vector<BarBondState> next_bond_;
  Tridiagonal system_;
};

}  // namespace adit::dem
