#include "dem_server/engines/general/bars/bars.hpp"

#include <algorithm>
#include <cmath>

namespace adit::dem {

Bars::NodeMotion Bars::motion_of(const BarNode& node, double turn, const Particles& p) {
  const double x = node.x - p.x[node.disc], y = node.y - p.y[node.disc];
  const double sine = std::sin(turn), half = std::sin(turn / 2), versine = 2 * half * half;
  const PlaneVector swung{-versine * x - sine * y, sine * x - versine * y};
  return {{x + swung.x, y + swung.y}, {p.ux[node.disc] + swung.x, p.uy[node.disc] + swung.y}};
}

Bars::Shape Bars::shape_of(const OneBar& bar, std::size_t k, const NodeMotion& one, const NodeMotion& other) {
  const Bar& model = bar.chain.bar();
  const std::size_t after = model.after(k);
  const BarNode &a = model.nodes[k], &b = model.nodes[after];
  const double rest_x = b.x - a.x, rest_y = b.y - a.y, rest = bar.chain.rest_lengths()[k];
  const double ux = other.moved.x - one.moved.x, uy = other.moved.y - one.moved.y;
  const double dx = rest_x + ux, dy = rest_y + uy, length = std::hypot(dx, dy);
  const double swing = std::atan2(across(rest_x, rest_y, ux, uy), along(rest_x, rest_y, dx, dy));
  return {a.disc,
          b.disc,
          one.arm,
          other.arm,
          a.x + one.moved.x,
          a.y + one.moved.y,
          dx,
          dy,
          length,
          rest,
          growth_of_square(rest_x, rest_y, dx, dy, ux, uy) / (length + rest),
          rest * std::remainder(swing - (bar.turn[k] + bar.turn[after]) / 2, 2 * std::numbers::pi)};
}

Bars::Shape Bars::shape_of(const OneBar& bar, std::size_t k, const Particles& p) {
  const Bar& model = bar.chain.bar();
  const std::size_t after = model.after(k);
  return shape_of(bar, k, motion_of(model.nodes[k], bar.turn[k], p),
                  motion_of(model.nodes[after], bar.turn[after], p));
}

Bars::Bars(const std::vector<Bar>& bars, const Particles& particles) {
  for (const Bar& bar : bars)
    bars_.push_back({BarChain(bar),
                     bar.stage == 0,
                     std::vector<double>(bar.nodes.size(), 0.0),
                     std::vector<Dowel>(bar.elements()),
                     std::vector<Installed>(bar.elements()),
                     0,
                     std::vector<double>(bar.elements(), 0.0),
                     {},
                     {}});
  begin_stage(0, 0, particles);
}

void Bars::begin_stage(std::uint32_t before, std::uint32_t stage, const Particles& p) {
  for (OneBar& bar : bars_) {
    const Bar& model = bar.chain.bar();
    if (!bar.installed && model.stage > before && model.stage <= stage) install(p, bar);
    if (bar.installed) let_go(p, bar);
  }
}

void Bars::install(const Particles& p, OneBar& bar) {
  bar.installed = true;
  for (std::size_t k = 0; k < bar.begun.size(); ++k) {
    const Shape shape = shape_of(bar, k, p);
    bar.begun[k] = {shape.growth, shape.shift};
  }
}

// Of particles that were taken away.
void Bars::let_go(const Particles& p, OneBar& bar) {
  const Bar& model = bar.chain.bar();
  for (std::size_t k = 0; k < model.nodes.size(); ++k)
    if (!p.is_there(model.nodes[k].disc)) bar.chain.loosen(k);
  for (std::size_t k = 0; k < model.elements(); ++k) {
    if (p.is_there(model.nodes[k].disc) && p.is_there(model.nodes[model.after(k)].disc)) continue;
    bar.chain.cut(k);
    bar.dowels[k] = {};
  }
}

void Bars::add_forces(double dt, protocol::Team& team, Particles& p) {
  if (empty()) return;
  team.run(bars_.size(), [&](std::size_t number, std::size_t) { follow(dt, p, bars_[number]); });
  for (const OneBar& bar : bars_) {
    if (!bar.installed) continue;
    for (std::size_t k = 0; k < bar.shapes.size(); ++k)
      if (bar.chain.whole(k)) pull(bar.shapes[k], bar.chain.force(k), bar.dowels[k].force, p);
  }
}

void Bars::follow(double dt, const Particles& p, OneBar& bar) {
  const Bar& model = bar.chain.bar();
  bar.motions.clear();
  for (std::size_t k = 0; k < model.nodes.size(); ++k) {
    bar.turn[k] += dt * p.spin[model.nodes[k].disc];
    bar.motions.push_back(motion_of(model.nodes[k], bar.turn[k], p));
  }
  if (!bar.installed) return;
  bar.shapes.clear();
  for (std::size_t k = 0; k < model.elements(); ++k) {
    bar.shapes.push_back(shape_of(bar, k, bar.motions[k], bar.motions[model.after(k)]));
    bar.growths[k] = bar.shapes[k].growth - bar.begun[k].growth;
  }
  bar.chain.stretch(bar.growths);
  for (std::size_t k = 0; k < model.elements(); ++k)
    if (bar.chain.whole(k)) shear(k, bar.shapes[k].shift - bar.begun[k].shift, bar);
}

void Bars::shear(std::size_t k, double shift, OneBar& bar) {
  const BarNode& node = bar.chain.bar().nodes[k];
  const double used = bar.chain.stress(k) / bar.chain.bar().steel.yield;
  const double strength = node.dowel_strength * std::sqrt(std::max(0.0, 1 - used * used));
  Dowel now = bar.dowels[k];
  now.shift = shift;
  now.force = node.dowel_stiffness * (shift - now.plastic);
  if (std::abs(now.force) > strength) {
    now.force = std::copysign(strength, now.force);
    now.plastic = shift - now.force / node.dowel_stiffness;
    bar.lost_by_dowels += (bar.dowels[k].force + now.force) / 2 * (now.plastic - bar.dowels[k].plastic);
  }
  bar.dowels[k] = now;
}

void Bars::pull(const Shape& of, double force, double dowel, Particles& p) {
  const double ex = of.dx / of.length, ey = of.dy / of.length;
  const auto [fx, fy] = vector_of(ex, ey, force, dowel * of.rest_length / of.length);
  p.fx[of.first] += fx;
  p.fy[of.first] += fy;
  p.moment[of.first] += across(of.arm_1.x, of.arm_1.y, fx, fy) + dowel * of.rest_length / 2;
  p.fx[of.second] -= fx;
  p.fy[of.second] -= fy;
  p.moment[of.second] += -across(of.arm_2.x, of.arm_2.y, fx, fy) + dowel * of.rest_length / 2;
}

BarElement Bars::element(std::size_t number, std::size_t k, const Particles& p) const {
  const OneBar& bar = bars_[number];
  const Shape of = shape_of(bar, k, p);
  return {of.first,
          of.second,
          of.x_1,
          of.y_1,
          of.x_1 + of.dx,
          of.y_1 + of.dy,
          of.dx / of.length,
          of.dy / of.length,
          bar.chain.force(k),
          bar.dowels[k].force * of.rest_length / of.length};
}

double Bars::internal_force() const {
  double sum = 0;
  for (const OneBar& bar : bars_)
    for (std::size_t k = 0; k < bar.dowels.size(); ++k)
      sum += std::hypot(bar.chain.force(k), bar.dowels[k].force);
  return sum;
}

double Bars::strain_energy() const {
  double sum = 0;
  for (const OneBar& bar : bars_) {
    sum += bar.chain.stored();
    for (std::size_t k = 0; k < bar.dowels.size(); ++k)
      sum += bar.dowels[k].force * bar.dowels[k].force / (2 * bar.chain.bar().nodes[k].dowel_stiffness);
  }
  return sum;
}

double Bars::yielded() const {
  double sum = 0;
  for (const OneBar& bar : bars_) sum += bar.chain.yielded();
  return sum;
}

double Bars::slipped() const {
  double sum = 0;
  for (const OneBar& bar : bars_) sum += bar.chain.slipped();
  return sum;
}

double Bars::dowels() const {
  double sum = 0;
  for (const OneBar& bar : bars_) sum += bar.lost_by_dowels;
  return sum;
}

void Bars::start_over() {
  for (OneBar& bar : bars_) {
    bar.chain.start_over();
    bar.lost_by_dowels = 0;
  }
}

void Bars::exchange(state::Archive& archive) {
  if (empty()) return;
  for (OneBar& bar : bars_) {
    bar.chain.exchange(archive);
    archive("bar_installed", bar.installed);
    archive("bar_turns", std::span(bar.turn));
    archive("bar_dowels", std::span(bar.dowels));
    archive("bar_begun", std::span(bar.begun));
    archive("bar_dowel_losses", bar.lost_by_dowels);
  }
}

}  // namespace adit::dem
