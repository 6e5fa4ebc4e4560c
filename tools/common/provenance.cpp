#include "tools/common/provenance.h"

#include "tools/common/version.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <utility>

namespace masu {

std::vector<std::string> command_line() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary); // each ends with a zero
  std::vector<std::string> words;
  for (std::string word; std::getline(file, word, '\0');)
    words.push_back(std::move(word));
  return words;
}

nlohmann::ordered_json program_version() {
  return {{"version", version}, {"commit", commit}};
}

nlohmann::ordered_json provenance() {
  return {{"version", version}, {"commit", commit}, {"command", command_line()}};
}

nlohmann::ordered_json with_version(nlohmann::ordered_json rows) {
  for (auto& row : rows)
    row.update(program_version());
  return rows;
}

nlohmann::ordered_json with_provenance(nlohmann::ordered_json measured, const std::string& device) {
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
