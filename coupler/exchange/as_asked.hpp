// Whether an answer fits what was asked, and what the participant said before. What holds for any answer is
// looked at in answers.hpp.
#pragma once

#include <set>
#include <string>

#include "coupler/participants/participant.hpp"

namespace adit::coupler {

// The participant's last answer is the prediction of the step that it was asked for. Otherwise
// protocol::PeerLost.
void require_as_asked(Participant& participant);

// Every piece of a snapshot can become a file, and none has a name that is `taken`; pieces of a region get
// its name. Otherwise protocol::PeerLost.
void require_drawable(const Participant& participant, wire::Snapshot& snapshot, std::set<std::string>& taken);

}  // namespace adit::coupler
