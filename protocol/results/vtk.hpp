// Fields as files that ParaView and VTK open: VTU for zones, VTP for particles, cells and bonds, one PVD that
// names them all with their times. XML with inline base64 data: little-endian, 8-byte lengths, Float64
// values to the last bit. Points and fields of two components get z = 0, because viewers know vectors of
// three components only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/messages/wire.pb.h"
#include "protocol/state/archive.hpp"

namespace adit::results {

// Whether a text may name a file, a column or an XML attribute, and leave neither the folder nor the
// attribute: letters, digits, `_` and `-`, one at least and at most `longest`.
bool is_name(std::string_view text, std::size_t longest);

// What is wrong with a piece, which comes from another program: sizes that do not fit, points that do not
// exist, names that no file and no attribute may have. Any value may be NaN.
std::optional<std::string> wrong_with(const wire::Piece& piece);

// The piece as a file: QUADS as an unstructured grid, VERTICES, LINES and POLYGONS as poly data. Throws
// std::runtime_error for what is wrong with it.
std::string vtk_document(const wire::Piece& piece);
void write_piece(const std::filesystem::path& path, const wire::Piece& piece);

// The PVD file of a folder of pieces.
class Collection {
 public:
  // Creates the folder if it is absent.
  explicit Collection(std::filesystem::path folder);

  // Lists a file of the folder at a time [s]. Throws std::runtime_error if the piece is listed at that time.
  void add(double time, const std::string& piece, const std::string& file);
  // Rewrites `fields.pvd` as a whole (atomic_file.hpp).
  void write() const;
  // What is listed enters the state of a run. One that reads lists what was listed then, and removes all
  // other files.
  void exchange(state::Archive& archive);
  const std::filesystem::path& folder() const { return folder_; }

 private:
  struct Entry {
    double time;
    std::string piece;
    std::string file;
  };
  std::filesystem::path folder_;
  std::vector<Entry> entries_;
};

// Writes every piece as `<piece>_<step, 8 digits>.vtu|vtp` into the collection's folder, then the PVD.
void write_snapshot(std::uint64_t step, double time, const wire::Snapshot& snapshot, Collection& collection);

}  // namespace adit::results
