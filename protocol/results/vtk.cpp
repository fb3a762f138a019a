#include "protocol/results/vtk.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdio>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "protocol/results/atomic_file.hpp"
#include "protocol/results/disk/growing_file.hpp"
#include "protocol/text.hpp"

namespace adit::results {
namespace {

static_assert(std::endian::native == std::endian::little, "the files state little-endian values");

// VTK's names for the shapes of a piece.
struct Format {
  std::size_t points_per_cell;  // 0: as the piece's corners say
  std::string_view dataset;     // the element that holds the data
  std::string_view cells;       // the element that holds the connectivity
  std::string_view cell_count;
  std::string_view ending;
};

constexpr Format kVertices{1, "PolyData", "Verts", "NumberOfVerts", ".vtp"};
constexpr Format kLines{2, "PolyData", "Lines", "NumberOfLines", ".vtp"};
constexpr Format kQuads{4, "UnstructuredGrid", "Cells", "NumberOfCells", ".vtu"};
constexpr Format kPolygons{0, "PolyData", "Polys", "NumberOfPolys", ".vtp"};
constexpr std::uint8_t kVtkQuad = 9;

[[noreturn]] void refuse(const wire::Piece& piece, const std::string& reason) {
  throw std::runtime_error("piece " + protocol::quote(piece.name()) + ": " + reason);
}

const Format& format_of(const wire::Piece& piece) {
  switch (piece.shape()) {
    case wire::Piece::VERTICES:
      return kVertices;
    case wire::Piece::LINES:
      return kLines;
    case wire::Piece::QUADS:
      return kQuads;
    case wire::Piece::POLYGONS:
      return kPolygons;
    default:
      refuse(piece, "its shape is none of vertices, lines, quads and polygons");
  }
}

std::size_t cells_of(const wire::Piece& piece, const Format& format) {
  return static_cast<std::size_t>(format.points_per_cell > 0
                                      ? piece.connectivity_size() / static_cast<int>(format.points_per_cell)
                                      : piece.corners_size());
}

constexpr std::size_t kLongestName = 200;  // the name of a file has room for 255

void check_fields(const wire::Piece& piece, const google::protobuf::RepeatedPtrField<wire::Field>& fields,
                  std::size_t count, const std::string& owners) {
  std::set<std::string_view> names;
  for (const wire::Field& field : fields) {
    if (!is_name(field.name(), kLongestName))
      refuse(piece, "a field's name is not of letters, digits, _ and -, or too long");
    if (!names.insert(field.name()).second) refuse(piece, "two fields are named " + field.name());
    const std::size_t values = field.values_size();
    if (field.components() == 0 || values != field.components() * count) {
      refuse(piece, "field " + field.name() + " has " + std::to_string(values) + " values, expected " +
                        std::to_string(field.components()) + " for each of " + std::to_string(count) + " " +
                        owners);
    }
  }
}

void check_sizes(const wire::Piece& piece, const Format& format) {
  const std::size_t named = piece.connectivity_size(), each = format.points_per_cell;
  if (each > 0 && named % each != 0)
    refuse(piece, "its connectivity has " + std::to_string(named) + " point numbers, expected " +
                      std::to_string(each) + " a cell");
  if (each > 0) return;
  std::uint64_t corners = 0;
  for (const std::uint32_t of_one : piece.corners()) {
    if (of_one < 3)
      refuse(piece, "a polygon has " + std::to_string(of_one) + " corners, expected 3 at least");
    corners += of_one;
  }
  if (corners != named)
    refuse(piece, "its connectivity has " + std::to_string(named) + " point numbers, but its polygons have " +
                      std::to_string(corners) + " corners");
}

void check(const wire::Piece& piece, const Format& format) {
  if (!is_name(piece.name(), kLongestName)) {
    throw std::runtime_error("a piece's name is not of letters, digits, _ and -, or too long");
  }
  if (piece.points_size() % 2 != 0) refuse(piece, "its points are not pairs of x and y");
  const std::size_t points = piece.points_size() / 2;
  check_sizes(piece, format);
  for (const std::uint32_t point : piece.connectivity()) {
    if (point >= points) {
      refuse(piece, "a cell names point " + std::to_string(point) + ", but there are " +
                        std::to_string(points) + ", counted from 0");
    }
  }
  check_fields(piece, piece.point_fields(), points, "points");
  check_fields(piece, piece.cell_fields(), cells_of(piece, format), "cells");
}

// A document on its way: it is handed on in pieces, because that of a large model would fill the memory.
class Document {
 public:
  using Sink = std::function<void(std::string_view)>;
  explicit Document(const Sink& sink) : sink_(sink) {}

