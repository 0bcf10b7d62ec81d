/// Arrays for NumPy: an NPZ file, which is a ZIP of NPY files, as numpy.savez writes it.
///
/// NPY 1.0 (NumPy Enhancement Proposal 1, "A Simple File Format for NumPy Arrays"): little-endian,
/// the last index fastest. The ZIP (PKWARE's APPNOTE 6.3) is stored, not deflated: poses hardly
/// shrink. Its entries are all of 1980-01-01, so that the same arrays give the same bytes.
#pragma once

#include <cstdint>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace amble {

/// Length along each axis; {} is a single value.
using NpyShape = std::vector<size_t>;

class NpyArchive {
 public:
  /// @param name  of the array: letters, digits and `_`, given once
  /// @pre as many values as the shape says
  void add(const std::string& name, std::span<const double> values, const NpyShape& shape);
  void add(const std::string& name, std::span<const float> values, const NpyShape& shape);
  void add(const std::string& name, std::span<const int32_t> values, const NpyShape& shape);
  /// NumPy's bool_: 0 or 1.
  void addBools(const std::string& name, std::span<const uint8_t> values, const NpyShape& shape);
  /// Texts of UTF-8 as NumPy's str_; bytes that are none become U+FFFD.
  void addTexts(const std::string& name, std::span<const std::string> values,
                const NpyShape& shape);

  /// Any other file, which NumPy gives as bytes; one that is called `NAME.npy` is an array.
  /// @param name  given once
  void addFile(const std::string& name, std::string bytes);

  /// @throws std::length_error where it were 4 GB or more, which a ZIP without extensions cannot be
  void write(std::ostream& out) const;

 private:
  struct Entry {
    std::string name;  // of the file in the archive
    std::string bytes;
  };
  void addBytes(const std::string& name, std::string_view type, const NpyShape& shape,
                std::string_view values);

  std::vector<Entry> entries_;
};

}  // namespace amble
