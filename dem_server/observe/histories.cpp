#include "dem_server/observe/histories.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <tuple>

#include "dem_server/lining/use_peaks.hpp"
#include "dem_server/observe/branches.hpp"
#include "dem_server/observe/fragments.hpp"
#include "protocol/errors.hpp"
#include "protocol/text.hpp"

namespace adit::dem {
namespace {

using protocol::UserError;

std::uint32_t nearest(const Particles& p, double x, double y) {
  std::uint32_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double dx = p.x[i] - x, dy = p.y[i] - y, squared = dx * dx + dy * dy;
    if (squared < least) {
      least = squared;
      best = static_cast<std::uint32_t>(i);
    }
  }
  return best;
}

std::uint32_t particle_at(const scene::Point& at, const std::string& path, const Particles& particles) {
  const double x = at.x(), y = at.y();
  const std::uint32_t particle = nearest(particles, x, y);
  if (const double distance = std::hypot(particles.x[particle] - x, particles.y[particle] - y);
      distance > 2 * particles.radius[particle])
    throw UserError(path, fmt::format("is ({:g}, {:g}) m, but the nearest particle is {:g} m away; choose "
                                      "a place within a diameter of a particle",
                                      x, y, distance));
  return particle;
}

// `over`: what a circle is for.
Circle circle_of(const scene::History& history, const std::string& path, const std::string& over,
                 const Particles& p) {
  if (!history.has_at()) throw UserError(path + ".at", "is missing; give the circle's middle, {x: …, y: …}");
  if (!history.has_radius())
    throw UserError(path + ".radius", fmt::format("is missing; {} of particles is {}",
                                                  protocol::name_of(history.quantity()), over));
  const Circle circle{history.at().x(), history.at().y(), history.radius()};
  std::size_t inside = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (std::hypot(p.x[i] - circle.x, p.y[i] - circle.y) < circle.radius) ++inside;
  if (inside < 3)
    throw UserError(
        path + ".radius",
        fmt::format("is {:g} m, but the centres of {} particle(s) lie so near to ({:g}, {:g}) m; choose a "
                    "radius that holds three and more",
                    circle.radius, inside, circle.x, circle.y));
  return circle;
}

// What a history names: `given` among `names`; its key, what the quantity is, and where the scene adds one.
struct Named {
  std::string key, told, list;
};
std::size_t number_of(const Named& kind, const std::string& given, const std::vector<std::string>& names,
                      scene::Quantity quantity, const std::string& path) {
  const auto found = std::ranges::find(names, given);
  if (!given.empty() && found != names.end()) return static_cast<std::size_t>(found - names.begin());
  std::vector<std::string> named;
  std::ranges::copy_if(names, std::back_inserter(named), [](const auto& name) { return !name.empty(); });
  throw UserError(path + "." + kind.key,
                  fmt::format("is {}, but {} is {}; {}", given.empty() ? "missing" : protocol::quote(given),
                              protocol::name_of(quantity), kind.told,
                              named.empty() ? "add it to " + kind.list
                                            : fmt::format("choose one of {}", fmt::join(named, ", "))));
}

std::size_t wall_of(const scene::History& history, const std::string& path, const Observable& observed) {
  std::vector<std::string> names;
  for (const WallForce& wall : observed.walls()) names.push_back(wall.name);
  return number_of({"wall", "a force on a wall", "particles.walls"}, history.wall(), names,
                   history.quantity(), path);
}

std::size_t section_of(const scene::History& history, const std::string& path, const Sections& sections) {
  std::vector<std::string> names;
  for (const Cut& cut : sections.cuts()) names.push_back(cut.name);
  const std::size_t number = number_of({"section", "a force in a section", "particles.sections"},
                                       history.section(), names, history.quantity(), path);
  protocol::require_strength(history, sections.cuts()[number].strength != nullptr,
                             fmt::format("particles.sections[{}]", number), path);
  return number;
}

std::size_t joint_of(const scene::History& history, const std::string& path,
                     const std::vector<JointFaces>& joints) {
  std::vector<std::string> names;
  for (const JointFaces& joint : joints) names.push_back(joint.name());
  return number_of({"joint", "a motion of a joint", "particles.joints, with a name"}, history.joint(), names,
                   history.quantity(), path);
}

std::size_t spring_of(const scene::History& history, const std::string& path, const Observable& observed) {
  std::vector<std::string> names;
  for (const SpringForce& spring : observed.springs()) names.push_back(spring.name);
  return number_of({"spring", "the force of a spring", "particles.springs"}, history.spring(), names,
                   history.quantity(), path);
}

std::size_t oval_of(const scene::History& history, const std::string& path, const std::vector<Oval>& ovals) {
  std::vector<std::string> names;
  for (const Oval& oval : ovals) names.push_back(oval.name());
  return number_of({"oval", "that of an oval", "particles.ovals"}, history.oval(), names, history.quantity(),
                   path);
}

std::size_t group_of(const scene::History& history, const std::string& what, const std::string& path,
                     const Observable& observed) {
  const auto names = observed.group_names();
  return number_of({"group", what, "particles.groups"}, history.group(), {names.begin(), names.end()},
                   history.quantity(), path);
}

// The largest demand on the facets between two cells of each group; none where they cannot break.
std::vector<std::optional<double>> demands(const Observable& observed) {
  std::vector<std::optional<double>> largest(observed.group_names().size());
  observed.for_each_bond([&, group = observed.group()](const ObservedPair& pair) {
    if (!pair.demand || group[pair.first] != group[pair.second]) return;
    std::optional<double>& of_group = largest[group[pair.first]];
    of_group = std::max(of_group.value_or(0), *pair.demand);
  });
  return largest;
}

std::size_t breakable_group_of(const scene::History& history, const std::string& path,
                               const Observable& observed) {
  const std::size_t group = group_of(history, "the largest in a group", path, observed);
  if (!demands(observed)[group])
    throw UserError(
        path + ".quantity",
        fmt::format("is demand, but nothing between the particles of group `{}` can break that has "
                    "a demand; pack `cells`, and give their material `fracture`",
                    observed.group_names()[group]));
  return group;
}

// The element of a bar whose middle is nearest, and whether its second end is the nearer one.
std::pair<std::size_t, bool> bar_at(const scene::History& history, const std::string& path,
                                    const Observable& observed) {
  const std::vector<ObservedBar> bars = observed.bars();
  if (bars.empty())
    throw UserError(path + ".quantity",
                    fmt::format("is {}, but the scene has no bar; add it to particles.bars",
                                protocol::name_of(history.quantity())));
  const double x = history.at().x(), y = history.at().y();
  const auto nearest_bar = std::ranges::min_element(bars, {}, [&](const ObservedBar& bar) {
    return std::hypot((bar.x_1 + bar.x_2) / 2 - x, (bar.y_1 + bar.y_2) / 2 - y);
  });
  const double first = std::hypot(nearest_bar->x_1 - x, nearest_bar->y_1 - y),
               second = std::hypot(nearest_bar->x_2 - x, nearest_bar->y_2 - y);
  const double length = std::hypot(nearest_bar->x_2 - nearest_bar->x_1, nearest_bar->y_2 - nearest_bar->y_1);
  if (std::min(first, second) > length)
    throw UserError(path + ".at",
                    fmt::format("is ({:g}, {:g}) m, but the nearest bar is {:g} m away; choose a "
                                "place on it",
                                x, y, std::min(first, second)));
  return {nearest_bar - bars.begin(), second < first};
}

double component(const SectionForces& forces, scene::Quantity quantity) {
  if (quantity == scene::THRUST) return forces.thrust;
  return quantity == scene::MOMENT ? forces.moment : forces.shear;
}

double velocity(const Particles& p, scene::Quantity quantity, std::uint32_t i) {
  return quantity == scene::VELOCITY_Y || quantity == scene::ACCELERATION_Y ? p.vy[i] : p.vx[i];
}

double displacement(const Particles& p, scene::Quantity quantity, std::uint32_t i) {
  return quantity == scene::DISPLACEMENT_Y ? p.uy[i] - p.settled_y[i] : p.ux[i] - p.settled_x[i];
}

double component(const JointMotion& motion, scene::Quantity quantity) {
  if (quantity == scene::OPENING) return motion.opening;
  return quantity == scene::OFFSET ? motion.offset : motion.rotation;
}

double component(const DiameterChange& change, scene::Quantity quantity) {
  if (quantity == scene::LARGEST_DIAMETER_CHANGE) return change.largest;
  return quantity == scene::SMALLEST_DIAMETER_CHANGE ? change.smallest : change.direction;
}

// What means over circles need of the particles that are there, found once a row and only where it is asked
// for.
class CircleMeans {
 public:
  explicit CircleMeans(const Observable& observed) : observed_(observed) {
    const Particles& p = observed.particles();
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (!p.is_there(i)) continue;
      there_.push_back(i);
      x_.push_back(p.x[i] + p.ux[i]);
      y_.push_back(p.y[i] + p.uy[i]);
      vx_.push_back(p.vx[i]);
      vy_.push_back(p.vy[i]);
      radius_.push_back(p.radius[i]);
    }
  }

