// SPDX-License-Identifier: GPL-3.0-or-later
// GltfNumbers reads the numbers that accessors of a glTF file name, in double. They are from a buffer or sparse or both,
// normalised or not.
#pragma once

#include <string>
#include <vector>

#include "algorithms/model/gltf_file.hpp"

namespace refitlab {

// A row has as many numbers as the accessor's type: 3 for a VEC3, and 16 for a MAT4 (column by column).
struct NumberTable {
  std::size_t rows = 0, width = 1;
  std::vector<double> values;
  double at(std::size_t row, std::size_t column) const { return values[row * width + column]; }
};

// Numbers says what the numbers of an accessor may be.
enum class Numbers {
  floats,                // single precision
  floats_or_normalized,  // or integers that stand for fractions, by glTF 2.0, 3.6.2.2
  any,                   // or integers that stand for themselves
  unsigned_integers
};

class GltfNumbers {
 public:
  // Both must stay as long as this is used.
  GltfNumbers(const tinygltf::Model& source, const std::string& file) : source_(source), file_(file) {}

  // Reads an accessor. type is one of tinygltf, such as TINYGLTF_TYPE_VEC3. thing is for error messages. Throws ModelError that
  // names the file, the thing, the accessor and the reason. The reasons are an accessor, buffer view or buffer that does not
  // exist, one that reaches past the end of another, another type than these, and sparse indices that are out of range or order.
  NumberTable read(int accessor, int type, Numbers numbers, const std::string& thing) const;

 private:
  struct Bytes {
    const unsigned char* first;
    std::size_t stride;
  };
  Bytes bytes_of(int view, std::size_t offset, std::size_t rows, std::size_t row_size, const std::string& at) const;
  void read_rows(const Bytes& bytes, const tinygltf::Accessor& accessor, NumberTable& out) const;
  void read_sparse(const tinygltf::Accessor& accessor, const std::string& at, NumberTable& out) const;
  std::size_t total_bytes() const;

  const tinygltf::Model& source_;
  const std::string& file_;
};

}  // namespace refitlab
