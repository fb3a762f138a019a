// The plain product of transfer matrices, which the Riccati sweep replaces: right while it has digits, and
// how soon it has none.
#include "tests/support/chain/transfer_matrix.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocol/errors.hpp"
#include "simplified/chain/joints/joint_forces.hpp"
#include "tests/unit/simplified/chain/chains.hpp"

namespace adit::simplified::chain::transfer_matrix_test {
namespace {

// s = m A of the segment for dt = 5 ms, k = 2 GN/m.
const double kDigitsAJoint = std::acosh(1 + 9.5e6 * 4 / (0.005 * 0.005) / (2 * 2e9)) / std::log(10);

const Integrator kIntegrator(Newmark{}, 0.005);

double predicted(const Chain& chain, const Integrator& integrator = kIntegrator) {
  return test::predicted_digits_lost(Model(chain), integrator.A(), integrator.C());
}

// In the first step from rest, under loads that differ from body to body.
double measured(const Chain& chain) {
  const Model model(chain);
  Components load = components(model.bodies + 2);
  for (std::size_t i = 0; i < model.bodies; ++i) load[0][i + 1] = 1e6 * std::cos(static_cast<double>(i));
  return test::measured_digits_lost(model, kIntegrator.A(), kIntegrator.C(), load);
}

// Steps of Newmark's method by the product, under loads alone; abutments stand still.
class ProductIntegration {
 public:
  ProductIntegration(const Chain& chain, double dt)
      : model_(chain),
        integrator_(Newmark{}, dt),
        product_(model_),
        tracks_{track(), track(), track()},
        hinges_(components(model_.bodies + 1)),
        r_(components(model_.bodies + 2)),
        y_(r_) {
    product_.factor(model_, integrator_.A(), integrator_.C());
  }

  // One value a place.
  void step(const Components& load) {
    const std::size_t n = model_.bodies;
    for (Track& track : tracks_) integrator_.predict(track, 1, n + 1);
    const Field p = predicted_displacement(tracks_), q = predicted_velocity(tracks_);
    hinge_forces(model_, p, q, 0, n + 1, hinges_);
    unbalanced(model_, p, q, load, hinges_, 1, n + 1, r_);
    product_.solve(r_, y_);
    for (std::size_t c = 0; c < 3; ++c) integrator_.correct(tracks_[c], y_[c], 1, n + 1);
  }
  double x(std::size_t body) const { return tracks_[0].x[body + 1]; }

 private:
  Track track() const { return Track(model_.bodies + 2); }

  Model model_;
  Integrator integrator_;
  test::TransferMatrixSweep product_;
  Tracks tracks_;
  Components hinges_, r_, y_;
};

// The prediction is that of theory: 2.9 digits a joint for a 22.5 m immersed segment at 5 ms.
TEST(TransferMatrix, PredictsItsLoss) {
  EXPECT_NEAR(kDigitsAJoint, 2.9, 0.05);
  for (const std::size_t n : {2, 5, 30})
    EXPECT_NEAR(predicted(test::segments(n)), kDigitsAJoint * (static_cast<double>(n) - 1), 1e-6 * n);
}

// It loses what is predicted, within a digit, up to 5 joints, and all after 6, as predicted and as measured.
TEST(TransferMatrix, DiesAfterSixJoints) {
  for (const std::size_t joints : {2, 3, 4, 5}) {
    const Chain chain = test::segments(joints + 1);
    EXPECT_NEAR(measured(chain), kDigitsAJoint * static_cast<double>(joints), 1) << joints << " joints";
    EXPECT_LT(std::max(measured(chain), predicted(chain)), test::kAllDigits) << joints << " joints";
  }
  const Chain chain = test::segments(7);
  EXPECT_GT(predicted(chain), 15.65);
  EXPECT_NEAR(measured(chain), 15.65, 0.5);
}

// While it has digits the product gives the Riccati sweep's motion, step after step, with soil, turns and
// abutment.
TEST(TransferMatrix, AgreesWhileItHasDigits) {
  Chain chain = test::winding(4);
  for (Hinge& hinge : chain.hinges)
    for (HingeDirection* d : {&hinge.axial, &hinge.shear, &hinge.rotation}) d->stiffness *= 100;
  const double dt = 0.02;
  ASSERT_LT(predicted(chain, Integrator(Newmark{}, dt)), 5);
  ProductIntegration product(chain, dt);
  Simulation riccati(chain, {.dt = dt});
  test::Wave wave(4);
  double largest = 0;
  for (int step = 1; step <= 500; ++step) {
    const Excitation motion = wave.at(dt * step);
    Components load = components(6);
    std::vector<double> x, y;
    for (std::size_t i = 0; i < 4; ++i) {  // what soil of 1 GN/m would carry over
      x.push_back(load[0][i + 1] = 1e9 * motion.ground_x[i]);
      y.push_back(load[1][i + 1] = 1e9 * motion.ground_y[i]);
    }
    product.step(load);
    riccati.step({.load_x = x, .load_y = y});
    for (std::size_t i = 0; i < 4; ++i) {
      ASSERT_NEAR(product.x(i), riccati.bodies().x[i], 1e-9);
      largest = std::max(largest, std::abs(product.x(i)));
    }
  }
  EXPECT_GT(largest, 0.01);
}

// In a chain far too long for it nothing is left of the motion.
TEST(TransferMatrix, HasNoNumberForALongChain) {
  const Chain chain = test::segments(200);
  EXPECT_GT(predicted(chain), test::kAllDigits);
  ProductIntegration product(chain, 0.005);
  Components load = components(202);
  std::fill(load[0].begin() + 1, load[0].end() - 1, 1e6);
  for (int step = 0; step < 1000 && std::isfinite(product.x(0)); ++step) product.step(load);
  EXPECT_FALSE(std::isfinite(product.x(0)));
}

// It cannot pass a hinge without stiffness.
TEST(TransferMatrix, RefusesAnOpenHinge) {
  Chain chain = test::winding(4);
  chain.hinges[1].shear = {};
  try {
    ProductIntegration(chain, 0.005);
    FAIL() << "was made";
  } catch (const protocol::UserError& error) {
    EXPECT_EQ(error.path(), "chain.hinges[1].shear");
    EXPECT_THAT(error.what(), testing::HasSubstr("take the Riccati sweep"));
  }
}

}  // namespace
}  // namespace adit::simplified::chain::transfer_matrix_test
