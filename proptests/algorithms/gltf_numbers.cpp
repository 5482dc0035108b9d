// SPDX-License-Identifier: GPL-3.0-or-later
// Tests accessors of every kind, which are written byte by byte, from integers and from the bits of floats. What is read has to
// be what glTF says of these.
#include "algorithms/model/gltf_numbers.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <tuple>

#include "algorithms/model/model.hpp"
#include "proptests/gen/any_place.hpp"
#include "proptests/gen/gltf_builder.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_gltf_numbers {
namespace {

using namespace refitlab;

// A code is an integer of the component type, or the bits of a float.
struct Component {
  int type;
  std::size_t size;
  std::int64_t least, greatest;  // These are the limits of its codes.
  bool may_be_normalized;        // by glTF 2.0, 3.6.2.2
};
constexpr Component components[] = {{gen::gltf_byte, 1, -128, 127, true},      {gen::gltf_ubyte, 1, 0, 255, true},
                                    {gen::gltf_short, 2, -32768, 32767, true}, {gen::gltf_ushort, 2, 0, 65535, true},
                                    {gen::gltf_uint, 4, 0, 4294967295, false}, {gen::gltf_float, 4, 0, 4294967295, false}};
constexpr Component index_components[] = {components[1], components[3], components[4]};

struct Type {
  const char* name;
  int type;
  std::size_t width;
};
constexpr Type types[] = {{"SCALAR", TINYGLTF_TYPE_SCALAR, 1},
                          {"VEC2", TINYGLTF_TYPE_VEC2, 2},
                          {"VEC3", TINYGLTF_TYPE_VEC3, 3},
                          {"VEC4", TINYGLTF_TYPE_VEC4, 4},
                          {"MAT4", TINYGLTF_TYPE_MAT4, 16}};

std::string written(std::int64_t code, std::size_t size) {
  std::string out;
  for (std::size_t i = 0; i < size; ++i) out += static_cast<char>(static_cast<std::uint64_t>(code) >> 8 * i & 255);
  return out;
}

double meaning(std::int64_t code, const Component& component, bool normalized) {
  if (component.type == gen::gltf_float) return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(code)));
  const auto value = static_cast<double>(code);
  return normalized ? std::max(value / static_cast<double>(component.greatest), -1.0) : value;
}

// Says where rows lie: in a view behind other bytes, with others behind them. The view itself begins somewhere in the buffer. A
// stride of 0 is none.
struct Place {
  std::size_t view_offset = 0, offset = 0, behind = 0, stride = 0;
};

Place drawn_place() {
  const auto length = [] {
    return *rc::gen::weightedOneOf<std::size_t>({{1, rc::gen::just<std::size_t>(0)}, {2, rc::gen::inRange<std::size_t>(0, 13)}});
  };
  return {length(), length(), length(), 0};
}

struct Sparse {
  Component index;
  Place indices, values;
  std::vector<std::int64_t> rows;  // in order
};

struct Written {
  Component component;
  Type type;
  bool normalized, is_dense, is_sparse;
  std::size_t rows;
  Place place;
  Sparse sparse;
  std::vector<std::int64_t> codes, sparse_codes;  // row by row
};

// Draws a code from a generator, since there may be too many numbers to draw them one by one. The ends of the range come up
// often.
std::int64_t drawn_code(const Component& c, std::mt19937_64& random) {
  const auto any = c.least + static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(c.greatest - c.least + 1));
  const std::int64_t codes[] = {c.least, c.greatest, c.least + 1, c.greatest / 2 + 1, 0, any, any, any};
  return codes[random() % std::size(codes)];
}

std::vector<std::int64_t> drawn_rows(std::size_t rows, const Component& index, std::mt19937_64& random) {
  const std::uint64_t end = std::min<std::uint64_t>(rows, static_cast<std::uint64_t>(index.greatest) + 1);
  std::set<std::int64_t> out;
  for (std::uint64_t i = 1 + random() % 5; i > 0; --i)
    out.insert(static_cast<std::int64_t>(random() % 3 == 0 ? end - 1 : random() % end));
  return {out.begin(), out.end()};
}

