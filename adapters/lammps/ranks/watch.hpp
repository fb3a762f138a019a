// Signs of life between ranks, from threads that compute nothing: rank 0 hears each rank, and each hears rank
// 0.
//
// A rank that is killed takes all others along, by mpirun. One that is stopped, or whose machine is gone,
// does not: all others would wait for it in MPI for ever. Who misses a sign for kSilence names the rank and
// ends its process, and mpirun ends the rest.
#pragma once

#include <mpi.h>

#include <chrono>
#include <functional>
#include <string>
#include <thread>

namespace adit::lammps {

class Watch {
 public:
  static constexpr std::chrono::milliseconds kBeat{250}, kSilence{4000};
  // Time to tell the coupler of it.
  static constexpr std::chrono::milliseconds kLastWords{1500};

  // `fail`: called on rank 0 with the sentence that names the silent rank.
  Watch(MPI_Comm ranks, std::function<void(const std::string& why)> fail);
  // All ranks together: signs end.
  ~Watch();

 private:
  void run(const std::stop_token& stop);
  void beat();
  void hear();

  MPI_Comm ranks_;
  int rank_ = 0;
  std::function<void(const std::string&)> fail_;
  struct Other {
    int rank;
    std::string place;  // host and process
    std::chrono::steady_clock::time_point heard;
  };
  std::vector<Other> others_;
  std::jthread thread_;
};

}  // namespace adit::lammps
