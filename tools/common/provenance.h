// Where results come from: what every JSON says of the program that wrote it.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace masu {

// The program's name and arguments.
std::vector<std::string> command_line();

nlohmann::ordered_json program_version();
nlohmann::ordered_json provenance();

// Rows, each with the version and the commit.
nlohmann::ordered_json with_version(nlohmann::ordered_json rows);

// Measurements, one object or rows of them, each with that, the command and the device.
nlohmann::ordered_json with_provenance(nlohmann::ordered_json measured, const std::string& device);

} // namespace masu
