#include "adapters/lammps/particles/conditions.hpp"

#include <map>
#include <utility>

#include "protocol/state/archive.hpp"

namespace adit::lammps {
namespace {

// Sums since the start stay where they were counted.
template <class Counting>
void replace(Counting& old, Counting fresh) {
  state::Archive written;
  old.exchange(written);
  state::Archive read(written.take());
  fresh.exchange(read);
  old = std::move(fresh);
}

}  // namespace

ConditionSets::ConditionSets(const dem::Model& model) {
  std::vector<std::vector<double>> acting(model.discs.size());
  double number = 0;
  told_ = {static_cast<double>(model.loads.size()), static_cast<double>(model.motions.size())};
  for (const dem::Load& load : model.loads) {
    told_.insert(told_.end(),
                 {static_cast<double>(load.kind), load.x, load.y, static_cast<double>(load.discs.size())});
    for (const std::uint32_t i : load.discs) acting[i].push_back(number);
    ++number;
  }
  for (const dem::PrescribedMotion& motion : model.motions) {
    told_.insert(told_.end(), {static_cast<double>(motion.component), motion.amplitude});
    for (const std::uint32_t i : motion.discs) acting[i].push_back(number);
    ++number;
  }
  std::map<std::vector<double>, double> numbers;
  for (const std::vector<double>& set : acting) {
    const auto [found, fresh] = numbers.try_emplace(set, static_cast<double>(numbers.size()));
    set_of_disc_.push_back(found->second);
    if (!fresh) continue;
    told_.push_back(static_cast<double>(set.size()));
    told_.insert(told_.end(), set.begin(), set.end());
  }
}

Values ConditionSets::factors(const dem::Model& model, const protocol::Step& step) {
  Values factors;
  for (const dem::Load& load : model.loads) factors.push_back(load.time(step.time()));
  for (const dem::PrescribedMotion& motion : model.motions) factors.push_back(motion.time(step.half_time()));
  return factors;
}

Conditions::Conditions(std::span<const double> told) {
  auto at = told.begin();
  const auto loads = static_cast<std::size_t>(*at++), motions = static_cast<std::size_t>(*at++);
  const auto factor = [this](std::size_t k) { return [all = factors_, k](double) { return (*all)[k]; }; };
  for (std::size_t k = 0; k < loads; ++k, at += 4) {
    model_.loads.push_back({.kind = static_cast<dem::Load::Kind>(at[0]),
                            .discs = {},
                            .x = at[1],
                            .y = at[2],
                            .time = factor(k),
                            .path = {}});
    whole_.push_back({at[1], at[2], at[3]});
  }
  for (std::size_t k = 0; k < motions; ++k, at += 2)
    model_.motions.push_back({.component = static_cast<dem::Component>(at[0]),
                              .discs = {},
                              .amplitude = at[1],
                              .time = factor(loads + k),
                              .path = {}});
  while (at != told.end()) {
    const auto count = static_cast<std::ptrdiff_t>(*at++);
    sets_.emplace_back(at, at + count);
    at += count;
  }
}

// Of a force that all its particles share equally, those here bear their part.
void Conditions::share(const Whole& whole, dem::Load& load) {
  if (load.kind != dem::Load::Kind::kForce) return;
  const double part = static_cast<double>(load.discs.size()) / whole.particles;
  load.x = whole.x * part;
  load.y = whole.y * part;
}

void Conditions::renew(const Part& part) {
  for (dem::Load& load : model_.loads) load.discs.clear();
  for (dem::PrescribedMotion& motion : model_.motions) motion.discs.clear();
  for (std::uint32_t i = 0; i < part.own(); ++i)
    for (const std::uint32_t k : sets_[static_cast<std::size_t>(part.conditions[i])])
      (k < model_.loads.size() ? model_.loads[k].discs : model_.motions[k - model_.loads.size()].discs)
          .push_back(i);
  for (std::size_t k = 0; k < whole_.size(); ++k) share(whole_[k], model_.loads[k]);
  dem::Loads loads(model_, part.particles);
  dem::PrescribedMotions motions(model_, part.particles);
  if (!std::exchange(began_, true)) {
    loads_ = std::move(loads);
    motions_ = std::move(motions);
    return;
  }
  replace(loads_, std::move(loads));
  replace(motions_, std::move(motions));
}

}  // namespace adit::lammps
