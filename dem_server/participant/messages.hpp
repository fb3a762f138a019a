// What the participant reads from and writes into messages.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "dem_server/engines/answers.hpp"
#include "dem_server/engines/crack.hpp"
#include "dem_server/model/weigh.hpp"
#include "dem_server/observe/crack_paths.hpp"
#include "dem_server/participant/wave_speeds.hpp"
#include "protocol/messages/wire.pb.h"

namespace adit::dem {

void assign(google::protobuf::RepeatedField<double>& field, std::span<const double> values);

// Weights of the particles' centres and the bonds' midpoints, from one list in the order of the sample
// points. RequestError where they do not fit.
SampledWeights split_weights(const wire::Weights& sent, std::size_t centres, std::size_t midpoints);

void report(const CriticalElement& element, wire::Model& to);
void report(const WaveSpeeds& speeds, wire::Model& to);
void report(const Crack& crack, std::uint64_t step, std::span<const std::string> group_names,
            wire::Crack& to);
void report(const Strongest& strongest, std::uint64_t step, wire::BondForce& to);
void report(const Energies& energies, wire::Energies& to);
void report(const CrackPath& path, wire::CrackPath& to);

}  // namespace adit::dem
