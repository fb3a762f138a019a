// Measures of the motion at a place: response and Fourier spectra, peaks, Arias intensity and durations, and
// transfer functions. They are computed from those rows of histories.csv that are equally spaced in time.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "coupler/participants/set_up.hpp"
#include "protocol/motion/motion.hpp"

namespace adit::coupler {

// The longest time between two samples [s] that resolves the shortest period.
double sampling_interval(const scene::Spectra& spectra);

class MotionOutputs {
 public:
  // Throws protocol::UserError if spectra are asked for of a history that does not exist or is not an
  // acceleration, or for periods that rows at this interval [s] do not resolve.
  MotionOutputs(const Model& model, double interval);

  // Takes a row of histories.csv, which must follow the last one after the interval.
  void take(std::span<const double> row);

  // The results of write(): measures for the summary, lines and warnings for the user.
  struct Found {
    std::vector<std::pair<std::string, double>> measures;
    std::vector<std::string> lines, warnings;
  };

  // Writes <motion>_motion.csv, _response.csv, _fourier.csv and, relative to another motion, _transfer.csv,
  // where <motion> is <history>_ax or <history>_ay. Creates the folder if there are motions.
  Found write(const std::filesystem::path& folder) const;

 private:
  struct Record {
    std::string name;    // crown_ax
    std::size_t column;  // its column in a row
    motion::Motion motion{};
  };
  struct Request {
    scene::Spectra spectra;
    std::size_t record;
    std::optional<std::size_t> relative_to;  // number of another record
  };
  void check(const scene::Spectra& spectra, const std::string& path, bool interval_given) const;
  // The record of the history of this name and quantity; nothing if it is not recorded.
  std::optional<std::size_t> find(const std::string& name, scene::Quantity quantity) const;
  void require_recorded(const std::string& name, const std::string& path) const;

  double interval_;
  std::vector<scene::History> histories_;  // in the order of their columns
  std::vector<Record> records_;
  std::vector<Request> requests_;
};

}  // namespace adit::coupler
