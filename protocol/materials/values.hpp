// Which values of the classes of materials a structure is computed with.
#pragma once

#include "protocol/messages/reinforced_section.pb.h"

namespace adit::protocol {

enum class Values { kMean, kDesign };

inline Values values_of(scene::ReinforcedSection::Values values) {
  return values == scene::ReinforcedSection::DESIGN ? Values::kDesign : Values::kMean;
}

}  // namespace adit::protocol
