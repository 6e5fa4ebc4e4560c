#include "libscene/file/scene_file.h"

#include "libscene/base/error.h"
#include "libscene/file/scene_checks.h"
#include "libscene/geometry/cone.h"
#include "libscene/geometry/margin.h"
#include "libscene/mesh/indexed_mesh.h"
#include "libscene/scene_bounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace masu {
namespace {

std::uint32_t number(fb::SceneSection section) {
  return static_cast<std::uint32_t>(section);
}

// Of what `stored` makes of the records.
template <class Scene, class AsStored>
Boxd bounds_of(const Scene& scene, const AsStored& stored) {
  return joined_boxes(scene, [&](const auto& record) { return cast<double>(bounds(stored(record))); });
}

template <class Triangles>
std::vector<std::uint8_t> scene_table(const SceneOf<Triangles>& scene, fb::Store store,
                                      const fb::Vec3& origin, const Boxd& box,
                                      const std::vector<fb::Section>& layout) {
  flatbuffers::FlatBufferBuilder builder;
  const auto sections = builder.CreateVectorOfStructs(layout);
  const Camera& view = scene.camera;
  const fb::Camera camera(table_vector(view.from), table_vector(view.at), table_vector(view.up), view.angle,
                          view.hither, view.width, view.height);
  const fb::Color background(scene.background.x, scene.background.y, scene.background.z);
  const fb::ObjectCounts objects(scene.objects.polygons, scene.objects.patches, scene.objects.spheres,
                                 scene.objects.cones);
  const fb::Box bounds = table_box(box);
  const auto count = [&](bool (*property)(const Material&)) {
    return static_cast<std::uint64_t>(
        std::count_if(scene.materials.begin(), scene.materials.end(), property));
  };
  builder.Finish(fb::CreateScene(builder, store, &origin, &camera, &background, scene.ambient, &objects,
                                 &bounds, count(reflects), count(transmits), sections));
  return {builder.GetBufferPointer(), builder.GetBufferPointer() + builder.GetSize()};
}

// The same of a table, with other bounds.
std::vector<std::uint8_t> scene_table(const fb::Scene& from, const fb::Box& bounds,
                                      const std::vector<fb::Section>& layout) {
  flatbuffers::FlatBufferBuilder builder;
  const auto sections = builder.CreateVectorOfStructs(layout);
  builder.Finish(fb::CreateScene(builder, from.store(), from.origin(), from.camera(), from.background(),
                                 from.ambient(), from.objects(), &bounds, from.reflective_materials(),
                                 from.transmitting_materials(), sections));
  return {builder.GetBufferPointer(), builder.GetBufferPointer() + builder.GetSize()};
}

// The range of the largest coordinate's magnitude.
struct Reach {
  double min, max;
};
template <class Stored>
constexpr Reach reach_of =
    std::is_same_v<Stored, float> ? Reach{min_float32_reach, max_float32_reach} : Reach{1e-90, 1e100};
template <class Stored>
constexpr const char* store_name = std::is_same_v<Stored, float> ? "float32" : "float64";

// For what the caller keeps.
template <class T>
std::shared_ptr<const T> not_owned(const T& of) {
  return {std::shared_ptr<void>(), &of};
}

// Calls act(the sections, what makes the table of their layout). That of triangles keeps `triangles`, which
// are the scene's.
template <class Stored, class Triangles, class Act>
auto with_sections(const SceneOf<Triangles>& scene, const std::shared_ptr<const Triangles>& triangles,
                   const Vec3d& origin, const std::string& path, const Act& act) {
  // Records are converted when they are needed: another copy of them all could be too large.
  const auto stored = [origin](const auto& record) {
    if constexpr (std::is_same_v<std::decay_t<decltype(record)>, CornerNormals<double>>)
      return cast<Stored>(record);
    else
      return cast<Stored>(widened(relative_to(origin, record)));
  };
  const auto section = [](fb::SceneSection kind, const auto& records) {
    return section_data(number(kind), std::span(records));
  };
  const auto converted_section = [&](fb::SceneSection kind, const auto& records) {
    return converted_section_data(number(kind), not_owned(records), stored);
  };
  using fb::SceneSection;
  const std::array sections{
      converted_section(SceneSection::lights, scene.lights),
      section(SceneSection::materials, scene.materials),
      converted_section_data(number(SceneSection::triangles), triangles, stored),
      converted_section(SceneSection::corner_normals, scene.normals),
      converted_section(SceneSection::spheres, scene.spheres),
      section(SceneSection::sphere_surfaces, scene.sphere_surfaces),
      converted_section(SceneSection::cones, scene.cones),
      section(SceneSection::cone_surfaces, scene.cone_surfaces),
      section(SceneSection::faces, scene.faces),
  };
  // A cone without length, or whose length's square underflows, has no bounds.
  const auto flattened = std::count_if(scene.cones.begin(), scene.cones.end(), [&](const Cone<double>& cone) {
    return is_finite(stored(cone)) && is_empty(bounds(stored(cone)));
  });
  if (flattened > 0) {
    throw Error(ErrorCode::input, path,
                fmt::format("{} cone(s) have no length in {}: {}", flattened, store_name<Stored>,
                            std::is_same_v<Stored, float> ? "store it as float64" : "make them longer"));
  }
  const auto all_finite = [&](const auto& records) {
    return std::all_of(records.begin(), records.end(),
                       [&](const auto& record) { return is_finite(stored(record)); });
  };
  const Boxd box = bounds_of(scene, stored);
  if (!reaches_within<Stored>(box) || !all_finite(scene.cones)) { // infinite ones have no bounds either
    throw Error(ErrorCode::input, path,
                fmt::format("the largest coordinate{} is {:g}, but {} allows {:g} to {:g}: {}",
                            origin == Vec3d{0, 0, 0} ? "" : ", relative to the origin,",
                            largest_magnitude(box), store_name<Stored>, reach_of<Stored>.min,
                            reach_of<Stored>.max,
                            std::is_same_v<Stored, float> ? "store it as float64" : "scale it"));
  }
  if (!all_finite(scene.normals))
    throw Error(ErrorCode::input, path, "a corner's normal isn't finite: give it a length near 1");
  if (!all_finite(scene.lights))
    throw Error(ErrorCode::input, path,
                fmt::format("a light's position isn't finite in {}: move it closer", store_name<Stored>));
  const auto store = std::is_same_v<Stored, float> ? fb::Store::float32 : fb::Store::float64;
  const fb::Vec3 local = table_vector(origin);
  return act(sections, [&](const std::vector<fb::Section>& layout) {
    return scene_table(scene, store, local, box, layout);
  });
}

// With an origin and a store that are chosen where they aren't given.
template <class Triangles, class Act>
auto with_sections(const SceneOf<Triangles>& scene, const std::shared_ptr<const Triangles>& triangles,
                   Store store, const std::optional<Vec3d>& wanted, const std::string& path, const Act& act,
                   const ProgressMonitor* progress = nullptr) {
  const Vec3d origin = origin_for(scene, wanted);
  if (store == Store::automatic) store = resolved(store, float32_precision(scene, origin, progress));
  return store == Store::float32 ? with_sections<float>(scene, triangles, origin, path, act)
                                 : with_sections<double>(scene, triangles, origin, path, act);
}

bool is_finite(const fb::Vec3& v) {
  return is_finite(vector_of(v));
}

// Whether the view direction and up aren't zero or parallel.
bool has_direction(const fb::Camera& camera) {
  const Vec3d view = vector_of(camera.at()) - vector_of(camera.from()), up = vector_of(camera.up());
  if (!(largest_magnitude(view) > 0 && largest_magnitude(up) > 0)) return false;
  return largest_magnitude(cross(normalized(view), normalized(up))) > 1e-12;
}

} // namespace

