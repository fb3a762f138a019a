// What rank 0 asks all ranks to do: one order at a time, answered by each.
//
// The conversation with the coupler has a thread of its own on rank 0, which gives the orders; the main
// thread of each rank obeys them. So the conversation can tell which rank has failed while MPI waits for it.
#pragma once

#include <mpi.h>

#include <array>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace adit::lammps {

inline constexpr const char* kProgram = "lammps";  // as this participant calls itself

enum class Order : int {
  kBegin,         // a model: box, reach, laws
  kParticles,     // columns of some particles
  kBalance,       // all particles are known
  kBonds,         // records of some bonds
  kContacts,      // records of some contacts
  kConditions,    // loads and motions
  kStart,         // all is known
  kTie,           // numbers of the tied particles
  kCorrect,       // velocities of the tied particles
  kRemember,      // velocities, for the kinetic energy
  kStep,          // velocities of the tied particles, where they were corrected; one step
  kEnergies,      // since the start
  kTellMotion,    // of each particle
  kTellBonds,     // history of each bond
  kTellContacts,  // the same, of those that are listed
  kQuit
};

using Values = std::vector<double>;

// A rank that waits sleeps soon: the rest of the run may need its core, and who sleeps is woken before those
// that spin. It wakes late by a small part of the time that it waited, and an idle server leaves cores alone.
void wait(MPI_Request& request);

class Orders {
 public:
  explicit Orders(MPI_Comm ranks);

  int rank() const { return rank_; }
  int ranks() const { return ranks_; }
  MPI_Comm communicator() const { return communicator_; }

  // The conversation's thread: returns the answers of all ranks, in their order. Throws std::runtime_error
  // where fail() was called.
  std::vector<Values> give(Order order, Values values = {});
  // Any thread of rank 0: ranks no longer answer.
  void fail(const std::string& why);

  // The main thread of every rank: obeys until kQuit.
  using Obey = std::function<Values(Order order, std::span<const double> values)>;
  void obey_until_quit(const Obey& obey);

 private:
  struct Given {
    Order order;
    Values values;
  };
  // What most orders and answers need is one message, so that ranks wait for one another once. Others send
  // the rest after it.
  static constexpr std::size_t kFrame = 128, kHead = 2, kFirst = kFrame - kHead;
  using Frame = std::array<double, kFrame>;

  Given next();
  Values whole(const Frame& frame, std::size_t rank);
  void broadcast(double* values, std::size_t count);
  void answer(const Values& values);

  MPI_Comm communicator_;
  int rank_ = 0, ranks_ = 1;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Given> given_;                  // not begun
  std::optional<std::vector<Values>> answers_;  // complete
  std::string failure_;
};

}  // namespace adit::lammps
