// What participants of particles read from and write into messages.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "dem_server/participant/crack.hpp"
#include "dem_server/particles/assembly.hpp"
#include "protocol/messages/wire.pb.h"
#include "protocol/participant/step.hpp"

namespace adit::dem {

void assign(google::protobuf::RepeatedField<double>& field, std::span<const double> values);
std::span<const double> view(const google::protobuf::RepeatedField<double>& field);

// Weights of the particles' centres and the bonds' midpoints, from one list in the order of the sample
// points.
SampledWeights split_weights(const wire::Weights& sent, std::size_t centres, std::size_t midpoints);

void report(const Crack& crack, std::uint64_t step, wire::Crack& to);

// Throws protocol::RequestError unless a step was made and each coupling point has its two impulses.
void check_impulses(std::span<const double> impulses, std::size_t points, const protocol::Step& last);

// Throws protocol::RequestError unless dt [s] is positive and, after step 0, that of the steps before.
double checked_dt(const wire::Advance& advance, double before);

}  // namespace adit::dem
