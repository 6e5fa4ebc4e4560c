// libFuzzer target: any bytes as a mesh that Assimp reads throw Error, or become a scene. The first byte
// selects the format. Assimp's own faults end it, too, which mesh2bin reports as an invalid file.
#include "libscene/base/error.h"
#include "libscene/mesh/import/import.h"

#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>

// Assimp leaks some of what it has read of an invalid file.
extern "C" const char* __lsan_default_suppressions() { // NOLINT(bugprone-reserved-identifier)
  return "leak:libassimp";
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  constexpr std::array formats{"gltf", "glb", "dae", "3ds", "ase", "raw"};
  const std::string path =
      "/dev/shm/masu-fuzz-" + std::to_string(getpid()) + "." + formats[data[0] / 2 % formats.size()];
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(data + 1), static_cast<std::streamsize>(size - 1));
  try {
    masu::read_mesh(path, {.smooth = data[0] % 2 != 0});
  } catch (const masu::Error&) {
  }
  unlink(path.c_str());
  return 0;
}
