#pragma once

namespace adit::sections::test {

// Takes a fibre to a strain in small steps; counts its work in the form of the ledger.
template <class Law, class State>
struct Fibre {
  Law law;
  State state;
  double strain = 0, work = 0;

  double to(double goal, int steps = 2000) {
    const double from = strain;
    for (int i = 1; i <= steps; ++i) {
      const double next = from + (goal - from) * i / steps, before = state.stress;
      strain_to(law, next, state);
      work += (before + state.stress) / 2 * (next - strain);
      strain = next;
    }
    return state.stress;
  }
};

}  // namespace adit::sections::test
