// The ways in which a run ends without being our bug.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace adit::protocol {

// Exit codes of every program. A run that a signal ended has 128 and the signal's number, as shells know it.
enum ExitCode : int {
  kSuccess = 0,
  kInternalError = 1,
  kUserError = 2,
  kPeerLost = 3,
  kUnstable = 4,
  kDiskFull = 5,
  kSignalled = 128
};

// The user's input cannot be computed. `path` names the scene field (`particles.loads[0].where`), empty
// where none is to blame; the message says what is wrong, what was expected and what to do.
class UserError : public std::runtime_error {
 public:
  UserError(std::string path, const std::string& message)
      : std::runtime_error(message), path_(std::move(path)) {}
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

// Throws UserError unless it holds.
inline void require(bool holds, const std::string& path, const std::string& message) {
  if (!holds) throw UserError(path, message);
}

// The other end is gone, silent or unintelligible. `peer` names it.
class PeerLost : public std::runtime_error {
 public:
  PeerLost(std::string peer, const std::string& message)
      : std::runtime_error(peer + ": " + message), peer_(std::move(peer)) {}
  const std::string& peer() const { return peer_; }

 private:
  std::string peer_;
};

// The other end asked for what the conversation does not allow, or for what contradicts an earlier request
// (wire.proto): its bug. The message says what came and what was expected.
class RequestError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

// A value that must be finite is not, or energy grows without cause: the step, the place and the value.
class Unstable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// No more can be written. The message names the file.
class DiskFull : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A signal asked the run to end (stop_signals.hpp).
class Stopped : public std::runtime_error {
 public:
  Stopped(int signal, const std::string& message) : std::runtime_error(message), signal_(signal) {}
  int signal() const { return signal_; }

 private:
  int signal_;
};

}  // namespace adit::protocol
