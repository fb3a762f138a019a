#include "coupler/answers/answers.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <initializer_list>
#include <set>
#include <utility>
#include <vector>

#include "protocol/errors.hpp"
#include "protocol/results/vtk.hpp"
#include "protocol/text.hpp"
#include "protocol/wire/content/finite.hpp"

namespace adit::coupler {
namespace {

// Names become columns of tables.
constexpr std::size_t kLongestName = 64;

// Collects what is wrong with the answers of one peer.
class Answer {
 public:
  explicit Answer(const std::string& peer) : peer_(peer) {}

  [[noreturn]] void refuse(const std::string& what) const {
    throw protocol::PeerLost(peer_, "sent an answer that cannot be used: " + what);
  }
  void require(bool holds, const std::string& what) const {
    if (!holds) refuse(what);
  }
  void at_least_zero(std::initializer_list<std::pair<const char*, double>> values) const {
    for (const auto& [name, value] : values)
      if (!(value >= 0)) refuse(fmt::format("{} is {}, which cannot be less than 0", name, value));
  }
  void named(const std::string& what, const std::string& name) const {
    if (!results::is_name(name, kLongestName))
      refuse(fmt::format("{} is named {}; expected 1 to 64 letters, digits, `_` or `-`", what,
                         protocol::quote(name)));
  }

 private:
  const std::string& peer_;
};

void check(const wire::Model& model, const Answer& answer) {
  answer.require(model.critical_dt() > 0,
                 fmt::format("model.critical_dt is {}, which must be positive", model.critical_dt()));
  answer.at_least_zero({{"model.critical_static_dt", model.critical_static_dt()},
                        {"model.p_wave_speed", model.p_wave_speed()},
                        {"model.s_wave_speed", model.s_wave_speed()},
                        {"model.highest_frequency", model.highest_frequency()}});
  answer.require(model.x_min() <= model.x_max() && model.y_min() <= model.y_max(),
                 "the bounding box of the model is turned inside out");
  answer.require(model.sample_points_size() % 2 == 0, "model.sample_points are not pairs of x and y");
}

void check(const wire::Interface& interface, const Answer& answer) {
  answer.at_least_zero({{"interface.mass", interface.mass()}});
  answer.require(interface.points_size() % 2 == 0, "interface.points are not pairs of x and y");
  std::vector<std::pair<double, double>> points;
  for (int i = 0; i + 1 < interface.points_size(); i += 2)
    points.emplace_back(interface.points(i), interface.points(i + 1));
  std::ranges::sort(points);
  if (const auto twice = std::ranges::adjacent_find(points); twice != points.end())
    answer.refuse(fmt::format("interface.points offers ({:g}, {:g}) m twice", twice->first, twice->second));
}

void check(const wire::Energies& energies, const Answer& answer) {
  std::set<std::string_view> names;
  for (const wire::EnergyShare& share : energies.shares()) {
    answer.named("a share of the energy", share.name());
    answer.require(names.insert(share.name()).second,
                   fmt::format("two shares of the energy are named `{}`", share.name()));
  }
}

void check(const wire::Relaxation& relaxation, const Answer& answer) {
  answer.at_least_zero({{"relaxation.kinetic_energy", relaxation.kinetic_energy()},
                        {"relaxation.unbalanced_force", relaxation.unbalanced_force()},
                        {"relaxation.internal_force", relaxation.internal_force()},
                        {"relaxation.largest_unbalanced_force", relaxation.largest_unbalanced_force()},
                        {"relaxation.largest_displacement", relaxation.largest_displacement()},
                        {"relaxation.drag_x", relaxation.drag_x()},
                        {"relaxation.drag_y", relaxation.drag_y()}});
  answer.require(relaxation.points() > 0 || relaxation.unbalanced_force() == 0,
                 "relaxation has an unbalanced force of no points");
  answer.require(relaxation.elements() > 0 || relaxation.internal_force() == 0,
                 "relaxation has an internal force of no elements");
}

void check(const wire::Predicted& predicted, const Answer& answer) {
  answer.at_least_zero({{"predicted.compute_seconds", predicted.compute_seconds()},
                        {"predicted.hidden_seconds", predicted.hidden_seconds()},
                        {"predicted.demand", predicted.demand()}});
  for (const wire::BondForce& force : predicted.strongest())
    answer.at_least_zero({{"predicted.strongest.force", force.force()}});
  for (const wire::Crack& crack : predicted.cracks())
    answer.at_least_zero({{"predicted.cracks.length", crack.length()}});
  if (predicted.has_energies()) check(predicted.energies(), answer);
  if (predicted.has_relaxation()) check(predicted.relaxation(), answer);
}

void check(const wire::Bye& bye, const Answer& answer) {
  answer.at_least_zero({{"bye.cpu_seconds", bye.cpu_seconds()}});
  for (const wire::CrackPath& path : bye.crack_paths())
    answer.at_least_zero({{"bye.crack_paths.length", path.length()},
                          {"bye.crack_paths.opening", path.opening()},
                          {"bye.crack_paths.slip", path.slip()}});
}

}  // namespace

void require_sound(const wire::Frame& frame, const std::string& peer) {
  const Answer answer(peer);
  if (const auto wrong = protocol::first_not_finite(frame)) answer.refuse(*wrong);
  switch (frame.content_case()) {
    case wire::Frame::kModel:
      return check(frame.model(), answer);
    case wire::Frame::kInterface:
      return check(frame.interface(), answer);
    case wire::Frame::kPredicted:
      return check(frame.predicted(), answer);
    case wire::Frame::kBye:
      return check(frame.bye(), answer);
    default:  // an operator is checked where its rows are known, a snapshot where its files are
      return;
  }
}

}  // namespace adit::coupler
