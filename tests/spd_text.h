// SPD scenes as tests need them: their text, without a file.
#pragma once

#include "libscene/spd/spd.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <memory>
#include <string>

namespace masu {

inline std::string spd_text(const SpdOptions& request) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::tmpfile(), std::fclose);
  write_spd(request, file.get(), "a temporary file");
  std::string text(static_cast<std::size_t>(std::ftell(file.get())), '\0');
  std::rewind(file.get());
  EXPECT_EQ(std::fread(text.data(), 1, text.size(), file.get()), text.size());
  return text;
}

} // namespace masu
