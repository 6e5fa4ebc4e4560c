// JSON of text from outside, and what libscene/base/printable.h has of it.
#pragma once

#include "libscene/base/printable.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace masu {

// JSON text of strings that can hold any bytes: what isn't UTF-8 becomes U+FFFD, and control characters are
// escaped, those from U+007F to U+009F too. Compiled once, for the code that prints JSON is long.
std::string json_text(const nlohmann::ordered_json& json, int indent = 2);

} // namespace masu
