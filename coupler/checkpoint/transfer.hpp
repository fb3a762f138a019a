// The states of participants, from and to the programs that compute them.
#pragma once

#include <filesystem>
#include <vector>

#include "coupler/checkpoint/manifest.hpp"
#include "coupler/participants/participant.hpp"

namespace adit::coupler {

// Whether each can save its state.
bool all_save_states(const std::vector<Participant>& participants);

// Saves the state of each into `folder`, all at the step that they have reached. All work at the same time.
std::vector<StateFile> save(std::vector<Participant>& participants, const std::filesystem::path& folder);

// The participant goes on from the state in this file. It compares the checksums.
void restore(Participant& participant, const std::filesystem::path& folder, const StateFile& file);

}  // namespace adit::coupler
