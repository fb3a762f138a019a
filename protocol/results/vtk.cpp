#include "protocol/results/vtk.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdio>
#include <map>
#include <set>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "protocol/results/atomic_file.hpp"
#include "protocol/text.hpp"

namespace adit::results {
namespace {

static_assert(std::endian::native == std::endian::little, "the files state little-endian values");

// VTK's names for the shapes of a piece.
struct Format {
  std::size_t points_per_cell;
  std::string_view dataset;  // the element that holds the data
  std::string_view cells;    // the element that holds the connectivity
  std::string_view cell_count;
  std::string_view ending;
};

constexpr Format kVertices{1, "PolyData", "Verts", "NumberOfVerts", ".vtp"};
constexpr Format kLines{2, "PolyData", "Lines", "NumberOfLines", ".vtp"};
constexpr Format kQuads{4, "UnstructuredGrid", "Cells", "NumberOfCells", ".vtu"};
constexpr std::uint8_t kVtkQuad = 9;

[[noreturn]] void refuse(const wire::Piece& piece, const std::string& reason) {
  throw std::runtime_error("piece \"" + piece.name() + "\": " + reason);
}

const Format& format_of(const wire::Piece& piece) {
  switch (piece.shape()) {
    case wire::Piece::VERTICES:
      return kVertices;
    case wire::Piece::LINES:
      return kLines;
    case wire::Piece::QUADS:
      return kQuads;
    default:
      refuse(piece, "its shape is none of vertices, lines and quads");
  }
}

// Names become file names and XML attributes, so they may not leave the folder or the attribute.
bool is_name(std::string_view text) {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  return !text.empty() && text.size() <= 64 && std::all_of(text.begin(), text.end(), allowed);
}

void check_fields(const wire::Piece& piece, const google::protobuf::RepeatedPtrField<wire::Field>& fields,
                  std::size_t count, const std::string& owners) {
  std::set<std::string_view> names;
  for (const wire::Field& field : fields) {
    if (!is_name(field.name())) refuse(piece, "a field's name is not 1 to 64 letters, digits, _ or -");
    if (!names.insert(field.name()).second) refuse(piece, "two fields are named " + field.name());
    const std::size_t values = field.values_size();
    if (field.components() == 0 || values != field.components() * count) {
      refuse(piece, "field " + field.name() + " has " + std::to_string(values) + " values, expected " +
                        std::to_string(field.components()) + " for each of " + std::to_string(count) + " " +
                        owners);
    }
  }
}

void check(const wire::Piece& piece, const Format& format) {
  if (!is_name(piece.name())) {
    throw std::runtime_error("a piece's name is not 1 to 64 letters, digits, _ or -");
  }
  if (piece.points_size() % 2 != 0) refuse(piece, "its points are not pairs of x and y");
  const std::size_t points = piece.points_size() / 2;
  const std::size_t corners = piece.connectivity_size();
  if (corners % format.points_per_cell != 0) {
    refuse(piece, "its connectivity has " + std::to_string(corners) + " point numbers, expected " +
                      std::to_string(format.points_per_cell) + " a cell");
  }
  for (const std::uint32_t point : piece.connectivity()) {
    if (point >= points) {
      refuse(piece, "a cell names point " + std::to_string(point) + ", but there are " +
                        std::to_string(points) + ", counted from 0");
    }
  }
  check_fields(piece, piece.point_fields(), points, "points");
  check_fields(piece, piece.cell_fields(), corners / format.points_per_cell, "cells");
}

void append_base64(std::string& out, std::span<const std::byte> bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  out.reserve(out.size() + (bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t used = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < used; ++k)
      group |= std::to_integer<std::uint32_t>(bytes[i + k]) << (16 - 8 * k);
    for (std::size_t k = 0; k < 4; ++k) out += k <= used ? digits[(group >> (18 - 6 * k)) & 63] : '=';
  }
}

template <class T>
constexpr std::string_view kVtkType;
template <>
constexpr std::string_view kVtkType<double> = "Float64";
template <>
constexpr std::string_view kVtkType<std::int64_t> = "Int64";
template <>
constexpr std::string_view kVtkType<std::uint8_t> = "UInt8";

// One <DataArray>: the length in bytes and the values, in one base64 stream.
template <class T>
void append_array(std::string& out, std::string_view name, std::size_t components,
                  const std::vector<T>& values) {
  const std::span<const std::byte> data = std::as_bytes(std::span(values));
  const std::array<std::uint64_t, 1> length{data.size()};
  const auto header = std::as_bytes(std::span(length));
  std::vector<std::byte> stream(header.begin(), header.end());
  stream.insert(stream.end(), data.begin(), data.end());

  out.append("<DataArray type=\"").append(kVtkType<T>).append("\" Name=\"").append(name);
  out.append("\" NumberOfComponents=\"").append(std::to_string(components)).append("\" format=\"binary\">");
  append_base64(out, stream);
  out += "</DataArray>\n";
}

std::vector<double> in_space(const google::protobuf::RepeatedField<double>& pairs) {
  std::vector<double> triples;
  triples.reserve(static_cast<std::size_t>(pairs.size()) / 2 * 3);
  for (int i = 0; i + 1 < pairs.size(); i += 2) triples.insert(triples.end(), {pairs[i], pairs[i + 1], 0.0});
  return triples;
}

void append_fields(std::string& out, std::string_view element,
                   const google::protobuf::RepeatedPtrField<wire::Field>& fields) {
  out.append("<").append(element).append(">\n");
  for (const wire::Field& field : fields) {
    if (field.components() == 2) {
      append_array(out, field.name(), 3, in_space(field.values()));
    } else {
      append_array(out, field.name(), field.components(),
                   std::vector<double>(field.values().begin(), field.values().end()));
    }
  }
  out.append("</").append(element).append(">\n");
}

void append_cells(std::string& out, const wire::Piece& piece, const Format& format) {
  const std::vector<std::int64_t> corners(piece.connectivity().begin(), piece.connectivity().end());
  std::vector<std::int64_t> ends(corners.size() / format.points_per_cell);
  for (std::size_t cell = 0; cell < ends.size(); ++cell) {
    ends[cell] = static_cast<std::int64_t>((cell + 1) * format.points_per_cell);
  }
  out.append("<").append(format.cells).append(">\n");
  append_array(out, "connectivity", 1, corners);
  append_array(out, "offsets", 1, ends);
  if (piece.shape() == wire::Piece::QUADS) {
    append_array(out, "types", 1, std::vector<std::uint8_t>(ends.size(), kVtkQuad));
  }
  out.append("</").append(format.cells).append(">\n");
}

std::string document_start(std::string_view type) {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + std::string(type) +
         "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<" + std::string(type) +
         ">\n";
}

std::string document_end(std::string_view type) {
  return "</" + std::string(type) + ">\n</VTKFile>\n";
}

}  // namespace

std::string vtk_document(const wire::Piece& piece) {
  // What follows relies on the sizes, so they are checked first.
  const Format& format = format_of(piece);
  check(piece, format);
  const std::size_t cells = piece.connectivity_size() / format.points_per_cell;

  std::string out = document_start(format.dataset);
  out.append("<Piece NumberOfPoints=\"").append(std::to_string(piece.points_size() / 2)).append("\" ");
  out.append(format.cell_count).append("=\"").append(std::to_string(cells)).append("\">\n");
  append_fields(out, "PointData", piece.point_fields());
  append_fields(out, "CellData", piece.cell_fields());
  out += "<Points>\n";
  append_array(out, "points", 3, in_space(piece.points()));
  out += "</Points>\n";
  append_cells(out, piece, format);
  out += "</Piece>\n";
  out += document_end(format.dataset);
  return out;
}

void write_piece(const std::filesystem::path& path, const wire::Piece& piece) {
  replace_file(path, vtk_document(piece));
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
