// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/harness/thrown.hpp"

#include <dlfcn.h>

#include <exception>
#include <mutex>
#include <typeinfo>

namespace proptests {
namespace {

struct Record {
  std::mutex guard;
  std::string stem;
  std::map<std::string, std::set<std::string>> messages;
};

Record& record() {
  static Record the_one;
  return the_one;
}

// A property that throws in every case need not be remembered for each.
constexpr std::size_t most_messages = 20000;

void note(const std::exception& error) {
  Record& r = record();
  const std::lock_guard lock(r.guard);
  auto& messages = r.messages[r.stem];
  if (messages.size() < most_messages) messages.insert(error.what());
}

}  // namespace

void record_errors_of(const std::string& stem) {
  const std::lock_guard lock(record().guard);
  record().stem = stem;
}

std::map<std::string, std::set<std::string>> recorded_errors() {
  const std::lock_guard lock(record().guard);
  return record().messages;
}

}  // namespace proptests

// Every throw expression calls this in place of the C++ runtime's own function, which then does its work. The runtime's headers
// do not declare it for programs.
extern "C" __attribute__((noreturn)) void __cxa_throw(void* thrown, std::type_info* type, void (*destroy)(void*)) {
  using Throw = void (*)(void*, std::type_info*, void (*)(void*));
  static const auto runtime = reinterpret_cast<Throw>(dlsym(RTLD_NEXT, "__cxa_throw"));
  void* object = thrown;
  if (typeid(std::exception).__do_catch(type, &object, 1)) proptests::note(*static_cast<std::exception*>(object));
  runtime(thrown, type, destroy);
  __builtin_unreachable();
}
