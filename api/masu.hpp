// Masu in C++20: RAII and exceptions over the C interface (masu.h says what everything means).
#pragma once

#include "masu.h"

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <memory>
#include <ranges>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace masu {

class Exception : public std::runtime_error {
public:
  Exception(masu_status code, const char* message) : std::runtime_error(message), status(code) {}
  masu_status status;
};

// Throws what masu_error() says.
inline void check(masu_status status) {
  if (status != MASU_OK) throw Exception(status, masu_error());
}

// Owns an object of C's.
template <class Object, void (*free)(Object*)>
struct Free {
  void operator()(Object* object) const { free(object); }
};
template <class Object, void (*free)(Object*)>
using Handle = std::unique_ptr<Object, Free<Object, free>>;

inline int gpu_count() {
  int count = 0;
  check(masu_gpu_count(&count));
  return count;
}

// What a function of C made of what it is given.
template <class Object, class Make, class... Given>
Object* made(Make* make, Given... given) {
  Object* object = nullptr;
  check(make(given..., &object));
  return object;
}

// A structure of C whose size is set, and the rest zero.
template <class Struct>
Struct sized() {
  Struct made{};
  made.size = sizeof made;
  return made;
}

// One that a function of C filled in.
template <class Struct, class Fill, class... Given>
Struct filled(Fill* fill, Given... given) {
  auto to = sized<Struct>();
  check(fill(given..., &to));
  return to;
}

// --- Scenes and grids

// Numbers one after the other, or in arrays of three: a vector, an array, a span.
template <class T, class Number>
concept NumbersOf = std::ranges::contiguous_range<T> &&
    (std::same_as<std::ranges::range_value_t<T>, Number> ||
     std::same_as<std::ranges::range_value_t<T>, std::array<Number, 3>>);
template <class T>
concept Vertices = NumbersOf<T, float> || NumbersOf<T, double>;

// An object of triangles, which refers to the arrays.
template <Vertices V, NumbersOf<std::uint32_t> Indices>
masu_mesh mesh(const V& vertices, const Indices& indices) {
  const auto triples = [](const auto& numbers) {
    constexpr bool are_arrays = requires {
      numbers.begin()->size();
    };
    return std::ranges::size(numbers) / (are_arrays ? 1 : 3);
  };
  auto mesh = sized<masu_mesh>();
  const void* const numbers = std::ranges::data(vertices);
  if constexpr (NumbersOf<V, float>)
    mesh.vertices = static_cast<const float*>(numbers);
  else
    mesh.vertices64 = static_cast<const double*>(numbers);
  mesh.vertex_count = triples(vertices);
  const void* const corners = std::ranges::data(indices);
  mesh.indices = static_cast<const std::uint32_t*>(corners);
  mesh.triangle_count = triples(indices);
  return mesh;
}

inline masu_build_options default_build_options() {
  return filled<masu_build_options>(masu_default_build_options);
}

// Where a scene's vertices are now; refers to the array.
template <Vertices V>
masu_vertices moved_to(const V& vertices) {
  const masu_mesh as_mesh = mesh(vertices, std::array<std::uint32_t, 0>{});
  auto moved = sized<masu_vertices>();
  moved.values = as_mesh.vertices;
  moved.values64 = as_mesh.vertices64;
  moved.count = as_mesh.vertex_count;
  return moved;
}

// A mesh where it is: rows of M, each followed by its number of t.
inline masu_placement placement(std::uint32_t mesh, const std::array<double, 12>& transform,
                                std::uint32_t world = 0, std::uint32_t mask = 0) {
  auto placement = sized<masu_placement>();
  std::ranges::copy(transform, placement.transform);
  placement.mesh = mesh;
  placement.mask = mask;
  placement.world = world;
  return placement;
}

class Scene {
public:
  explicit Scene(const masu_geometry& geometry) : Scene(made<masu_scene>(masu_scene_create, &geometry)) {}
  explicit Scene(std::span<const masu_mesh> meshes, std::span<const masu_placement> placements = {})
      : Scene(geometry_of(meshes, placements)) {}
  template <Vertices V, NumbersOf<std::uint32_t> Indices>
  Scene(const V& vertices, const Indices& indices) : Scene(std::array{mesh(vertices, indices)}) {}
  static Scene read(const std::string& path) {
    return Scene(made<masu_scene>(masu_scene_read, path.c_str()));
  }

