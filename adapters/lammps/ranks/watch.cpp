#include "adapters/lammps/ranks/watch.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <vector>

#include "adapters/lammps/ranks/orders.hpp"
#include "protocol/errors.hpp"
#include "protocol/log/log.hpp"

namespace adit::lammps {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::size_t kLongestPlace = 320;

std::array<char, kLongestPlace> own_place() {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  std::array<char, kLongestPlace> place{};
  fmt::format_to_n(place.data(), place.size() - 1, "process {} on {}", ::getpid(), host.data());
  return place;
}

}  // namespace

Watch::Watch(MPI_Comm ranks, std::function<void(const std::string& why)> fail) : fail_(std::move(fail)) {
  MPI_Comm_dup(ranks, &ranks_);
  MPI_Comm_rank(ranks_, &rank_);
  int count = 1;
  MPI_Comm_size(ranks_, &count);
  const auto place = own_place();
  std::vector<char> places(static_cast<std::size_t>(count) * kLongestPlace);
  MPI_Allgather(place.data(), kLongestPlace, MPI_CHAR, places.data(), kLongestPlace, MPI_CHAR, ranks_);
  for (int other = 0; other < count; ++other)
    if (other != rank_ && (rank_ == 0 || other == 0))
      others_.push_back({other, &places[static_cast<std::size_t>(other) * kLongestPlace], Clock::now()});
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

Watch::~Watch() {
  thread_.request_stop();
  thread_.join();
  MPI_Barrier(ranks_);
  hear();
  MPI_Comm_free(&ranks_);
}

void Watch::run(const std::stop_token& stop) {
  auto last = Clock::now();
  while (!stop.stop_requested()) {
    beat();
    std::this_thread::sleep_for(kBeat);
    hear();
    const auto now = Clock::now();
    // Who slept long itself has no right to complain: the whole run may have been suspended.
    if (now - last > 4 * kBeat)
      for (Other& other : others_) other.heard = now;
    last = now;
    for (const Other& other : others_) {
      if (now - other.heard < kSilence) continue;
      const std::string why =
          fmt::format("rank {} ({}) has given no sign of life for {} s", other.rank, other.place,
                      std::chrono::duration_cast<std::chrono::seconds>(kSilence).count());
      protocol::tell(protocol::Severity::kError, std::string(kProgram) + ": ", why);
      if (rank_ == 0) fail_(why);
      std::this_thread::sleep_for(kLastWords);
      std::_Exit(protocol::kPeerLost);
    }
  }
}

void Watch::beat() {
  for (const Other& other : others_) {
    MPI_Request sent;
    MPI_Isend(nullptr, 0, MPI_CHAR, other.rank, 0, ranks_, &sent);
    MPI_Request_free(&sent);
  }
}

void Watch::hear() {
  for (Other& other : others_)
    for (int waits = 0; MPI_Iprobe(other.rank, 0, ranks_, &waits, MPI_STATUS_IGNORE), waits;) {
      MPI_Recv(nullptr, 0, MPI_CHAR, other.rank, 0, ranks_, MPI_STATUS_IGNORE);
      other.heard = Clock::now();
    }
}

}  // namespace adit::lammps
