// LAMMPS as the particles of a run, under MPI: mpirun -np 2 adit_lammps --help
#include <mpi.h>

#include <csignal>
#include <cstdio>
#include <memory>
#include <thread>

#include "adapters/lammps/computed.hpp"
#include "adapters/lammps/rank.hpp"
#include "adapters/lammps/ranks/orders.hpp"
#include "adapters/lammps/ranks/watch.hpp"
#include "dem_server/participant/participant.hpp"
#include "protocol/errors.hpp"
#include "protocol/server/server.hpp"

namespace {

using namespace adit;

// Of each run, when it begins.
std::unique_ptr<protocol::Participant> participant(lammps::Orders& orders) {
  return std::make_unique<dem::DemParticipant>(std::make_unique<lammps::LammpsEngines>(orders));
}

int converse(int argc, char** argv, lammps::Orders& orders) {
  const int code = protocol::server_main(
      argc, argv, lammps::kProgram, lammps::computed(), [&orders] { return participant(orders); }, nullptr,
      protocol::kPatienceOfServers, false);
  orders.give(lammps::Order::kQuit);
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  int support = MPI_THREAD_SINGLE, code = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_MULTIPLE, &support);
  if (support != MPI_THREAD_MULTIPLE) {
    std::fputs(
        "lammps: this MPI does not let several threads call it (MPI_THREAD_MULTIPLE); use one that does\n",
        stderr);
    MPI_Abort(MPI_COMM_WORLD, protocol::kUserError);
  }
  {
    lammps::Orders orders(MPI_COMM_WORLD);
    lammps::Watch watch(MPI_COMM_WORLD, [&orders](const std::string& why) { orders.fail(why); });
    lammps::Rank rank(MPI_COMM_WORLD);
    std::thread conversation;
    if (orders.rank() == 0)
      conversation = std::thread([&] { code = converse(argc, argv, orders); });
    else
      for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_IGN);  // rank 0 says when to end
    orders.obey_until_quit(
        [&rank](lammps::Order order, std::span<const double> v) { return rank.obey(order, v); });
    if (conversation.joinable()) conversation.join();
  }
  MPI_Finalize();
  return code;
}
