#include "simplified/chain/results.hpp"

namespace adit::simplified::chain {

Results::Results(std::size_t bodies)
    : deformation(components(bodies + 1)), force(components(bodies + 1)), envelopes(bodies, bodies + 1) {}

void Results::set(const Model& model, const CurvedHinges& curved, const Tracks& tracks, std::size_t begin,
                  std::size_t end) {
  measure(model, displacement(tracks), velocity(tracks), begin, end, deformation, force);
  // After measure(), whose tangent forces it replaces for the hinges with curves.
  curved.put_on_curve(model, velocity(tracks), begin, end, deformation, force);
}

void Results::start(const Model& model, const CurvedHinges& curved, const Tracks& tracks) {
  set(model, curved, tracks, 0, model.bodies + 1);
  Envelopes& e = envelopes;
  e.x.reset_to(std::span(tracks[0].x).subspan(1, model.bodies));
  e.y.reset_to(std::span(tracks[1].x).subspan(1, model.bodies));
  e.opening.reset_to(deformation[0]);
  e.slip.reset_to(deformation[1]);
  e.rotation.reset_to(deformation[2]);
  e.axial_force.reset_to(force[0]);
  e.shear_force.reset_to(force[1]);
  e.moment.reset_to(force[2]);
}

void Results::take(const Model& model, const CurvedHinges& curved, const Tracks& tracks, std::size_t first,
                   std::size_t last) {
  const std::size_t begin = first == 1 ? 0 : first;  // the first hinge
  set(model, curved, tracks, begin, last);
  Envelopes& e = envelopes;
  e.x.widen_to(std::span(tracks[0].x).subspan(1), first - 1, last - 1);
  e.y.widen_to(std::span(tracks[1].x).subspan(1), first - 1, last - 1);
  e.opening.widen_to(deformation[0], begin, last);
  e.slip.widen_to(deformation[1], begin, last);
  e.rotation.widen_to(deformation[2], begin, last);
  e.axial_force.widen_to(force[0], begin, last);
  e.shear_force.widen_to(force[1], begin, last);
  e.moment.widen_to(force[2], begin, last);
}

}  // namespace adit::simplified::chain