template <class Stored>
bool reaches_within(const Boxd& bounds) {
  if (bounds.min.x > bounds.max.x) return true; // no primitive
  const double reach = largest_magnitude(bounds);
  return reach >= reach_of<Stored>.min && reach <= reach_of<Stored>.max;
}
template bool reaches_within<float>(const Boxd&);
template bool reaches_within<double>(const Boxd&);

template <class Triangles>
Boxd bounds(const SceneOf<Triangles>& scene) {
  return bounds_of(scene, [](const auto& record) { return record; });
}
template Boxd bounds(const Scene&);
template Boxd bounds(const ArrayScene&);

Hash geometry_hash(std::span<const fb::Section> sections, const fb::Box& bounds, const fb::Vec3& origin) {
  using fb::SceneSection;
  struct Entry {
    std::uint32_t kind = 0, record_bytes = 0;
    std::uint64_t count = 0;
    fb::Hash hash;
  };
  static_assert(sizeof(fb::Box) == 48 && sizeof(Entry) == 32); // without gaps
  std::vector<std::uint8_t> bytes;
  const auto append = [&](const auto& record) {
    const auto* const begin = reinterpret_cast<const std::uint8_t*>(&record);
    bytes.insert(bytes.end(), begin, begin + sizeof record);
  };
  append(bounds);
  if (!(vector_of(origin) == Vec3d{0, 0, 0})) append(origin);
  for (const fb::Section& s : sections) {
    const auto kind = static_cast<SceneSection>(s.kind());
    if (kind == SceneSection::triangles || kind == SceneSection::spheres || kind == SceneSection::cones)
      append(Entry{s.kind(), s.record_bytes(), s.count(), s.hash()});
  }
  return hash_of(bytes);
}

