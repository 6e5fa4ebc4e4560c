// libFuzzer target: any bytes as a scene file throw Error, or the scene can be traced. Seeds: files made by
// nff2bin.
#include "tests/fuzz/repaired.h"
#include "tests/tracing_probe.h"

namespace {

void open_and_trace(const std::string& path) {
  try {
    const masu::SceneFile scene(path);
    masu::trace_a_little(scene, nullptr);
    for (const masu::StructureKind kind : {masu::StructureKind::uniform, masu::StructureKind::balance,
                                           masu::StructureKind::irregular, masu::StructureKind::hierarchy})
      masu::build_a_little(scene, masu::Overlap::exact, kind, "/dev/null");
  } catch (const masu::Error&) {
  }
}

} // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
  return masu::mutated<masu::fb::Scene>(data, size, max_size, seed, masu::scene_file_kind);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  masu::with_repaired<masu::fb::Scene>({data, size}, masu::scene_file_kind, open_and_trace);
  return 0;
}
