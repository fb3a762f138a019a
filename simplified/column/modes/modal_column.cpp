#include "simplified/column/modes/modal_column.hpp"

namespace adit::simplified::column {

ModalColumn modal_column(const Deposit& deposit, std::size_t count) {
  ModalColumn column{deposit, modes(deposit, count), deposit.mass()};
  for (const Mode& mode : column.modes) column.rigid_mass -= mode.effective_mass;
  return column;
}

std::vector<double> shapes_at(const ModalColumn& column, double depth) {
  std::vector<double> shapes;
  for (const Mode& mode : column.modes)
    shapes.push_back(mode.participation * shape(column.deposit, mode, depth));
  return shapes;
}

std::vector<double> stresses_at(const ModalColumn& column, double depth) {
  std::vector<double> stresses;
  for (const Mode& mode : column.modes)
    stresses.push_back(mode.participation * stress(column.deposit, mode, depth));
  return stresses;
}

}  // namespace adit::simplified::column
