// Hinges whose force follows a curve: tangents, renewed within the step until every force lies on its curve.
//
// The curve is replaced by its tangent f = offset + slope delta at some delta; the linear step gives a new
// delta. Newton's method: where the tangents' forces differ from the curves' by too much, the new tangents
// are taken there. The step's equations hold for the tangents, so the difference is the whole of their error.
// Curves of straight pieces converge as soon as the pieces are found.
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
    double error = 0;  // largest difference of tangent and curve, as a part of the curve's largest force
    std::size_t hinge = 0, direction = 0;  // where
  };
  // Compares the tangents with the curves at the displacements x.
  Check compare(const Model& model, const Field& x) const;

  // Takes new tangents at the displacements x, or half-way to them from the last ones where `cautious`
  // (Newton may jump to and fro across a curve that first hardens and then softens). Returns the first hinge
  // that has changed.
  std::size_t relinearize(const Field& x, bool cautious, Model& model);

  // Sets the curves' own forces in the results of the hinges begin … end - 1.
  void put_on_curve(const Model& model, const Field& v, std::size_t begin, std::size_t end,
                    const Components& deformation, Components& force) const;

 private:
  struct Term {
    std::size_t hinge, direction;
    Curve curve;
    double largest;  // |force| in the table
    double at = 0;   // deformation of the tangent
  };
  std::vector<Term> terms_;  // by hinge
};

}  // namespace adit::simplified::chain
