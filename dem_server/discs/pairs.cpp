#include "dem_server/discs/pairs.hpp"

#include <algorithm>

namespace adit::dem {

void Pairs::finish(std::size_t discs, bool cement, bool dashpots) {
  for (auto* zeroed : {&rest_x, &rest_y, &rest_length, &half_difference, &slack, &slide})
    zeroed->assign(size(), 0.0);
  weight.assign(size(), 1.0);
  law.assign(size(), 0);
  for (auto* zeroed : {&initial, &shear, &moment}) zeroed->assign(cement ? size() : 0, 0.0);
  state.assign(cement ? size() : 0, BondState::kIntact);
  for (auto* zeroed : {&normal_dashpot, &shear_dashpot}) zeroed->assign(dashpots ? size() : 0, 0.0);

  const std::size_t blocks = blocks_of(discs);
  chunks.clear();
  chunk_starts.assign(1, 0);
  away_starts.assign(1, 0);
  std::vector<std::uint32_t> count(blocks + 1, 0);
  std::uint32_t away = 0;
  for (std::uint32_t block = 0, k = 0; block < blocks; ++block) {
    const std::uint32_t begin = k;
    for (; k < size() && first[k] / kBlock == block; ++k)
      if (second[k] / kBlock != block) {
        ++away;
        ++count[second[k] / kBlock + 1];
      }
    for (std::uint32_t at = begin; at < k; at += kChunk)
      chunks.push_back({at, std::min(at + kChunk, k), false});
    chunk_starts.push_back(static_cast<std::uint32_t>(chunks.size()));
    away_starts.push_back(away);
  }
  for (auto* forces : {&away_x, &away_y, &away_moment}) forces->assign(away, 0.0);
  for (std::size_t b = 0; b < blocks; ++b) count[b + 1] += count[b];
  arrival_starts = count;
  arrivals.resize(away);
  for (std::uint32_t k = 0, slot = 0; k < size(); ++k)
    if (second[k] / kBlock != first[k] / kBlock) arrivals[count[second[k] / kBlock]++] = {slot++, second[k]};
}

void Pairs::find_plain() {
  for (Chunk& chunk : chunks) {
    chunk.plain = cemented();
    for (std::uint32_t k = chunk.begin; k < chunk.end && chunk.plain; ++k)
      chunk.plain = law[k] == law[chunk.begin] && state[k] == BondState::kIntact && slack[k] == 0 &&
                    initial[k] == 0 && weight[k] == 1;
  }
}

}  // namespace adit::dem
