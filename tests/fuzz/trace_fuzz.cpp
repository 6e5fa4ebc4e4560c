// libFuzzer target: any grid file of a geometry throws Error, or the scene can be traced through it. The grid
// is bound to a scene of four primitives. Seeds: the grids of grid_fuzz.
#include "tests/fuzz/repaired.h"
#include "tests/tiny_scene.h"
#include "tests/tracing_probe.h"

namespace {

struct TinyScene {
  masu::MemoryFile memory;
  masu::Hash geometry = masu::write_scene(masu::tiny_scene(), masu::Store::float32, memory.path());
  masu::SceneFile file{memory.path()};
};

} // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
  return masu::mutated<masu::fb::Structure>(data, size, max_size, seed, masu::structure_file_kind);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const TinyScene scene;
  static const masu::ReusedFile memory;
  const masu::Geometry geometry{scene.geometry, masu::tiny_scene_primitives};
  try {
    const masu::StructureFile grid(
        memory.with(masu::repaired<masu::fb::Structure>({data, size}, masu::structure_file_kind, &geometry)));
    if (grid.references().size() < 1 << 16) masu::trace_a_little(scene.file, &grid); // or it takes seconds
  } catch (const masu::Error&) {
  }
  return 0;
}
