#include "simplified/chain/joints/curved_hinges.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace adit::simplified::chain {

CurvedHinges::CurvedHinges(const Chain& chain) {
  const auto add = [this](std::size_t j, const Hinge& hinge) {
    const std::array<const HingeDirection*, 3> directions{&hinge.axial, &hinge.shear, &hinge.rotation};
    for (std::size_t d = 0; d < 3; ++d) {
      const Curve& curve = directions[d]->curve;
      if (curve.empty()) continue;
      // The force never decreases along a curve, so its largest size lies at one of the two ends.
      const double largest = std::max(std::abs(curve.force.front()), std::abs(curve.force.back()));
      terms_.push_back({j, d, curve, largest});
    }
  };
  // Terms are added in the order of the hinges, because put_on_curve() searches them by bisection.
  if (chain.start) add(0, *chain.start);
  for (std::size_t j = 0; j < chain.hinges.size(); ++j) add(j + 1, chain.hinges[j]);
  if (chain.finish) add(chain.bodies.size(), *chain.finish);
}

CurvedHinges::Check CurvedHinges::compare(const Model& model, const Field& x) const {
  Check worst;
  for (const Term& term : terms_) {
    const auto [j, d] = std::pair(term.hinge, term.direction);
    const double delta = deformation(model, x, j, d);
    // The model keeps the force at rest apart from the tangent, because outer forces balance it; the curve
    // contains it.
    const double tangent = model.at_rest[d][j] + model.offset[d][j] + model.stiffness[d][j] * delta;
    const double difference = std::abs(line_at(term.curve, delta).at(delta) - tangent);
    // A curve of zeros has no error.
    const double error = difference > 0 ? difference / term.largest : 0;
    if (error > worst.error) worst = {error, j, d};
  }
  return worst;
}

std::size_t CurvedHinges::relinearize(const Field& x, bool cautious, Model& model) {
  // Only slopes enter the matrices of the sweep. If none changes, the last hinge is returned, so that a
  // single place is factored again.
  std::size_t first = model.bodies;
  for (Term& term : terms_) {
    const auto [j, d] = std::pair(term.hinge, term.direction);
    const double delta = deformation(model, x, j, d);
    term.at = cautious ? 0.5 * (term.at + delta) : delta;
    const Line line = line_at(term.curve, term.at);
    if (line.slope != model.stiffness[d][j]) first = std::min(first, j);
    model.stiffness[d][j] = line.slope;
    model.offset[d][j] = line.offset - model.at_rest[d][j];
  }
  return first;
}

void CurvedHinges::put_on_curve(const Model& model, const Field& v, std::size_t begin, std::size_t end,
                                const Components& deformations, Components& force) const {
  auto term = std::lower_bound(terms_.begin(), terms_.end(), begin,
                               [](const Term& t, std::size_t hinge) { return t.hinge < hinge; });
  for (; term != terms_.end() && term->hinge < end; ++term) {
    const auto [j, d] = std::pair(term->hinge, term->direction);
    const double delta = deformations[d][j];
    // The result is the force of the curve itself; that of the tangent differs from it by up to the
    // tolerance.
    force[d][j] = line_at(term->curve, delta).at(delta) + model.dashpot[d][j] * deformation(model, v, j, d);
  }
}

}  // namespace adit::simplified::chain
