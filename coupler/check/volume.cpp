#include "coupler/check/volume.hpp"

#include "coupler/exchange/round_trip.hpp"
#include "coupler/output/recorder.hpp"
#include "protocol/machine/memory.hpp"
#include "protocol/results/vtk.hpp"

namespace adit::coupler {
namespace {

constexpr double kBytesOfNumber = 20;  // of a number with 17 digits in a table; many are shorter

}  // namespace

Volume measure_volume(const Model& model, const Schedule& schedule,
                      const std::vector<wire::Snapshot>& snapshots) {
  Volume volume;
  volume.coupler_bytes = static_cast<double>(protocol::resident_bytes());
  for (const wire::Snapshot& snapshot : snapshots)
    volume.snapshot_bytes.push_back(static_cast<double>(snapshot.ByteSizeLong()));
  {
    const Stopwatch writing(volume.field_seconds);
    for (const wire::Snapshot& snapshot : snapshots)
      for (const wire::Piece& piece : snapshot.pieces())
        volume.field_bytes += static_cast<double>(results::vtk_document(piece).size());
  }
  volume.history_columns = history_columns(model).size();
  const std::size_t numbers = volume.history_columns + share_columns(model).size();
  volume.history_bytes = kBytesOfNumber * static_cast<double>(schedule.row_count() * numbers);
  return volume;
}

}  // namespace adit::coupler
