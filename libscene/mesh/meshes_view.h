// The view of a scene in host memory whose triangles are made from meshes whenever they are read.
#pragma once

#include "libscene/mesh/stored_triangles.h"
#include "libscene/scene_view.h"

namespace masu {

template <class Stored, class Number>
struct MeshesView {
  SceneView<Stored> others; // without triangles
  StoredTriangles<Stored, Number> triangles;

  std::uint32_t primitive_count() const { return others.primitive_count(); }
};

// As of a SceneView.
template <class Stored, class Number>
std::uint32_t triangle_count(const MeshesView<Stored, Number>& scene) {
  return scene.others.triangle_count;
}
template <class Stored, class Number, class Act>
void with_primitive(const MeshesView<Stored, Number>& scene, PrimitiveIndex index, const Act& act) {
  if (index < scene.others.triangle_count)
    act(widened(scene.triangles(index)));
  else
    with_primitive(scene.others, index, act);
}

} // namespace masu
