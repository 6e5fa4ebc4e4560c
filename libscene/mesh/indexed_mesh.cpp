#include "libscene/mesh/indexed_mesh.h"

#include "libscene/automatic_camera.h"
#include "libscene/base/error.h"
#include "libscene/base/parallel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace masu {
namespace {

// Of a range of triangles.
struct Found {
  std::size_t wrong = none, first_surface = none;
  // Of those that have a surface.
  Boxd box = empty_box<double>();
  double least_extent = std::numeric_limits<double>::infinity();

  static constexpr std::size_t none = ~std::size_t{0};
};
Found join(const Found& a, const Found& b) {
  return {std::min(a.wrong, b.wrong), std::min(a.first_surface, b.first_surface), join(a.box, b.box),
          std::min(a.least_extent, b.least_extent)};
}

// A vertex in a register, with a number more that counts for nothing.
template <class Number>
struct VertexLanes {
  // NOLINTNEXTLINE(modernize-use-using): which takes no attribute of a template's type
  typedef Number Lanes __attribute__((vector_size(4 * sizeof(Number))));
  using Mask = decltype(Lanes() < Lanes());

  static void load(const Number* from, Lanes& to) { std::memcpy(&to, from, sizeof to); }
  static bool all(const Mask& mask) { return (mask[0] & mask[1] & mask[2]) != 0; }
};

// `vertices`: a mesh's own, and a number more behind the last; `indices`: where its own go, for vertices from
// `first_vertex` on, or null.
template <class Number>
Found taken(const IndexedMesh& mesh, const Number* vertices, std::size_t first_vertex, std::uint32_t* indices,
            std::size_t begin, std::size_t end) {
  using Of = VertexLanes<Number>;
  using Lanes = typename Of::Lanes;
  constexpr auto most =
      static_cast<Number>(std::min<double>(max_coordinate, std::numeric_limits<Number>::max()));
  constexpr auto far = std::numeric_limits<Number>::infinity();
  Found found;
  Lanes low = Lanes{} + far, high = Lanes{} - far;
  Number least_extent = far;
  for (std::size_t i = begin; i != end; ++i) {
    std::size_t corners[3];
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = mesh.indices != nullptr ? mesh.indices[3 * i + k] : 3 * i + k;
      if (indices != nullptr) indices[3 * i + k] = static_cast<std::uint32_t>(first_vertex + corners[k]);
    }
    if (max(corners[0], max(corners[1], corners[2])) >= mesh.vertices) return join(found, Found{i});
    Lanes a, b, c;
    Of::load(vertices + 3 * corners[0], a);
    Of::load(vertices + 3 * corners[1], b);
    Of::load(vertices + 3 * corners[2], c);
    if (!Of::all((a <= most) & (a >= -most) & (b <= most) & (b >= -most) & (c <= most) & (c >= -most)))
      return join(found, Found{i});
    const auto ab = a == b, bc = b == c, ca = c == a;
    if (Of::all(ab | bc | ca) && (Of::all(ab) || Of::all(bc) || Of::all(ca)))
      continue; // has_distinct_corners()
    if (found.first_surface == Found::none) found.first_surface = i;
    // Of equal ones the last, as of -0 and 0: so is the join of boxes.
    const Lanes ab_low = a < b ? a : b, ab_high = a > b ? a : b;
    const Lanes its_low = ab_low < c ? ab_low : c, its_high = ab_high > c ? ab_high : c;
    low = low < its_low ? low : its_low;
    high = high > its_high ? high : its_high;
    const Lanes sides = its_high - its_low;
    least_extent = min(least_extent, max(sides[0], max(sides[1], sides[2])));
  }
  if (found.first_surface != Found::none)
    found.box = cast<double>(Box<Number>{{low[0], low[1], low[2]}, {high[0], high[1], high[2]}});
  found.least_extent = static_cast<double>(least_extent);
  return found;
}

// Of all of a mesh, the number m.
template <class Number>
Found taken(const IndexedMesh& mesh, std::size_t m, const Number* vertices, std::size_t first_vertex,
            std::uint32_t* indices, const ProgressMonitor* progress) {
  const Found found = parallel_reduce(
      mesh.triangles, 4096, Found{},
      [&](std::size_t begin, std::size_t end) {
        check_progress(progress);
        return taken(mesh, vertices, first_vertex, indices, begin, end);
      },
      [](const Found& a, const Found& b) { return join(a, b); });
  if (found.wrong != Found::none)
    throw Error(ErrorCode::usage, "meshes",
                fmt::format("mesh {}: triangle {} has a vertex that there isn't, or whose coordinates "
                            "aren't finite or beyond 1e100",
                            m, found.wrong));
  return found;
}

// All meshes' numbers, one after the other, and one more.
template <class Number>
HostArray<Number> joined_numbers(std::span<const IndexedMesh> meshes, std::size_t vertices) {
  HostArray<Number> all(3 * vertices + 1);
  Number* to = all.data();
  for (const IndexedMesh& mesh : meshes) {
    const auto copy = [&](const auto* from) {
      parallel_ranges(3 * mesh.vertices, std::size_t{1} << 15, [=](std::size_t begin, std::size_t end) {
        std::transform(from + begin, from + end, to + begin,
                       [](auto number) { return static_cast<Number>(number); });
      });
    };
    if (mesh.floats != nullptr)
      copy(mesh.floats);
    else if (mesh.doubles != nullptr)
      copy(mesh.doubles);
    to += 3 * mesh.vertices;
  }
  return all;
}