  void write(const std::string& path) const { masu::check(masu_scene_write(get(), path.c_str())); }
  masu_scene_description describe() const {
    return filled<masu_scene_description>(masu_scene_describe, get());
  }
  masu_primitive primitive(std::uint32_t index) const {
    return filled<masu_primitive>(masu_scene_primitive, get(), index);
  }
  // What is wrong with its triangles as a mesh (masu_scene_check).
  masu_mesh_check check() const { return filled<masu_mesh_check>(masu_scene_check, get()); }

  masu_scene* get() const { return handle_.get(); }

private:
  explicit Scene(masu_scene* scene) : handle_(scene) {}
  static masu_geometry geometry_of(std::span<const masu_mesh> meshes,
                                   std::span<const masu_placement> placements) {
    auto geometry = sized<masu_geometry>();
    geometry.meshes = meshes.data();
    geometry.mesh_count = meshes.size();
    geometry.placements = placements.data();
    geometry.placement_count = placements.size();
    return geometry;
  }

  Handle<masu_scene, masu_scene_free> handle_;
};

class Grid {
public:
  // Builds it.
  explicit Grid(const Scene& scene, const masu_build_options& options = default_build_options())
      : Grid(made<masu_grid>(masu_grid_build, scene.get(), &options)) {}
  static Grid read(const std::string& path) { return Grid(made<masu_grid>(masu_grid_read, path.c_str())); }

  // Of a scene whose primitives have moved (masu_grid_refit).
  Grid refitted(const Scene& scene) const {
    return Grid(made<masu_grid>(masu_grid_refit, get(), scene.get()));
  }

  void write(const std::string& path) const { check(masu_grid_write(get(), path.c_str())); }
  masu_grid_description describe() const { return filled<masu_grid_description>(masu_grid_describe, get()); }

  masu_grid* get() const { return handle_.get(); }

private:
  friend class Tracer;
  explicit Grid(masu_grid* grid) : handle_(grid) {}

  Handle<masu_grid, masu_grid_free> handle_;
};

// --- Tracers

// The format of rays is that of their type. Those of six numbers are an origin and a direction.
template <class T>
concept Ray = std::same_as<T, masu_ray> || std::same_as<T, masu_ray64> ||
    std::same_as<T, std::array<float, 6>> || std::same_as<T, std::array<double, 6>>;
template <Ray R>
constexpr masu_ray_format format_of() {
  if (std::same_as<R, masu_ray>) return MASU_RAYS_FLOAT32;
  if (std::same_as<R, masu_ray64>) return MASU_RAYS_FLOAT64;
  return std::same_as<R, std::array<float, 6>> ? MASU_RAYS_FLOAT32_6 : MASU_RAYS_FLOAT64_6;
}
template <class T> // a vector, an array, a span
concept RayRange = std::ranges::contiguous_range<T> && Ray<std::ranges::range_value_t<T>>;

// As masu_query, but for the format.
struct QueryOptions {
  masu_precision precision = MASU_PRECISION_AUTO;
  bool coherent = false;
  void* stream = nullptr; // of rays in device memory
  bool relative = false;  // to the scene's origin
  int threads = 0;        // of the host, for rays in its memory; 0: all cores
  masu_faces faces = MASU_FACES_BOTH;
  const std::uint32_t* exclude = nullptr;        // a primitive for each ray, or MASU_NONE
  std::span<const std::uint32_t> object_masks{}; // bits for each object of the scene; none: all are hit
  const std::uint32_t* ray_masks = nullptr;      // bits for each ray; null: all bits
  masu_loop loop = MASU_LOOP_AUTO;
  masu_go_on go_on = nullptr;                     // whether to go on (masu.h)
  void* user = nullptr;                           // for go_on
  const std::uint32_t* exclude_objects = nullptr; // of placed meshes: the objects of those in `exclude`
  const std::uint32_t* worlds = nullptr;          // of placed meshes: each ray's; null: 0
};

// The hits of rays in host memory.
struct Hits {
  std::vector<float> t;
  std::vector<std::uint32_t> primitive;
};

// A row of `limit` hits for each ray, of which `counts` are there.
struct HitLists {
  std::uint32_t limit;
  std::vector<std::uint32_t> counts;
  std::vector<double> t;
  std::vector<std::uint32_t> primitive;
  std::vector<std::uint8_t> front;

