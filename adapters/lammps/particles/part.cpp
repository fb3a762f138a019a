#include "adapters/lammps/particles/part.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "dem_server/model/group_pairs.hpp"

namespace adit::lammps {

std::array<std::vector<double>*, Part::kColumns> Part::columns() {
  dem::Particles& p = particles;
  return {&p.x,
          &p.y,
          &p.radius,
          &p.ux,
          &p.uy,
          &p.vx,
          &p.vy,
          &p.spin,
          &p.weight,
          &p.mass,
          &p.inertia,
          &p.inverse_mass,
          &p.inverse_inertia,
          &group,
          &conditions,
          &before.x,
          &before.y,
          &before.spin};
}

void Part::resize(std::size_t places) {
  for (auto* column : columns()) column->resize(places);
  for (auto* sum : {&particles.fx, &particles.fy, &particles.moment}) sum->resize(places);
  particles.id.resize(places);
  origin_.resize(places);
}

Part::Index Part::index_of(const std::vector<PairRecord>& records, const PlaceOf& place_of) {
  Index index;
  for (std::uint32_t k = 0; k < records.size(); ++k)
    for (const double number : {records[k].first, records[k].second}) index.push_back({place_of(number), k});
  std::ranges::sort(index, {}, &Entry::place);
  return index;
}

void Part::open(std::size_t room, const PlaceOf& place_of) {
  for (const Share& from : bonds_)
    for (std::uint32_t k = 0; k < from.set.pairs.size(); ++k)
      bonds_out_.push_back(record_of(from.set, k, numbers()));
  bonds_out_.insert(bonds_out_.end(), apart_.begin(), apart_.end());
  for (const Share& from : contacts_)
    for (std::uint32_t k = 0; k < from.set.pairs.size(); ++k)
      contacts_out_.push_back(record_of(from.set, k, numbers()));
  bonds_ = contacts_ = {};
  apart_.clear();
  bonds_at_ = index_of(bonds_out_, place_of);
  contacts_at_ = index_of(contacts_out_, place_of);
  resize(std::max(room, particles.size()));
  std::iota(origin_.begin(), origin_.end(), 0);
}

std::size_t Part::most_pairs() const {
  std::vector<std::size_t> pairs(own_, 0);
  for (const Index* index : {&bonds_at_, &contacts_at_})
    for (const Entry& entry : *index)
      if (entry.place < own_) ++pairs[entry.place];
  return pairs.empty() ? 0 : std::ranges::max(pairs);
}

void Part::copy(std::size_t from, std::size_t to) {
  for (auto* column : columns()) (*column)[to] = (*column)[from];
  origin_[to] = origin_[from];
}

std::vector<PairRecord> Part::taken_along(std::size_t place, const Index& index,
                                          const std::vector<PairRecord>& records,
                                          std::vector<PairRecord> Arrival::*arrived) const {
  const std::int64_t origin = origin_[place];
  if (origin < 0) return arrivals_[static_cast<std::size_t>(-1 - origin)].*arrived;
  std::vector<PairRecord> taken;
  const auto from = static_cast<std::uint32_t>(origin);
  for (auto entry = std::ranges::lower_bound(index, from, {}, &Entry::place);
       entry != index.end() && entry->place == from; ++entry)
    taken.push_back(records[entry->record]);
  return taken;
}

std::vector<PairRecord> Part::bonds_of(std::size_t place) const {
  return taken_along(place, bonds_at_, bonds_out_, &Arrival::bonds);
}

std::vector<PairRecord> Part::contacts_of(std::size_t place) const {
  return taken_along(place, contacts_at_, contacts_out_, &Arrival::contacts);
}

void Part::arrive(std::size_t place, std::vector<PairRecord> bonds, std::vector<PairRecord> contacts) {
  arrivals_.push_back({std::move(bonds), std::move(contacts)});
  origin_[place] = -static_cast<std::int64_t>(arrivals_.size());
}

// A pair is the business of the ranks that have one of its particles.
void Part::keep_own(std::vector<PairRecord>& records, const PlaceOf& place_of) const {
  std::erase_if(records, [&](const PairRecord& r) {
    return !is_own(r.first, place_of) && !is_own(r.second, place_of);
  });
  sort(records);
}

void Part::close(Numbers numbers, std::uint32_t own, const PlaceOf& place_of, const Near& near) {
  resize(numbers.size());
  particles.id = std::move(numbers);
  own_ = own;
  for (auto* mass : {&particles.mass, &particles.inertia}) std::fill(mass->begin() + own_, mass->end(), 0.0);
  for (const Arrival& arrival : arrivals_) {
    bonds_out_.insert(bonds_out_.end(), arrival.bonds.begin(), arrival.bonds.end());
    contacts_out_.insert(contacts_out_.end(), arrival.contacts.begin(), arrival.contacts.end());
  }
  keep_own(bonds_out_, place_of);
  keep_own(contacts_out_, place_of);
  contacts_ = divide(list(near), place_of, false);
  bonds_ = divide(bonds_in_reach(place_of), place_of, true);
  for (auto* records : {&bonds_out_, &contacts_out_}) *records = {};
  for (Index* index : {&bonds_at_, &contacts_at_}) *index = {};
  arrivals_.clear();
  moved.start(particles, {});
}

// What both lists hold keeps its history.
std::vector<PairRecord> Part::list(const Near& near) const {
  const dem::Particles& p = particles;
  const auto is_in = [](const std::vector<PairRecord>& records, const PairRecord& pair) {
    const auto found = std::ranges::lower_bound(records, pair, ascends);
    const bool same = found != records.end() && found->first == pair.first && found->second == pair.second;
    return same ? &*found : nullptr;
  };
  std::vector<PairRecord> listed;
  for (auto [i, j] : near) {
    if (p.id[i] > p.id[j]) std::swap(i, j);
    PairRecord r{.first = static_cast<double>(p.id[i]), .second = static_cast<double>(p.id[j])};
    r.rest_x = p.x[j] - p.x[i];
    r.rest_y = p.y[j] - p.y[i];
    r.rest_length = p.radius[i] + p.radius[j];
    if (std::hypot(r.rest_x + p.ux[j] - p.ux[i], r.rest_y + p.uy[j] - p.uy[i]) > r.rest_length + laws.skin)
      continue;
    if (is_in(bonds_out_, r)) continue;
    if (const PairRecord* kept = is_in(contacts_out_, r)) {
      listed.push_back(*kept);
      continue;
    }
    r.half_difference = (p.radius[i] - p.radius[j]) / 2;
    r.weight = (p.weight[i] + p.weight[j]) / 2;
    r.law = laws.first_contact + dem::group_pair_number(laws.groups, static_cast<std::uint32_t>(group[i]),
                                                        static_cast<std::uint32_t>(group[j]));
    listed.push_back(r);
  }
  return listed;
}

// Sets those apart whose other particle is out of sight: they bear nothing, and wait for it to come back.
std::vector<PairRecord> Part::bonds_in_reach(const PlaceOf& place_of) {
  std::vector<PairRecord> in_reach;
  for (const PairRecord& bond : bonds_out_) {
    const auto seen = [&](double number) { return place_of(number) < particles.size(); };
    if (seen(bond.first) && seen(bond.second)) {
      in_reach.push_back(bond);
      continue;
    }
    apart_.push_back(bond);
    torn_ = torn_ || bond.state == static_cast<double>(dem::BondState::kIntact);
  }
  return in_reach;
}

std::array<Part::Share, 2> Part::divide(const std::vector<PairRecord>& records, const PlaceOf& place_of,
                                        bool bonded) const {
  std::vector<PairRecord> inner, across;
  for (const PairRecord& r : records)
    (is_own(r.first, place_of) && is_own(r.second, place_of) ? inner : across).push_back(r);
  const PairKind kind{bonded, laws.dashpots, laws.all};
  return {Share{set_of(inner, place_of, particles.size(), kind), 1},
          Share{set_of(across, place_of, particles.size(), kind), 0.5}};
}

void Part::for_each(const std::array<Share, 2>& sets,
                    const std::function<void(const PairRecord&)>& see) const {
  for (const Share& from : sets)
    for (std::uint32_t k = 0; k < from.set.pairs.size(); ++k) {
      const std::uint32_t i = from.set.pairs.first[k], j = from.set.pairs.second[k];
      const std::uint32_t lower = particles.id[i] < particles.id[j] ? i : j;
      if (lower < own_) see(record_of(from.set, k, numbers()));
    }
}

void Part::for_each_bond(const std::function<void(const PairRecord&)>& see) const {
  for_each(bonds_, see);
  for (const PairRecord& bond : apart_) see(bond);
}

void Part::for_each_contact(const std::function<void(const PairRecord&)>& see) const {
  for_each(contacts_, see);
}

}  // namespace adit::lammps