  double value(scene::Quantity quantity, const Circle& circle) {
    switch (quantity) {
      case scene::STRESS_XX:
        return stress(circle).xx;
      case scene::STRESS_YY:
        return stress(circle).yy;
      case scene::STRESS_XY:
        return stress(circle).xy;
      case scene::STRAIN_RATE_XX:
        return strain_rate(circle).xx;
      case scene::STRAIN_RATE_YY:
        return strain_rate(circle).yy;
      case scene::SHEAR_STRAIN_RATE_XY:
        return 2 * strain_rate(circle).xy;
      case scene::COORDINATION:
        return mean_coordination(circle, x_, y_, coordination());
      default:
        return porosity(circle, x_, y_, radius_);
    }
  }

 private:
  Tensor stress(const Circle& circle) {
    if (!branches_) branches_ = branches_of(observed_);
    return mean_stress(circle, *branches_);
  }
  Tensor strain_rate(const Circle& circle) const {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    return mean_strain_rate(circle, x_, y_, vx_, vy_).value_or(Tensor{kNone, kNone, kNone});
  }
  const std::vector<std::uint32_t>& coordination() {
    if (!coordination_) {
      const auto all = coordination_of(observed_.particles().size(), touching_particles(observed_));
      coordination_.emplace();
      for (const std::size_t i : there_) coordination_->push_back(all[i]);
    }
    return *coordination_;
  }

