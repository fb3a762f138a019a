#include "adapters/lammps/engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "adapters/lammps/particles/conditions.hpp"
#include "adapters/lammps/particles/pair_records.hpp"
#include "adapters/lammps/particles/part.hpp"
#include "adapters/lammps/rank.hpp"
#include "dem_server/engines/general/renumber.hpp"
#include "protocol/errors.hpp"

namespace adit::lammps {
namespace {

constexpr std::size_t kRows = 65536;  // of a list that is told at a time

dem::Model renumbered(dem::Model model) {
  renumber(model);
  return model;
}

[[noreturn]] void refuse(const std::string& what) {
  throw protocol::RequestError(what + " is not computed by LAMMPS, and the scene does not ask for it");
}

}  // namespace

LammpsEngine::LammpsEngine(const dem::Model& model, Orders& orders)
    : orders_(orders), model_(renumbered(model)), picture_(model_, 1) {}

// The first that is asked of an engine whose particles have their weights; the ranks may take long to begin.
void LammpsEngine::watch(const scene::Particles& scene) {
  begin();
  picture_.watch(scene);
  watched_ = scene.histories_size() + scene.sections_size() + scene.ovals_size() > 0;
  remembers_ = std::ranges::any_of(scene.histories(), [](const scene::History& history) {
    const auto quantity = history.quantity();
    return quantity == scene::VELOCITY_X || quantity == scene::VELOCITY_Y ||
           quantity == scene::ACCELERATION_X || quantity == scene::ACCELERATION_Y;
  });
}

const protocol::InterfaceOperator& LammpsEngine::tie(std::span<const double> places) {
  const protocol::InterfaceOperator& n = picture_.tie(places);
  orders_.give(Order::kTie, Values(n.points().begin(), n.points().end()));
  return n;
}

void LammpsEngine::begin() {
  const dem::Solver& solver = picture_.solver();
  const dem::Pairs &bonds = solver.bonds(), &contacts = solver.contacts();
  const dem::Particles& p = solver.particles();
  double reach = 2 * std::ranges::max(p.radius);
  if (bonds.size() > 0) reach = std::max(reach, std::ranges::max(bonds.rest_length));
  const auto [x_min, x_max] = std::ranges::minmax(p.x);
  const auto [y_min, y_max] = std::ranges::minmax(p.y);
  const double first_contact = static_cast<double>(solver.laws().size() - model_.contacts.size());
  Values values{x_min,
                x_max,
                y_min,
                y_max,
                reach,
                solver.neighbours().skin(),
                bonds.size() > 0 ? 1.0 : 0.0,
                contacts.normal_dashpot.empty() ? 0.0 : 1.0,
                first_contact,
                static_cast<double>(model_.groups())};
  for (const double value : told({solver.laws().begin(), solver.laws().end()})) values.push_back(value);
  orders_.give(Order::kBegin, std::move(values));
  tell_particles();
  orders_.give(Order::kBalance);
  tell_pairs(Order::kBonds, bonds);
  tell_pairs(Order::kContacts, contacts);
  orders_.give(Order::kStart);
}

void LammpsEngine::tell_particles() {
  const ConditionSets conditions(model_);
  orders_.give(Order::kConditions, conditions.told());
  // A part of all particles, from which their rows are taken.
  Part all;
  all.particles = picture_.particles();
  const std::size_t count = all.particles.size();
  for (std::size_t i = 0; i < count; ++i) {
    all.group.push_back(picture_.group()[i]);
    all.conditions.push_back(conditions.of(i));
  }
  all.resize(count);
  const auto columns = all.columns();
  for (std::size_t first = 0; first < count; first += kRows) {
    Values rows{static_cast<double>(first)};
    for (std::size_t i = first; i < std::min(first + kRows, count); ++i)
      for (const auto* column : columns) rows.push_back((*column)[i]);
    orders_.give(Order::kParticles, std::move(rows));
  }
}

void LammpsEngine::tell_pairs(Order order, const dem::Pairs& pairs) {
  PairSet set{pairs, {}};
  for (std::size_t k = 0; k < pairs.size(); ++k) set.number.push_back(static_cast<double>(k));
  Numbers numbers(picture_.particles().size());
  for (std::uint32_t i = 0; i < numbers.size(); ++i) numbers[i] = i;
  for (std::uint32_t first = 0; first < pairs.size(); first += kRows) {
    Values rows;
    for (std::uint32_t k = first; k < std::min<std::size_t>(first + kRows, pairs.size()); ++k)
      append(record_of(set, k, numbers), rows);
    orders_.give(order, std::move(rows));
  }
}

// The picture corrects its tied particles, and the ranks take over their velocities, at the latest with the
// next step.
void LammpsEngine::correct(std::span<const double> impulses) {
  picture_.correct(impulses);
  corrected_ = true;
}

Values LammpsEngine::corrected_velocities() const {
  Values velocities;
  if (!std::exchange(corrected_, false)) return velocities;
  const dem::Particles& p = picture_.particles();
  for (const std::uint32_t i : picture_.tied()) velocities.insert(velocities.end(), {p.vx[i], p.vy[i]});
  return velocities;
}

std::vector<Values> LammpsEngine::ask(Order order) const {
  if (Values velocities = corrected_velocities(); !velocities.empty())
    orders_.give(Order::kCorrect, std::move(velocities));
  return orders_.give(order);
}

void LammpsEngine::prepare(bool energies) {
  if (energies) ask(Order::kRemember);
  if (!remembers_) return;
  fetch_motion();
  picture_.prepare(false);
}

void LammpsEngine::step_interface(const protocol::Step& step) {
  if (step.relax || step.stop) refuse("statics");
  Values values{static_cast<double>(step.number), step.dt};
  for (const Values& more : {ConditionSets::factors(model_, step), corrected_velocities()})
    values.insert(values.end(), more.begin(), more.end());
  strongest_ = {};
  std::vector<std::uint32_t> broken;
  for (const Values& answer : orders_.give(Order::kStep, std::move(values))) {
    take_answer(answer, step);
    for (std::size_t k = 0; k < static_cast<std::size_t>(answer[4]); ++k) {
      const auto bond = static_cast<std::uint32_t>(answer[5 + 2 * k]);
      picture_.solver().bonds().state[bond] = static_cast<dem::BondState>(answer[6 + 2 * k]);
      broken.push_back(bond);
    }
  }
  if (!std::isfinite(strongest_.force))
    throw protocol::Unstable(
        fmt::format("step {}: the normal force between the particles at ({:.6g}, {:.6g}) m is {} N; reduce "
                    "time.dt_factor",
                    step.number, strongest_.x, strongest_.y, strongest_.force));
  note_cracks(std::move(broken));
}

void LammpsEngine::take_answer(const Values& answer, const protocol::Step& step) {
  if (answer[0] != 0)
    throw protocol::Unstable(fmt::format(
        "step {}: a bond has stretched to twice the longest one at rest, beyond what a rank sees of "
        "another; give its bonds a strength, or use dem_server",
        step.number));
  // The order of non-negative numbers leaves nan out, which must be told.
  if (!(std::abs(answer[1]) <= std::abs(strongest_.force)))
    strongest_ = {std::abs(answer[1]), answer[2], answer[3]};
  dem::Particles& p = picture_.particles();
  for (std::size_t k = 5 + 2 * static_cast<std::size_t>(answer[4]); k < answer.size(); k += 3) {
    const std::uint32_t i = picture_.tied()[static_cast<std::size_t>(answer[k])];
    p.vx[i] = answer[k + 1];
    p.vy[i] = answer[k + 2];
  }
}

void LammpsEngine::note_cracks(std::vector<std::uint32_t> broken) {
  cracks_.clear();
  std::ranges::sort(broken);
  const dem::Solver& solver = picture_.solver();
  const dem::Pairs& bonds = solver.bonds();
  for (const std::uint32_t k : broken) {
    const std::uint32_t i = bonds.first[k], j = bonds.second[k];
    const double width = solver.laws()[bonds.law[k]].contact_beside_bond ? bonds.width[k] : 0;
    dem::Crack crack = crack_between(solver.particles(), i, j, width, bonds.state[k]);
    std::tie(crack.group_a, crack.group_b) = std::minmax({picture_.group()[i], picture_.group()[j]});
    cracks_.push_back(crack);
  }
}

dem::Energies LammpsEngine::energies(const protocol::Step&) {
  Values sum(10, 0.0);
  for (const Values& answer : ask(Order::kEnergies))
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += answer[k];
  return {.kinetic = sum[0],
          .strain = sum[1] + sum[2] + sum[3],
          .external_work = sum[7] + sum[8] + sum[9],
          .released = sum[4],
          .dissipated = sum[5] + sum[6],
          .shares = {{"contacts", sum[1]},
                     {"contact_bonds", sum[2]},
                     {"parallel_bonds", sum[3]},
                     {"loads", sum[7]},
                     {"body_loads", sum[8]},
                     {"motions", sum[9]},
                     {"friction", sum[5]},
                     {"contact_dashpots", sum[6]}}};
}

void LammpsEngine::read_histories(const protocol::Step& step, std::vector<double>& values) {
  if (!watched_) return;
  fetch();
  picture_.read_histories(step, values);
}

void LammpsEngine::snapshot(wire::Snapshot& snapshot) const {
  fetch();
  picture_.snapshot(snapshot);
}

std::uint64_t LammpsEngine::fragments() const {
  return picture_.fragments();
}

void LammpsEngine::fetch() const {
  fetch_motion();
  fetch_bonds();
  fetch_contacts();
}

void LammpsEngine::fetch_motion() const {
  dem::Particles& p = picture_.particles();
  for (const Values& told : ask(Order::kTellMotion))
    for (std::size_t k = 0; k < told.size(); k += 6) {
      const auto i = static_cast<std::size_t>(told[k]);
      std::tie(p.ux[i], p.uy[i], p.vx[i], p.vy[i], p.spin[i]) =
          std::tie(told[k + 1], told[k + 2], told[k + 3], told[k + 4], told[k + 5]);
    }
}

void LammpsEngine::fetch_bonds() const {
  dem::Pairs& bonds = picture_.solver().bonds();
  for (const Values& told : ask(Order::kTellBonds))
    for (std::size_t at = 0; at < told.size(); at += kRecordValues) {
      const PairRecord r = record_at(&told[at]);
      const auto k = static_cast<std::size_t>(r.number);
      bonds.slide[k] = r.slide;
      bonds.shear[k] = r.shear;
      bonds.moment[k] = r.moment;
      bonds.state[k] = static_cast<dem::BondState>(r.state);
    }
}

void LammpsEngine::fetch_contacts() const {
  std::vector<PairRecord> listed;
  for (const Values& told : ask(Order::kTellContacts))
    for (std::size_t at = 0; at < told.size(); at += kRecordValues) listed.push_back(record_at(&told[at]));
  dem::Pairs& contacts = picture_.solver().neighbours().pairs();
  const auto same = [](double number) { return static_cast<std::uint32_t>(number); };
  contacts =
      set_of(listed, same, picture_.particles().size(), {false, !contacts.normal_dashpot.empty(), {}}).pairs;
}

double LammpsEngine::kinetic_energy() const {
  refuse("statics");
}
dem::Unrest LammpsEngine::unrest(const protocol::Step&) {
  refuse("statics");
}
void LammpsEngine::stop() {
  refuse("statics");
}
void LammpsEngine::count_displacements() {
  refuse("statics");
}
void LammpsEngine::start_over(const protocol::Drift&) {
  refuse("statics");
}
void LammpsEngine::exchange(state::Archive&) {
  refuse("the state of a run");
}

}  // namespace adit::lammps
