// A pair of particles by their numbers in the whole model, as it travels between ranks; and the pairs of a
// rank by the places of its own particles.
//
// A pair of two ranks is computed by both, from the same bits and so to the same bits: forces, history and
// the step in which it breaks agree without a word between them.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "dem_server/engines/general/pairs/pairs.hpp"

namespace adit::lammps {

// Every value is a double, because LAMMPS moves doubles. The first particle has the lower number.
struct PairRecord {
  double first, second;
  double number = 0;  // of a bond in the whole model
  double law = 0, state = 0;
  // dem::Pairs has the units.
  double rest_x = 0, rest_y = 0, rest_length = 0, half_difference = 0, slack = 0, width = 0, weight = 0;
  double initial = 0;
  double slide = 0, shear = 0, moment = 0, normal_dashpot = 0, shear_dashpot = 0;  // history
};
inline constexpr std::size_t kRecordValues = sizeof(PairRecord) / sizeof(double);

// Its values, one after another.
void append(const PairRecord& record, std::vector<double>& to);
PairRecord record_at(const double* values);

struct PairSet {
  dem::Pairs pairs;
  std::vector<double> number;  // of bonds
};

// Numbers in the whole model of the particles at a rank's places.
using Numbers = std::vector<std::uint32_t>;
// The place of a particle of this number.
using PlaceOf = std::function<std::uint32_t(double number)>;

PairRecord record_of(const PairSet& set, std::uint32_t pair, const Numbers& numbers);

struct PairKind {
  bool bonded, dashpots;
  std::span<const dem::PairLaw> laws;  // of bonds
};
// `places`: of a rank, ghosts too. All particles of the records have one.
PairSet set_of(const std::vector<PairRecord>& records, const PlaceOf& place_of, std::size_t places,
               PairKind kind);

// By their particles; a pair that is there twice, once.
void sort(std::vector<PairRecord>& records);
bool ascends(const PairRecord& a, const PairRecord& b);

}  // namespace adit::lammps
