// The number of modes that a deposit needs, from the error of N modes compared with wave theory.
#pragma once

#include <cstddef>

#include "simplified/column/modes/modal_column.hpp"

namespace adit::simplified::column {

// The largest | |A_N| - |A| | over 0 < omega <= highest_frequency, as a fraction of the largest |A| there. A
// is the amplification at `depth` by wave theory, A_N that of the equivalent system with hysteretic damping.
// `highest_frequency` is circular, > 0 [rad/s].
double amplification_error(const ModalColumn& column, double highest_frequency, double depth = 0);

// The smallest N whose amplification_error does not exceed `error` (a fraction, such as 0.01). Throws
// protocol::UserError with an empty path if no N up to kMostModes is enough: layers of different damping
// couple the modes, and the resulting error does not decrease with the number of modes.
inline constexpr std::size_t kMostModes = 200;
std::size_t modes_needed(const Deposit& deposit, double highest_frequency, double error, double depth = 0);

}  // namespace adit::simplified::column
