#include "simplified/beam/elements/joint_springs.hpp"

#include <algorithm>
#include <cmath>

namespace adit::simplified::beam {
namespace {

Curve scaled(Curve curve, double factor) {
  for (CurvePoint& point : curve.points) point.force *= factor;
  curve.slope_before *= factor;
  curve.slope_after *= factor;
  return curve;
}

// Force of the load curve per metre of gasket, which continues with its last slope.
double force_at(const std::vector<CurvePoint>& compression, double c) {
  const CurvePoint &a = compression[compression.size() - 2], &b = compression.back();
  return Curve{compression, 0, (b.force - a.force) / (b.elongation - a.elongation)}.force(c);
}

double gasket_force(const std::vector<Joint::Gasket>& gaskets, double compression) {
  double force = 0;
  for (const auto& g : gaskets) force += g.length * force_at(g.compression, compression);
  return force;
}

// The compression, common to all gaskets of a joint, at which together they carry the hydrostatic force. The
// force is monotone, so bisection finds it to the last bit.
double common_compression(const Joint& joint) {
  if (joint.hydrostatic_force == 0) return 0;
  // The bracket starts at a millimetre and doubles until the gaskets carry the force, which they do because
  // their load curves rise for ever.
  double low = 0, high = 1e-3;
  while (gasket_force(joint.gaskets, high) < joint.hydrostatic_force) high *= 2;
  for (double middle = 0.5 * high; middle > low && middle < high; middle = 0.5 * (low + high))
    (gasket_force(joint.gaskets, middle) < joint.hydrostatic_force ? low : high) = middle;
  return high;
}

std::array<double, kDofs> along_axis(double y, double z) {
  return {1, 0, 0, -y, -z};
}

}  // namespace

std::vector<Joint::Spring> axial_springs(const Joint& joint) {
  const double installed = common_compression(joint);
  std::vector<Joint::Spring> springs;
  for (const auto& g : joint.gaskets)
    springs.push_back(
        {g.y, g.z, scaled(gasket(g.compression, force_at(g.compression, installed)), g.length)});
  springs.insert(springs.end(), joint.springs.begin(), joint.springs.end());
  return springs;
}

JointSprings::JointSprings(const Tunnel& tunnel, const Mesh& mesh)
    : links_(mesh.joints), link_count_(mesh.links.size()) {
  for (const int link : links_) {
    const Joint& joint = tunnel.joints[mesh.links[link].joint];
    std::vector<Place> perimeter;
    const auto add = [&](const std::array<double, kDofs>& arm, const Curve& curve) {
      if (!curve.points.empty()) springs_.push_back({link, arm, index_of(curve), curve.piece(0)});
    };
    const std::vector<Joint::Spring> axial = axial_springs(joint);
    for (std::size_t k = 0; k < axial.size(); ++k) {
      add(along_axis(axial[k].y, axial[k].z), axial[k].curve);
      // Gaskets lie on the perimeter; without them the springs' places are the outermost known points.
      if (joint.gaskets.empty() || k < joint.gaskets.size()) perimeter.push_back({axial[k].y, axial[k].z});
    }
    if (perimeter.empty()) perimeter.push_back({0, 0});
    add({0, 1, 0, 0, 0}, joint.lateral);
    add({0, 0, 1, 0, 0}, joint.vertical);
    installed_.push_back(common_compression(joint));
    perimeter_.push_back(std::move(perimeter));
  }
}

std::size_t JointSprings::index_of(const Curve& curve) {
  // A linear search is enough: joints of one group share their curves, so there are few.
  const auto found = std::ranges::find(curves_, curve);
  if (found != curves_.end()) return static_cast<std::size_t>(found - curves_.begin());
  curves_.push_back(curve);
  return curves_.size() - 1;
}

SpringAnswer JointSprings::mean(const Spring& s) const {
  const auto [start, end] = s.elongation;
  return s.piece.holds(end) ? s.piece.mean(start, end) : curves_[s.curve].mean(start, end);
}

Piece JointSprings::piece_at_end(const Spring& s) const {
  return s.piece.holds(s.elongation[1]) ? s.piece : curves_[s.curve].piece(s.elongation[1]);
}

void JointSprings::evaluate(const Scheme& scheme, std::span<const double> u, std::span<double> forces) {
  auto spring = springs_.begin();
  for (const int link : links_) {
    const double *first = u.data() + kDofs * link, *second = first + kDofs;
    std::array<double, kDofs> relative, sum{};
    for (int i = 0; i < kDofs; ++i) relative[i] = second[i] - first[i];
    for (; spring != springs_.end() && spring->link == link; ++spring) {
      const double force = respond(scheme, *spring, relative);
      for (int i = 0; i < kDofs; ++i) sum[i] += spring->arm[i] * force;
    }
    double* on_first = forces.data() + kDofs * link;
    for (int i = 0; i < kDofs; ++i) {
      on_first[i] -= sum[i];
      on_first[kDofs + i] += sum[i];
    }
  }
}

double JointSprings::respond(const Scheme& scheme, Spring& s,
                             const std::array<double, kDofs>& relative) const {
  s.elongation[1] = 0;
  for (int i = 0; i < kDofs; ++i) s.elongation[1] += s.arm[i] * relative[i];
  if (scheme.mean_force) {
    const SpringAnswer answer = mean(s);
    s.tangent = answer.tangent;
    return answer.force;
  }
  const Piece end = piece_at_end(s);
  s.force[1] = end.at(s.elongation[1]);
  s.tangent = (1 - scheme.alpha_f) * end.slope;
  return (1 - scheme.alpha_f) * s.force[1] + scheme.alpha_f * s.force[0];
}

std::size_t JointSprings::update_tangents(BlockTridiagonal& matrix) {
  std::size_t first = link_count_;
  for (Spring& s : springs_) {
    // Only changes are added, because few springs change their piece in a step and the matrix holds the
    // others.
    if (s.tangent == s.assembled_tangent) continue;
    const double change = s.tangent - s.assembled_tangent;
    for (int i = 0; i < kDofs; ++i)
      for (int j = 0; j < kDofs; ++j) {
        const double value = change * s.arm[i] * s.arm[j];
        matrix.diagonal[s.link](i, j) += value;
        matrix.diagonal[s.link + 1](i, j) += value;
        matrix.lower[s.link](i, j) -= value;
      }
    s.assembled_tangent = s.tangent;
    first = std::min<std::size_t>(first, s.link);
  }
  return first;
}

void JointSprings::forget_tangents() {
  for (Spring& s : springs_) s.assembled_tangent = 0;
}

double JointSprings::commit() {
  double stored = 0;
  for (Spring& s : springs_) {
    // The mean force needs the piece at the start of the step, so it comes before the piece is renewed.
    stored += mean(s).force * (s.elongation[1] - s.elongation[0]);
    s.piece = piece_at_end(s);
    s.elongation[0] = s.elongation[1];
    s.force[0] = s.force[1];
  }
  return stored;
}

JointState JointSprings::state(std::size_t joint, std::span<const double> u) const {
  const double *first = u.data() + kDofs * links_[joint], *second = first + kDofs;
  JointState state{-1e300, -1e300, std::hypot(second[1] - first[1], second[2] - first[2])};
  for (const Place& place : perimeter_[joint]) {
    const double opening =
        second[0] - first[0] - place.y * (second[3] - first[3]) - place.z * (second[4] - first[4]);
    state.opening = std::max(state.opening, opening);
    state.compression = std::max(state.compression, -opening);
  }
  return state;
}

JointAction JointSprings::action(std::size_t joint, std::span<const double> u) const {
  const double *first = u.data() + kDofs * links_[joint], *second = first + kDofs;
  JointAction action{second[0] - first[0], second[1] - first[1], second[3] - first[3]};
  for (auto spring = std::ranges::lower_bound(springs_, links_[joint], {}, &Spring::link);
       spring != springs_.end() && spring->link == links_[joint]; ++spring) {
    double elongation = 0;
    for (int i = 0; i < kDofs; ++i) elongation += spring->arm[i] * (second[i] - first[i]);
    const double force = curves_[spring->curve].force(elongation);
    action.axial_force += spring->arm[0] * force;
    action.shear += spring->arm[1] * force;
    action.moment += spring->arm[3] * force;
  }
  return action;
}

}  // namespace adit::simplified::beam
