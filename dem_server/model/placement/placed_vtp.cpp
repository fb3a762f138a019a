#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <pugixml.hpp>
#include <string_view>

#include "dem_server/model/placement/placed_table.hpp"
#include "dem_server/model/placement/written_numbers.hpp"
#include "protocol/errors.hpp"
#include "protocol/excerpt.hpp"
#include "protocol/text.hpp"

namespace adit::dem {
namespace {

struct Numbers {
  std::vector<double> values;
  double rounding;  // half a unit of the last digit of the largest
};

class Reader {
 public:
  Reader(const std::string& content, const std::string& path) : path_(path) {
    const auto parsed = document_.load_buffer(content.data(), content.size());
    if (!parsed)
      refuse(fmt::format("is no XML from byte {} on ({}); save it with the data as ASCII, not appended",
                         parsed.offset, parsed.description()));
    file_ = document_.child("VTKFile");
    if (std::string_view(file_.attribute("type").value()) != "PolyData")
      refuse("is no VTK file of type PolyData; save the particles as points of a VTP file");
    if (file_.attribute("compressor"))
      refuse("holds compressed data, which are not read; save it without compression, or as ASCII");
  }

  PlacedDiscs read() const {
    PlacedDiscs placed;
    for (const auto& piece : file_.child("PolyData").children("Piece")) read_piece(piece, placed);
    return placed;
  }

 private:
  [[noreturn]] void refuse(const std::string& message) const { throw protocol::UserError(path_, message); }

  void read_piece(const pugi::xml_node& piece, PlacedDiscs& placed) const {
    const std::size_t count = piece.attribute("NumberOfPoints").as_ullong();
    const auto [points, place_rounding] =
        values(piece.child("Points").child("DataArray"), "the points", 3 * count);
    const auto field = [&](const char* name) {
      return piece.child("PointData").find_child_by_attribute("DataArray", "Name", name);
    };
    if (count > 0 && !field("radius_m"))
      refuse("has no point field `radius_m`; add it, or give the particles as CSV");
    const auto [radius, radius_rounding] = values(field("radius_m"), "radius_m", count);
    placed.x_rounding = placed.y_rounding = std::max(placed.x_rounding, place_rounding);
    placed.radius_rounding = std::max(placed.radius_rounding, radius_rounding);
    for (std::size_t i = 0; i < count; ++i) {
      for (const double value : {points[3 * i], points[3 * i + 1], radius[i]})
        if (!std::isfinite(value)) refuse(fmt::format("point {} has a place or radius that is no number", i));
      if (const auto wrong = wrong_with_disc(points[3 * i], points[3 * i + 1], radius[i]))
        refuse(fmt::format("point {}: {}", i, *wrong));
      placed.discs.x.push_back(points[3 * i]);
      placed.discs.y.push_back(points[3 * i + 1]);
      placed.discs.radius.push_back(radius[i]);
    }
    if (!field("group")) return;
    for (const double group : values(field("group"), "group", count).values) {
      if (!(group >= 0 && group == std::floor(group) && group < 1e6))
        refuse(fmt::format("a point's group is {}; give whole numbers from 0", group));
      placed.number.push_back(static_cast<std::uint32_t>(group));
    }
  }

  Numbers values(const pugi::xml_node& array, const std::string& what, std::size_t expected) const {
    const std::string_view format = array.attribute("format").as_string("ascii");
    Numbers numbers{};
    if (format == "ascii")
      numbers = from_text(array.text().get(), what);
    else if (format == "binary")
      numbers = from_base64(array, what);
    else
      refuse(fmt::format("holds {} as {} data; save it as ASCII, or with binary data in place", what,
                         protocol::excerpt(format)));
    if (numbers.values.size() != expected)
      refuse(fmt::format("holds {} values of {}, expected {}", numbers.values.size(), what, expected));
    if (std::string_view(array.attribute("type").value()) == "Float32")  // however many digits it writes
      for (const double value : numbers.values)
        numbers.rounding = std::max(numbers.rounding, std::abs(value) * kSingle);
    return numbers;
  }

