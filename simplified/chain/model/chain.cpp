#include "simplified/chain/model/chain.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "protocol/errors.hpp"

namespace adit::simplified::chain {
namespace {

using protocol::UserError;

void check_above_zero(double value, const std::string& path) {
  if (!(value > 0 && std::isfinite(value)))
    throw UserError(path, fmt::format("{} is not a finite number above 0", value));
}

void check_not_negative(double value, const std::string& path) {
  if (!(value >= 0 && std::isfinite(value)))
    throw UserError(path, fmt::format("{} is not a finite number, 0 or above", value));
}

void check(const Directions& directions, const std::string& path) {
  check_not_negative(directions.axial, path + ".axial");
  check_not_negative(directions.lateral, path + ".lateral");
  check_not_negative(directions.rotation, path + ".rotation");
}

void check(const Body& body, const std::string& path) {
  check_above_zero(body.length, path + ".length");
  if (!std::isfinite(body.angle))
    throw UserError(path + ".angle", fmt::format("{} is not a finite number", body.angle));
  check_above_zero(body.mass, path + ".mass");
  check_above_zero(body.inertia, path + ".inertia");
  check(body.ground_stiffness, path + ".ground_stiffness");
  check(body.ground_dashpot, path + ".ground_dashpot");
}

void check(const HingeDirection& direction, const std::string& path) {
  check_not_negative(direction.stiffness, path + ".stiffness");
  check_not_negative(direction.dashpot, path + ".dashpot");
  if (direction.curve.empty()) return;
  if (direction.stiffness > 0)
    throw UserError(path + ".curve", "stands beside a stiffness: give one of the two");
  check(direction.curve, path + ".curve");
}

void check(const Hinge& hinge, const std::string& path) {
  check(hinge.axial, path + ".axial");
  check(hinge.shear, path + ".shear");
  check(hinge.rotation, path + ".rotation");
}

}  // namespace

void check(const Chain& chain) {
  const std::size_t n = chain.bodies.size();
  if (n == 0) throw UserError("chain.bodies", "holds no body: give 1 or more");
  if (chain.hinges.size() + 1 != n)
    throw UserError("chain.hinges",
                    fmt::format("holds {} hinge(s) for {} bodies: give {}, one between each two",
                                chain.hinges.size(), n, n - 1));
  for (std::size_t i = 0; i < n; ++i) {
    const std::string path = fmt::format("chain.bodies[{}]", i);
    check(chain.bodies[i], path);
    // A hinge has the mean direction of its two bodies, which means little if the chain turns back.
    if (i > 0 && std::cos(chain.bodies[i].angle - chain.bodies[i - 1].angle) < 0)
      throw UserError(path + ".angle",
                      fmt::format("{} rad turns by more than a right angle from the {} rad of the "
                                  "body before it: a chain goes on forwards",
                                  chain.bodies[i].angle, chain.bodies[i - 1].angle));
  }
  for (std::size_t j = 0; j < chain.hinges.size(); ++j)
    check(chain.hinges[j], fmt::format("chain.hinges[{}]", j));
  if (chain.start) check(*chain.start, "chain.start");
  if (chain.finish) check(*chain.finish, "chain.finish");
}

}  // namespace adit::simplified::chain