template <class Triangles>
Hash write_scene(const SceneOf<Triangles>& scene, Store store, const std::string& path,
                 const std::optional<Vec3d>& wanted) {
  const auto act = [&](const auto& sections, const auto& table_of) {
    const auto layout = lay_out(sections);
    const std::vector<std::uint8_t> bytes = table_of(layout);
    write_container(path, scene_file_kind, bytes, sections, layout);
    const fb::Scene& table = *fb::GetScene(bytes.data());
    return geometry_hash(layout, *table.bounds(), *table.origin());
  };
  return with_sections(scene, not_owned(scene.triangles), store, wanted, path, act);
}
template Hash write_scene(const Scene&, Store, const std::string&, const std::optional<Vec3d>&);
template Hash write_scene(const ArrayScene&, Store, const std::string&, const std::optional<Vec3d>&);

template <class Triangles>
SceneFile scene_in_memory(const SceneOf<Triangles>& scene, Store store, const std::optional<Vec3d>& wanted,
                          const ProgressMonitor* progress) {
  constexpr bool is_later = std::is_same_v<Triangles, MeshTriangles>;
  auto triangles = not_owned(scene.triangles);
  if constexpr (is_later) triangles = std::make_shared<const MeshTriangles>(scene.triangles);
  const auto act = [&](auto sections, const auto& table_of) {
    for (SectionData& section : sections)
      section.is_later = is_later && section.kind == number(fb::SceneSection::triangles);
    SceneFile file(ContainerFile(make_container(scene_file_kind, sections, table_of, progress), "scene"));
    if constexpr (is_later) file.unmade_triangles_ = triangles;
    return file;
  };
  return with_sections(scene, triangles, store, wanted, "scene", act, progress);
}
template SceneFile scene_in_memory(const Scene&, Store, const std::optional<Vec3d>&, const ProgressMonitor*);
template SceneFile scene_in_memory(const ArrayScene&, Store, const std::optional<Vec3d>&,
                                   const ProgressMonitor*);

SceneFile::SceneFile(const std::string& path, Residence residence)
    : SceneFile(ContainerFile(path, scene_file_kind, residence)) {}

SceneFile::SceneFile(ContainerFile container) : TableFile(std::move(container)) {
  check(table_->store() == fb::Store::float32 || table_->store() == fb::Store::float64,
        "its coordinates are of an unknown type");
  check(is_finite(origin()) && largest_magnitude(origin()) <= max_origin, "its origin is invalid");
  const fb::Camera& camera = *table_->camera();
  check(is_finite(camera.from()) && is_finite(camera.at()) && is_finite(camera.up()) && camera.angle() > 0 &&
            camera.angle() < 180 && camera.width() > 0 && camera.height() > 0 && camera.width() <= 65536 &&
            camera.height() <= 65536 && std::isfinite(camera.hither()) && has_direction(camera),
        "its camera is invalid");
  // In the store's range, or exactly those of no primitive.
  const Boxd box = bounds(), none = empty_box<double>();
  const bool reaches = is_float64() ? reaches_within<double>(box) : reaches_within<float>(box);
  check(is_empty(box) ? box.min == none.min && box.max == none.max : reaches, "its bounds are invalid");
  read_sections(sections());

  const fb::ObjectCounts& counted = *table_->objects();
  const std::uint64_t limit = std::uint64_t{1} << 31;
  check(counted.polygons() < limit && counted.patches() < limit && counted.spheres() < limit &&
            counted.cones() < limit,
        "its counts of objects are too large");
  if (is_float64())
    view_ = view_of_sections<double>();
  else
    view_ = view_of_sections<float>();
  if (has_records_to_check()) {
    with_view([&]<class Stored>(const SceneView<Stored>& view) {
      const char* const fault = fault_of(HostChecker{}, view, lighting<Stored>(), bounds(), counts());
      check(fault == nullptr, fault);
    });
  }
  set_validated();
}

