#include "adapters/lammps/particles/pair_records.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <tuple>
#include <utility>

namespace adit::lammps {
namespace {

// The same pair, seen from its second particle.
PairRecord turned(PairRecord r) {
  std::swap(r.first, r.second);
  for (double* value : {&r.rest_x, &r.rest_y, &r.half_difference, &r.moment}) *value = -*value;
  return r;
}

// The pair's places, in ascending order, and its record as the lower place sees it.
struct Placed {
  std::uint32_t first, second;
  PairRecord record;
};

Placed placed(const PairRecord& r, const PlaceOf& place_of) {
  const std::uint32_t i = place_of(r.first), j = place_of(r.second);
  return i < j ? Placed{i, j, r} : Placed{j, i, turned(r)};
}

}  // namespace

void append(const PairRecord& record, std::vector<double>& to) {
  const auto values = std::bit_cast<std::array<double, kRecordValues>>(record);
  to.insert(to.end(), values.begin(), values.end());
}

PairRecord record_at(const double* values) {
  std::array<double, kRecordValues> of_record;
  std::copy_n(values, kRecordValues, of_record.begin());
  return std::bit_cast<PairRecord>(of_record);
}

PairRecord record_of(const PairSet& set, std::uint32_t k, const Numbers& numbers) {
  const dem::Pairs& p = set.pairs;
  const bool bonded = p.bonded(), dashpots = !p.normal_dashpot.empty();
  const auto of_bond = [&](const std::vector<double>& values) { return bonded ? values[k] : 0; };
  const auto of_dashpot = [&](const std::vector<double>& values) { return dashpots ? values[k] : 0; };
  const PairRecord r{.first = static_cast<double>(numbers[p.first[k]]),
                     .second = static_cast<double>(numbers[p.second[k]]),
                     .number = of_bond(set.number),
                     .law = static_cast<double>(p.law[k]),
                     .state = bonded ? static_cast<double>(p.state[k]) : 0,
                     .rest_x = p.rest_x[k],
                     .rest_y = p.rest_y[k],
                     .rest_length = p.rest_length[k],
                     .half_difference = p.half_difference[k],
                     .slack = p.slack[k],
                     .width = of_bond(p.width),
                     .weight = p.weight[k],
                     .initial = of_bond(p.initial),
                     .slide = p.slide[k],
                     .shear = of_bond(p.shear),
                     .moment = of_bond(p.moment),
                     .normal_dashpot = of_dashpot(p.normal_dashpot),
                     .shear_dashpot = of_dashpot(p.shear_dashpot)};
  return r.first < r.second ? r : turned(r);
}

PairSet set_of(const std::vector<PairRecord>& records, const PlaceOf& place_of, std::size_t places,
               PairKind kind) {
  std::vector<Placed> all;
  all.reserve(records.size());
  for (const PairRecord& record : records) all.push_back(placed(record, place_of));
  std::ranges::sort(all, {}, [](const Placed& p) { return std::tie(p.first, p.second); });

  PairSet set;
  dem::Pairs& p = set.pairs;
  for (const Placed& pair : all) {
    p.first.push_back(pair.first);
    p.second.push_back(pair.second);
  }
  p.finish(places, kind.bonded, kind.dashpots);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const PairRecord& r = all[k].record;
    p.law[k] = static_cast<std::uint32_t>(r.law);
    p.rest_x[k] = r.rest_x;
    p.rest_y[k] = r.rest_y;
    p.rest_length[k] = r.rest_length;
    p.half_difference[k] = r.half_difference;
    p.slack[k] = r.slack;
    p.weight[k] = r.weight;
    p.slide[k] = r.slide;
    if (kind.dashpots) {
      p.normal_dashpot[k] = r.normal_dashpot;
      p.shear_dashpot[k] = r.shear_dashpot;
    }
    if (!kind.bonded) continue;
    set.number.push_back(r.number);
    p.width[k] = r.width;
    p.initial[k] = r.initial;
    p.shear[k] = r.shear;
    p.moment[k] = r.moment;
    p.state[k] = static_cast<dem::BondState>(r.state);
  }
  p.sort_chunks(kind.laws);
  return set;
}

bool ascends(const PairRecord& a, const PairRecord& b) {
  return std::tie(a.first, a.second) < std::tie(b.first, b.second);
}

void sort(std::vector<PairRecord>& records) {
  std::ranges::sort(records, ascends);
  const auto same = [](const PairRecord& a, const PairRecord& b) {
    return a.first == b.first && a.second == b.second;
  };
  records.erase(std::unique(records.begin(), records.end(), same), records.end());
}

}  // namespace adit::lammps
