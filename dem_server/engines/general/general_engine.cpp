#include "dem_server/engines/general/general_engine.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "dem_server/engines/general/critical_step.hpp"
#include "dem_server/engines/general/renumber.hpp"
#include "dem_server/model/at_stage.hpp"
#include "dem_server/packing/meeting_place.hpp"
#include "dem_server/packing/useful_threads.hpp"
#include "protocol/errors.hpp"

namespace adit::dem {
namespace {

constexpr double kFar = 10;  // extents of the model from where it stood: a particle has left

Model renumbered(Model model) {
  renumber(model);
  return model;
}

}  // namespace

GeneralEngine::GeneralEngine(Model model, std::size_t threads)
    : GeneralEngine(threads, renumbered(std::move(model))) {}

GeneralEngine::GeneralEngine(std::size_t threads, Model model)
    : LocalEngine(model),
      model_(std::move(model)),
      solver_(model_, threads > 0 ? threads : useful_threads(model_.discs.size())),
      loads_(model_, solver_.particles()),
      motions_(model_, solver_.particles()),
      lists_(solver_.lists()) {}

CriticalElement GeneralEngine::critical_element() const {
  std::vector<CriticalElement> elements;
  for (const Model& model : all_stages(model_)) elements.push_back(dem::critical_element(model));
  CriticalElement critical = std::ranges::min(elements, {}, &CriticalElement::step);
  critical.static_step = std::ranges::min(elements, {}, &CriticalElement::static_step).static_step;
  critical.mass_per_stiffness = 0;
  for (const CriticalElement& one : elements)
    critical.mass_per_stiffness =
        std::max(critical.mass_per_stiffness,
                 one.mass_per_stiffness * std::pow(critical.static_step / one.static_step, 2));
  return critical;
}

const protocol::InterfaceOperator& GeneralEngine::tie(std::span<const double> places) {
  const Pairs& bonds = solver_.bonds();
  const FacetSet& facets = solver_.facets().set();
  const bool cells = facets.size() > 0;
  double longest = 0;
  if (cells)
    longest = 2 * std::ranges::max(facets.half_distance);
  else if (bonds.size() > 0)
    longest = std::ranges::max(bonds.rest_length);
  const protocol::InterfaceOperator& n = tie_particles(
      places, {cells ? facets.first : bonds.first, cells ? facets.second : bonds.second, longest}, motions_);
  solver_.tie(tied());
  return n;
}

void GeneralEngine::step_interface(const protocol::Step& step) {
  begin(step);
  solver_.step(step, loads_, motions_);
  require_finite(step);
  note_cracks();
  note_broken_springs(step);
  warn_of_escapes(step);
}

void GeneralEngine::require_finite(const protocol::Step& step) const {
  const auto [force, x, y] = solver_.strongest();
  if (!std::isfinite(force))
    throw protocol::Unstable(
        fmt::format("step {}: the normal force between the particles at ({:.6g}, {:.6g}) m is {} N; reduce "
                    "time.dt_factor",
                    step.number, x, y, force));
  if (std::isfinite(solver_.ledger().pairs)) return;
  const Particles& p = particles();
  std::size_t i = 0;
  while (i + 1 < p.size() && std::isfinite(p.vx[i]) && std::isfinite(p.vy[i]) && std::isfinite(p.spin[i]))
    ++i;
  throw protocol::Unstable(
      fmt::format("step {}: the work of the particles' forces is not finite, near the one that stood at "
                  "({:.6g}, {:.6g}) m; "
                  "reduce time.dt_factor",
                  step.number, p.x[i], p.y[i]));
}

void GeneralEngine::note_cracks() {
  cracks_.clear();
  for (const std::uint32_t pair : solver_.broken()) {
    const Bond& bond = model_.bonds[solver_.bond_of_pair()[pair]];
    const double width = bond.law == Bond::Law::kParallelBond ? model_.parallel_bonds[bond.number].area() : 0;
    Crack crack = crack_between(particles(), bond.first, bond.second, width, solver_.bonds().state[pair]);
    std::tie(crack.group_a, crack.group_b) = std::minmax({group()[bond.first], group()[bond.second]});
    cracks_.push_back(crack);
  }
  for (const std::uint32_t facet : solver_.facets().cracked()) {
    Crack crack = solver_.facets().crack(facet, particles());
    const FacetSet& set = solver_.facets().set();
    std::tie(crack.group_a, crack.group_b) =
        std::minmax({group()[set.first[facet]], group()[set.second[facet]]});
    cracks_.push_back(crack);
  }
}

void GeneralEngine::note_broken_springs(const protocol::Step& step) {
  const auto broken = solver_.springs().broken();
  if (spring_breaks_.count == 0 && !broken.empty()) {
    const Spring& first = solver_.springs().springs()[broken.front()];
    const auto [x, y] = meeting_place(particles(), first.first, first.second);
    // What breaks in statics is broken when time begins.
    spring_breaks_ = {0, step.relax ? 0 : static_cast<double>(step.number) * step.dt, x, y};
  }
  spring_breaks_.count = broken.size();
}

std::vector<Figure> GeneralEngine::figures() const {
  std::vector<Figure> figures = LocalEngine::figures();
  if (solver_.springs().springs().empty()) return figures;
  for (const Figure& figure : figures_of(spring_breaks_)) figures.push_back(figure);
  return figures;
}

// Only what moves far makes new lists of neighbours.
void GeneralEngine::warn_of_escapes(const protocol::Step& step) {
  if (escaped_ || solver_.lists() == lists_) return;
  lists_ = solver_.lists();
  const auto& extent = model_.extent;
  const double far = kFar * std::hypot(extent.x_max - extent.x_min, extent.y_max - extent.y_min);
  const Particles& p = particles();
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!(std::hypot(p.ux[i], p.uy[i]) > far)) continue;
    escaped_ = true;
    spdlog::warn(
        "step {}: particle {} has left the model: it is {:.3g} m from where it stood at ({:.6g}, {:.6g}) m; "
        "the run goes on, and further ones are not reported",
        step.number, p.id[i], std::hypot(p.ux[i], p.uy[i]), p.x[i], p.y[i]);
    return;
  }
}

