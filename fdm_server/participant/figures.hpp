// Figures of the continuum's summary.
#pragma once

#include <cstdint>
#include <string>

#include "fdm_server/grid/grid.hpp"
#include "protocol/messages/wire.pb.h"

namespace adit::fdm {

inline void add_figure(const std::string& name, double value, wire::Bye& bye) {
  wire::Figure& figure = *bye.add_figures();
  figure.set_name(name);
  figure.set_value(value);
}

class Figures {
 public:
  Figures(const Grid& grid, wire::Bye& bye) : grid_(grid), bye_(bye) {}

  void add(const std::string& name, double value) { add_figure(name, value, bye_); }
  // <name>_time_s, <name>_x_m, <name>_y_m: a time [s] and the place of a grid point.
  void add_when_and_where(const std::string& name, double time, std::uint32_t point) {
    add(name + "_time_s", time);
    add(name + "_x_m", grid_.x[point]);
    add(name + "_y_m", grid_.y[point]);
  }

 private:
  const Grid& grid_;
  wire::Bye& bye_;
};

}  // namespace adit::fdm
