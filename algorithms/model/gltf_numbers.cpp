// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/model/gltf_numbers.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>

#include "algorithms/model/model.hpp"

namespace refitlab {
namespace {

template <class T>
T loaded(const unsigned char* from) {
  T value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

template <class T>
double integer(const unsigned char* from, bool normalized) {
  const auto value = static_cast<double>(loaded<T>(from));
  return normalized ? std::max(value / std::numeric_limits<T>::max(), -1.0) : value;
}

double number(const unsigned char* from, int component, bool normalized) {
  switch (component) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: return integer<std::int8_t>(from, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return integer<std::uint8_t>(from, normalized);
    case TINYGLTF_COMPONENT_TYPE_SHORT: return integer<std::int16_t>(from, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return integer<std::uint16_t>(from, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return integer<std::uint32_t>(from, normalized);
    default: return static_cast<double>(loaded<float>(from));
  }
}

bool is_unsigned(int component) {
  return component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
         component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

bool is_of_gltf(int component) {
  return is_unsigned(component) || component == TINYGLTF_COMPONENT_TYPE_BYTE || component == TINYGLTF_COMPONENT_TYPE_SHORT ||
         component == TINYGLTF_COMPONENT_TYPE_FLOAT;
}

bool are(Numbers numbers, const tinygltf::Accessor& accessor) {
  const bool floats = accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT;
  switch (numbers) {
    case Numbers::floats: return floats;
    case Numbers::floats_or_normalized: return floats || accessor.normalized;
    case Numbers::any: return true;
    case Numbers::unsigned_integers: break;
  }
  return is_unsigned(accessor.componentType) && !accessor.normalized;
}

const char* name_of(Numbers numbers) {
  return numbers == Numbers::floats                 ? "floats"
         : numbers == Numbers::floats_or_normalized ? "floats or normalised integers"
                                                    : "unsigned integers";
}

}  // namespace

NumberTable GltfNumbers::read(int accessor, int type, Numbers numbers, const std::string& thing) const {
  const std::string at = thing + ", accessor " + std::to_string(accessor);
  if (accessor < 0 || static_cast<std::size_t>(accessor) >= source_.accessors.size())
    throw ModelError(file_, at, "there is none");
  const tinygltf::Accessor& a = source_.accessors[static_cast<std::size_t>(accessor)];
  if (!is_of_gltf(a.componentType)) throw ModelError(file_, at, "glTF has no component type " + std::to_string(a.componentType));
  if (a.type != type) throw ModelError(file_, at, "is of another type than it has to be here");
  if (!are(numbers, a)) throw ModelError(file_, at, "is not of " + std::string(name_of(numbers)));

  NumberTable out;
  out.rows = a.count;
  out.width = static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(a.type)));
  if (a.bufferView >= 0) {
    const auto size = static_cast<std::size_t>(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(a.componentType)));
    const Bytes bytes = bytes_of(a.bufferView, a.byteOffset, out.rows, out.width * size, at);
    read_rows(bytes, a, out);
  } else {
    // Zeros cost no bytes in the file, and must not cost all memory.
    if (out.rows > total_bytes()) throw ModelError(file_, at, "has more elements than there are bytes in the file");
    out.values.assign(out.rows * out.width, 0);
  }
  if (a.sparse.isSparse) read_sparse(a, at, out);
  return out;
}

GltfNumbers::Bytes GltfNumbers::bytes_of(int view, std::size_t offset, std::size_t rows, std::size_t row_size,
                                         const std::string& at) const {
  if (view < 0 || static_cast<std::size_t>(view) >= source_.bufferViews.size())
    throw ModelError(file_, at, "is in a buffer view that there is not");
  const tinygltf::BufferView& v = source_.bufferViews[static_cast<std::size_t>(view)];
  if (v.buffer < 0 || static_cast<std::size_t>(v.buffer) >= source_.buffers.size())
    throw ModelError(file_, at, "is in a buffer that there is not");
  const std::vector<unsigned char>& buffer = source_.buffers[static_cast<std::size_t>(v.buffer)].data;
  if (v.byteOffset > buffer.size() || v.byteLength > buffer.size() - v.byteOffset)
    throw ModelError(file_, at, "is in a buffer view that reaches past the end of its buffer");
  const std::size_t stride = v.byteStride > 0 ? v.byteStride : row_size;
  const std::size_t room = offset <= v.byteLength ? v.byteLength - offset : 0;
  if (rows > 0 && (row_size > room || rows - 1 > (room - row_size) / stride))
    throw ModelError(file_, at, "reaches past the end of its buffer view");
  return {buffer.data() + v.byteOffset + (rows > 0 ? offset : 0), stride};
}

void GltfNumbers::read_rows(const Bytes& bytes, const tinygltf::Accessor& accessor, NumberTable& out) const {
  const auto size =
      static_cast<std::size_t>(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType)));
  out.values.reserve(out.rows * out.width);
  for (std::size_t row = 0; row < out.rows; ++row)
    for (std::size_t column = 0; column < out.width; ++column)
      out.values.push_back(number(bytes.first + row * bytes.stride + column * size, accessor.componentType, accessor.normalized));
}

void GltfNumbers::read_sparse(const tinygltf::Accessor& accessor, const std::string& at, NumberTable& out) const {
  const auto& sparse = accessor.sparse;
  const std::size_t count = static_cast<std::size_t>(sparse.count);
  if (!is_unsigned(sparse.indices.componentType))
    throw ModelError(file_, at, "has sparse indices that are not unsigned integers");
  const auto size_of = [](int component) {
    return static_cast<std::size_t>(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(component)));
  };
  const std::size_t index_size = size_of(sparse.indices.componentType), size = size_of(accessor.componentType);
  const Bytes indices =
      bytes_of(sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset), count, index_size, at);
  const Bytes values =
      bytes_of(sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset), count, out.width * size, at);
  double last = -1;
  for (std::size_t i = 0; i < count; ++i) {
    const double row = number(indices.first + i * indices.stride, sparse.indices.componentType, false);
    if (row <= last || row >= static_cast<double>(out.rows))
      throw ModelError(file_, at, "has sparse indices that are out of range or order");
    last = row;
    for (std::size_t column = 0; column < out.width; ++column)
      out.values[static_cast<std::size_t>(row) * out.width + column] =
          number(values.first + i * values.stride + column * size, accessor.componentType, accessor.normalized);
  }
}

std::size_t GltfNumbers::total_bytes() const {
  std::size_t sum = 0;
  for (const tinygltf::Buffer& buffer : source_.buffers) sum += buffer.data.size();
  return sum;
}

}  // namespace refitlab
