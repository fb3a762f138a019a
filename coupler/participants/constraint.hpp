// The velocity constraint over all coupling points of a model: one system, whatever participants and
// interfaces it joins, so that interfaces may share grid points. Velocities, masses and multipliers are those
// of the model's clock (Participant::step_ratio).
#pragma once

#include <map>
#include <memory>
#include <span>
#include <vector>

#include "coupler/bridging/solves/multipliers.hpp"
#include "coupler/participants/interface.hpp"
#include "coupler/participants/participant.hpp"

namespace adit::coupler {

enum class Part { kCoarse, kFine };

class Constraint {
 public:
  // `points`: the coupling points of all interfaces in turn, x0 y0 x1 y1 …; dt: time between two corrections
  // [s]. Every participant has its operator. Throws protocol::UserError where a point is tied twice, where
  // the interfaces name different solves, and for what the solve itself refuses.
  Constraint(const std::vector<Participant>& participants, const std::vector<Interface>& interfaces,
             std::span<const double> points, double dt);

  std::size_t size() const { return coarse_.coupling_points(); }

  // Velocities of all coupling points, as the coarse or as the fine sides have them: `velocities` names the
  // member of Participant to read, predicted or corrected.
  void read(const std::vector<Participant>& participants, Part part,
            std::vector<double> Participant::*velocities, std::span<double> at_points) const;

  // The multipliers λ [N s] for these velocities of both parts. Throws protocol::Unstable where they are
  // beyond numbers.
  void solve(std::span<const double> coarse, std::span<const double> fine, std::span<double> multipliers);

  // Renews the corrections of the participants, at the coupling points where they are this part: −factor·λ on
  // the coarse sides, +factor·λ on the fine ones.
  void assign(std::span<const double> multipliers, double factor, Part part,
              std::vector<Participant>& participants) const;

  // Whether the fine side waits, condensed, at these coupling points. There are no multipliers there then.
  void set_idle(std::size_t begin, std::size_t end, bool idle);
  // The fine velocities there become the coarse ones, so that they leave no gap.
  void close_idle(std::span<const double> coarse, std::span<double> fine) const;

  // velocities −= N M⁻¹ Nᵀ λ: what −λ does to the coarse velocities at the coupling points.
  void correct_coarse(std::span<const double> multipliers, std::span<double> velocities);

  const MultiplierSolve& multipliers() const { return *solve_; }

 private:
  Interpolation coarse_;  // N and M of all coarse sides in one numbering
  std::unique_ptr<MultiplierSolve> solve_;
  std::map<std::size_t, std::size_t> idle_;  // coupling points from the first to before the second
  std::vector<double> own_, at_points_;      // scratch
};

}  // namespace adit::coupler