template <std::size_t N, class T>
T drawn_of(const T (&list)[N]) {
  return list[*gen::between<std::size_t>(0, N)];
}

// Draws what is written. Some accessors have more rows than the smaller index types have numbers.
Written drawn() {
  Written out{drawn_of(components), drawn_of(types), false, true, *rc::gen::arbitrary<bool>(), 1, drawn_place(), {}, {}, {}};
  out.normalized = out.component.may_be_normalized && *rc::gen::arbitrary<bool>();
  out.is_dense = !out.is_sparse || *rc::gen::inRange(0, 3) > 0;
  out.rows = *rc::gen::weightedOneOf<std::size_t>({{20, rc::gen::inRange<std::size_t>(1, 20)},
                                                   {4, rc::gen::inRange<std::size_t>(254, 260)},
                                                   {1, rc::gen::inRange<std::size_t>(65534, 65540)}});
  const std::size_t row = out.component.size * out.type.width;
  if (*rc::gen::arbitrary<bool>()) out.place.stride = (row + 3) / 4 * 4 + 4 * *rc::gen::inRange<std::size_t>(0, 4);
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  out.codes.assign(out.rows * out.type.width, 0);
  if (out.is_dense)
    for (std::int64_t& code : out.codes) code = drawn_code(out.component, random);
  if (!out.is_sparse) return out;
  const Component index = drawn_of(index_components);
  out.sparse = {index, drawn_place(), drawn_place(), drawn_rows(out.rows, index, random)};
  for (std::size_t i = 0; i < out.sparse.rows.size() * out.type.width; ++i)
    out.sparse_codes.push_back(drawn_code(out.component, random));
  return out;
}

std::size_t add_rows(gen::GltfBuilder& file, const std::vector<std::int64_t>& codes, std::size_t size, std::size_t width,
                     const Place& place) {
  std::string bytes(place.view_offset + place.offset, '\x5a');
  for (std::size_t i = 0; i < codes.size(); ++i) {
    if (i % width == 0 && place.stride > 0) bytes.resize(place.view_offset + place.offset + i / width * place.stride, '\x5a');
    bytes += written(codes[i], size);
  }
  bytes.append(place.behind, '\x5a');
  const std::size_t index = file.add_view(bytes.data(), bytes.size());
  nlohmann::json& view = file.json["bufferViews"][index];
  view["byteOffset"] = view["byteOffset"].get<std::size_t>() + place.view_offset;
  view["byteLength"] = view["byteLength"].get<std::size_t>() - place.view_offset;
  if (place.stride > 0) view["byteStride"] = place.stride;
  return index;
}

// Writes an accessor's rows. Fields that are left out of a file mean 0.
nlohmann::json at_rows(gen::GltfBuilder& file, const std::vector<std::int64_t>& codes, std::size_t size, std::size_t width,
                       const Place& place) {
  nlohmann::json out = {{"bufferView", add_rows(file, codes, size, width, place)}};
  if (place.offset > 0) out["byteOffset"] = place.offset;
  return out;
}

// Makes a file whose one accessor is this one.
gen::GltfBuilder file_of(const Written& of) {
  gen::GltfBuilder file;
  // A file has as many bytes as rows, even if these are zeros.
  file.add_view(std::string(of.rows, '\x5a').data(), of.rows);
  nlohmann::json accessor = nlohmann::json::object();
  if (of.is_dense) accessor = at_rows(file, of.codes, of.component.size, of.type.width, of.place);
  accessor["componentType"] = of.component.type, accessor["count"] = of.rows, accessor["type"] = of.type.name;
  if (of.normalized) accessor["normalized"] = true;
  if (of.is_sparse) {
    const Sparse& sparse = of.sparse;
    nlohmann::json indices = at_rows(file, sparse.rows, sparse.index.size, 1, sparse.indices);
    indices["componentType"] = sparse.index.type;
    accessor["sparse"] = {{"count", sparse.rows.size()},
                          {"indices", indices},
                          {"values", at_rows(file, of.sparse_codes, of.component.size, of.type.width, sparse.values)}};
  }
  file.json["accessors"].push_back(accessor);
  return file;
}

