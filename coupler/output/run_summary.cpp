#include "coupler/output/run_summary.hpp"

#include <spdlog/fmt/fmt.h>
#include <sys/resource.h>

#include <cmath>
#include <limits>

#include "protocol/log/log.hpp"
#include "protocol/standard_streams.hpp"
#include "protocol/text.hpp"

namespace adit::coupler {
namespace {

// A figure that a run does not have is null in its summary, so that every summary has the same names.
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr double kLargeChange = 0.01;  // of the energy, where particles that waited begin

// Left by statics, above which a user is warned: velocity [m/s], a thousandth of that of a moderate
// earthquake; acceleration [m/s^2], a twentieth of it; and the largest unbalanced force of a point as a share
// of the mean internal force, because a mean over all points does not see a small part that is not at rest.
constexpr double kDriftLimit = 1e-4, kAccelerationLimit = 0.1, kPartLimit = 0.1;

double own_cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

std::string at(const Event& event) {
  return fmt::format("at {:.2f} ms, x = {:.2f} m, y = {:.2f} m", 1e3 * event.time, event.x, event.y);
}

std::string how_many(const BrokenBonds& bonds) {
  if (bonds.count == 0) return "none";
  return fmt::format("{}, {}{}", bonds.count, bonds.count > 1 ? "the first " : "", at(bonds.first));
}

// "12 in stage 1, 3 in stage 2": bonds that broke before time began.
std::string by_stage(const Findings& findings) {
  std::map<std::uint32_t, std::uint64_t> broken = findings.cracks.in_statics;
  for (const auto& [stage, count] : findings.debonded.in_statics) broken[stage] += count;
  std::vector<std::string> stages;
  for (const auto& [stage, count] : broken) stages.push_back(fmt::format("{} in stage {}", count, stage));
  return fmt::format("{}", fmt::join(stages, ", "));
}

}  // namespace

RunSummary::RunSummary(const RunLabels& labels, const Model& model) : model_(model) {
  const scene::Scene& scene = model.scene;
  summary_.set("case", labels.case_name);
  summary_.set("scene", scene.name());
  summary_.set("scene_hash", labels.scene_hash);
  summary_.set("versions", labels.versions);
  summary_.set_origin(labels.origin);
  summary_.set("plane", protocol::lower_case(scene::Plane_Name(scene.plane())));
  summary_.set("duration_s", scene.time().duration());
  summary_.set("dt_s", model.dt);
  summary_.set("substeps", model.substeps);
  summary_.set("critical_dt_s", model.critical_dt * model.substeps);  // of the same step as dt_s
  wire::Interface counts;  // sums over all participants, each of which leaves out what it does not have
  for (const Participant& participant : model.participants) {
    counts.set_particles(counts.particles() + participant.counts.particles());
    counts.set_bonds(counts.bonds() + participant.counts.bonds());
    counts.set_zones(counts.zones() + participant.counts.zones());
    counts.set_grid_points(counts.grid_points() + participant.counts.grid_points());
  }
  summary_.set("particles", counts.particles());
  summary_.set("bonds", counts.bonds());
  summary_.set("zones", counts.zones());
  summary_.set("grid_points", counts.grid_points());
  summary_.set("coupling_points", model.coupling_points.size() / 2);
  add_engines();
  add_names();
  add_notes(labels.notes);
  if (model.interfaces.empty()) return;
  summary_.set("solve", protocol::lower_case(scene::Solve_Name(model.interfaces[0].given.solve())));
  const scene::Overlap& overlap = model.interfaces[0].given.overlap();
  if (!overlap.has_particles_begin()) return;
  summary_.set("overlap_particles_begin_x_m", overlap.particles_begin().x());
  summary_.set("overlap_particles_begin_y_m", overlap.particles_begin().y());
  summary_.set("overlap_continuum_ends_x_m", overlap.continuum_ends().x());
  summary_.set("overlap_continuum_ends_y_m", overlap.continuum_ends().y());
}

void RunSummary::add_engines() {
  for (const Participant& participant : model_.participants) {
    if (participant.model.engine().empty()) continue;
    summary_.set(participant.member.name + "_engine", participant.model.engine());
    lines_.push_back(
        fmt::format("engine             {}: {}", participant.member.name, participant.model.engine()));
  }
}

// Of what the fields `group` and `material` number.
void RunSummary::add_names() {
  const auto add = [this](const std::string& name, const auto& names) {
    if (names.size() > 1) summary_.set(name, std::vector<std::string>(names.begin(), names.end()));
  };
  for (const Participant& participant : model_.participants) {
    add(participant.member.name + "_groups", participant.model.groups());
    add(participant.member.name + "_materials", participant.model.materials());
  }
}

void RunSummary::add_notes(std::vector<std::string> notes) {
  notes.insert(notes.end(), model_.notes.begin(), model_.notes.end());
  for (const std::string& note : notes) lines_.push_back("note               " + note);
  summary_.set("notes", notes);
}

void RunSummary::add_stated() {
  auto list = nlohmann::ordered_json::array();
  for (const Stated& one : model_.stated)
    list.push_back({{"key", one.key}, {"stated", one.stated}, {"acted", one.acted}, {"unit", one.unit}});
  summary_.set("stated", list);
}

void RunSummary::warn(const std::string& warning) {
  protocol::tell(protocol::Severity::kWarning, "warning: ", warning);
  warnings_.push_back(warning);
}

void RunSummary::add_statics(const Rest& rest) {
  summary_.set("statics_steps", rest.steps);
  summary_.set("statics_stops", rest.stops);
  summary_.set("statics_unbalanced_ratio", rest.mean_ratio);
  summary_.set("statics_largest_ratio", rest.largest_ratio);
  const double drift = std::hypot(rest.drift.x, rest.drift.y);
  summary_.set("statics_drift_m_per_s", drift);
  lines_.push_back(
      fmt::format("at rest            after {} steps, unbalanced force ratio {:.1e}, the largest {:.1e} at "
                  "({:.4g}, {:.4g}) m of {}",
                  rest.steps, rest.mean_ratio, rest.largest_ratio, rest.x, rest.y, rest.of));
  const std::string remedy = fmt::format(
      "; where that matters beside the motion, give a statics.unbalanced_ratio below "
      "{:.0e}",
      model_.scene.statics().unbalanced_ratio());
  if (drift > kDriftLimit)
    warn(fmt::format(
        "statics left forces without balance, by which the model starts at about {:.2g} mm/s when time "
        "begins{}",
        1e3 * drift, remedy));
  if (rest.acceleration > kAccelerationLimit)
    warn(fmt::format(
        "statics left forces without balance, which accelerate the points by {:.2g} m/s^2 on average when "
        "time begins{}",
        rest.acceleration, remedy));
  if (rest.largest_ratio > kPartLimit)
    warn(fmt::format(
        "a part is not at rest: at ({:.4g}, {:.4g}) m of {} the unbalanced force is {:.2g} of the mean "
        "internal force, though the mean over all points is {:.1e}{}",
        rest.x, rest.y, rest.of, rest.largest_ratio, rest.mean_ratio, remedy));
}

void RunSummary::add_motions(const MotionOutputs::Found& found) {
  for (const auto& [name, value] : found.measures) summary_.set(name, value);
  lines_.insert(lines_.end(), found.lines.begin(), found.lines.end());
  warnings_.insert(warnings_.end(), found.warnings.begin(), found.warnings.end());
}

void RunSummary::add_participant(const Participant& participant, const wire::Bye& bye) {
  summary_.set(participant.member.name + "_cpu_s", bye.cpu_seconds());
  const std::string region = is_region(participant.member) ? participant.member.name + "_" : "";
  for (const wire::Figure& figure : bye.figures())
    figures_.emplace_back(region + figure.name(), figure.value());
  for (const wire::CrackPath& path : bye.crack_paths())
    if (crack_paths_++ == 0 || path.length() > longest_path_.length()) longest_path_ = path;
  for (const std::string& warning : bye.warnings())
    warn(fmt::format("{}: {}", participant.member.name, warning));
  (participant.member.role == Role::kContinuum ? zone_updates_ : particle_updates_) += bye.updates();
}

void RunSummary::add_outcome(const Stepper& stepper, const Findings& findings, std::uint64_t steps,
                             double wall_s, double stepping_s, const std::string& error) {
  summary_.set("completed", error.empty());
  if (!error.empty()) summary_.set("error", error);
  add_findings(findings);
  add_ledger(stepper.ledger());
  add_waiting(stepper);
  add_cost(stepper, steps, wall_s, stepping_s);
  add_figures();
  add_stated();
  add_warnings(findings);
}

void RunSummary::add_waiting(const Stepper& stepper) {
  const CondensedRegions& regions = stepper.regions();
  if (!regions.asked()) return;
  summary_.set("particles_followed", regions.followings());
  bool any_began = false;
  for (const auto& [region, beginning, largest] : regions.stories()) {
    if (!beginning) {
      summary_.set(region + "_waited_demand", largest);
      lines_.push_back(
          fmt::format("{:<18} waited to the end; the largest demand was {:.3g}, looked at {} times", region,
                      largest, regions.followings()));
      continue;
    }
    const double time = static_cast<double>(beginning->step) * model_.dt;
    summary_.set(region + "_began_s", time);
    if (!beginning->reason.empty()) {
      summary_.set(region + "_began_because", beginning->reason);
      lines_.push_back(fmt::format("{:<18} could not wait: {}", region, beginning->reason));
      continue;
    }
    any_began = true;
    summary_.set(region + "_began_demand", beginning->demand);
    lines_.push_back(
        fmt::format("{:<18} began at {:.4g} s, with a demand of {:.2g}", region, time, beginning->demand));
  }
  if (!any_began) return;
  if (const double change = std::abs(stepper.ledger().change()); change > kLargeChange)
    warn(fmt::format(
        "the energy changed by {:.1g} of its peak where particles began: they should not have waited "
        "any longer; give a smaller demand in `begin`, or leave it out",
        change));
  summary_.set("particles_began_energy_change", stepper.ledger().change());
  lines_.push_back(fmt::format("{:<18} the energy changed by {:.1e} where particles began", "",
                               stepper.ledger().change()));
}

// Participants choose their names, so that one may be taken already.
void RunSummary::add_figures() {
  for (const auto& [name, value] : figures_)
    if (summary_.has(name))
      warnings_.push_back(
          fmt::format("a participant's figure `{}` is left out: the summary has this name already", name));
    else
      summary_.set(name, value);
}

void RunSummary::add_states(const std::vector<std::uint64_t>& resumed, double written_s, double read_s) {
  if (written_s > 0) summary_.set("checkpoint_s", written_s);
  if (read_s > 0) summary_.set("restore_s", read_s);
  if (!resumed.empty()) summary_.set("resumed_at_steps", resumed);
}

void RunSummary::add_findings(const Findings& findings) {
  add_event("peak_bond_force", findings.peak, findings.peak_bond_force > 0);
  summary_.set("peak_bond_force_N", has_particles(model_) ? findings.peak_bond_force : kNothing);
  add_broken_bonds({"crack_count", "first_crack", "cracks_in_statics"}, findings.cracks);
  add_broken_bonds({"debonded_count", "first_debonding", "debonded_in_statics"}, findings.debonded);
  if (!has_particles(model_)) return;
  lines_.push_back(
      fmt::format("peak force chain   {:.0f} kN {}", 1e-3 * findings.peak_bond_force, at(findings.peak)));
  lines_.push_back("cracks             " + how_many(findings.cracks));
  if (findings.debonded.count > 0) lines_.push_back("debonded           " + how_many(findings.debonded));
  add_crack_paths();
}

// Of particles whose cracks have a width.
void RunSummary::add_crack_paths() {
  if (crack_paths_ == 0) return;
  const std::string mode(results::name_of(longest_path_.mode()));
  summary_.set("crack_path_count", crack_paths_);
  summary_.set("longest_crack_path_m", longest_path_.length());
  summary_.set("longest_crack_path_opening_m", longest_path_.opening());
  summary_.set("longest_crack_path_slip_m", longest_path_.slip());
  summary_.set("longest_crack_path_mode", mode);
  summary_.set("longest_crack_path_x_m", longest_path_.x());
  summary_.set("longest_crack_path_y_m", longest_path_.y());
  lines_.push_back(fmt::format(
      "crack paths        {}, the longest {:.3g} m, {}, open by {:.3g} mm at x = {:.2f} m, y = {:.2f} m",
      crack_paths_, longest_path_.length(), mode, 1e3 * longest_path_.opening(), longest_path_.x(),
      longest_path_.y()));
}

void RunSummary::add_broken_bonds(const BrokenNames& names, const BrokenBonds& bonds) {
  summary_.set(names.count, bonds.count);
  add_event(names.first, bonds.first, bonds.count > 0);
  auto by_stage = nlohmann::ordered_json::object();
  for (const auto& [stage, count] : bonds.in_statics) by_stage[std::to_string(stage)] = count;
  summary_.set(names.in_statics, by_stage);
}

void RunSummary::add_event(const std::string& name, const Event& event, bool happened) {
  summary_.set(name + "_time_s", happened ? event.time : kNothing);
  summary_.set(name + "_x_m", happened ? event.x : kNothing);
  summary_.set(name + "_y_m", happened ? event.y : kNothing);
}

void RunSummary::add_ledger(const Ledger& ledger) {
  double multiplier_work = 0;
  for (const ParticipantEnergies& participant : ledger.energies())
    multiplier_work += participant.multiplier_work;
  summary_.set("max_energy_drift", ledger.max_drift());
  summary_.set("energy_kept", ledger.kept());
  summary_.set("multiplier_work_J", multiplier_work);
  lines_.push_back(fmt::format("energy error       {:.1e} of the peak energy", ledger.max_drift()));
  summary_.set("max_constraint_residual", model_.constraint ? ledger.max_constraint_residual() : kNothing);
}

void RunSummary::add_cost(const Stepper& stepper, std::uint64_t steps, double wall_s, double stepping_s) {
  summary_.set("steps", steps);
  summary_.set("particle_updates", particle_updates_);
  summary_.set("zone_updates", zone_updates_);
  summary_.set("wall_s", wall_s);
  summary_.set("steps_per_s", static_cast<double>(steps) / stepping_s);
  summary_.set("coupler_cpu_s", own_cpu_seconds());
  summary_.set("coupler_wait_s", stepper.cost().wait);
  summary_.set("coupler_solve_s", stepper.cost().solve);
  double computed = 0, hidden = 0;
  for (const Participant& participant : model_.participants) {
    summary_.set(participant.member.name + "_compute_s", participant.compute_s);
    summary_.set(participant.member.name + "_hidden_s", participant.hidden_s);
    computed += participant.compute_s + participant.hidden_s;
    hidden += participant.hidden_s;
  }
  if (model_.constraint) {
    const SolveCost solve = model_.constraint->multipliers().cost();
    summary_.set("solve_unknowns", solve.unknowns);
    summary_.set("solve_factor_s", solve.factor_seconds);
    summary_.set("solve_factor_bytes", solve.factor_bytes);
    summary_.set("hidden_share", computed > 0 ? hidden / computed : 0.0);
    lines_.push_back(
        fmt::format("exchange           {:.0f} % of the models' work was done during the exchange, "
                    "the multipliers took {:.2g} s",
                    computed > 0 ? 100 * hidden / computed : 0.0, stepper.cost().solve));
  }
  lines_.push_back(
      fmt::format("wall time          {:.2f} s, {} steps of {:.3g} s", wall_s, steps, model_.dt));
}

void RunSummary::add_warnings(const Findings& findings) {
  if (findings.in_overlap.count > 0)
    warnings_.push_back(
        fmt::format("bonds broke inside the overlap: {}; the particle region is too small; move the overlap "
                    "away from the damage",
                    how_many(findings.in_overlap)));
  if (const std::string stages = by_stage(findings); !stages.empty())
    warnings_.push_back(
        fmt::format("bonds broke before time began, {}: the state from which time starts is "
                    "cracked; look at strengths and initial stress where it should not be",
                    stages));
  for (const auto& warning : warnings_) lines_.push_back("warning            " + warning);
  summary_.set("warnings", warnings_);
}

void RunSummary::print(const std::filesystem::path& directory) const {
  protocol::print(fmt::format("results            {}\n{}\n", directory.string(), fmt::join(lines_, "\n")));
}

}  // namespace adit::coupler