  const Observable& observed_;
  std::vector<std::size_t> there_;
  std::vector<double> x_, y_, vx_, vy_, radius_;
  std::optional<std::vector<Branch>> branches_;
  std::optional<std::vector<std::uint32_t>> coordination_;
};

}  // namespace

Histories::Histories(const scene::Particles& scene, const Observable& observed, const Lining& lining) {
  for (int i = 0; i < scene.histories_size(); ++i) {
    const auto& given = scene.histories(i);
    const std::string path = fmt::format("particles.histories[{}]", i);
    History history{.quantity = given.quantity()};
    protocol::require_relative_motion(given, path);
    switch (taken_over(given.quantity())) {
      case Over::kParticle:
        if (!given.has_at()) throw UserError(path + ".at", "is missing; give the place, {x: …, y: …}");
        history.particle = particle_at(given.at(), path + ".at", observed.particles());
        if (given.has_relative_to())
          history.against = particle_at(given.relative_to(), path + ".relative_to", observed.particles());
        break;
      case Over::kCircle:
        history.circle =
            circle_of(given, path, "a mean over a circle: give its radius, best ten of a particle's or more",
                      observed.particles());
        break;
      case Over::kWall:
        history.named = wall_of(given, path, observed);
        break;
      case Over::kSection:
        history.named = section_of(given, path, lining.sections);
        break;
      case Over::kJoint:
        history.named = joint_of(given, path, lining.joints);
        break;
      case Over::kSpring:
        history.named = spring_of(given, path, observed);
        break;
      case Over::kOval:
        history.named = oval_of(given, path, lining.ovals);
        break;
      case Over::kCracks:
        if (observed.outlines().empty())
          throw UserError(path + ".quantity",
                          "is crack_width, but only cracks between `particles.cells` have a width; choose "
                          "another quantity, or pack cells");
        if (given.has_group())
          history.named = group_of(given, "that of the cracks in a group", path, observed);
        else
          history.circle =
              circle_of(given, path, "the largest in a circle or a group: give its radius, or `group`",
                        observed.particles());
        break;
      case Over::kDemand:
        history.named = breakable_group_of(given, path, observed);
        break;
      case Over::kBar:
        if (!given.has_at())
          throw UserError(path + ".at", "is missing; give the place on the bar, {x: …, y: …}");
        std::tie(history.named, history.second) = bar_at(given, path, observed);
        break;
      case Over::kNothing:
        throw UserError(
            path + ".quantity",
            fmt::format("is {}, which particles do not have; choose a motion, a stress, a strain rate, "
                        "coordination or porosity, a force on a wall, in a section or of a spring, a motion "
                        "of a joint, a diameter of an oval, a width of cracks, the stress or slip of a bar",
                        protocol::name_of(given.quantity())));
    }
    histories_.push_back(history);
  }
}