Hash SceneFile::geometry_hash() const {
  make_whole();
  return masu::geometry_hash(sections(), *table_->bounds(), *table_->origin());
}

SceneCounts SceneFile::counts() const {
  const fb::ObjectCounts& objects = *table_->objects();
  const auto normals = [&]<class Stored>(Stored) {
    return count<CornerNormals<Stored>>(fb::SceneSection::corner_normals);
  };
  return {objects.polygons() + objects.patches() + objects.spheres() + objects.cones(),
          is_float64() ? normals(0.0) : normals(0.0F), count<Material>(fb::SceneSection::materials)};
}

Camera SceneFile::camera() const {
  const fb::Camera& c = *table_->camera();
  return {vector_of(c.from()), vector_of(c.at()), vector_of(c.up()), c.angle(),
          c.hither(),          c.width(),         c.height()};
}

std::uint64_t SceneFile::primitive_count() const {
  return with_view_but_triangles([](const auto& view) { return view.primitive_count(); });
}

template <class Stored>
SceneFile SceneFile::with_triangles(std::span<const Triangle<Stored>> triangles, const Boxd& bounds) const {
  std::vector<SectionData> data;
  for (const fb::Section& section : sections()) {
    const void* const records = section.kind() == number(fb::SceneSection::triangles)
                                    ? static_cast<const void*>(triangles.data())
                                    : bytes_of(section).data();
    data.push_back({section.kind(), section.record_bytes(), section.count(), records, {}});
  }
  return SceneFile(ContainerFile(
      make_container(scene_file_kind, data,
                     [&](const auto& layout) { return scene_table(*table_, table_box(bounds), layout); }),
      "scene"));
}
template SceneFile SceneFile::with_triangles(std::span<const Triangle<float>>, const Boxd&) const;
template SceneFile SceneFile::with_triangles(std::span<const Triangle<double>>, const Boxd&) const;

template <class Stored>
SceneView<Stored> SceneFile::view_of_sections() const {
  using fb::SceneSection;
  SceneView<Stored> view{};
  bool is_consistent = true;
  const auto set = [&]<class T>(SceneSection kind, const T*& first, std::uint32_t& number_of) {
    const std::uint64_t all = count<T>(kind);
    is_consistent = is_consistent && all < no_primitive;
    first = records<T>(kind).data();
    number_of = static_cast<std::uint32_t>(all);
  };
  std::uint32_t normals_count = 0, sphere_surface_count = 0, cone_surface_count = 0, face_count = 0,
                material_count = 0;
  set(SceneSection::triangles, view.triangles, view.triangle_count);
  set(SceneSection::corner_normals, view.normals, normals_count);
  set(SceneSection::spheres, view.spheres, view.sphere_count);
  set(SceneSection::sphere_surfaces, view.sphere_surfaces, sphere_surface_count);
  set(SceneSection::cones, view.cones, view.cone_count);
  set(SceneSection::cone_surfaces, view.cone_surfaces, cone_surface_count);
  set(SceneSection::faces, view.faces, face_count);
  set(SceneSection::materials, view.materials, material_count);
  const std::uint64_t primitives = std::uint64_t{view.triangle_count} + view.sphere_count + view.cone_count;
  if (!is_consistent || primitives >= no_primitive || view.sphere_count != sphere_surface_count ||
      view.cone_count != cone_surface_count || (face_count > 0 && face_count != view.triangle_count))
    throw_damaged(path(), "its sections have inconsistent sizes");
  view.clip = cast<Stored>(padded_bounds<Stored>(bounds()));
  return view;
}
template <class Stored>
Lighting<Stored> SceneFile::lighting() const {
  const std::uint64_t lights = count<Light<Stored>>(fb::SceneSection::lights);
  if (lights >= no_primitive) throw_damaged(path(), "its sections have inconsistent sizes");
  const fb::Color& background = *table_->background();
  return {records<Light<Stored>>(fb::SceneSection::lights).data(),
          static_cast<std::uint32_t>(lights),
          {background.r(), background.g(), background.b()},
          table_->ambient()};
}

template Lighting<float> SceneFile::lighting<float>() const;
template Lighting<double> SceneFile::lighting<double>() const;

} // namespace masu
