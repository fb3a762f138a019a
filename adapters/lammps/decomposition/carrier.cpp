#include "adapters/lammps/decomposition/carrier.hpp"

#include <algorithm>
#include <array>

namespace adit::lammps {
namespace {

// What a step changes of a particle.
std::array<std::vector<double>*, 5> motion_of(dem::Particles& p) {
  return {&p.ux, &p.uy, &p.vx, &p.vy, &p.spin};
}

template <class Columns>
int pack(const Columns& columns, int count, const int* places, double* out) {
  double* at = out;
  for (int k = 0; k < count; ++k)
    for (const auto* column : columns) *at++ = (*column)[static_cast<std::size_t>(places[k])];
  return static_cast<int>(at - out);
}

template <class Columns>
int unpack(const Columns& columns, int count, int first, const double* in) {
  const double* at = in;
  for (int k = 0; k < count; ++k)
    for (auto* column : columns) (*column)[static_cast<std::size_t>(first + k)] = *at++;
  return static_cast<int>(at - in);
}

// A list of records: their number, then their values.
double* pack(const std::vector<PairRecord>& records, double* out) {
  std::vector<double> values{static_cast<double>(records.size())};
  for (const PairRecord& record : records) append(record, values);
  return std::ranges::copy(values, out).out;
}

const double* unpack(const double* in, std::vector<PairRecord>& records) {
  const auto count = static_cast<std::size_t>(*in++);
  for (std::size_t k = 0; k < count; ++k, in += kRecordValues) records.push_back(record_at(in));
  return in;
}

LAMMPS_NS::Fix* make(LAMMPS_NS::LAMMPS* lammps, int count, char** words) {
  return new Carrier(lammps, count, words);
}

}  // namespace

void Carrier::add_style(LAMMPS_NS::LAMMPS& lammps) {
  (*lammps.modify->fix_map)[kStyle] = &make;
}

Carrier::Carrier(LAMMPS_NS::LAMMPS* lammps, int count, char** words) : Fix(lammps, count, words) {
  maxexchange_dynamic = 1;
  comm_border = static_cast<int>(Part::kColumns);
  comm_forward = 5;
  make_room(0);
  // LAMMPS takes the fix that is being made for the one that is called back.
  for (const int callback : {LAMMPS_NS::Atom::GROW, LAMMPS_NS::Atom::BORDER}) atom->add_callback(callback);
}

Carrier::~Carrier() {
  for (const int callback : {LAMMPS_NS::Atom::GROW, LAMMPS_NS::Atom::BORDER})
    atom->delete_callback(id, callback);
}

void Carrier::make_room(std::size_t most_pairs) {
  maxexchange = static_cast<int>(Part::kColumns + 2 + most_pairs * kRecordValues);
}

void Carrier::carry(Part& part) {
  part_ = &part;
  grow_arrays(atom->nmax);
}

void Carrier::grow_arrays(int room) {
  part_->resize(static_cast<std::size_t>(room));
}

void Carrier::copy_arrays(int from, int to, int) {
  part_->copy(static_cast<std::size_t>(from), static_cast<std::size_t>(to));
}

int Carrier::pack_exchange(int place, double* out) {
  double* at = out + pack(part_->columns(), 1, &place, out);
  at = pack(part_->bonds_of(static_cast<std::size_t>(place)), at);
  at = pack(part_->contacts_of(static_cast<std::size_t>(place)), at);
  return static_cast<int>(at - out);
}

int Carrier::unpack_exchange(int place, double* in) {
  const double* at = in + unpack(part_->columns(), 1, place, in);
  std::vector<PairRecord> bonds, contacts;
  at = unpack(at, bonds);
  at = unpack(at, contacts);
  part_->arrive(static_cast<std::size_t>(place), std::move(bonds), std::move(contacts));
  return static_cast<int>(at - in);
}

int Carrier::pack_border(int count, int* places, double* out) {
  return pack(part_->columns(), count, places, out);
}

int Carrier::unpack_border(int count, int first, double* in) {
  return unpack(part_->columns(), count, first, in);
}

int Carrier::pack_forward_comm(int count, int* places, double* out, int, int*) {
  return pack(motion_of(part_->particles), count, places, out);
}

void Carrier::unpack_forward_comm(int count, int first, double* in) {
  unpack(motion_of(part_->particles), count, first, in);
}

}  // namespace adit::lammps
