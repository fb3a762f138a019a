// Whether a bond is whole, and how it broke.
#pragma once

#include <cstdint>

namespace adit::dem {

enum class BondState : std::uint8_t { kIntact = 0, kTensileCrack = 1, kShearCrack = 2 };

}  // namespace adit::dem
