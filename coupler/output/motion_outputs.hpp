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
#include "protocol/state/archive.hpp"

namespace adit::coupler {

class MotionOutputs {
 public:
  // Throws protocol::UserError if spectra are asked for of a history that does not exist or is not an
  // acceleration, or for periods that rows at this interval [s] do not resolve.
  MotionOutputs(const Model& model, double interval);

  // Takes a row of histories.csv, which must follow the last one after the interval.
  void take(std::span<const double> row);
  void exchange(state::Archive& archive) {
    for (Record& record : records_) archive("record", record.motion.acceleration);
  }

  // The results of write(): measures for the summary, lines and warnings for the user.
  struct Found {
    std::vector<std::pair<std::string, double>> measures;
    std::vector<std::string> lines, warnings;
  };

  // Writes <motion>_motion.csv, _response.csv, _fourier.csv and, relative to another motion, _transfer.csv.
  // That motion, or else the base's acceleration in the same direction, is in _input.csv, its spectra are in
  // _reference.csv. Here <motion> is <history>_ax or <history>_ay. Creates the folder if there are motions.
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
    scene::Quantity quantity;                // acceleration in x or y
  };
  void check(const scene::Spectra& spectra, const std::string& path, bool interval_given) const;
  // The record of the history of this name and quantity; nothing if it is not recorded.
  std::optional<std::size_t> find(const std::string& name, scene::Quantity quantity) const;
  // Takes the acceleration of the base of the first continuum that has one.
  void read_input(const Model& model);
  // Where a motion begins [m]: those in the input's direction with the input.
  double place(const Request& request) const;
  // The motion from which that of the request came, if it is known.
  const motion::Motion* reference(const Request& request) const;
  void require_recorded(const std::string& name, const std::string& path) const;

  double interval_;
  std::vector<scene::History> histories_;  // in the order of their columns
  std::vector<Record> records_;
  std::vector<Request> requests_;
  std::optional<motion::Motion> input_;  // acceleration of the base
  double input_place_ = 0;               // where it begins, in its record's displacement [m]
  scene::Quantity input_direction_ = scene::ACCELERATION_X;
};

}  // namespace adit::coupler