Material matte(const Vec3f& color) {
  return {color, 1, 0, 0, 0, 1};
}

bool is_valid(const Sphere<double>& s) {
  return is_coordinate(s.center) && is_coordinate({s.radius, 0, 0}) && s.radius != 0;
}
bool is_valid(const Cone<double>& c) {
  return is_coordinate(c.base) && is_coordinate(c.apex) && is_coordinate({c.base_radius, c.apex_radius, 0}) &&
         !(c.base == c.apex) && (c.base_radius != 0 || c.apex_radius != 0) &&
         (c.base_radius == 0 || c.apex_radius == 0 || (c.base_radius < 0) == (c.apex_radius < 0));
}

template <class Primitive>
void add(const PrimitiveArray<Primitive>& array, std::size_t object, const char* place, ArrayScene& scene,
         GrowingArray<Primitive>& primitives, GrowingArray<Surface>& surfaces) {
  const Surface surface{static_cast<std::uint32_t>(object),
                        static_cast<std::uint32_t>(scene.materials.size())};
  scene.materials.push_back(matte(array.color));
  for (std::size_t i = 0; i < array.count; ++i) {
    primitives.push_back(array.primitive(i));
    surfaces.push_back(surface);
    if (!is_valid(primitives.back()))
      throw Error(ErrorCode::usage, place,
                  fmt::format("object {}: number {} has no surface, radii of both signs, or a number that "
                              "isn't finite or beyond 1e100",
                              object, i));
  }
}

template <class Objects, class Count>
std::size_t sum(const Objects& objects, const Count& count) {
  std::size_t all = 0;
  for (const auto& object : objects)
    all = std::min(all, max_primitives + 1) + std::min(count(object), max_primitives + 1);
  return all;
}

} // namespace

MeshTriangles::MeshTriangles(std::span<const IndexedMesh> meshes, const ProgressMonitor* progress)
    : place_(points_without_surface) {
  bool are_doubles = false, are_indexed = false;
  for (const IndexedMesh& mesh : meshes) {
    begins_.push_back(size_);
    size_ += mesh.triangles;
    vertices_.count += mesh.vertices;
    are_doubles = are_doubles || mesh.doubles != nullptr;
    are_indexed = are_indexed || mesh.indices != nullptr || mesh.vertices != 3 * mesh.triangles;
  }
  if (are_indexed && vertices_.count > std::uint64_t{1} << 32)
    throw Error(ErrorCode::usage, "meshes", "have more vertices than can be numbered");
  const auto indices = are_indexed ? std::make_shared<Indices>(3 * size_) : nullptr;
  std::size_t first_surface = Found::none;
  const auto take = [&]<class Number>(const Number* Vertices::*numbers) {
    auto all = std::make_shared<const HostArray<Number>>(joined_numbers<Number>(meshes, vertices_.count));
    vertices_.*numbers = all->data();
    std::size_t first_vertex = 0;
    for (std::size_t m = 0; m < meshes.size(); ++m) {
      const Found found = taken(meshes[m], m, all->data() + 3 * first_vertex, first_vertex,
                                are_indexed ? indices->data() + 3 * begins_[m] : nullptr, progress);
      if (found.first_surface != Found::none)
        first_surface = std::min(first_surface, begins_[m] + found.first_surface);
      box_ = join(box_, found.box);
      least_extent_ = std::min(least_extent_, found.least_extent);
      first_vertex += meshes[m].vertices;
    }
    numbers_ = std::move(all);
  };
  are_doubles ? take(&Vertices::doubles) : take(&Vertices::floats);
  if (indices) vertices_.indices = *indices;
  indices_ = indices;
  if (first_surface != Found::none) place_ = (*this)[first_surface].a;
  if (size() > 0 && is_empty(box_)) box_ = {place_, place_};
}

ArrayScene scene_of(std::span<const IndexedMesh> meshes, std::span<const SphereArray> spheres,
                    std::span<const ConeArray> cones, const ProgressMonitor* progress) {
  ArrayScene scene{};
  const auto count = [](const auto& array) -> std::uint64_t { return array.count; };
  const std::uint64_t triangles =
      sum(meshes, [](const IndexedMesh& mesh) -> std::uint64_t { return mesh.triangles; });
  if (triangles + sum(spheres, count) + sum(cones, count) > max_primitives ||
      meshes.size() + spheres.size() + cones.size() > max_primitives)
    throw Error(ErrorCode::usage, "geometry", "has more primitives than a scene may hold");
  for (const IndexedMesh& mesh : meshes)
    scene.materials.push_back(matte(mesh.color));
  scene.triangles = MeshTriangles(meshes, progress);
  std::size_t object = meshes.size();
  for (const SphereArray& array : spheres)
    add(array, object++, "spheres", scene, scene.spheres, scene.sphere_surfaces);
  for (const ConeArray& array : cones)
    add(array, object++, "cones", scene, scene.cones, scene.cone_surfaces);
  scene.objects = {meshes.size(), 0, spheres.size(), cones.size()};
  scene.camera = automatic_camera(bounding_sphere(scene), false, 512, 512);
  scene.ambient = 0.5F; // of one light
  scene.lights = {{scene.camera.from, {0.5, 0.5, 0.5}}};
  return scene;
}

} // namespace masu
