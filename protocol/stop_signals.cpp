#include "protocol/stop_signals.hpp"

#include <array>
#include <csignal>
#include <string>

#include "protocol/errors.hpp"

namespace adit::protocol {
namespace {

constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};
volatile std::sig_atomic_t noted = 0;

void let_go() {
  for (const int signal : kSignals) {
    struct sigaction now {};
    sigaction(signal, nullptr, &now);
    if (now.sa_handler != SIG_IGN) std::signal(signal, SIG_DFL);
  }
}

// Calls only what a handler may call.
void note(int signal) {
  noted = signal;
  let_go();
}

std::string name_of(int signal) {
  return signal == SIGINT ? "SIGINT" : signal == SIGTERM ? "SIGTERM" : "SIGHUP";
}

}  // namespace

StopSignals::StopSignals() {
  noted = 0;
  struct sigaction handler {};
  handler.sa_handler = note;
  handler.sa_flags = SA_RESTART;
  for (const int signal : kSignals) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(signal, &handler, nullptr);
  }
}

StopSignals::~StopSignals() {
  let_go();
}

bool stop_requested() {
  return noted != 0;
}

void end_if_stopped() {
  if (noted != 0) throw Stopped(noted, "ended by " + name_of(noted));
}

}  // namespace adit::protocol
