// Requirement: continuum and particles come to rest together under gravity and initial stress, and carry the
// stress of one model alone, also where they share it; shaken afterwards, they move as from any rest.
#include "coupler/statics.hpp"

#include <google/protobuf/text_format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "protocol/errors.hpp"
#include "tests/support/local_peer.hpp"
#include "tests/support/overlaps.hpp"

namespace adit {
namespace {

// A block of ground on rollers at its sides, fixed at its base, in plane strain.
constexpr double kWidth = 16, kHeight = 10, kZone = 0.5, kDensity = 2000, kGravity = 10, kPoisson = 0.2;
constexpr double kK0 = kPoisson / (1 - kPoisson);
const double kRadius = kHeight / (58 * std::numbers::sqrt3);  // rows that fill the height

constexpr const char* kGravityLoad = "body_loads { acceleration { y: -10 } } ";

std::string continuum(const std::string& more = kGravityLoad) {
  return fmt::format(
      "continuum {{ block {{ x_min: 0 x_max: {} y_min: 0 y_max: {} zones_x: {} zones_y: {} }} {} "
      "motions {{ where {{ x_max: 0 }} velocity {{ x: 0 }} }} "
      "motions {{ where {{ x_min: {} }} velocity {{ x: 0 }} }} "
      "motions {{ where {{ y_max: 0 }} velocity {{ x: 0 y: 0 }} }} }} ",
      kWidth, kHeight, std::lround(kWidth / kZone), std::lround(kHeight / kZone), more, kWidth);
}

std::string particles(double x_min, double x_max, double y_min, double y_max,
                      const std::string& more = kGravityLoad) {
  return fmt::format(
      "particles {{ packing {{ x_min: {} x_max: {} y_min: {} y_max: {} radius: {:.17g} }} {} }} ", x_min, x_max,
      y_min, y_max + 1e-9, kRadius, more);
}

// Rollers and base of particles that fill the width.
std::string rollers(double from) {
  return fmt::format(
      "{} motions {{ where {{ x_max: {} y_min: {} }} velocity {{ x: 0 }} }} "
      "motions {{ where {{ x_min: {} y_min: {} }} velocity {{ x: 0 }} }} ",
      kGravityLoad, 2.5 * kRadius, from, kWidth - 2.5 * kRadius, from);
}

scene::Scene block(const std::string& models, double ratio = 1e-5) {
  scene::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(
      fmt::format("material {{ young_modulus: 5e7 poisson_ratio: {} density: {} }} time {{ duration: 0.2 }} "
                  "statics {{ unbalanced_ratio: {} }} ",
                  kPoisson, kDensity, ratio) +
          models,
      &scene))
      << models;
  return scene;
}

std::string joined(const std::string& overlap) {
  return "interface { overlap { " + overlap + " } } ";
}
const std::string kCoupledByStrip = continuum() + particles(0, kWidth, 0, kHeight, rollers(6.01)) +
                                    joined(test::strip(8, 3, 8, 6));
std::string coupled_by_ring(const std::string& shape) {
  return continuum() + particles(2, 14, 0, kHeight) + joined(test::ring(shape, 2.5));
}

struct Settled {
  coupler::Model model;
  coupler::Stepper stepper{model};
  coupler::Rest rest;

