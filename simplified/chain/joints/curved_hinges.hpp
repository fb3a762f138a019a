// Hinges whose force follows a curve. Their tangents are renewed within the step until every force lies on
// its curve.
//
// The curve is replaced by its tangent f = offset + slope delta at some delta, and the linear step gives a
// new delta. If the forces of tangents and curves differ too much there, the tangents are taken at the new
// delta, and so on (Newton's method). The equations of the step hold exactly for the tangents, so this
// difference is the only error. With curves of straight pieces the iteration has converged as soon as the
// right pieces are found.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "simplified/chain/joints/joint_forces.hpp"
#include "simplified/chain/model/model.hpp"

namespace adit::simplified::chain {

class CurvedHinges {
 public:
  explicit CurvedHinges(const Chain& chain);
  bool empty() const { return terms_.empty(); }

  struct Check {
    double error = 0;  // largest difference between tangent and curve, relative to the curve's largest force
    std::size_t hinge = 0, direction = 0;  // the place of this difference
  };
  // Compares the tangents with the curves at the displacements x.
  Check compare(const Model& model, const Field& x) const;

  // Takes new tangents at the displacements x or, if `cautious`, half-way between the last ones and these,
  // because Newton's method may oscillate about a curve that first hardens and then softens. Returns the
  // first hinge that has changed.
  std::size_t relinearize(const Field& x, bool cautious, Model& model);

  // Sets the curves' own forces in the results of the hinges begin … end - 1.
  void put_on_curve(const Model& model, const Field& v, std::size_t begin, std::size_t end,
                    const Components& deformation, Components& force) const;

 private:
  struct Term {
    std::size_t hinge, direction;
    Curve curve;
    double largest;  // largest |force| of the curve
    double at = 0;   // deformation at which the tangent is taken
  };
  std::vector<Term> terms_;  // by hinge
};

}  // namespace adit::simplified::chain
