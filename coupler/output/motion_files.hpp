// Writes the tables of a motion.
#pragma once

#include <filesystem>
#include <string>

#include "protocol/messages/scene.pb.h"
#include "protocol/motion/motion.hpp"

namespace adit::coupler {

// Acceleration, velocity and displacement over time, and the share of the Arias intensity so far. The
// displacement counts from `place` [m].
void write_motion(const std::filesystem::path& path, const motion::Motion& motion, double place);

// Response spectra for every damping: largest displacement, velocity and absolute acceleration of
// oscillators, and their pseudo velocity and pseudo acceleration.
void write_response(const std::filesystem::path& path, const motion::Motion& motion,
                    const scene::Spectra& spectra);

// The Fourier amplitude of the acceleration up to the Nyquist frequency, without that of 0 Hz.
void write_fourier(const std::filesystem::path& path, const motion::Motion& motion);

// The smoothed Fourier amplitudes of two motions and their ratio, which is `nan` where the amplitude of
// `from` is below a few percent of its largest. Returns the largest ratio and its frequency.
struct Amplification {
  double frequency, ratio;  // [Hz]
};
Amplification write_transfer(const std::filesystem::path& path, const motion::Motion& from,
                             const motion::Motion& to, const std::string& name_of_from,
                             const scene::Spectra& spectra);

}  // namespace adit::coupler