  Numbers from_text(std::string_view text, const std::string& what) const {
    constexpr std::string_view kBlanks = " \t\r\n";
    std::vector<double> values;
    WrittenNumbers written;
    for (auto at = text.find_first_not_of(kBlanks); at != std::string_view::npos;
         at = text.find_first_not_of(kBlanks, at)) {
      const auto word = text.substr(at, text.find_first_of(kBlanks, at) - at);
      double value = 0;
      const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
      if (error != std::errc() || end != word.data() + word.size())
        refuse(fmt::format("{} of {} is not a number", protocol::excerpt(word), what));
      values.push_back(value);
      written.add(word, value);
      at += word.size();
    }
    return {std::move(values), written.rounding()};
  }

  // The length in bytes, then the values, in one stream.
  Numbers from_base64(const pugi::xml_node& array, const std::string& what) const {
    if (std::string_view(file_.attribute("byte_order").value()) != "LittleEndian")
      refuse("holds big-endian data; save it as ASCII");
    const std::string bytes = decode(array.text().get(), what);
    const std::size_t header = std::string_view(file_.attribute("header_type").value()) == "UInt64" ? 8 : 4;
    std::uint64_t length = 0;
    std::memcpy(&length, bytes.data(), std::min(header, bytes.size()));
    if (bytes.size() < header || bytes.size() - header < length)
      refuse(fmt::format("holds fewer data of {} than it says; save it again", what));
    const std::string_view type = array.attribute("type").value();
    return {numbers(std::string_view(bytes).substr(header, length), type, what), 0};
  }

  std::vector<double> numbers(std::string_view bytes, std::string_view type, const std::string& what) const {
    const auto as = [bytes]<class T>(T) {
      std::vector<double> values(bytes.size() / sizeof(T));
      for (std::size_t i = 0; i < values.size(); ++i) {
        T value;
        std::memcpy(&value, bytes.data() + i * sizeof(T), sizeof(T));
        values[i] = static_cast<double>(value);
      }
      return values;
    };
    if (type == "Float64") return as(double());
    if (type == "Float32") return as(float());
    if (type == "Int64") return as(std::int64_t());
    if (type == "UInt64") return as(std::uint64_t());
    if (type == "Int32") return as(std::int32_t());
    if (type == "UInt32") return as(std::uint32_t());
    if (type == "Int16") return as(std::int16_t());
    if (type == "UInt16") return as(std::uint16_t());
    if (type == "Int8") return as(std::int8_t());
    if (type == "UInt8") return as(std::uint8_t());
    refuse(fmt::format("holds {} of the type {}; save it as Float64", what, protocol::excerpt(type)));
  }

  std::string decode(std::string_view text, const std::string& what) const {
    std::string bytes;
    std::uint32_t group = 0;
    int bits = 0;
    for (const char c : protocol::trim(text)) {
      if (c == '=') bits = 0;  // the end of a stream, perhaps of the length alone
      if (c == '\n' || c == '\r' || c == ' ' || c == '=') continue;
      const auto digit = kDigits.find(c);
      if (digit == std::string_view::npos) refuse(fmt::format("holds data of {} that are no base64", what));
      group = group << 6 | static_cast<std::uint32_t>(digit);
      if ((bits += 6) < 8) continue;
      bits -= 8;
      bytes += static_cast<char>(group >> bits & 0xFF);
    }
    return bytes;
  }

  static constexpr double kSingle = std::numeric_limits<float>::epsilon() / 2;
  static constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string path_;
  pugi::xml_document document_;
  pugi::xml_node file_;
};

}  // namespace

PlacedDiscs read_vtp(const std::string& content, const std::string& path) {
  return Reader(content, path).read();
}

}  // namespace adit::dem