  bool operator==(const HitLists&) const = default;
};

// The closest points to places in host memory.
struct ClosestPoints {
  std::vector<double> distance;
  std::vector<std::uint32_t> primitive;
  std::vector<std::array<double, 3>> point;
};

// A scene and its grid on a device; it keeps what it needs of both.
class Tracer {
public:
  // Without a grid one is built, as masu_tracer_create() says.
  explicit Tracer(const Scene& scene, int device = MASU_CPU) : Tracer(scene, nullptr, gpus_of(device)) {}
  Tracer(const Scene& scene, const Grid& grid, int device = MASU_CPU)
      : Tracer(scene, &grid, gpus_of(device)) {}
  // On several GPUs, which share queries of rays in host memory; none: on the CPU.
  Tracer(const Scene& scene, const Grid* grid, std::span<const int> gpus, bool brute_force = false) {
    auto options = sized<masu_tracer_options>();
    options.gpus = gpus.data();
    options.gpu_count = gpus.size();
    options.brute_force = brute_force ? 1 : 0;
    handle_.reset(made<masu_tracer>(masu_tracer_create, scene.get(), grid != nullptr ? grid->get() : nullptr,
                                    &options));
  }

  // What it traces through (masu_tracer_grid).
  Grid grid() const { return Grid(made<masu_grid>(masu_tracer_grid, handle_.get())); }

  // In host memory, or all in memory of one of the tracer's GPUs.
  template <Ray R>
  void nearest(const R* rays, std::size_t count, const masu_hits& hits,
               const QueryOptions& options = {}) const {
    ask<R>(masu_nearest, rays, count, options, &hits);
  }
  template <Ray R>
  void occluded(const R* rays, std::size_t count, std::uint8_t* occluded,
                const QueryOptions& options = {}) const {
    ask<R>(masu_occluded, rays, count, options, occluded);
  }
  template <Ray R>
  void all_hits(const R* rays, std::size_t count, std::uint32_t limit, const masu_hits& hits,
                std::uint32_t* counts, const QueryOptions& options = {}) const {
    ask<R>(masu_all_hits, rays, count, options, limit, &hits, counts);
  }
  template <Ray R>
  void count_hits(const R* rays, std::size_t count, std::uint32_t* counts,
                  const QueryOptions& options = {}) const {
    ask<R>(masu_count_hits, rays, count, options, counts);
  }
  template <Ray R>
  void inside(const R* rays, std::size_t count, std::uint8_t* inside,
              const QueryOptions& options = {}) const {
    ask<R>(masu_inside, rays, count, options, inside);
  }

  // In host memory.
  template <RayRange Rays>
  Hits nearest(const Rays& rays, const QueryOptions& options = {}) const {
    const std::size_t count = std::ranges::size(rays);
    Hits found{std::vector<float>(count), std::vector<std::uint32_t>(count)};
    auto hits = sized<masu_hits>();
    hits.t = found.t.data();
    hits.primitive = found.primitive.data();
    nearest(std::ranges::data(rays), count, hits, options);
    return found;
  }
  template <RayRange Rays>
  std::vector<std::uint8_t> occluded(const Rays& rays, const QueryOptions& options = {}) const {
    std::vector<std::uint8_t> found(std::ranges::size(rays));
    occluded(std::ranges::data(rays), found.size(), found.data(), options);
    return found;
  }
  template <RayRange Rays>
  HitLists all_hits(const Rays& rays, std::uint32_t limit, const QueryOptions& options = {}) const {
    const std::size_t count = std::ranges::size(rays), all = count * limit;
    HitLists found{limit, std::vector<std::uint32_t>(count), std::vector<double>(all),
                   std::vector<std::uint32_t>(all), std::vector<std::uint8_t>(all)};
    auto hits = sized<masu_hits>();
    hits.t64 = found.t.data();
    hits.primitive = found.primitive.data();
    hits.front = found.front.data();
    all_hits(std::ranges::data(rays), count, limit, hits, found.counts.data(), options);
    return found;
  }
  template <RayRange Rays>
  std::vector<std::uint32_t> count_hits(const Rays& rays, const QueryOptions& options = {}) const {
    std::vector<std::uint32_t> found(std::ranges::size(rays));
    count_hits(std::ranges::data(rays), found.size(), found.data(), options);
    return found;
  }
  template <RayRange Rays>
  std::vector<std::uint8_t> inside(const Rays& rays, const QueryOptions& options = {}) const {
    std::vector<std::uint8_t> found(std::ranges::size(rays));
    inside(std::ranges::data(rays), found.size(), found.data(), options);
    return found;
  }

