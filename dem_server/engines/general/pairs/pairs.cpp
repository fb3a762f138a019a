#include "dem_server/engines/general/pairs/pairs.hpp"

#include <algorithm>

namespace adit::dem {

void Pairs::finish(std::size_t discs, bool bonded, bool dashpots) {
  for (auto* zeroed : {&rest_x, &rest_y, &rest_length, &half_difference, &slack, &slide})
    zeroed->assign(size(), 0.0);
  weight.assign(size(), 1.0);
  law.assign(size(), 0);
  for (auto* zeroed : {&width, &initial, &shear, &moment}) zeroed->assign(bonded ? size() : 0, 0.0);
  state.assign(bonded ? size() : 0, BondState::kIntact);
  for (auto* zeroed : {&normal_dashpot, &shear_dashpot}) zeroed->assign(dashpots ? size() : 0, 0.0);

  divide(discs);
}

void Pairs::divide(std::size_t discs) {
  const auto blocks = static_cast<std::uint32_t>(blocks_of(discs));
  chunks.clear();
  reached.clear();
  chunk_starts.assign(1, 0);
  reach_starts.assign(1, 0);
  for (auto* places : {&first_place, &second_place}) places->resize(size());
  for (std::uint32_t block = 0, k = 0; block < blocks; ++block) {
    const std::uint32_t begin = k;
    while (k < size() && first[k] / kBlock == block) ++k;
    find_places(block, begin, k);
    for (std::uint32_t at = begin; at < k; at += kChunk)
      chunks.push_back({.begin = at, .end = std::min(at + kChunk, k)});
    chunk_starts.push_back(static_cast<std::uint32_t>(chunks.size()));
    reach_starts.push_back(static_cast<std::uint32_t>(reached.size()));
  }
  for (auto* forces : {&away_x, &away_y, &away_moment}) forces->assign(reached.size(), 0.0);

  arrival_starts.assign(blocks + 1, 0);
  for (const std::uint32_t disc : reached) ++arrival_starts[disc / kBlock + 1];
  for (std::uint32_t b = 0; b < blocks; ++b) arrival_starts[b + 1] += arrival_starts[b];
  arrivals.resize(reached.size());
  auto next = arrival_starts;
  for (std::uint32_t slot = 0; slot < reached.size(); ++slot)
    arrivals[next[reached[slot] / kBlock]++] = {slot, reached[slot]};
}

void Pairs::find_places(std::uint32_t block, std::uint32_t begin, std::uint32_t end) {
  const auto start = static_cast<std::ptrdiff_t>(reached.size());
  for (std::uint32_t k = begin; k < end; ++k)
    if (second[k] / kBlock != block) reached.push_back(second[k]);
  std::sort(reached.begin() + start, reached.end());
  reached.erase(std::unique(reached.begin() + start, reached.end()), reached.end());
  for (std::uint32_t k = begin; k < end; ++k) {
    std::uint32_t at = second[k] - block * kBlock;
    if (second[k] / kBlock != block)
      at = kBlock +
           static_cast<std::uint32_t>(std::lower_bound(reached.begin() + start, reached.end(), second[k]) -
                                      reached.begin() - start);
    first_place[k] = kDiscValues * (first[k] - block * kBlock);
    second_place[k] = kDiscValues * at;
  }
}

void Pairs::exchange(std::size_t discs, std::span<const PairLaw> laws, state::Archive& archive) {
  bool with_bonds = bonded(), with_dashpots = !normal_dashpot.empty();
  archive("with_bonds", with_bonds);
  archive("with_dashpots", with_dashpots);
  archive("pair_first", first);
  second.resize(first.size());
  archive("pair_second", std::span(second));
  if (archive.reads()) {
    state::require_below(first, discs, "pair_first");
    state::require_below(second, discs, "pair_second");
    state::require_of_model(std::ranges::is_sorted(first), "pair_first");
    finish(discs, with_bonds, with_dashpots);
  }
  archive("pair_law", std::span(law));
  archive("pair_rest_x", std::span(rest_x));
  archive("pair_rest_y", std::span(rest_y));
  archive("pair_rest_length", std::span(rest_length));
  archive("pair_half_difference", std::span(half_difference));
  archive("pair_slack", std::span(slack));
  archive("pair_width", std::span(width));
  archive("pair_weight", std::span(weight));
  archive("pair_slide", std::span(slide));
  archive("pair_normal_dashpot", std::span(normal_dashpot));
  archive("pair_shear_dashpot", std::span(shear_dashpot));
  archive("pair_initial", std::span(initial));
  archive("pair_shear", std::span(shear));
  archive("pair_moment", std::span(moment));
  archive("pair_state", std::span(state));
  exchange_kinds(laws, archive);
}

// Between two steps a chunk may still be computed as one of a more general kind than it is.
void Pairs::exchange_kinds(std::span<const PairLaw> laws, state::Archive& archive) {
  std::vector<std::uint8_t> kinds;
  for (const Chunk& chunk : chunks)
    kinds.insert(kinds.end(), {static_cast<std::uint8_t>(chunk.kind), chunk.one_law});
  archive("chunks", std::span(kinds));
  if (!archive.reads()) return;
  state::require_below(law, laws.size(), "pair_law");
  sort_chunks(laws);
  for (std::size_t c = 0; c < chunks.size(); ++c) {
    chunks[c].kind = std::max(chunks[c].kind, std::min(Kind{kinds[2 * c]}, Kind::kGeneral));
    chunks[c].one_law = chunks[c].one_law && kinds[2 * c + 1] != 0;
  }
}

void Pairs::sort_chunks(std::span<const PairLaw> laws) {
  for (Chunk& chunk : chunks) {
    const std::uint32_t one = chunk.begin;
    chunk.law = law[one];
    chunk.one_law = true;
    chunk.contacts_beside_bonds = !bonded() || laws[chunk.law].contact_beside_bond;
    bool intact = true, varied = true, plain = true;
    for (std::uint32_t k = one; k < chunk.end; ++k) {
      chunk.one_law &= law[k] == chunk.law;
      varied = varied && weight[k] == 1;
      plain = plain && slack[k] == 0;
      if (!bonded()) continue;
      intact = intact && state[k] == BondState::kIntact &&
               laws[law[k]].contact_beside_bond == chunk.contacts_beside_bonds;
      varied = varied && initial[k] == 0;
      plain = plain && width[k] == width[one];
    }
    varied = varied && intact && chunk.one_law;
    chunk.kind = varied && plain ? Kind::kPlain
                 : varied        ? Kind::kVaried
                 : intact        ? Kind::kIntact
                                 : Kind::kGeneral;
  }
}

}  // namespace adit::dem
