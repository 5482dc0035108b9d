// SPDX-License-Identifier: GPL-3.0-or-later
// Declares fuzz targets: what is tried on any bytes whatever. Each has a file, named as its target:
//
//   FUZZ_TARGET(case_file, bytes) { ... }
//
// A target returns for bytes that are good and for those that are refused as they should be. Anything else that happens is a
// finding: an exception that gets out, a broken promise (check), a sanitizer's complaint, no end. Compiled with REFITLAB_FUZZER a
// file is a libFuzzer program (proptests/fuzz/run). Otherwise it registers itself, and the test suite `fuzz` tries the corpus,
// and whatever was ever found, on it.
#pragma once

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>

namespace proptests::fuzz {

using Target = void (*)(const std::string& bytes);

inline std::map<std::string, Target>& targets() {
  static std::map<std::string, Target> all;
  return all;
}

struct BrokenPromise : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline void check(bool holds, const char* promise) {
  if (!holds) throw BrokenPromise(promise);
}

}  // namespace proptests::fuzz

#ifdef REFITLAB_FUZZER
#define REFITLAB_FUZZ_ENTRY(name)                                                     \
  extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) { \
    proptests::fuzz::name({reinterpret_cast<const char*>(data), size});               \
    return 0;                                                                         \
  }
#else
#define REFITLAB_FUZZ_ENTRY(name)                                          \
  namespace proptests::fuzz {                                              \
  static const bool is_registered = targets().emplace(#name, name).second; \
  }
#endif

#define FUZZ_TARGET(name, bytes)              \
  namespace proptests::fuzz {                 \
  static void name(const std::string& bytes); \
  }                                           \
  REFITLAB_FUZZ_ENTRY(name)                   \
  void proptests::fuzz::name(const std::string& bytes)
