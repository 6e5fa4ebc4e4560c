// Any bytes as a grid file: an Error, or a grid whose every index can be followed. Seeds: files that
// gridbuild makes.
#include "libgrid/grid_file.h"
#include "libgrid/statistics.h"
#include "libgrid/walk.h"
#include "libscene/error.h"
#include "tests/fuzz/memory_file.h"

namespace {

// Reads what a walk would read.
struct Visitor {
  std::span<const masu::PrimitiveIndex> references;
  std::uint64_t primitives;

  void cell(std::uint32_t first, std::uint32_t last) const {
    for (const masu::PrimitiveIndex reference : references.subspan(first, last - first)) {
      if (reference >= primitives) std::abort();
    }
  }
  void empty_cell(std::uint64_t) const {}
  template <class Real>
  bool done(Real) const {
    return false;
  }
};

template <class Real>
void walk_through(const masu::GridFile& file) {
  const masu::GridView<Real> grid = file.view<Real>();
  Visitor visitor{file.references(), file.table().primitives()};
  const Real nearly = Real(0.99);
  for (const masu::Vec3<Real>& direction :
       {masu::Vec3<Real>{1, nearly, Real(0.5)}, {-1, Real(0.001), 0}, {0, 0, 1}, {-1, -1, -1}})
    masu::walk(grid, grid.min, direction, visitor);
}

void open_and_walk(std::span<const std::uint8_t> bytes) {
  try {
    const masu::MemoryFile memory(bytes);
    const masu::GridFile file(memory.path());
    static_cast<void>(masu::grid_statistics(file.view<double>(), file.cells()));
    walk_through<float>(file);
    walk_through<double>(file);
  } catch (const masu::Error&) {
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  open_and_walk({data, size});
  open_and_walk(masu::repaired<masu::fb::Grid>({data, size}, masu::grid_file_kind));
  return 0;
}
