// A text as a whole file.
#pragma once

#include "libscene/file/output_file.h"

#include <string>

namespace masu {

// - is standard output. Throws Error(output).
inline void write_text_file(const std::string& path, const std::string& text) {
  OutputFile file(path);
  file.write(text.data(), text.size());
  file.commit();
}

} // namespace masu