  Document& operator<<(std::string_view text) {
    waiting_ += text;
    if (waiting_.size() >= kGathered) end();
    return *this;
  }
  void end() {
    sink_(waiting_);
    waiting_.clear();
  }

 private:
  static constexpr std::size_t kGathered = std::size_t{1} << 20;
  const Sink& sink_;
  std::string waiting_;
};

void append_base64(Document& out, std::span<const std::byte> bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t used = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < used; ++k)
      group |= std::to_integer<std::uint32_t>(bytes[i + k]) << (16 - 8 * k);
    for (std::size_t k = 0; k < 4; ++k) text += k <= used ? digits[(group >> (18 - 6 * k)) & 63] : '=';
  }
  out << text;
}

template <class T>
constexpr std::string_view kVtkType;
template <>
constexpr std::string_view kVtkType<double> = "Float64";
template <>
constexpr std::string_view kVtkType<std::int64_t> = "Int64";
template <>
constexpr std::string_view kVtkType<std::uint8_t> = "UInt8";

// One <DataArray>: the length in bytes and the values, value(0) to value(count - 1), in one base64 stream.
template <class T, class Value>
void append_array(Document& out, std::string_view name, std::size_t components, std::size_t count,
                  const Value& value) {
  out << "<DataArray type=\"" << kVtkType<T> << "\" Name=\"" << name << "\" NumberOfComponents=\""
      << std::to_string(components) << "\" format=\"binary\">";
  constexpr std::size_t kBlock = 3 * 4096;  // bytes: groups of three
  std::vector<std::byte> waiting;
  waiting.reserve(kBlock + sizeof(std::uint64_t));
  const auto add = [&waiting](const auto& number) {
    const auto bytes = std::as_bytes(std::span(&number, 1));
    waiting.insert(waiting.end(), bytes.begin(), bytes.end());
  };
  add(static_cast<std::uint64_t>(count * sizeof(T)));
  for (std::size_t i = 0; i < count; ++i) {
    add(static_cast<T>(value(i)));
    if (waiting.size() < kBlock) continue;
    append_base64(out, std::span(waiting).first(kBlock));
    waiting.erase(waiting.begin(), waiting.begin() + kBlock);
  }
  append_base64(out, waiting);
  out << "</DataArray>\n";
}

// Pairs of numbers as points in space.
void append_in_space(Document& out, std::string_view name,
                     const google::protobuf::RepeatedField<double>& pairs) {
  append_array<double>(out, name, 3, static_cast<std::size_t>(pairs.size()) / 2 * 3, [&](std::size_t i) {
    return i % 3 == 2 ? 0.0 : pairs[static_cast<int>(i / 3 * 2 + i % 3)];
  });
}

void append_fields(Document& out, std::string_view element,
                   const google::protobuf::RepeatedPtrField<wire::Field>& fields) {
  out << "<" << element << ">\n";
  for (const wire::Field& field : fields) {
    const auto& values = field.values();
    if (field.components() == 2)
      append_in_space(out, field.name(), values);
    else
      append_array<double>(out, field.name(), field.components(), static_cast<std::size_t>(values.size()),
                           [&](std::size_t i) { return values[static_cast<int>(i)]; });
  }
  out << "</" << element << ">\n";
}

void append_cells(Document& out, const wire::Piece& piece, const Format& format) {
  const std::size_t cells = cells_of(piece, format);
  out << "<" << format.cells << ">\n";
  append_array<std::int64_t>(out, "connectivity", 1, static_cast<std::size_t>(piece.connectivity_size()),
                             [&](std::size_t i) { return piece.connectivity(static_cast<int>(i)); });
  std::size_t end = 0;
  append_array<std::int64_t>(out, "offsets", 1, cells, [&](std::size_t cell) {
    return end += format.points_per_cell > 0 ? format.points_per_cell : piece.corners(static_cast<int>(cell));
  });
  if (piece.shape() == wire::Piece::QUADS)
    append_array<std::uint8_t>(out, "types", 1, cells, [](std::size_t) { return kVtkQuad; });
  out << "</" << format.cells << ">\n";
}

