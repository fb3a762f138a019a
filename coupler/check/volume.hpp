// The size of a run's results, and of what is held for them.
#pragma once

#include <vector>

#include "coupler/output/schedule.hpp"
#include "coupler/participants/set_up.hpp"

namespace adit::coupler {

struct Volume {
  double field_bytes = 0;              // of the fields at one time, as files
  double field_seconds = 0;            // to put them into files
  std::vector<double> snapshot_bytes;  // of each participant, as it is sent
  double coupler_bytes = 0;            // that the coupler holds with the snapshots
  double history_bytes = 0;            // of histories.csv and energies.csv, about
  std::size_t history_columns = 0;

  double bytes(const Schedule& schedule) const {
    return static_cast<double>(schedule.field_count()) * field_bytes + history_bytes;
  }
};

// The fields are those of the snapshots, one a participant. The participants have stepped with energies.
Volume measure_volume(const Model& model, const Schedule& schedule,
                      const std::vector<wire::Snapshot>& snapshots);

}  // namespace adit::coupler
