#include "adapters/lammps/ranks/orders.hpp"

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <utility>

namespace adit::lammps {

void wait(MPI_Request& request) {
  using Clock = std::chrono::steady_clock;
  constexpr Clock::duration kPatience = std::chrono::microseconds(20),
                            kLongestNap = std::chrono::milliseconds(1);
  constexpr int kNaps = 64;  // in the time waited so far
  const auto begin = Clock::now();
  for (int done = 0; MPI_Test(&request, &done, MPI_STATUS_IGNORE), !done;)
    if (const auto waited = Clock::now() - begin; waited > kPatience)
      std::this_thread::sleep_for(std::min(waited / kNaps, kLongestNap));
}

Orders::Orders(MPI_Comm ranks) : communicator_(ranks) {
  MPI_Comm_rank(ranks, &rank_);
  MPI_Comm_size(ranks, &ranks_);
}

std::vector<Values> Orders::give(Order order, Values values) {
  std::unique_lock lock(mutex_);
  given_ = Given{order, std::move(values)};
  changed_.notify_all();
  changed_.wait(lock, [this] { return answers_ || !failure_.empty(); });
  if (!failure_.empty()) throw std::runtime_error(failure_);
  return std::exchange(answers_, std::nullopt).value();
}

void Orders::fail(const std::string& why) {
  const std::lock_guard lock(mutex_);
  failure_ = why;
  changed_.notify_all();
}

void Orders::broadcast(double* values, std::size_t count) {
  MPI_Request request;
  MPI_Ibcast(values, static_cast<int>(count), MPI_DOUBLE, 0, communicator_, &request);
  wait(request);
}

Orders::Given Orders::next() {
  Given given{};
  Frame frame{};
  if (rank_ == 0) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return given_.has_value(); });
    given = std::exchange(given_, std::nullopt).value();
    frame = {static_cast<double>(given.order), static_cast<double>(given.values.size())};
    std::copy_n(given.values.begin(), std::min(given.values.size(), kFirst), frame.begin() + kHead);
  }
  broadcast(frame.data(), frame.size());
  given.order = static_cast<Order>(frame[0]);
  const auto count = static_cast<std::size_t>(frame[1]), first = std::min(count, kFirst);
  given.values.resize(count);
  std::copy_n(frame.begin() + kHead, first, given.values.begin());
  if (count > first) broadcast(&given.values[first], count - first);
  return given;
}

void Orders::answer(const Values& values) {
  Frame frame{static_cast<double>(values.size())};
  const std::size_t first = std::min(values.size(), kFirst);
  std::copy_n(values.begin(), first, frame.begin() + kHead);
  std::vector<Frame> frames(rank_ == 0 ? static_cast<std::size_t>(ranks_) : 0);
  MPI_Request request;
  MPI_Igather(frame.data(), kFrame, MPI_DOUBLE, frames.data(), kFrame, MPI_DOUBLE, 0, communicator_,
              &request);
  wait(request);
  if (rank_ != 0) {
    if (values.size() > first)
      MPI_Send(&values[first], static_cast<int>(values.size() - first), MPI_DOUBLE, 0, 0, communicator_);
    return;
  }
  std::vector<Values> answers{values};
  for (std::size_t rank = 1; rank < frames.size(); ++rank) answers.push_back(whole(frames[rank], rank));
  const std::lock_guard lock(mutex_);
  answers_ = std::move(answers);
  changed_.notify_all();
}

Values Orders::whole(const Frame& frame, std::size_t rank) {
  Values values(static_cast<std::size_t>(frame[0]));
  const std::size_t first = std::min(values.size(), kFirst);
  std::copy_n(frame.begin() + kHead, first, values.begin());
  if (values.size() > first)
    MPI_Recv(&values[first], static_cast<int>(values.size() - first), MPI_DOUBLE, static_cast<int>(rank), 0,
             communicator_, MPI_STATUS_IGNORE);
  return values;
}

void Orders::obey_until_quit(const Obey& obey) {
  for (Given given = next(); given.order != Order::kQuit; given = next())
    answer(obey(given.order, given.values));
  answer({});
}

}  // namespace adit::lammps