std::string document_start(std::string_view type) {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + std::string(type) +
         "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<" + std::string(type) +
         ">\n";
}

std::string document_end(std::string_view type) {
  return "</" + std::string(type) + ">\n</VTKFile>\n";
}

void write_document(const wire::Piece& piece, const Document::Sink& sink) {
  // What follows relies on the sizes, so they are checked first.
  const Format& format = format_of(piece);
  check(piece, format);
  Document out(sink);
  out << document_start(format.dataset) << "<Piece NumberOfPoints=\""
      << std::to_string(piece.points_size() / 2) << "\" " << format.cell_count << "=\""
      << std::to_string(cells_of(piece, format)) << "\">\n";
  append_fields(out, "PointData", piece.point_fields());
  append_fields(out, "CellData", piece.cell_fields());
  out << "<Points>\n";
  append_in_space(out, "points", piece.points());
  out << "</Points>\n";
  append_cells(out, piece, format);
  out << "</Piece>\n" << document_end(format.dataset);
  out.end();
}

}  // namespace

bool is_name(std::string_view text, std::size_t longest) {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  return !text.empty() && text.size() <= longest && std::ranges::all_of(text, allowed);
}

std::optional<std::string> wrong_with(const wire::Piece& piece) {
  try {
    check(piece, format_of(piece));
    return std::nullopt;
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

std::string vtk_document(const wire::Piece& piece) {
  std::string document;
  write_document(piece, [&document](std::string_view text) { document += text; });
  return document;
}

void write_piece(const std::filesystem::path& path, const wire::Piece& piece) {
  replace_file(path, [&piece](GrowingFile& file) {
    write_document(piece, [&file](std::string_view text) { file.append(text); });
  });
}

Collection::Collection(std::filesystem::path folder) : folder_(std::move(folder)) {
  std::filesystem::create_directories(folder_);
}

void Collection::add(double time, const std::string& piece, const std::string& file) {
  for (const Entry& entry : entries_) {
    if (entry.time == time && entry.piece == piece) {
      throw std::runtime_error("two pieces are named \"" + piece + "\" at " + protocol::shortest(time) +
                               " s");
    }
  }
  entries_.push_back({time, piece, file});
}

void Collection::write() const {
  std::string out = document_start("Collection");
  std::map<std::string, std::size_t>
      parts;  // a number for each piece, by which viewers show the parts of one time together
  for (const Entry& entry : entries_) {
    const std::size_t part = parts.emplace(entry.piece, parts.size()).first->second;
    out += "<DataSet timestep=\"" + protocol::shortest(entry.time) + "\" part=\"" + std::to_string(part) +
           "\" name=\"" + entry.piece + "\" file=\"" + entry.file + "\"/>\n";
  }
  out += document_end("Collection");
  replace_file(folder_ / "fields.pvd", out);
}

void Collection::exchange(state::Archive& archive) {
  std::uint64_t count = entries_.size();
  archive("fields_count", count);
  if (archive.reads()) entries_.clear();
  for (std::uint64_t k = 0; k < count; ++k) {
    if (archive.reads()) entries_.emplace_back();
    archive("fields_time", entries_[k].time);
    archive("fields_piece", entries_[k].piece);
    archive("fields_file", entries_[k].file);
  }
  if (!archive.reads()) return;
  std::set<std::string> listed{"fields.pvd"};
  for (const Entry& entry : entries_) listed.insert(entry.file);
  for (const auto& found : std::filesystem::directory_iterator(folder_))
    if (!listed.contains(found.path().filename())) std::filesystem::remove_all(found.path());
  if (entries_.empty())
    std::filesystem::remove(folder_ / "fields.pvd");
  else
    write();
}

void write_snapshot(std::uint64_t step, double time, const wire::Snapshot& snapshot, Collection& collection) {
  std::array<char, 24> digits{};
  // Leading zeros keep the files in the order of time wherever names are sorted.
  std::snprintf(digits.data(), digits.size(), "%08llu", static_cast<unsigned long long>(step));
  for (const wire::Piece& piece : snapshot.pieces()) {
    const std::string file = piece.name() + "_" + digits.data() + std::string(format_of(piece).ending);
    write_piece(collection.folder() / file, piece);
    collection.add(time, piece.name(), file);
  }
  // The list comes last, so that it never names a file that does not exist yet.
  collection.write();
}

}  // namespace adit::results
