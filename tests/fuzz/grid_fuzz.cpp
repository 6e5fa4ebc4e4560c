// libFuzzer target: any bytes as a grid file throw Error, or all indices are valid. Seeds: files made by
// gridbuild.
#include "libgrid/file/structure_file.h"
#include "libgrid/statistics/statistics.h"
#include "libgrid/trace/trace.h"
#include "renderer/counts.h"
#include "tests/fuzz/repaired.h"

namespace {

// Checks the primitive indices that traversal meets.
template <class Real>
struct Visitor {
  std::uint64_t primitive_count;
  masu::Ray<Real> ray;
  masu::NoCounts counts;
  masu::SceneView<Real> scene{}; // of that Real

  void primitive(masu::PrimitiveIndex index) const {
    if (index >= primitive_count) std::abort();
  }
  bool done(Real) const { return false; }
  Real farthest() const { return ray.t_max; }
  bool ends() const { return false; }
};

template <class Real, class Structure>
void traverse(const Structure& grid, const masu::StructureFile& file) {
  const Real almost_one = Real(0.99);
  for (const masu::Vec3<Real>& d :
       {masu::Vec3<Real>{1, almost_one, Real(0.5)}, {-1, Real(0.001), 0}, {0, 0, 1}, {-1, -1, -1}}) {
    const masu::ClippedRay<Real> ray{
        masu::unbounded_ray(masu::cast<Real>(file.layout().space.min), d), {1 / d.x, 1 / d.y, 1 / d.z}, 0};
    Visitor<Real> visitor{file.table().primitives(), ray.ray, {}};
    masu::visit(grid, ray, 0, visitor);
  }
}

void open_and_traverse(const std::string& path) {
  try {
    const masu::StructureFile file(path);
    if (file.is_hierarchy()) {
      static_cast<void>(masu::hierarchy_statistics(file.nodes()));
      traverse<float>(masu::hierarchy_view_of<float>(file.records()), file);
      traverse<double>(masu::hierarchy_view_of<double>(file.records()), file);
    } else if (file.is_merged()) {
      static_cast<void>(masu::grid_statistics(file.cells().size(), file.references()));
      traverse<float>(masu::merged_view_of<float>(file.records()), file);
      traverse<double>(masu::merged_view_of<double>(file.records()), file);
    } else {
      static_cast<void>(masu::grid_statistics(0, file.references()));
      traverse<float>(masu::view_of<float>(file.records()), file);
      traverse<double>(masu::view_of<double>(file.records()), file);
    }
  } catch (const masu::Error&) {
  }
}

} // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
  return masu::mutated<masu::fb::Structure>(data, size, max_size, seed, masu::structure_file_kind);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  masu::with_repaired<masu::fb::Structure>({data, size}, masu::structure_file_kind, open_and_traverse);
  return 0;
}
