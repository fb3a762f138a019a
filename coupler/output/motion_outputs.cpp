#include "coupler/output/motion_outputs.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "coupler/output/motion_files.hpp"
#include "coupler/participants/time_step.hpp"
#include "protocol/errors.hpp"
#include "protocol/motion/excitation/ground_motion.hpp"
#include "protocol/motion/measures.hpp"
#include "protocol/nearest_name.hpp"
#include "protocol/participant/history.hpp"

namespace adit::coupler {
namespace {

using protocol::UserError;

constexpr scene::Quantity kComponents[] = {scene::ACCELERATION_X, scene::ACCELERATION_Y};

std::string name_of_motion(const std::string& history, scene::Quantity quantity) {
  return history + (quantity == scene::ACCELERATION_X ? "_ax" : "_ay");
}

// Share of the motion's Fourier energy above half the Nyquist frequency, where frequencies that are too high
// for the sampling appear first.
double share_of_fast_motion(const motion::Motion& motion) {
  const auto spectrum = motion::fourier_spectrum(motion);
  double all = 0, fast = 0;
  for (std::size_t k = 1; k < spectrum.amplitude.size(); ++k) {  // 0 Hz is no shaking
    const double energy = spectrum.amplitude[k] * spectrum.amplitude[k];
    all += energy;
    if (2 * k > spectrum.amplitude.size()) fast += energy;
  }
  return all > 0 ? fast / all : 0;
}

}  // namespace

MotionOutputs::MotionOutputs(const Model& model, double interval) : interval_(interval) {
  for (const Participant& participant : model.participants)
    for (const auto& history : histories_of(model.scene, participant.member)) histories_.push_back(history);
  const auto& output = model.scene.output();
  for (int i = 0; i < output.spectra_size(); ++i) {
    const auto& spectra = output.spectra(i);
    const std::string path = fmt::format("output.spectra[{}]", i);
    check(spectra, path, output.has_history_interval());
    for (const auto quantity : kComponents) {
      const auto column = find(spectra.history(), quantity);
      if (!column) continue;
      const auto record = [&](const std::string& history, std::size_t at) {
        const std::string name = name_of_motion(history, quantity);
        const auto known = std::ranges::find(records_, name, &Record::name);
        if (known != records_.end()) return static_cast<std::size_t>(known - records_.begin());
        records_.push_back({name, at + 1, {interval, {}}});  // the first column is the time
        return records_.size() - 1;
      };
      Request request{spectra, record(spectra.history(), *column), std::nullopt, quantity};
      for (const Request& other : requests_)
        if (other.record == request.record)
          throw UserError(
              path + ".history",
              fmt::format("is `{}` a second time; give all of its `damping` at once", spectra.history()));
      if (spectra.has_relative_to()) {
        const auto base = find(spectra.relative_to(), quantity);
        if (!base)
          throw UserError(path + ".relative_to",
                          fmt::format("is `{}`, which has no history of {} as `{}` has; add one",
                                      spectra.relative_to(), protocol::name_of(quantity), spectra.history()));
        request.relative_to = record(spectra.relative_to(), *base);
      }
      requests_.push_back(std::move(request));
    }
  }
  if (!requests_.empty()) read_input(model);
}

void MotionOutputs::read_input(const Model& model) {
  for (const Participant& participant : model.participants) {
    if (participant.member.role != Role::kContinuum) continue;
    const scene::Base& base = continuum_of(model.scene, participant.member).base();
    if (!base.has_acceleration()) continue;
    input_direction_ = base.direction() == scene::Base::X ? scene::ACCELERATION_X : scene::ACCELERATION_Y;
    const motion::UsedMotion used = motion::ground_motion(
        base.acceleration(), participant.member.path + ".base.acceleration", model.scene.time().duration());
    input_ = motion::lasting(used.acting(), used.duration);
    input_place_ = used.place;
    return;
  }
}

double MotionOutputs::place(const Request& request) const {
  return request.quantity == input_direction_ ? input_place_ : 0;
}

const motion::Motion* MotionOutputs::reference(const Request& request) const {
  if (request.relative_to) return &records_[*request.relative_to].motion;
  return input_ && request.quantity == input_direction_ ? &*input_ : nullptr;
}

void MotionOutputs::check(const scene::Spectra& spectra, const std::string& path, bool interval_given) const {
  require_recorded(spectra.history(), path + ".history");
  if (spectra.has_relative_to()) require_recorded(spectra.relative_to(), path + ".relative_to");
  const double needed = sampling_interval(spectra);
  if (interval_ <= needed * (1 + 1e-9)) return;
  if (interval_given)
    throw UserError(
        "output.history_interval",
        fmt::format("makes rows {:g} s apart, but {}.shortest_period = {:g} s needs {:g} s; shorten the "
                    "interval, or begin the spectra at {:g} s",
                    interval_, path, spectra.shortest_period(), needed,
                    interval_ / needed * spectra.shortest_period()));
  throw UserError(
      path + ".shortest_period",
      fmt::format("is {:g} s, which needs samples {:g} s apart, but the time step is {:g} s; begin the "
                  "spectra at {:g} s",
                  spectra.shortest_period(), needed, interval_,
                  interval_ / needed * spectra.shortest_period()));
}

void MotionOutputs::require_recorded(const std::string& name, const std::string& path) const {
  std::vector<std::string> names, quantities;
  for (const auto& history : histories_) {
    if (std::ranges::find(names, history.name()) == names.end()) names.push_back(history.name());
    if (history.name() == name) quantities.push_back(protocol::name_of(history.quantity()));
  }
  if (quantities.empty())
    throw UserError(path, fmt::format("is `{}`, but no history has this name{}", name,
                                      names.empty() ? "; the scene has no histories"
                                                    : protocol::did_you_mean(name, names)));
  for (const auto quantity : kComponents)
    if (find(name, quantity)) return;
  throw UserError(
      path, fmt::format("is `{}`, whose histories are of {}; add one of acceleration_x or acceleration_y "
                        "by this name",
                        name, fmt::join(quantities, ", ")));
}

std::optional<std::size_t> MotionOutputs::find(const std::string& name, scene::Quantity quantity) const {
  for (std::size_t i = 0; i < histories_.size(); ++i)
    if (histories_[i].name() == name && histories_[i].quantity() == quantity) return i;
  return std::nullopt;
}

void MotionOutputs::take(std::span<const double> row) {
  for (Record& record : records_) record.motion.acceleration.push_back(row[record.column]);
}

MotionOutputs::Found MotionOutputs::write(const std::filesystem::path& folder) const {
  Found found;
  if (requests_.empty()) return found;
  std::filesystem::create_directories(folder);
  found.measures.emplace_back("spectra_sampling_interval_s", interval_);
  for (const Request& request : requests_) {
    const auto& [spectra, record, relative_to, quantity] = request;
    const auto& [name, column, motion] = records_[record];
    write_motion(folder / (name + "_motion.csv"), motion, place(request));
    write_response(folder / (name + "_response.csv"), motion, spectra);
    if (const motion::Motion* before = reference(request)) {
      write_motion(folder / (name + "_input.csv"), *before, place(request));
      write_response(folder / (name + "_reference.csv"), *before, spectra);
    }
    write_fourier(folder / (name + "_fourier.csv"), motion);
    const motion::Peaks peaks = motion::peaks(motion, place(request));
    const double arias = motion::arias_intensity(motion),
                 d = motion::significant_duration(motion, 0.05, 0.95);
    const auto add = [&, &name = name](const char* measure, double value) {
      found.measures.emplace_back(name + measure, value);
    };
    add("_pga_m_per_s2", peaks.acceleration);
    add("_pgv_m_per_s", peaks.velocity);
    add("_pgd_m", peaks.displacement);
    add("_arias_m_per_s", arias);
    add("_cav_m_per_s", motion::cumulative_absolute_velocity(motion));
    add("_significant_duration_s", d);
    found.lines.push_back(
        fmt::format("{:<18} peak {:.3g} m/s^2, {:.3g} m/s, {:.3g} m; Arias {:.3g} m/s in {:.3g} s", name,
                    peaks.acceleration, peaks.velocity, peaks.displacement, arias, d));
    if (const double fast = share_of_fast_motion(motion); fast > 0.05)
      found.warnings.push_back(
          fmt::format("{:.0f} % of the energy of the motion {} lies above {:.3g} Hz, half its Nyquist "
                      "frequency: it may be aliased; choose a shorter output.history_interval",
                      100 * fast, name, 0.25 / interval_));
    if (!relative_to) continue;
    const Amplification top = write_transfer(folder / (name + "_transfer.csv"), records_[*relative_to].motion,
                                             motion, records_[*relative_to].name, spectra);
    add("_largest_amplification", top.ratio);
    add("_largest_amplification_Hz", top.frequency);
  }
  return found;
}

}  // namespace adit::coupler
