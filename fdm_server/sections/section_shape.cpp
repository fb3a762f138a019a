#include "fdm_server/sections/section_shape.hpp"

#include <algorithm>

namespace adit::fdm {

std::vector<ConcreteLayer> concrete_layers(const SectionShape& shape, std::size_t count) {
  const double step = shape.thickness / static_cast<double>(count);
  std::vector<ConcreteLayer> layers;
  for (std::size_t i = 0; i < count; ++i)
    layers.push_back({(static_cast<double>(i) + 0.5) * step - shape.thickness / 2, shape.width * step});
  for (const BarLayer& bars : shape.bars) {
    const double from_inside = (bars.position + shape.thickness / 2) / step;
    layers[std::min(static_cast<std::size_t>(from_inside), count - 1)].area -= bars.area;
  }
  return layers;
}

}  // namespace adit::fdm