Energies GeneralEngine::energies(const protocol::Step& step) {
  const DiscLedger ledger = solver_.ledger();
  const Solver::StrainEnergy strain = solver_.strain_energy();
  const double loads = loads_.work().forces, body_loads = loads_.work().accelerations,
               motions = motions_.work(), walls = solver_.walls().work();
  Energies energies{.kinetic = kinetic_energy_of(step, motions_.kinetic_energy()),
                    .strain = strain.sum() + solver_.foundation_energy(),
                    .external_work = loads + body_loads + motions + walls + ledger.support + ledger.ground,
                    .released = ledger.released,
                    .dissipated = ledger.friction + solver_.facets().fracture() +
                                  solver_.bars().dissipated() + ledger.dashpots + ledger.damping.local +
                                  ledger.damping.viscous + ledger.damping.edges + ledger.foundations,
                    .shares = {{"contacts", strain.pairs.contacts},
                               {"contact_bonds", strain.pairs.contact_bonds},
                               {"parallel_bonds", strain.pairs.parallel_bonds},
                               {"joints", strain.joints},
                               {"springs", strain.springs},
                               {"foundations", solver_.foundation_energy()},
                               {"loads", loads},
                               {"body_loads", body_loads},
                               {"motions", motions},
                               {"walls", walls},
                               {"ground", ledger.ground},
                               {"friction", ledger.friction},
                               {"contact_dashpots", ledger.dashpots},
                               {"local_damping", ledger.damping.local},
                               {"viscous_damping", ledger.damping.viscous},
                               {"quiet_edges", ledger.damping.edges},
                               {"foundation_losses", ledger.foundations},
                               {"time_step", solver_.time_step_share(strain.sum())}}};
  if (!solver_.facets().empty()) {
    energies.shares.push_back({"facets", strain.facets});
    energies.shares.push_back({"fracture", solver_.facets().fracture()});
  }
  if (const Bars& bars = solver_.bars(); !bars.empty()) {
    energies.shares.push_back({"bars", strain.bars});
    energies.shares.push_back({"bar_yield", bars.yielded()});
    energies.shares.push_back({"bar_slip", bars.slipped()});
    energies.shares.push_back({"bar_dowels", bars.dowels()});
  }
  return energies;
}

void GeneralEngine::exchange(state::Archive& archive) {
  LocalEngine::exchange(archive);
  solver_.exchange(archive);
  loads_.exchange(archive);
  motions_.exchange(archive);
  exchange_waiting(archive);
  archive("lists_looked_at", lists_);
  archive("escaped", escaped_);
  archive("spring_breaks", spring_breaks_);
}

void GeneralEngine::stop() {
  LocalEngine::stop();
  solver_.stop();
}

void GeneralEngine::scale_masses(double mass_per_stiffness) {
  if (mass_per_stiffness > 0)
    set_moved_masses(scaled_masses(model_, mass_per_stiffness), solver_.particles());
  else
    set_masses(model_, solver_.particles());
  renew_tied_masses();
}

void GeneralEngine::begin_stage(std::uint32_t stage) {
  LocalEngine::begin_stage(stage);
  for (const ParticleStage& next : model_.stages) {
    if (next.number <= stage_ || next.number > stage) continue;
    set_stage(next, model_);
    solver_.begin_stage(stage_, next, model_);
    stage_ = next.number;
  }
  take_stage(model_);
  renew_tied_masses();
  loads_ = Loads(model_, particles());
  motions_ = PrescribedMotions(model_, particles());
}

void GeneralEngine::start_over(const protocol::Drift& drift) {
  LocalEngine::start_over(drift);
  solver_.start_over(drift);
  loads_.start_over();
  motions_.start_over();
}

}  // namespace adit::dem
