#include "adapters/lammps/rank.hpp"

#include <functional>

#include "dem_server/particles/energy.hpp"
#include "dem_server/particles/integrate.hpp"

namespace adit::lammps {
namespace {

constexpr std::size_t kLawValues = 13;

std::vector<dem::PairLaw> laws_of(std::span<const double> told) {
  std::vector<dem::PairLaw> laws;
  for (const double* v = told.data(); v < told.data() + told.size(); v += kLawValues)
    laws.push_back({v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7] != 0, {v[8], v[9], v[10], v[11], v[12]}});
  return laws;
}

template <class Take>
void for_each_record(std::span<const double> values, Take&& take) {
  for (std::size_t k = 0; k < values.size(); k += kRecordValues) take(record_at(&values[k]));
}

}  // namespace

Values told(const std::vector<dem::PairLaw>& laws) {
  Values told;
  for (const dem::PairLaw& l : laws)
    told.insert(told.end(),
                {l.kn, l.ks, l.km, l.tensile_strength, l.moment_factor, l.cohesion, l.tan_friction_angle,
                 l.contact_beside_bond ? 1.0 : 0.0, l.contact.normal_stiffness, l.contact.shear_stiffness,
                 l.contact.friction, l.contact.normal_damping, l.contact.shear_damping});
  return told;
}

Values Rank::obey(Order order, std::span<const double> values) {
  const auto take_own = [&](void (Part::*take)(const PairRecord&)) {
    for_each_record(values, [&](const PairRecord& r) {
      const bool own = decomposition_->place_of(r.first) < part_->own() ||
                       decomposition_->place_of(r.second) < part_->own();
      if (own) ((*part_).*take)(r);
    });
    return Values{};
  };
  const auto tell = [](const auto& for_each) {
    Values told;
    for_each([&told](const PairRecord& record) { append(record, told); });
    return told;
  };
  switch (order) {
    case Order::kBegin:
      return begin(values), Values{};
    case Order::kParticles:
      return decomposition_->add(static_cast<std::uint32_t>(values[0]), values.subspan(1)), Values{};
    case Order::kBalance:
      return decomposition_->balance(), Values{};
    case Order::kBonds:
      return take_own(&Part::take_bond);
    case Order::kContacts:
      return take_own(&Part::take_contact);
    case Order::kConditions:
      conditions_ = Conditions(values);
      return {};
    case Order::kStart:
      return renew(), Values{};
    case Order::kTie:
      tied_.assign(values.begin(), values.end());
      return find_tied(), Values{};
    case Order::kCorrect:
      return correct(values), Values{};
    case Order::kRemember:
      return dem::remember(part_->particles, part_->before), Values{};
    case Order::kStep:
      return step(values);
    case Order::kEnergies:
      return energies();
    case Order::kTellMotion:
      return tell_motion();
    case Order::kTellBonds:
      return tell(std::bind_front(&Part::for_each_bond, part_.get()));
    case Order::kTellContacts:
      return tell(std::bind_front(&Part::for_each_contact, part_.get()));
    case Order::kQuit:
      break;
  }
  return {};
}

// x_min x_max y_min y_max, reach, skin, whether there are bonds and dashpots, the first law of contacts, the
// number of groups, the laws.
void Rank::begin(std::span<const double> v) {
  decomposition_.reset();
  part_ = std::make_unique<Part>();
  tied_.clear();
  tied_here_.clear();
  part_->laws = {laws_of(v.subspan(10)),
                 static_cast<std::uint32_t>(v[8]),
                 static_cast<std::uint32_t>(v[9]),
                 v[5],
                 v[6] != 0,
                 v[7] != 0};
  decomposition_ = std::make_unique<Decomposition>(ranks_, geometry::BoundingBox{v[0], v[1], v[2], v[3]},
                                                   v[4], v[5], *part_);
}

void Rank::renew() {
  decomposition_->renew();
  conditions_.renew(*part_);
  find_tied();
}

void Rank::find_tied() {
  tied_here_.clear();
  for (std::uint32_t k = 0; k < tied_.size(); ++k)
    if (const std::uint32_t place = decomposition_->place_of(tied_[k]); place < part_->own())
      tied_here_.push_back({place, k});
}

void Rank::correct(std::span<const double> velocities) {
  for (const auto [place, tie] : tied_here_) {
    part_->particles.vx[place] = velocities[2 * tie];
    part_->particles.vy[place] = velocities[2 * tie + 1];
  }
}

// The number of the step, dt [s], the factors of loads and motions, corrected velocities of tied particles.
Values Rank::step(std::span<const double> v) {
  const protocol::Step step{.number = static_cast<std::uint64_t>(v[0]), .dt = v[1]};
  const std::size_t factors = conditions_.size();
  conditions_.set_factors(v.subspan(2, factors));
  if (v.size() > 2 + factors) correct(v.subspan(2 + factors));
  from_rest_ = step.from_rest();
  dem::Particles& particles = part_->particles;
  if (!from_rest_) {
    part_->move(step.dt);
    const auto farthest = [this] {
      double most = part_->moved.most();
      MPI_Request request;
      MPI_Iallreduce(MPI_IN_PLACE, &most, 1, MPI_DOUBLE, MPI_MAX, ranks_, &request);
      wait(request);
      return most;
    };
    if (farthest() > part_->laws.skin / 2) {
      part_->moved.measure(particles);
      if (farthest() > part_->laws.skin / 2) renew();
    }
  }
  decomposition_->show();
  part_->pull(from_rest_ ? 0 : step.dt);
  conditions_.load(step, particles);
  const protocol::IndexRange own = part_->own_range();
  dem::kick(step, {&own, 1}, dem::resultants_of(particles), particles);
  conditions_.impose(step, particles);
  return reached();
}

// Whether a bond is torn, the largest normal force and its place, the number of bonds that broke and these,
// the velocities of tied particles with the numbers of their ties.
Values Rank::reached() const {
  const auto [force, x, y] = part_->strongest();
  Values reached{part_->torn() ? 1.0 : 0.0, force, x, y, static_cast<double>(part_->broken().size())};
  for (const Broken& bond : part_->broken()) reached.insert(reached.end(), {bond.number, bond.state});
  for (const auto [place, tie] : tied_here_)
    reached.insert(reached.end(),
                   {static_cast<double>(tie), part_->particles.vx[place], part_->particles.vy[place]});
  return reached;
}

// Kinetic; stored in contacts, contact bonds, parallel bonds; released, by friction, by dashpots; work of
// forces, accelerations, motions.
Values Rank::energies() const {
  const dem::Stored stored = part_->stored();
  const dem::Loads::Work& work = conditions_.work_of_loads();
  return {dem::kinetic_energy(part_->particles, part_->before, from_rest_) +
              (from_rest_ ? conditions_.kinetic_energy_of_motions() : 0),
          stored.contacts,
          stored.contact_bonds,
          stored.parallel_bonds,
          part_->released,
          part_->friction,
          part_->dashpots,
          work.forces,
          work.accelerations,
          conditions_.work_of_motions()};
}

// Of each own particle: its number, displacement, velocity, spin.
Values Rank::tell_motion() const {
  const dem::Particles& p = part_->particles;
  Values told;
  for (std::uint32_t i = 0; i < part_->own(); ++i)
    told.insert(told.end(), {static_cast<double>(p.id[i]), p.ux[i], p.uy[i], p.vx[i], p.vy[i], p.spin[i]});
  return told;
}

}  // namespace adit::lammps
