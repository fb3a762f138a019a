// The time between two rows of histories.csv that the scene asks for.
#pragma once

#include "protocol/messages/scene.pb.h"

namespace adit::coupler {

// The longest time between two samples [s] that resolves the shortest period.
double sampling_interval(const scene::Spectra& spectra);

// `history_interval`; where absent, a five-hundredth of the duration, or what the spectra need if that is
// less [s].
double row_interval(const scene::Scene& scene);

}  // namespace adit::coupler
