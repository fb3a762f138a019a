// What engineers state of the motion at a place: response and Fourier spectra, peaks, Arias intensity and
// durations, transfer functions, from the rows of histories.csv that follow at equal times.
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
  // Throws protocol::UserError for spectra of histories that do not exist or are not of accelerations, and of
  // periods that rows at this interval [s] do not resolve.
  MotionOutputs(const Model& model, double interval);

  // A row of histories.csv, at the next of the equal times.
  void take(std::span<const double> row);

  // What write() found: measures for the summary, sentences for the user.
  struct Found {
    std::vector<std::pair<std::string, double>> measures;
    std::vector<std::string> lines, warnings;
  };

  // Writes <motion>_motion.csv, _response.csv, _fourier.csv and, relative to another motion, _transfer.csv;
  // the motion is called <history>_ax or _ay. Makes the folder where there are motions.
  Found write(const std::filesystem::path& folder) const;

 private:
  struct Record {
    std::string name;    // crown_ax
    std::size_t column;  // in a row
    motion::Motion motion{};
  };
  struct Request {
    scene::Spectra spectra;
    std::size_t record;
    std::optional<std::size_t> relative_to;  // another record
  };
  void check(const scene::Spectra& spectra, const std::string& path, bool interval_given) const;
  // Of this name, with a column of this quantity; none where the history is not recorded.
  std::optional<std::size_t> find(const std::string& name, scene::Quantity quantity) const;
  void require_recorded(const std::string& name, const std::string& path) const;

  double interval_;
  std::vector<scene::History> histories_;  // in the order of their columns
  std::vector<Record> records_;
  std::vector<Request> requests_;
};

}  // namespace adit::coupler
