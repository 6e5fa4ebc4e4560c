// The scene file: a container (container.h) whose table is schemas/scene.fbs.
#pragma once

#include "libscene/file/container.h"
#include "libscene/float32_precision.h"
#include "libscene/scene.h"
#include "libscene/scene_view.h"
#include "schemas/scene_generated.h"

#include <memory>
#include <string>
#include <variant>

namespace masu {

class MeshTriangles; // libscene/mesh/indexed_mesh.h

inline constexpr FileKind scene_file_kind{
    {'M', 'A', 'S', 'U', 'S', 'C', 'N', '\0'}, 2, "scene", "convert the scene again"};

// automatic: float32 where it is precise enough (float32_precision.h), else float64.
enum class Store { automatic, float32, float64 };

// Of all primitives; empty where there is none.
template <class Triangles>
Boxd bounds(const SceneOf<Triangles>& scene);

// Whether a store holds coordinates within these bounds: float32 from 1e-10 to 1e12, float64 from 1e-90 to
// 1e100, so that products of three neither overflow nor underflow. Also where there is no primitive.
template <class Stored>
bool reaches_within(const Boxd& bounds);

// The store that is taken: never automatic.
inline Store resolved(Store store, const Float32Precision& precision) {
  if (store != Store::automatic) return store;
  return precision.suffices() ? Store::float32 : Store::float64;
}

// Identifies what a grid is built from, and can be used with: XXH3-128 of the table's bounds and of the
// entries (kind, record_bytes, count, hash) of the sections of triangles, spheres and cones. A triangle's
// record also holds the indices of its object, material and normals, which count for that reason alone;
// what they refer to doesn't, nor do lights, the camera, and the surfaces of spheres and cones. The
// sections' own hashes are checked when a file is opened, so this one needs no other pass over the geometry,
// and no field that could contradict it.
Hash geometry_hash(std::span<const fb::Section> sections, const fb::Box& bounds, const fb::Vec3& origin);

// Writes `scene` to `path`, whole or not at all, relative to its origin_for(`origin`). Returns its geometry
// hash. Throws Error(output) when it can't be written, Error(usage) as origin_for() does, Error(input) when
// the largest coordinate, relative to the origin, is out of the store's range, or a cone has no length once
// rounded.
template <class Triangles>
Hash write_scene(const SceneOf<Triangles>& scene, Store store, const std::string& path,
                 const std::optional<Vec3d>& origin = {});

class SceneFile;

// The same in memory: a scene file that was never written. The place of its errors is "scene". Triangles of
// meshes are made when somebody first reads them: a GPU makes its own.
template <class Triangles>
SceneFile scene_in_memory(const SceneOf<Triangles>& scene, Store store,
                          const std::optional<Vec3d>& origin = {}, const ProgressMonitor* progress = nullptr);

// What a grid has to know of the scene that it is built from.
struct SceneGeometry {
  Boxd bounds = empty_box<double>(); // of all primitives, relative to the origin; empty where there is none
  Hash hash;                         // of the records of primitives
  Vec3d origin{0, 0, 0};             // in the world (local_origin.h)
};

// A scene file, checked: every index and range in it is valid. Of one whose records stay in the file, only
// the table is; who copies them checks them (scene_checks.h).
class SceneFile : public TableFile<fb::Scene, fb::SceneSection> {
public:
  // Throws Error(input, path, …) for a file that can't be read, isn't a scene or is damaged.
  explicit SceneFile(const std::string& path, Residence residence = Residence::memory);

  Hash geometry_hash() const;
  std::uint64_t primitive_count() const;
  Vec3d origin() const { return vector_of(*table_->origin()); } // local_origin.h
  Camera camera() const;                                        // in the world
  // Of all primitives, relative to the origin; empty where there is none.
  Boxd bounds() const { return box_of(*table_->bounds()); }
  bool is_float64() const { return table_->store() == fb::Store::float64; }

  SceneCounts counts() const;
  SceneGeometry geometry() const { return {bounds(), geometry_hash(), origin()}; }
  // Whether triangles have other numbers of faces than their own.
  bool has_faces() const { return count<std::uint32_t>(fb::SceneSection::faces) > 0; }

  // The same scene with other triangles, as many, where it is in memory. `bounds`: of all its primitives
  // then.
  template <class Stored>
  SceneFile with_triangles(std::span<const Triangle<Stored>> triangles, const Boxd& bounds) const;

  // Points into its memory, or nowhere where the records stay in the file; Stored must be the file's own
  // (is_float64).
  template <class Stored>
  const SceneView<Stored>& view() const {
    make_whole();
    return view_but_triangles<Stored>();
  }
  // For who reads no triangles: they may be still to be made, from the meshes that unmade_triangles() gives
  // until they are.
  template <class Stored>
  const SceneView<Stored>& view_but_triangles() const {
    return std::get<SceneView<Stored>>(view_);
  }
  std::shared_ptr<const MeshTriangles> unmade_triangles() const { return unmade_triangles_.lock(); }
  template <class Stored>
  Lighting<Stored> lighting() const;
  // What act(the view of the file's own) returns.
  template <class Act>
  auto with_view(const Act& act) const {
    make_whole();
    return with_view_but_triangles(act);
  }
  template <class Act>
  auto with_view_but_triangles(const Act& act) const {
    return is_float64() ? act(view_but_triangles<double>()) : act(view_but_triangles<float>());
  }

private:
  template <class Triangles>
  friend SceneFile scene_in_memory(const SceneOf<Triangles>&, Store, const std::optional<Vec3d>&,
                                   const ProgressMonitor*);
  explicit SceneFile(ContainerFile container);
  template <class Stored>
  SceneView<Stored> view_of_sections() const;

  std::weak_ptr<const MeshTriangles> unmade_triangles_;    // of the section that is made later
  std::variant<SceneView<float>, SceneView<double>> view_; // made once: a query of one ray needs it, too
};

} // namespace masu
