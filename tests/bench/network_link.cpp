// Two machines on one: a network namespace `near` and one `far`, and a link between them that is as slow,
// unsteady, lossy and narrow as asked. It carries the packets that the kernel's own TCP sends, so that losses
// are made good as they are between machines. Many kernels have netem for this; this needs /dev/net/tun and
// user namespaces only.
//
//   unshare --user --map-root-user --net network_link DELAY JITTER LOSS RATE
//
// DELAY: of each way [ms]; JITTER: up to so much more, each packet its own, in order [ms]; LOSS: share of the
// packets that vanish; RATE: of each way [Mbit/s], 0 without a cap. Prints the process ids whose namespaces
// are `near` (10.77.0.1) and `far` (10.77.0.2). At the end of its standard input it prints, for the way there
// and the way back, the bytes that TCP carried and the packets that held them, and ends.
#include <arpa/inet.h>
#include <fcntl.h>
#include <linux/if_tun.h>
#include <net/if.h>
#include <poll.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;
using Packet = std::vector<std::uint8_t>;

constexpr std::size_t kLongestPacket = 2048, kLongestQueue = 1000;  // bytes; packets, as netem has them

void require(bool success, const char* what) {
  if (!success) throw std::runtime_error(std::string(what) + ": " + std::strerror(errno));
}

struct Quality {
  std::chrono::duration<double, std::milli> delay, jitter;
  double loss;
  double bytes_per_s;  // 0: no cap
};

// What is on its way from one end to the other.
class Way {
 public:
  Way(const Quality& quality, std::uint32_t seed) : quality_(quality), random_(seed) {}

  void enter(Packet packet) {
    count(packet);
    std::uniform_real_distribution<double> share;
    if (waiting_.size() >= kLongestQueue || share(random_) < quality_.loss) return;
    sent_ = std::max(sent_, Clock::now());
    if (quality_.bytes_per_s > 0)
      sent_ +=
          in_clock(std::chrono::duration<double>(static_cast<double>(packet.size()) / quality_.bytes_per_s));
    arrived_ = std::max(arrived_, sent_ + in_clock(quality_.delay + share(random_) * quality_.jitter));
    waiting_.push_back({arrived_, std::move(packet)});
  }

  std::optional<Clock::time_point> next() const {
    return waiting_.empty() ? std::nullopt : std::optional(waiting_.front().due);
  }

  void leave_to(int end) {
    for (; !waiting_.empty() && waiting_.front().due <= Clock::now(); waiting_.pop_front())
      // An end that takes no more loses the packet, as a full network card does.
      std::ignore = write(end, waiting_.front().packet.data(), waiting_.front().packet.size());
  }

  void tell(const char* name) const { std::printf("%s %lu %lu\n", name, bytes_, packets_); }

 private:
  struct Waiting {
    Clock::time_point due;
    Packet packet;
  };

  static Clock::duration in_clock(std::chrono::duration<double> time) {
    return std::chrono::duration_cast<Clock::duration>(time);
  }

  // IPv4 and TCP headers say their own lengths in words of 4 bytes.
  void count(const Packet& packet) {
    if (packet.size() < 40 || packet[0] >> 4 != 4 || packet[9] != IPPROTO_TCP) return;
    const std::size_t network = 4UL * (packet[0] & 15U);
    if (packet.size() < network + 20) return;
    const std::size_t headers = network + 4UL * (packet[network + 12] >> 4U);
    if (packet.size() <= headers) return;
    bytes_ += packet.size() - headers;
    ++packets_;
  }

  Quality quality_;
  std::mt19937 random_;
  Clock::time_point sent_{}, arrived_{};
  std::deque<Waiting> waiting_;
  std::uint64_t bytes_ = 0, packets_ = 0;
};

// The end of the link in the namespace of this process.
int make_end(const char* address) {
  const int end = open("/dev/net/tun", O_RDWR | O_NONBLOCK | O_CLOEXEC);
  require(end >= 0, "/dev/net/tun");
  ifreq request{};
  std::strncpy(request.ifr_name, "link", IFNAMSIZ - 1);
  request.ifr_flags = IFF_TUN | IFF_NO_PI;
  require(ioctl(end, TUNSETIFF, &request) == 0, "TUNSETIFF");

  const int control = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  require(control >= 0, "socket");
  const auto set = [&](unsigned long what, const char* text) {
    sockaddr_in value{};
    value.sin_family = AF_INET;
    require(inet_pton(AF_INET, text, &value.sin_addr) == 1, text);
    std::memcpy(&request.ifr_addr, &value, sizeof value);
    require(ioctl(control, what, &request) == 0, text);
  };
  set(SIOCSIFADDR, address);
  set(SIOCSIFNETMASK, "255.255.255.0");
  for (const char* name : {"link", "lo"}) {
    std::strncpy(request.ifr_name, name, IFNAMSIZ - 1);
    request.ifr_flags = IFF_UP | IFF_RUNNING;
    require(ioctl(control, SIOCSIFFLAGS, &request) == 0, "SIOCSIFFLAGS");
  }
  close(control);
  return end;
}

// A process that holds the present namespace until this one ends.
pid_t hold_namespace() {
  const pid_t holder = fork();
  require(holder >= 0, "fork");
  if (holder > 0) return holder;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (;;) pause();
}

bool read_packets(int end, Way& way) {
  std::array<std::uint8_t, kLongestPacket> bytes{};
  for (ssize_t length = 0; (length = read(end, bytes.data(), bytes.size())) > 0;)
    way.enter(Packet(bytes.begin(), bytes.begin() + length));
  return errno == EAGAIN;
}

void carry(int near, int far, Way& there, Way& back) {
  for (;;) {
    std::optional<Clock::time_point> due = there.next();
    if (const auto other = back.next(); other && (!due || *other < *due)) due = other;
    timespec wait{};
    if (due) {
      const auto left = std::max<long>(0, std::chrono::nanoseconds(*due - Clock::now()).count());
      wait = {left / 1'000'000'000, left % 1'000'000'000};
    }
    std::array<pollfd, 3> ends{{{near, POLLIN, 0}, {far, POLLIN, 0}, {STDIN_FILENO, POLLIN, 0}}};
    require(ppoll(ends.data(), ends.size(), due ? &wait : nullptr, nullptr) >= 0, "ppoll");
    if (ends[2].revents != 0) return;
    require(read_packets(near, there) && read_packets(far, back), "read");
    there.leave_to(far);
    back.leave_to(near);
  }
}

void run(char** arguments) {
  const auto number = [&](int i) { return std::atof(arguments[i]); };
  using Milliseconds = std::chrono::duration<double, std::milli>;
  const Quality quality{Milliseconds(number(1)), Milliseconds(number(2)), number(3), number(4) * 1e6 / 8};

  prctl(PR_SET_TIMERSLACK, 1UL);  // [ns]: a delay of 0.05 ms must not become 0.1 ms
  const int near = make_end("10.77.0.1");
  const pid_t holder = hold_namespace();
  require(unshare(CLONE_NEWNET) == 0, "unshare");
  const int far = make_end("10.77.0.2");
  std::printf("near %d far %d\n", holder, getpid());
  std::fflush(stdout);

  Way there(quality, 1), back(quality, 2);
  carry(near, far, there, back);
  there.tell("there");
  back.tell("back");
  kill(holder, SIGKILL);
  waitpid(holder, nullptr, 0);
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 5) {
    std::fputs("usage: network_link DELAY JITTER LOSS RATE\n", stderr);
    return 2;
  }
  try {
    run(arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "network_link: %s\n", error.what());
    return 1;
  }
}
