// Implicit integration in time, in the form of the generalized-α method (Chung & Hulbert 1993):
//     M [(1−α_m) a₁ + α_m a₀] + (1−α_f) f(u₁, v₁) + α_f f(u₀, v₀) = 0,
//     u₁ = u₀ + Δt v₀ + Δt² [(½−β) a₀ + β a₁],   v₁ = v₀ + Δt [(1−γ) a₀ + γ a₁].
// Newmark: α_m = α_f = 0. HHT: α_m = 0, α_f = α, γ = ½ + α, β = (1+α)²/4. With α_m = α_f = ½, γ = ½, β = ¼
// and the mean force of every nonlinear spring over the step in place of the mean of its end forces, the
// work of the springs is their change of energy, whatever the step: energy is conserved. For linear springs
// that is Newmark's average acceleration. With stiff contacts Newmark's own rule can gain energy and blow up
// (the run then stops with Unstable), and HHT loses some of what the contacts excite.
#pragma once

namespace adit::simplified::beam {

struct Scheme {
  double alpha_m = 0, alpha_f = 0, beta = 0.25, gamma = 0.5;
  bool mean_force = false;
};

constexpr Scheme newmark(double beta = 0.25, double gamma = 0.5) {
  return {0, 0, beta, gamma, false};
}
constexpr Scheme hht(double alpha) {  // 0 ≤ alpha ≤ 1/3
  return {0, alpha, (1 + alpha) * (1 + alpha) / 4, 0.5 + alpha, false};
}
// Without inertia there is no kinetic energy to conserve, and the run uses newmark() instead.
constexpr Scheme energy_conserving() {
  return {0.5, 0.5, 0.25, 0.5, true};
}

}  // namespace adit::simplified::beam