  // Of places, in host memory (masu_closest()).
  template <class Number>
  requires std::same_as<Number, float> || std::same_as<Number, double>
  void closest(const std::array<Number, 3>* places, std::size_t count, const masu_hits& hits, double* points,
               const QueryOptions& options = {}) const {
    ask<std::conditional_t<std::same_as<Number, float>, masu_ray, masu_ray64>>(masu_closest, places, count,
                                                                               options, &hits, points);
  }
  template <std::ranges::contiguous_range Places>
  ClosestPoints closest(const Places& places, const QueryOptions& options = {}) const {
    const std::size_t count = std::ranges::size(places);
    ClosestPoints found{std::vector<double>(count), std::vector<std::uint32_t>(count),
                        std::vector<std::array<double, 3>>(count)};
    auto hits = sized<masu_hits>();
    hits.t64 = found.distance.data();
    hits.primitive = found.primitive.data();
    closest(std::ranges::data(places), count, hits,
            found.point.empty() ? nullptr : found.point.front().data(), options);
    return found;
  }

  // The winding numbers about places, in host memory (masu_winding()).
  template <std::ranges::contiguous_range Places>
  std::vector<double> winding(const Places& places, double bound = 1e-3,
                              const QueryOptions& options = {}) const {
    using Number = std::ranges::range_value_t<std::ranges::range_value_t<Places>>;
    std::vector<double> found(std::ranges::size(places));
    ask<std::conditional_t<std::same_as<Number, float>, masu_ray, masu_ray64>>(
        masu_winding, std::ranges::data(places), found.size(), options, bound, found.data(), nullptr);
    return found;
  }

  // Moves the triangles of its scene, and refits its hierarchy (masu_tracer_update).
  void update(const masu_vertices& vertices) { check(masu_tracer_update(handle_.get(), &vertices)); }
  template <Vertices V>
  void update(const V& vertices) {
    update(moved_to(vertices));
  }

  // Moves its scene's placements (masu_tracer_place): all of them, or those of the indices.
  void place(const masu_transforms& transforms) { check(masu_tracer_place(handle_.get(), &transforms)); }
  template <class Number>
  requires std::same_as<Number, float> || std::same_as<Number, double>
  void place(std::span<const std::array<Number, 12>> moved, std::span<const std::uint32_t> indices = {}) {
    auto transforms = sized<masu_transforms>();
    const void* const numbers = moved.data();
    if constexpr (std::same_as<Number, float>)
      transforms.values = static_cast<const float*>(numbers);
    else
      transforms.values64 = static_cast<const double*>(numbers);
    transforms.count = moved.size();
    transforms.indices = indices.data();
    place(transforms);
  }

  masu_tracer* get() const { return handle_.get(); }

private:
  // Valid until the end of the full expression.
  static std::span<const int> gpus_of(const int& device) {
    return {&device, device == MASU_CPU ? std::size_t{0} : std::size_t{1}};
  }
  // Asks a function of C, of rays in that format; `last`: what is its own.
  template <Ray R, class Function, class... Last>
  void ask(Function* function, const void* rays, std::size_t count, const QueryOptions& options,
           Last... last) const {
    auto query = sized<masu_query>();
    query.format = format_of<R>();
    query.precision = options.precision;
    query.coherent = options.coherent ? 1 : 0;
    query.relative = options.relative ? 1 : 0;
    query.stream = options.stream;
    query.threads = options.threads;
    query.faces = options.faces;
    query.exclude = options.exclude;
    query.object_masks = options.object_masks.data();
    query.object_count = options.object_masks.size();
    query.ray_masks = options.ray_masks;
    query.loop = options.loop;
    query.go_on = options.go_on;
    query.user = options.user;
    query.exclude_objects = options.exclude_objects;
    query.worlds = options.worlds;
    check(function(handle_.get(), rays, count, &query, last...));
  }

  Handle<masu_tracer, masu_tracer_free> handle_;
};

} // namespace masu
