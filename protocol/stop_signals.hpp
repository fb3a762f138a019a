// SIGINT, SIGTERM and SIGHUP end a run at its next step, with what it has computed until then. A second
// signal ends the program at once.
#pragma once

namespace adit::protocol {

// While an object of this class exists, the first signal is only noted. One that the program was started to
// ignore, as by nohup, stays ignored.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;
};

// A signal was noted.
bool stop_requested();

// To be called between two steps: throws Stopped, "ended by SIGTERM", once a signal was noted.
void end_if_stopped();

}  // namespace adit::protocol