NumberTable table_of(const gen::GltfBuilder& file, int type, Numbers numbers = Numbers::any) {
  const std::string name = "file";
  const tinygltf::Model model = read_gltf(file.binary_file(), name);
  return GltfNumbers(model, name).read(0, type, numbers, "thing");
}

std::string refusal(const gen::GltfBuilder& file, int type, Numbers numbers = Numbers::any) {
  try {
    table_of(file, type, numbers);
  } catch (const ModelError& e) {
    return e.what();
  }
  return "";
}

bool is_same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

void what_is_read(Suite& t) {
  t.holds(
      "an accessor has the numbers that were written: of each component type, wherever its rows are, and whichever are sparse",
      {.cases = 1500,
       .degenerate_at_least = 0.02,
       .tags_at_least = {{"normalized and sparse", 0.05},
                         {"sparse without others", 0.05},
                         {"sparse indices behind others", 0.1}}},
      [] {
        const Written of = drawn();
        RC_CLASSIFY(of.rows == 1, "degenerate");
        RC_CLASSIFY(of.is_sparse && of.normalized, "normalized and sparse");
        RC_CLASSIFY(!of.is_dense, "sparse without others");
        RC_CLASSIFY(of.is_sparse && of.sparse.indices.offset > 0, "sparse indices behind others");
        std::vector<std::int64_t> codes = of.codes;
        for (std::size_t i = 0; i < of.sparse_codes.size(); ++i)
          codes[static_cast<std::size_t>(of.sparse.rows[i / of.type.width]) * of.type.width + i % of.type.width] =
              of.sparse_codes[i];
        const NumberTable table = table_of(file_of(of), of.type.type);
        RC_ASSERT(table.rows == of.rows && table.width == of.type.width && table.values.size() == codes.size());
        for (std::size_t row = 0; row < of.rows; ++row)
          for (std::size_t column = 0; column < of.type.width; ++column)
            RC_ASSERT(is_same(table.at(row, column), meaning(codes[row * of.type.width + column], of.component, of.normalized)));
      });
  t.example("the ends of the ranges of normalised integers are 1 and 0, or 1 and -1, which the least two stand for", {}, [] {
    const auto ends = [](int component, std::size_t size, const std::vector<std::int64_t>& codes) {
      gen::GltfBuilder file;
      add_rows(file, codes, size, 1, {});
      file.json["accessors"].push_back(
          {{"bufferView", 0}, {"componentType", component}, {"count", codes.size()}, {"type", "SCALAR"}, {"normalized", true}});
      return table_of(file, TINYGLTF_TYPE_SCALAR, Numbers::floats_or_normalized).values;
    };
    using List = std::vector<double>;
    return Checked(ends(gen::gltf_byte, 1, {-128, -127, 0, 127}) == List{-1, -1, 0, 1} &&
                       ends(gen::gltf_short, 2, {-32768, -32767, 0, 32767}) == List{-1, -1, 0, 1} &&
                       ends(gen::gltf_ubyte, 1, {0, 51, 255}) == List{0, 0.2, 1} &&
                       ends(gen::gltf_ushort, 2, {0, 13107, 65535}) == List{0, 0.2, 1},
                   14);
  });
}

