// Triangles of meshes made on a CUDA device: a third of their bytes is uploaded. CUDA sources only.
#pragma once

#include "libscene/cuda/transfer.h"
#include "libscene/mesh/indexed_mesh.h"
#include "libscene/mesh/stored_triangles.h"

namespace masu {

template <class Stored, class Number>
struct MakeTriangles {
  StoredTriangles<Stored, Number> made;
  Triangle<Stored>* to;

  __device__ void operator()(std::uint64_t i) const { to[i] = made(i); }
};

// Relative to an origin. Vertices and indices are uploaded with whatever is waiting.
template <class Stored>
DeviceArray<Triangle<Stored>> made_on_device(const MeshTriangles& meshes, const Vec3d& origin,
                                             Transfer& upload) {
  auto triangles = upload.room_for<Triangle<Stored>>(meshes.size());
  meshes.as_stored<Stored>(origin, [&]<class Number>(StoredTriangles<Stored, Number> made) {
    const Vertices& of = meshes.vertices();
    const auto numbers = uploaded(made.vertices.numbers, 3 * of.count, upload);
    const auto indices = uploaded(made.vertices.indices, of.indices.size(), upload);
    const auto begins = uploaded(made.begins, made.meshes, upload);
    upload.run();
    for_each_on_device(meshes.size(), nullptr, MakeTriangles<Stored, Number>{made, triangles.data()});
  });
  return triangles;
}

} // namespace masu
