// Where results come from: what every JSON says of the program that wrote it.
#pragma once

#include "tools/common/version.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace masu {

// The program's name and arguments.
inline std::vector<std::string> command_line() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary); // each ends with a zero
  std::vector<std::string> words;
  for (std::string word; std::getline(file, word, '\0');)
    words.push_back(std::move(word));
  return words;
}

inline nlohmann::ordered_json program_version() {
  return {{"version", version}, {"commit", commit}};
}

inline nlohmann::ordered_json provenance() {
  return {{"version", version}, {"commit", commit}, {"command", command_line()}};
}

// Rows, each with the version and the commit.
inline nlohmann::ordered_json with_version(nlohmann::ordered_json rows) {
  for (auto& row : rows)
    row.update(program_version());
  return rows;
}

// Measurements, one object or rows of them, each with that, the command and the device.
inline nlohmann::ordered_json with_provenance(nlohmann::ordered_json measured, const std::string& device) {
  nlohmann::ordered_json origin = provenance();
  origin["device"] = device;
  if (measured.is_object())
    measured.update(origin);
  else
    for (auto& row : measured)
      row.update(origin);
  return measured;
}

} // namespace masu