  explicit Settled(const scene::Scene& scene) : model(test::local_model(scene)) { rest = relax(model, stepper); }
};

const wire::Field& field(const google::protobuf::RepeatedPtrField<wire::Field>& fields,
                         const std::string& name) {
  for (const auto& candidate : fields)
    if (candidate.name() == name) return candidate;
  throw std::out_of_range(name);
}

struct StressAt {
  double x, y, weight, xx, yy, xy;
};

std::vector<StressAt> stress_of_zones(const wire::Piece& grid) {
  std::vector<StressAt> result;
  const auto &stress = field(grid.cell_fields(), "stress_Pa"), &weight = field(grid.cell_fields(), "weight");
  for (int z = 0; z < grid.connectivity_size() / 4; ++z) {
    StressAt at{0, 0, weight.values(z), stress.values(3 * z), stress.values(3 * z + 1), stress.values(3 * z + 2)};
    for (int corner = 0; corner < 4; ++corner) {
      const int point = static_cast<int>(grid.connectivity(4 * z + corner));
      at.x += grid.points(2 * point) / 4;
      at.y += grid.points(2 * point + 1) / 4;
    }
    result.push_back(at);
  }
  return result;
}

// Mean of Σ f ⊗ l / area over the bonds whose middle lies in each square of 1 m that is full of them.
std::vector<StressAt> stress_of_patches(const wire::Piece& bonds) {
  constexpr int kColumns = 16;
  struct Sum {
    double xx = 0, yy = 0, xy = 0, y = 0, weight = 0;
    int bonds = 0;
  };
  std::vector<Sum> sums(kColumns * 10);
  const auto &fn = field(bonds.cell_fields(), "normal_force_N"), &fs = field(bonds.cell_fields(), "shear_force_N");
  const auto& weight = field(bonds.cell_fields(), "weight");
  for (int k = 0; k < bonds.connectivity_size() / 2; ++k) {
    const int i = static_cast<int>(bonds.connectivity(2 * k)), j = static_cast<int>(bonds.connectivity(2 * k + 1));
    const double lx = bonds.points(2 * j) - bonds.points(2 * i), ly = bonds.points(2 * j + 1) - bonds.points(2 * i + 1);
    const double nx = lx / (2 * kRadius), ny = ly / (2 * kRadius);
    const double fx = fn.values(k) * nx - fs.values(k) * ny, fy = fn.values(k) * ny + fs.values(k) * nx;
    const double x = bonds.points(2 * i) + lx / 2, y = bonds.points(2 * i + 1) + ly / 2;
    Sum& sum = sums[static_cast<int>(std::floor(y)) * kColumns + static_cast<int>(std::floor(x))];
    sum.xx += fx * lx;
    sum.yy += fy * ly;
    sum.xy += (fx * ly + fy * lx) / 2;
    sum.y += y;
    sum.weight += weight.values(k);
    ++sum.bonds;
  }
  const double area = 2 * std::numbers::sqrt3 * kRadius * kRadius / 3;  // of one bond
  std::vector<StressAt> result;
  for (std::size_t c = 0; c < sums.size(); ++c) {
    const Sum& sum = sums[c];
    if (sum.bonds * area < 0.9) continue;
    result.push_back({static_cast<double>(c % kColumns) + 0.5, sum.y / sum.bonds, sum.weight / sum.bonds,
                      sum.xx / (sum.bonds * area), sum.yy / (sum.bonds * area), sum.xy / (sum.bonds * area)});
  }
  return result;
}

std::vector<StressAt> stresses(Settled& settled) {
  std::vector<StressAt> all;
  for (const auto& snapshot : settled.stepper.snapshots())
    for (const auto& piece : snapshot.pieces()) {
      const auto some = piece.name() == "grid"    ? stress_of_zones(piece)
                        : piece.name() == "bonds" ? stress_of_patches(piece)
                                                  : std::vector<StressAt>{};
      all.insert(all.end(), some.begin(), some.end());
    }
  return all;
}

double vertical(double y) {
  return -kDensity * kGravity * (kHeight - y);
}

TEST(Statics, Print) {
  for (const std::string& models :
       {continuum(), kCoupledByStrip, coupled_by_ring(test::box(6, 10, 3, 7)), coupled_by_ring(test::circle(8, 5, 2.2)),
        particles(0, kWidth, 0, kHeight, rollers(1.5 * kRadius) + fmt::format("motions {{ where {{ y_max: {} }} velocity {{ x: 0 y: 0 }} spin: 0 }}", 1.5*kRadius))}) {
    Settled s(block(models));
    double worst[2][3] = {};
    for (const auto& a : stresses(s)) {
      const double scale = std::abs(vertical(a.y));
      double* w = worst[a.weight < 1];
      w[0] = std::max(w[0], std::abs(a.yy - vertical(a.y)) / scale);
      w[1] = std::max(w[1], std::abs(a.xx - kK0 * vertical(a.y)) / scale);
      w[2] = std::max(w[2], std::abs(a.xy) / scale);
      if (std::abs(a.yy - vertical(a.y)) / scale > 0.03 || std::abs(a.xx - kK0 * vertical(a.y)) / scale >0.03) fmt::print("   {} {} w {}: {} {} {}\n", a.x, a.y, a.weight, a.xx / (kK0*vertical(a.y)), a.yy / vertical(a.y), a.xy / scale);
    }
    fmt::print("steps {} stops {} ratio {} dt {}; full {:.4f} {:.4f} {:.4f} shared {:.4f} {:.4f} {:.4f}\n", s.rest.steps, s.rest.stops, s.rest.unbalanced_ratio, s.model.dt,
               worst[0][0], worst[0][1], worst[0][2], worst[1][0], worst[1][1], worst[1][2]);
  }
}

}  // namespace
}  // namespace adit
