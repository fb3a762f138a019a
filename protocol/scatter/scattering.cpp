#include "protocol/scatter/scattering.hpp"

#include <fmt/format.h>

#include "protocol/motion/errors_at.hpp"

namespace adit::protocol {

Scattering::Scattering(const ScatterFields& fields, scene::Scatter::Property property,
                       const std::string& path) {
  for (int k = 0; k < fields.size(); ++k)
    if (const scene::Scatter& field = fields[k]; field.of() == property)
      motion::errors_at(fmt::format("{}[{}].path", path, k),
                        [&] { fields_.emplace_back(field.path(), field.content()); });
}

double Scattering::at(double x, double y) const {
  double factor = 1;
  for (const FactorField& field : fields_) factor *= field.at(x, y);
  return factor;
}

}  // namespace adit::protocol
