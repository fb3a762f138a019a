#include "coupler/participants/interface.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "protocol/errors.hpp"

namespace adit::coupler {
namespace {

using protocol::UserError;

// On the line where a model ends its particles exist and are coupled, with a trace of weight, while zones
// beyond that line do not.
constexpr double kTrace = 1e-9;

double weight_at(const Participant& participant, std::size_t s, const std::vector<Interface>& interfaces,
                 double x, double y) {
  const bool particles = participant.member.role == Role::kParticles;
  double weight = 1;
  for (const Interface& interface : interfaces) {
    if (interface.outer != s && interface.inner != s) continue;
    const Overlap& overlap = interface.overlap;
    double own = interface.outer == s ? overlap.outer_weight(x, y) : overlap.inner_weight(x, y);
    if (particles && overlap.contains(x, y)) own = std::max(own, kTrace);
    if (!particles && own <= 2 * kTrace) own = 0;
    weight *= own;
  }
  return weight;
}

// Paths of the interfaces whose inner model reaches (x, y).
std::vector<std::string> paths_at(const std::vector<Interface>& interfaces, double x, double y) {
  std::vector<std::string> paths;
  for (const Interface& interface : interfaces)
    if (interface.overlap.inner_weight(x, y) > 0) paths.push_back(interface.path);
  return paths;
}

// The candidates of the participant that lie in the overlap.
std::vector<double> candidates_in(const Overlap& overlap, const Participant& participant) {
  std::vector<double> inside;
  const std::vector<double>& points = participant.candidates;
  for (std::size_t i = 0; i + 1 < points.size(); i += 2)
    if (overlap.contains(points[i], points[i + 1])) inside.insert(inside.end(), {points[i], points[i + 1]});
  return inside;
}

}  // namespace

BoundingBox bounds(const wire::Model& model) {
  return {model.x_min(), model.x_max(), model.y_min(), model.y_max()};
}

std::vector<double> weights_of(std::size_t s, const std::vector<Participant>& participants,
                               const std::vector<Interface>& interfaces, std::span<const double> points) {
  std::vector<double> weights(points.size() / 2);
  for (std::size_t i = 0; i < weights.size(); ++i)
    weights[i] = weight_at(participants[s], s, interfaces, points[2 * i], points[2 * i + 1]);
  return weights;
}

void require_one_owner(const std::vector<Participant>& participants,
                       const std::vector<Interface>& interfaces) {
  if (interfaces.size() < 2) return;
  constexpr double kTolerance = 1e-6;  // traces of weight on the lines where models end
  for (std::size_t s = 0; s < participants.size(); ++s) {
    const auto& points = participants[s].model.sample_points();
    for (int i = 0; i + 1 < points.size(); i += 2) {
      const double x = points[i], y = points[i + 1];
      if (weight_at(participants[s], s, interfaces, x, y) == 0) continue;
      double sum = 0;
      for (std::size_t other = 0; other < participants.size(); ++other)
        sum += weight_at(participants[other], other, interfaces, x, y);
      if (std::abs(sum - 1) > kTolerance)
        throw UserError(
            interfaces.back().path + ".overlap",
            fmt::format("meets another one at ({:g}, {:g}) m, where the energy weights of all models "
                        "sum to {:g}: {} share this place; move the overlaps apart",
                        x, y, sum, fmt::join(paths_at(interfaces, x, y), " and ")));
    }
  }
}

BoundingBox overlap_bounds(std::size_t participant, const std::vector<Participant>& participants,
                           const std::vector<Interface>& interfaces) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  BoundingBox box{kInfinity, -kInfinity, kInfinity, -kInfinity};
  for (const Interface& interface : interfaces) {
    if (interface.outer != participant && interface.inner != participant) continue;
    const BoundingBox part = interface.overlap.bounds(bounds(participants[participant].model));
    box = {std::min(box.x_min, part.x_min), std::max(box.x_max, part.x_max), std::min(box.y_min, part.y_min),
           std::max(box.y_max, part.y_max)};
  }
  return box;
}

std::vector<double> choose_coupling_points(const std::vector<Participant>& participants,
                                           std::vector<Interface>& interfaces) {
  std::vector<double> coupling_points;
  std::set<std::tuple<std::size_t, double, double>> taken;  // participant and place
  for (Interface& interface : interfaces) {
    auto outer = candidates_in(interface.overlap, participants[interface.outer]);
    auto inner = candidates_in(interface.overlap, participants[interface.inner]);
    const Role outer_role = participants[interface.outer].member.role,
               inner_role = participants[interface.inner].member.role;
    const bool inner_is_fine =
        outer_role == inner_role ? inner.size() >= outer.size() : inner_role == Role::kParticles;
    interface.fine = inner_is_fine ? interface.inner : interface.outer;
    interface.coarse = inner_is_fine ? interface.outer : interface.inner;
    const std::vector<double>& points = inner_is_fine ? inner : outer;
    if (points.empty())
      throw UserError(interface.path + ".overlap",
                      fmt::format("holds no {} of `{}`; widen it to several of their diameters",
                                  participants[interface.fine].member.role == Role::kParticles ? "particle"
                                                                                               : "grid point",
                                  participants[interface.fine].member.name));
    for (std::size_t i = 0; i < points.size(); i += 2)
      if (!taken.insert({interface.fine, points[i], points[i + 1]}).second)
        throw UserError(interface.path + ".overlap",
                        fmt::format("ties the point ({:g}, {:g}) m of `{}`, which another interface ties "
                                    "already; move the overlaps apart",
                                    points[i], points[i + 1], participants[interface.fine].member.name));
    interface.begin = coupling_points.size() / 2;
    coupling_points.insert(coupling_points.end(), points.begin(), points.end());
    interface.end = coupling_points.size() / 2;
  }
  return coupling_points;
}

}  // namespace adit::coupler
