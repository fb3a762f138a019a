// A recording: all that the coupler and its participants said to each other after their greeting, in one
// file.
//
//   file    "ADITREC\n", version of this format, version of the protocol
//   entry   length of the content, CRC-32 of all that follows, time since the recording began [ns, 64 bits],
//           number of the participant (16 bits), kind (16 bits), content
//
// Integers are unsigned and little-endian, of 32 bits where nothing is said. The first entries
// introduce the participants, numbered from 0: name of the model, role, program, release, each on a line. The
// content of a request or an answer is the frame as the wire carries it, length included. Heartbeats, secrets
// and their proofs are not recorded. The last entry of a run that was killed may be cut.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "coupler/participants/members.hpp"

namespace adit::coupler {

inline constexpr std::string_view kRecordingMagic = "ADITREC\n";
inline constexpr std::uint32_t kRecordingVersion = 1;
inline constexpr std::size_t kFileHeadBytes = 16, kEntryHeadBytes = 20;
// Of an entry's head: length and checksum, which the checksum does not cover.
inline constexpr std::size_t kUncheckedBytes = 8;

enum class Kind : std::uint16_t { kParticipant = 0, kRequest = 1, kAnswer = 2 };

struct Speaker {
  std::string name;  // of its model
  Role role;
  std::string program, release;
};

}  // namespace adit::coupler
