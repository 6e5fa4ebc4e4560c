#include "libscene/mesh/mesh_check.h"

#include "libscene/base/error.h"
#include "libscene/base/host_array.h"
#include "libscene/geometry/orientation.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <utility>

namespace masu {
namespace {

void add(MeshFaults& faults, std::uint32_t corner) {
  ++faults.count;
  std::uint32_t& last = faults.first[faults.examples() - 1];
  if (faults.count > faults.first.size() && last <= corner) return;
  last = corner;
  std::sort(faults.first.data(), &last + 1);
}

// Sorts records, and calls act(first, end) for those that `same` says are equal, in their order.
template <class Record, class Same, class Act>
void for_each_group(HostArray<Record>& records, const Same& same, const Act& act) {
  tbb::parallel_sort(records.begin(), records.end());
  for (auto first = records.begin(), end = first; first != records.end(); first = end) {
    end = std::find_if(first, records.end(), [&](const Record& other) { return !same(*first, other); });
    act(first, end);
  }
}

// Exactly.
bool are_on_a_line(const Triangle<double>& t) {
  const double scale =
      inverse_power_of_two(max(largest_magnitude(t.a), max(largest_magnitude(t.b), largest_magnitude(t.c))));
  const Vec3d a = t.a * scale, b = t.b * scale, c = t.c * scale;
  for (int axis = 0, next = 1; axis < 3; ++axis, next = (next + 1) % 3)
    if (orientation({a[axis], a[next]}, {b[axis], b[next]}, {c[axis], c[next]}) != 0) return false;
  return true;
}

// By corners.
using Points = HostArray<std::uint32_t>;

template <class Stored>
Points points_of(const SceneView<Stored>& scene, std::uint64_t& count) {
  using Corner = std::pair<std::array<Stored, 3>, std::uint32_t>;
  HostArray<Corner> corners(std::size_t{3} * scene.triangle_count);
  for (std::uint32_t i = 0; i < scene.triangle_count; ++i) {
    const Triangle<Stored>& t = scene.triangles[i];
    const Vec3<Stored> of_triangle[] = {t.a, t.b, t.c};
    for (std::uint32_t c = 0; c < 3; ++c) {
      const Vec3<Stored> at = of_triangle[c] + Vec3<Stored>{0, 0, 0}; // -0 is 0
      corners[3 * i + c] = {{at.x, at.y, at.z}, 3 * i + c};
    }
  }
  Points points(corners.size());
  for_each_group(
      corners, [](const Corner& a, const Corner& b) { return a.first == b.first; },
      [&](auto first, auto end) {
        for (auto corner = first; corner != end; ++corner)
          points[corner->second] = static_cast<std::uint32_t>(count);
        ++count;
      });
  return points;
}

void check_edges(const Points& points, MeshCheck& found) {
  using Edge =
      std::array<std::uint32_t, 4>; // the lesser point, the other, the corner, whether it is the first
  HostArray<Edge> edges;
  edges.reserve(points.size());
  for (std::uint32_t corner = 0; corner < points.size(); ++corner) {
    const std::uint32_t from = points[corner], to = points[corner % 3 == 2 ? corner - 2 : corner + 1];
    if (from != to) edges.push_back({std::min(from, to), std::max(from, to), corner, from < to ? 1U : 0U});
  }
  for_each_group(
      edges, [](const Edge& a, const Edge& b) { return a[0] == b[0] && a[1] == b[1]; },
      [&](auto first, auto end) {
        const std::ptrdiff_t triangles = end - first,
                             forwards = std::count_if(first, end, [](const Edge&e) { return e[3] == 1; });
        ++found.edges;
        if (triangles % 2 != 0)
          add(found.open, (*first)[2]);
        else if (2 * forwards != triangles)
          add(found.inconsistent, (*first)[2]);
        if (triangles > 2) add(found.nonmanifold, (*first)[2]);
      });
}

void check_duplicates(const Points& points, MeshCheck& found) {
  using Face = std::array<std::uint32_t, 4>; // its points, sorted, and the first corner
  HostArray<Face> faces;
  for (std::uint32_t corner = 0; corner < points.size(); corner += 3) {
    Face face{points[corner], points[corner + 1], points[corner + 2], corner};
    std::sort(face.begin(), face.end() - 1);
    if (face[0] != face[2]) faces.push_back(face);
  }
  for_each_group(
      faces, [](const Face& a, const Face& b) { return std::equal(a.begin(), a.end() - 1, b.begin()); },
      [&](auto first, auto end) {
        while (++first != end)
          add(found.duplicates, (*first)[3]);
      });
}

} // namespace

template <class Stored>
MeshCheck check_mesh(const SceneView<Stored>& scene) {
  if (scene.triangle_count > 0xffffffffU / 3)
    throw Error(ErrorCode::usage, "scene", "has more than 1431655765 triangles, too many to be checked");
  MeshCheck found;
  for (std::uint32_t i = 0; i < scene.triangle_count; ++i)
    if (are_on_a_line(widened(scene.triangles[i]))) add(found.no_area, 3 * i);
  const Points points = points_of(scene, found.points);
  check_edges(points, found);
  check_duplicates(points, found);
  return found;
}

template MeshCheck check_mesh(const SceneView<float>&);
template MeshCheck check_mesh(const SceneView<double>&);

} // namespace masu
