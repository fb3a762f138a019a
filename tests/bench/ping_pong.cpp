// Measures the round trip of the bare machine: two processes exchange BYTES over loopback TCP with plain
// sockets, TCP_NODELAY and one write for each message. Prints the median round trip in microseconds for a
// reader that blocks and for one that spins, yielding its core between two looks.
//
//   ping_pong BYTES_THERE BYTES_BACK ROUNDS
#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sched.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <vector>

namespace {

enum class Wait { kBlock, kSpin };

void require(bool success, const char* what) {
  if (!success) throw std::runtime_error(what);
}

void set_no_delay(int socket) {
  const int on = 1;
  require(setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on) == 0, "setsockopt");
}

void read_all(int socket, std::vector<char>& buffer, Wait wait) {
  std::size_t done = 0;
  while (done < buffer.size()) {
    const auto got =
        recv(socket, buffer.data() + done, buffer.size() - done, wait == Wait::kSpin ? MSG_DONTWAIT : 0);
    if (got > 0)
      done += static_cast<std::size_t>(got);
    else if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK))
      sched_yield();
    else
      _exit(0);  // the other end is done
  }
}

void write_all(int socket, const std::vector<char>& buffer) {
  std::size_t done = 0;
  while (done < buffer.size()) {
    const auto sent = send(socket, buffer.data() + done, buffer.size() - done, MSG_NOSIGNAL);
    require(sent > 0, "send");
    done += static_cast<std::size_t>(sent);
  }
}

double median_round_trip(std::size_t there, std::size_t back, int rounds, Wait wait) {
  const int listener = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t length = sizeof address;
  require(bind(listener, reinterpret_cast<sockaddr*>(&address), length) == 0 && listen(listener, 1) == 0 &&
              getsockname(listener, reinterpret_cast<sockaddr*>(&address), &length) == 0,
          "listen");
  std::vector<char> question(there), answer(back);
  const pid_t child = fork();
  require(child >= 0, "fork");
  if (child == 0) {
    const int socket = accept(listener, nullptr, nullptr);
    set_no_delay(socket);
    for (;;) {
      read_all(socket, question, wait);
      write_all(socket, answer);
    }
  }
  const int client = socket(AF_INET, SOCK_STREAM, 0);
  require(connect(client, reinterpret_cast<sockaddr*>(&address), length) == 0, "connect");
  set_no_delay(client);
  std::vector<double> times;
  for (int i = 0; i < rounds; ++i) {
    const auto start = std::chrono::steady_clock::now();
    write_all(client, question);
    read_all(client, answer, wait);
    times.push_back(
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count());
  }
  close(client);
  close(listener);
  waitpid(child, nullptr, 0);
  std::nth_element(times.begin(), times.begin() + rounds / 2, times.end());
  return times[rounds / 2];
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fputs("usage: ping_pong BYTES_THERE BYTES_BACK ROUNDS\n", stderr);
    return 2;
  }
  const auto there = static_cast<std::size_t>(std::atoll(argv[1]));
  const auto back = static_cast<std::size_t>(std::atoll(argv[2]));
  const int rounds = std::atoi(argv[3]);
  for (const Wait wait : {Wait::kBlock, Wait::kSpin})
    std::printf("%s %.3f\n", wait == Wait::kBlock ? "blocking" : "spinning",
                median_round_trip(there, back, rounds, wait));
}