void what_is_refused(Suite& t) {
  t.holds("an accessor, its sparse indices or their values in a view that is a byte too short are refused",
          {.cases = 500, .tags_at_least = {{"values", 0.2}, {"sparse indices", 0.1}, {"sparse values", 0.1}}}, [] {
            Written of = drawn();
            const int drawn_part = *gen::between(of.is_dense ? 0 : 1, 3), part = of.is_sparse ? drawn_part : 0;
            RC_TAG(part == 0 ? "values" : part == 1 ? "sparse indices" : "sparse values");
            (part == 0 ? of.place : part == 1 ? of.sparse.indices : of.sparse.values).behind = 0;
            gen::GltfBuilder file = file_of(of);
            nlohmann::json& accessor = file.json["accessors"][0];
            const nlohmann::json& cut = part == 0   ? accessor
                                        : part == 1 ? accessor["sparse"]["indices"]
                                                    : accessor["sparse"]["values"];
            nlohmann::json& length = file.json["bufferViews"][cut["bufferView"].get<std::size_t>()]["byteLength"];
            RC_ASSERT(refusal(file, of.type.type).empty());
            length = length.get<std::size_t>() - 1;
            RC_ASSERT(refusal(file, of.type.type) == "file: thing, accessor 0: reaches past the end of its buffer view");
          });
  t.holds("sparse indices that are the count or more, or do not grow, are refused", {.cases = 500, .degenerate_at_least = 0.1},
          [] {
            Written of = drawn();
            RC_PRE(of.is_sparse);
            std::vector<std::int64_t> wrong = {of.sparse.rows.back()};  // The wrong list has that index once more.
            const auto rows = static_cast<std::int64_t>(of.rows);
            if (of.sparse.rows.back() > 0) wrong.push_back(of.sparse.rows.back() - 1);
            for (const std::int64_t index :
                 {rows, rows + 1, std::int64_t{0x7fffffff}, std::int64_t{0x80000000}, of.sparse.index.greatest})
              if (index >= rows && index <= of.sparse.index.greatest) wrong.push_back(index);
            of.sparse.rows.push_back(*rc::gen::elementOf(wrong));
            RC_CLASSIFY(of.sparse.rows.back() >= rows, "degenerate");
            for (std::size_t column = 0; column < of.type.width; ++column) of.sparse_codes.push_back(0);
            RC_ASSERT(refusal(file_of(of), of.type.type) ==
                      "file: thing, accessor 0: has sparse indices that are out of range or order");
          });
  t.example("a kind of numbers is of the component types that have it, normalised or not, and of no others", {}, [] {
    std::string wrong;
    long cases = 0;
    for (const Component& component : components)
      for (const bool normalized : {false, true}) {
        gen::GltfBuilder file;
        add_rows(file, {0, 0}, component.size, 1, {});
        file.json["accessors"].push_back(
            {{"bufferView", 0}, {"componentType", component.type}, {"count", 2}, {"type", "SCALAR"}, {"normalized", normalized}});
        const bool is_float = component.type == gen::gltf_float, is_natural = !is_float && component.least == 0;
        const std::tuple<Numbers, bool, const char*> kinds[] = {
            {Numbers::any, true, ""},
            {Numbers::floats, is_float, "floats"},
            {Numbers::floats_or_normalized, is_float || normalized, "floats or normalised integers"},
            {Numbers::unsigned_integers, is_natural && !normalized, "unsigned integers"}};
        for (const auto& [numbers, is_right, name] : kinds) {
          const std::string found = refusal(file, TINYGLTF_TYPE_SCALAR, numbers),
                            expected = is_right ? "" : std::string("file: thing, accessor 0: is not of ") + name;
          ++cases;
          if (found != expected) wrong += std::to_string(component.type) + ": '" + found + "', not '" + expected + "'; ";
        }
      }
    return Checked(wrong.empty(), cases, wrong);
  });
}

}  // namespace

PROPTEST(gltf_numbers) {
  what_is_read(t);
  what_is_refused(t);
}

}  // namespace proptests::suite_gltf_numbers
