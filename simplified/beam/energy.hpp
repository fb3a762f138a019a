// The energies of a run [J], counted from the static state at its beginning.
#pragma once

namespace adit::simplified::beam {

struct Energy {
  double kinetic = 0;
  double strain = 0;     // stored in the lining
  double soil = 0;       // stored in the soil springs
  double joints = 0;     // stored in gaskets, cables and keys, less the work of the water pressure on them
  double slip = 0;       // dissipated in the soil springs
  double weakening = 0;  // lost by the soil springs as the ground liquefies
  double dashpots = 0;   // dissipated in the dashpots
  double loads = 0;      // work of the static loads and of the uplift
  double input = 0;      // work of the moving ground

  double error() const {
    return kinetic + strain + soil + joints + slip + weakening + dashpots - loads - input;
  }
};

}  // namespace adit::simplified::beam
