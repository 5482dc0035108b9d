// SPDX-License-Identifier: GPL-3.0-or-later
// An experiment on a model that an earlier run finished with the same program, options and model is not run again.
#pragma once

#include <chrono>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "experiments/resume/fields.hpp"
#include "experiments/resume/run_folder.hpp"

namespace refitlab {

template <class T>
concept HasFields = requires(T& value) {
  fields(value);
};

template <HasFields T>
void to_json(nlohmann::json& json, const T& value) {
  json = nlohmann::json::array();
  const auto add = [&](const auto&... field) { (json.push_back(nlohmann::json(field)), ...); };
  std::apply(add, fields(const_cast<T&>(value)));  // which are only read
}

template <HasFields T>
void from_json(const nlohmann::json& json, T& value) {
  std::size_t i = 0;
  std::apply([&](auto&... field) { (json.at(i++).get_to(field), ...); }, fields(value));
}

// Units are those of a run. As each begins, it says how many are left.
class Units {
 public:
  Units(const RunFolder& folder, std::size_t total) : folder(folder), total_(total) {}
  void begin(const std::string& unit) {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    std::cout << "== " << unit << " (" << ++begun_ << " of " << total_ << " parts; " << std::lround(passed.count())
              << " s so far)" << std::endl;
  }
  const RunFolder& folder;

 private:
  std::size_t total_, begun_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// Returns the result of make(), or of the run that made it before. options are the settings of the experiment. of identifies what
// else the result is made of, such as a model (identify()) or another program; it may be empty.
template <class Make, class Options>
auto resumed_or(Units& run, const std::string& unit, const Options& options, const std::string& of, const Make& make) {
  using Result = decltype(make());
  run.begin(unit);
  const std::string inputs = nlohmann::json(options).dump() + (of.empty() ? "" : ", of " + of);
  if (const auto kept = run.folder.find(unit, inputs)) {
    std::cout << "resumed: " << unit << " was finished before" << std::endl;
    return nlohmann::json::from_cbor(*kept).get<Result>();
  }
  Result result = make();
  std::string bytes;
  nlohmann::json::to_cbor(nlohmann::json(result), bytes);  // unlike text it has numbers that are not finite
  run.folder.keep(unit, inputs, bytes);
  return result;
}

// Returns a fingerprint of everything that a model has. Clips are taken at 4096 times each (all frames of a minute at 60 a
// second). Poses that are not rigid count as affine ones.
std::string identify(const Model& model);

}  // namespace refitlab
