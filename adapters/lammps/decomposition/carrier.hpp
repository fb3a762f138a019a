// The fix by which LAMMPS carries particles with their values and pairs from rank to rank, and shows ghosts
// to those beside: `fix ID all adit/particles`.
#pragma once

#include "adapters/lammps/decomposition/headers.hpp"
#include "adapters/lammps/particles/part.hpp"

namespace adit::lammps {

class Carrier final : public LAMMPS_NS::Fix {
 public:
  static constexpr const char* kStyle = "adit/particles";
  // LAMMPS makes fixes of this style from here on.
  static void add_style(LAMMPS_NS::LAMMPS& lammps);

  Carrier(LAMMPS_NS::LAMMPS* lammps, int count, char** words);
  ~Carrier() override;
  void carry(Part& part);
  // The pairs that a particle takes along are at most so many, on any rank.
  void make_room(std::size_t most_pairs);

 private:
  int setmask() override { return 0; }
  void grow_arrays(int room) override;
  void copy_arrays(int from, int to, int) override;
  int pack_exchange(int place, double* out) override;
  int unpack_exchange(int place, double* in) override;
  int pack_border(int count, int* places, double* out) override;
  int unpack_border(int count, int first, double* in) override;
  int pack_forward_comm(int count, int* places, double* out, int, int*) override;
  void unpack_forward_comm(int count, int first, double* in) override;

  Part* part_ = nullptr;
};

}  // namespace adit::lammps
