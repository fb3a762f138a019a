// How many modes a deposit needs: the error of N modes against wave theory.
#pragma once

#include <cstddef>

#include "simplified/column/modes/modal_column.hpp"

namespace adit::simplified::column {

// The largest | |A_N| - |A| | over 0 < omega <= highest_frequency, as a fraction of the largest |A| there;
// A the amplification at `depth` by wave theory, A_N that of the equivalent system with hysteretic damping.
// highest_frequency: circular, > 0 [rad/s].
double amplification_error(const ModalColumn& column, double highest_frequency, double depth = 0);

// The smallest N whose amplification_error does not exceed `error` (a fraction, such as 0.01). Throws
// protocol::UserError (empty path) where no N up to kMostModes is enough: layers of different damping couple
// the modes, which leaves an error that more modes do not remove.
inline constexpr std::size_t kMostModes = 200;
std::size_t modes_needed(const Deposit& deposit, double highest_frequency, double error, double depth = 0);

}  // namespace adit::simplified::column