void Histories::tie(std::span<const std::uint32_t> particles) {
  const auto is_tied = [&](std::uint32_t particle) {
    return std::ranges::find(particles, particle) != particles.end();
  };
  for (History& history : histories_)
    history.tied = is_tied(history.particle) || (history.against && is_tied(*history.against));
}

double Histories::motion(const History& history, const MotionOf& of, const Particles& particles) {
  const double here = of(particles, history.quantity, history.particle);
  return history.against ? here - of(particles, history.quantity, *history.against) : here;
}

// By their places at rest. A group has the cracks between two of its own cells.
bool Histories::holds(const History& history, const ObservedCrack& crack, const Observable& observed) {
  if (crack.debonded) return false;
  if (history.circle) {
    const auto [x, y] = crack.middle();
    return std::hypot(x - history.circle->x, y - history.circle->y) <= history.circle->radius;
  }
  const auto group = observed.group();
  return group[crack.first] == history.named && group[crack.second] == history.named;
}

void Histories::remember(const Particles& particles) {
  for (History& history : histories_) history.velocity.remember(motion(history, velocity, particles));
}

void Histories::read(const Observable& observed, const Lining& lining, const protocol::Step& step,
                     std::vector<double>& values) const {
  const Particles& p = observed.particles();
  std::optional<CircleMeans> means;
  std::optional<std::vector<SectionForces>> forces;  // in sections
  std::optional<Fragments> fragments;
  std::optional<std::vector<ObservedCrack>> cracks;
  std::optional<std::vector<ObservedBar>> bars;
  std::optional<std::vector<std::optional<double>>> largest_demands;
  for (const History& history : histories_) {
    switch (history.quantity) {
      case scene::DISPLACEMENT_X:
      case scene::DISPLACEMENT_Y:
        values.push_back(motion(history, displacement, p));
        break;
      case scene::VELOCITY_X:
      case scene::VELOCITY_Y:
        values.push_back(history.velocity.before());
        break;
      case scene::ACCELERATION_X:
      case scene::ACCELERATION_Y:
        values.push_back(history.velocity.acceleration(motion(history, velocity, p), step, history.tied));
        break;
      case scene::FORCE_X:
        values.push_back(observed.walls()[history.named].x);
        break;
      case scene::FORCE_Y:
        values.push_back(observed.walls()[history.named].y);
        break;
      case scene::OPENING:
      case scene::OFFSET:
      case scene::ROTATION:
        if (!fragments) fragments = fragments_of(p.size(), firm_bonds(observed));
        values.push_back(component(
            lining.joints[history.named].motion(p, {fragments->number, fragments->size}), history.quantity));
        break;
      case scene::SPRING_FORCE:
        values.push_back(observed.springs()[history.named].force);
        break;
      case scene::LARGEST_DIAMETER_CHANGE:
      case scene::SMALLEST_DIAMETER_CHANGE:
      case scene::LARGEST_DIAMETER_DIRECTION:
        values.push_back(component(lining.ovals[history.named].change(p), history.quantity));
        break;
      case scene::THRUST:
      case scene::MOMENT:
      case scene::SHEAR_FORCE:
        if (!forces) forces = section_forces(observed, lining.sections);
        values.push_back(component((*forces)[history.named], history.quantity));
        break;
      case scene::UTILISATION:
      case scene::SHEAR_STRENGTH: {
        if (!forces) forces = section_forces(observed, lining.sections);
        const sections::Use use = use_of(lining.sections.cuts()[history.named], (*forces)[history.named]);
        values.push_back(history.quantity == scene::UTILISATION ? use.utilisation : use.shear_strength);
        break;
      }
      case scene::CRACK_WIDTH:
        if (!cracks) cracks = observed.cracks();
        values.push_back(0);
        for (const ObservedCrack& crack : *cracks)
          if (holds(history, crack, observed)) values.back() = std::max(values.back(), crack.opening);
        break;
      case scene::DEMAND:
        if (!largest_demands) largest_demands = demands(observed);
        values.push_back((*largest_demands)[history.named].value_or(0));
        break;
      case scene::BAR_STRESS:
        if (!bars) bars = observed.bars();
        values.push_back((*bars)[history.named].stress);
        break;
      case scene::BAR_SLIP:
        if (!bars) bars = observed.bars();
        values.push_back(history.second ? (*bars)[history.named].slip_2 : (*bars)[history.named].slip_1);
        break;
      default:
        if (!means) means.emplace(observed);
        values.push_back(means->value(history.quantity, *history.circle));
    }
  }
}

}  // namespace adit::dem
