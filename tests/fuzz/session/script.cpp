#include "tests/fuzz/session/script.hpp"

#include <google/protobuf/io/tokenizer.h>
#include <google/protobuf/text_format.h>

#include <algorithm>
#include <optional>

#include "tests/fuzz/session/arrival.hpp"

namespace adit::fuzz {
namespace {

constexpr std::string_view kDivider = "---\n";

using google::protobuf::TextFormat;

// The parser would print what is wrong.
class Silent : public google::protobuf::io::ErrorCollector {
 public:
  void AddError(int, int, const std::string&) override {}
};

std::optional<wire::Frame> frame_of(std::string_view text) {
  constexpr int kDeepest = 50;
  Silent silent;
  TextFormat::Parser parser;
  parser.RecordErrorsTo(&silent);
  parser.SetRecursionLimit(kDeepest);
  wire::Frame frame;
  if (!parser.ParseFromString(std::string(text), &frame)) return {};
  return arrived(frame.SerializeAsString());
}

// Beyond these a model takes longer than a fuzzer has.
constexpr double kMostPieces = 400, kLongestMotion = 10;  // [s]

template <class Boxed>
double area(const Boxed& box) {
  return (box.x_max() - box.x_min()) * (box.y_max() - box.y_min());
}

double zones(const scene::Continuum& continuum) {
  double zones = double(continuum.block().zones_x()) * continuum.block().zones_y();
  for (const auto& block : continuum.blocks())
    zones += double(block.along().zones()) * block.across().zones();
  return zones;
}

double discs(const scene::Particles& particles) {
  const auto count = [](double area, double radius) { return area / (4 * radius * radius); };
  double discs = 0;
  if (particles.has_packing()) discs += count(area(particles.packing()), particles.packing().radius());
  if (particles.has_square_packing())
    discs += count(area(particles.square_packing()), particles.square_packing().radius());
  if (particles.has_random_packing())
    discs += count(area(particles.random_packing()), particles.random_packing().radius_min());
  return discs;
}

bool is_small(const scene::GroundMotion& motion) {
  double end = motion.from(), highest = 0;
  const auto take = [&](double its_end, double frequency) {
    end = std::max(end, its_end);
    highest = std::max(highest, frequency);
  };
  if (motion.has_ricker())
    take(motion.ricker().time() + 1 / motion.ricker().frequency(), motion.ricker().frequency());
  if (motion.has_sine()) take(motion.sine().end(), motion.sine().frequency());
  if (motion.has_gabor())
    take(motion.gabor().time() + motion.gabor().width() / motion.gabor().frequency(),
         motion.gabor().frequency());
  return end <= kLongestMotion && highest <= kMostPieces;
}

}  // namespace

std::vector<wire::Frame> frames_of(std::string_view script) {
  std::vector<wire::Frame> frames;
  while (!script.empty()) {
    const auto end = std::min(script.find(kDivider), script.size());
    if (auto frame = frame_of(script.substr(0, end))) frames.push_back(std::move(*frame));
    script.remove_prefix(std::min(end + kDivider.size(), script.size()));
  }
  return frames;
}

std::string script_of(const std::vector<wire::Frame>& frames) {
  std::string script;
  for (const wire::Frame& frame : frames) {
    if (!script.empty()) script += kDivider;
    std::string text;
    TextFormat::Printer printer;
    printer.SetUseShortRepeatedPrimitives(true);
    printer.PrintToString(frame, &text);
    script += text;
  }
  return script;
}

bool is_small(const scene::Scene& scene) {
  const bool has_motion = scene.continuum().base().has_acceleration();
  return zones(scene.continuum()) <= kMostPieces && discs(scene.particles()) <= kMostPieces &&
         (!has_motion ||
          (scene.time().duration() <= kLongestMotion && is_small(scene.continuum().base().acceleration())));
}

}  // namespace adit::fuzz
