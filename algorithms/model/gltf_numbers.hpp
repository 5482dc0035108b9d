// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers that accessors of a glTF file name, in double: from a buffer or sparse or both, normalised or not.
#pragma once

#include <string>
#include <vector>

#include "algorithms/model/gltf_file.hpp"

namespace refitlab {

// Rows of as many numbers as the accessor's type has: 3 of a VEC3, 16 of a MAT4 (column by column).
struct NumberTable {
  std::size_t rows = 0, width = 1;
  std::vector<double> values;
  double at(std::size_t row, std::size_t column) const { return values[row * width + column]; }
};

// What the numbers of an accessor may be.
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

  // type: of tinygltf, such as TINYGLTF_TYPE_VEC3. thing: for errors.
  // Throws ModelError that names the file, the thing, the accessor and the reason: an accessor, buffer view or buffer that
  // there is not, what reaches past its end, another type than these, sparse indices that are out of range or order.
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
