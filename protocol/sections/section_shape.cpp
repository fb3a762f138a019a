#include "protocol/sections/section_shape.hpp"

#include <algorithm>

namespace adit::sections {

std::vector<ConcreteLayer> concrete_layers(const SectionShape& shape, std::size_t count) {
  const double step = shape.thickness / static_cast<double>(count);
  std::vector<ConcreteLayer> layers;
  for (std::size_t i = 0; i < count; ++i)
    layers.push_back({(static_cast<double>(i) + 0.5) * step - shape.thickness / 2, shape.width * step});
  for (const BarLayer& bars : shape.bars)
    for (ConcreteLayer& layer : layers) {
      const double low = std::max(layer.position - step / 2, bars.position - bars.diameter / 2),
                   high = std::min(layer.position + step / 2, bars.position + bars.diameter / 2);
      if (high > low) layer.area -= bars.area * (high - low) / bars.diameter;
    }
  return layers;
}

}  // namespace adit::sections
