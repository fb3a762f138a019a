// All deadlines and sizes that bound a conversation. docs/reliability.md, section Bounds, lists them with
// what happens beyond each; a test compares that table with this header.
#pragma once

#include <chrono>
#include <cstdint>

namespace adit::protocol {

// The deadlines of one end of a connection.
struct Patience {
  std::chrono::milliseconds silence = std::chrono::seconds(8);  // longest time without a byte from the peer
  std::chrono::milliseconds answer = std::chrono::minutes(10);  // longest wait for one frame of a step
  std::chrono::milliseconds connect = std::chrono::seconds(5);  // for connecting, and for each greeting
  std::chrono::milliseconds heartbeat =
      std::chrono::seconds(1);  // longest time in which this end sends nothing
  // While models are built the wait is long, because a packing may take hours: the peer must beat meanwhile.
  std::chrono::milliseconds set_up = std::chrono::hours(24);
  std::chrono::milliseconds first_request = std::chrono::seconds(10);  // of a server, from hello to setup
  // From the first to the last byte of a frame that arrives, with a second more for each kLeastRate of bytes.
  std::chrono::milliseconds frame = std::chrono::seconds(10);
  std::chrono::milliseconds farewell =
      std::chrono::seconds(2);  // for the peer to read the last frame and close
};

inline constexpr std::uint64_t kLeastRate = 256u << 10;  // [bytes/s]

// The coupler may itself wait for another participant. A server waits longer than the coupler, so that the
// error names that participant and not the coupler.
inline constexpr Patience kPatienceOfServers{.answer = std::chrono::hours(1),
                                             .set_up = std::chrono::hours(25)};

// Processes: a server that the coupler starts must listen within kStartPatience. Told to end, a server takes
// at most kLastOrders, and the coupler kills it after kStopPatience.
inline constexpr std::chrono::seconds kStartPatience{10};
inline constexpr std::chrono::seconds kLastOrders{2};
inline constexpr std::chrono::seconds kStopPatience{3};

// The longest frame accepted in each phase.
inline constexpr std::uint64_t kMaxFrameBytes = 1024u << 20;  // of all, as announced in hello
inline constexpr std::uint64_t kMaxHelloBytes = 64u << 10;    // before hello has arrived
inline constexpr std::uint64_t kMaxPartBytes = 16u << 20;     // between ends that read messages in parts
inline constexpr std::uint64_t kMaxProgressBytes = 200;       // what a heartbeat says
// Such ends send longer messages in parts, with so many bytes of a list in each.
inline constexpr std::uint64_t kPartBytes = 8u << 20;

// The longest message of each kind, all of its parts together.
inline constexpr std::uint64_t kMaxAttachedBytes = 500u << 20;  // files of a scene, together
inline constexpr std::uint64_t kMaxSetupBytes = kMaxAttachedBytes + (32u << 20);
// In a run: what is known of sizes (a weight for each sample, an impulse for each coupling point), but this
// at least.
inline constexpr std::uint64_t kMaxRunBytes = 16u << 20;
// A model tells its sample points, which are the measure of what follows: the bytes for each of them, beside
// kMaxRunBytes.
inline constexpr std::uint64_t kMaxModelBytes = 4096ull << 20;
inline constexpr std::uint64_t kInterfaceBytes = 64;
inline constexpr std::uint64_t kSnapshotBytes = 1024;
inline constexpr std::uint64_t kStateBytes = 2048;
// Of a condensed model: the lower triangles of two matrices over x and y of its masters.
constexpr std::uint64_t condensed_bytes(std::uint64_t masters) {
  return 16 * masters * (2 * masters + 3);
}
constexpr std::uint64_t most_state_bytes(std::uint64_t samples) {
  return kMaxRunBytes + kStateBytes * samples;
}

// The memory that a message may take once it is parsed: so many times its length, and so many bytes more.
inline constexpr std::uint64_t kMaxParsedFactor = 2;
inline constexpr std::uint64_t kMaxParsedBytes = 128u << 20;
constexpr std::uint64_t most_parsed_bytes(std::uint64_t length) {
  return kMaxParsedFactor * length + kMaxParsedBytes;
}

}  // namespace adit::protocol
