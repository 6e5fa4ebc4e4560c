// The C interface over the tracer and the builders: arguments are checked, exceptions become statuses.
#include "masu.h"

#include "libgrid/build/chosen_structure.h"
#include "libscene/base/processor.h"
#include "libscene/file/memory_file.h"
#include "libscene/file/output_file.h"
#include "libscene/mesh/indexed_mesh.h"
#include "renderer/automatic_loop.h"
#include "renderer/tracer.h"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <initializer_list>
#include <memory>
#include <new>
#include <optional>

struct masu_tracer {
  masu::SceneFile scene;
  std::optional<masu::GridFile> grid; // none for brute force
  masu::Tracer tracer;
  mutable masu::UsualLoops loops; // found out by the first query

  // gpus: none for the CPU. open_grid(scene, grid): a pointer to the grid that it opened, or null.
  using OpenGrid =
      std::function<const masu::GridFile*(const masu::SceneFile&, std::optional<masu::GridFile>&)>;
  masu_tracer(const char* scene_path, masu::Residence residence, const std::vector<int>& gpus,
              const OpenGrid& open_grid)
      : scene(scene_path, residence),
        tracer(scene, open_grid(scene, grid), gpus.empty() ? masu::Device::cpu : masu::Device::cuda, gpus) {}
};

namespace {

using namespace masu;

static_assert(sizeof(masu_ray) == sizeof(Ray<float>) &&
              offsetof(masu_ray, tmin) == offsetof(Ray<float>, t_min) &&
              offsetof(masu_ray, direction) == offsetof(Ray<float>, direction));
static_assert(MASU_ERROR_USAGE == static_cast<int>(ErrorCode::usage) &&
              MASU_ERROR_INPUT == static_cast<int>(ErrorCode::input) &&
              MASU_ERROR_OUTPUT == static_cast<int>(ErrorCode::output) &&
              MASU_ERROR_DEVICE == static_cast<int>(ErrorCode::device));
static_assert(MASU_NONE == no_primitive);

std::string& error_of_thread() {
  thread_local std::string text;
  return text;
}

masu_status report(masu_status status, const char* text) noexcept {
  try {
    error_of_thread() = text;
  } catch (...) { // no memory for the text
    error_of_thread().clear();
  }
  return status;
}

// The status of act(), which may throw.
template <class Act>
masu_status guarded(const Act& act) noexcept {
  try {
    act();
    return MASU_OK;
  } catch (const Error& error) {
    return report(static_cast<masu_status>(error.code()), error.what());
  } catch (const std::bad_alloc&) {
    return report(MASU_ERROR_MEMORY, "memory: there isn't enough");
  } catch (const std::exception& error) {
    return report(MASU_ERROR_INPUT, error.what());
  } catch (...) {
    return report(MASU_ERROR_INPUT, "an unknown error");
  }
}

[[noreturn]] void fail(const char* place, const std::string& what) {
  throw Error(ErrorCode::usage, place, what);
}

void require(const void* pointer, const char* place) {
  if (pointer == nullptr) fail(place, "is a null pointer");
}

// An enumeration's value out of C, of so many that there are. C++ has no others, so its bytes are looked at.
template <class To, class From>
To choice(const From& value, int values, const char* place) {
  int number = 0;
  static_assert(sizeof number == sizeof value);
  std::memcpy(&number, &value, sizeof number);
  if (number < 0 || number >= values) fail(place, fmt::format("{} isn't one of its values", number));
  return static_cast<To>(number);
}

constexpr RayFormat ray_formats[] = {{false, 8}, {false, 6}, {true, 8}, {true, 6}};
static_assert(static_cast<int>(Precision::automatic) == MASU_PRECISION_AUTO &&
              static_cast<int>(Precision::doubled) == MASU_PRECISION_DOUBLE);

// --- Queries

// Fewer are traced in little more time than it takes to find out how.
constexpr std::size_t rays_worth_a_sample = std::size_t{1} << 22;

// Traces rays where they lie; the results must be there, too.
void trace(const masu_tracer& tracer, const void* rays, std::size_t count, const masu_query* options,
           Query query, const RayResults& results) {
  if (count == 0) return;
  require(rays, "rays");
  const masu_query wanted = options != nullptr ? *options : masu_query{};
  RaysRequest request;
  request.query = query;
  request.tracing.precision = choice<Precision>(wanted.precision, 4, "precision");
  RayList list(rays, count, ray_formats[choice<int>(wanted.format, 4, "format")]);
  list.format.is_relative = wanted.relative != 0;
  const int place = device_of(rays);
  for (const void* const pointer :
       std::initializer_list<const void*>{results.t, results.primitive, results.object, results.uv,
                                          results.normal, results.face, results.occluded}) {
    if (pointer != nullptr && device_of(pointer) != place)
      fail("results", "don't lie where the rays are: take memory of one kind and device for all");
    if (pointer != results.occluded && reinterpret_cast<std::uintptr_t>(pointer) % sizeof(float) != 0)
      fail("results", "aren't aligned as their numbers must be");
  }
  if (tracer.grid && tracer.tracer.device() == Device::cuda)
    request.loop = place == host_memory && count >= rays_worth_a_sample
                       ? automatic_loop(tracer.tracer, list, request.query, request.tracing.precision)
                       : tracer.loops.of(tracer.tracer, wanted.coherent != 0);
  if (place == host_memory) {
    tracer.tracer.trace(list, results, request);
    return;
  }
  const std::vector<int>& gpus = tracer.tracer.gpus();
  if (std::ranges::count(gpus, place) == 0)
    fail("rays", fmt::format("lie in memory of GPU {}, the tracer is on {}", place,
                             gpus.empty() ? "the CPU" : fmt::format("GPU {}", fmt::join(gpus, ", "))));
  tracer.tracer.trace_on_device(list, results, request, wanted.stream, place);
}

// --- Grids

BuildOptions build_options(const masu_grid_options& from) {
  BuildOptions options;
  constexpr GridKind kinds[] = {GridKind::automatic, GridKind::uniform,   GridKind::x,      GridKind::balance,
                                GridKind::irregular, GridKind::hierarchy, GridKind::fastest};
  const auto in_range = [](double value, double low, double high, const char* place) {
    if (!(value >= low && value <= high))
      fail(place, fmt::format("{} isn't from {} to {}", value, low, high));
  };
  in_range(from.target, 1, 1 << 20, "target");
  in_range(from.alpha, 0, 1, "alpha");
  in_range(from.step_cost, 0, 1000, "step_cost");
  in_range(from.detail, 0.1, 100, "detail");
  in_range(from.nested, 0, 15, "nested");
  in_range(from.expansions, 0, 64, "expansions");
  in_range(from.threads, 0, 4096, "threads");
  options.grid = {kinds[choice<int>(from.kind, 7, "kind")],
                  from.target,
                  from.alpha,
                  from.step_cost,
                  from.detail,
                  from.nested,
                  from.expansions};
  options.division = parse_division(from.division != nullptr ? from.division : "auto");
  options.space = from.cube_space != 0 ? SpaceRule::cube : SpaceRule::tight;
  options.overlap = from.box_overlap != 0 ? Overlap::box : Overlap::exact;
  options.processor = from.for_cpu != 0 ? Processor::cpu : Processor::gpu;
  return options;
}

template <class Stored>
void build(const SceneFile& file, const std::string& path, const BuildOptions& options, int device) {
  const SceneView<Stored> scene = file.view<Stored>();
  const auto builder = device == MASU_CPU ? cpu_builder(scene) : cuda_builder(scene, device);
  const auto [grid, provenance, considered] = build_chosen(*builder, file.geometry(), options);
  write_grid(grid, provenance, path);
}

// Writes the grid of a checked scene; `device` is MASU_CPU or a GPU's number.
void build(const SceneFile& file, const std::string& path, const BuildOptions& options, int device) {
  file.is_float64() ? build<double>(file, path, options, device) : build<float>(file, path, options, device);
}

// --- Tracers

// A library has no signal handlers, so it maps nothing: a CPU's tracer has copies, a GPU gets the files' own.
Residence residence_for(std::size_t gpu_count) {
  return gpu_count == 0 ? Residence::memory : Residence::file;
}

// What masu_build_grid() writes for MASU_GRID_FASTEST and the device, in a file in memory.
GridFile* build_in_memory(const SceneFile& scene, int device, std::optional<GridFile>& grid) {
  masu_grid_options fastest;
  masu_default_grid_options(&fastest);
  fastest.kind = MASU_GRID_FASTEST;
  fastest.for_cpu = device == MASU_CPU ? 1 : 0;
  const BuildOptions options = build_options(fastest);
  const MemoryFile file;
  // A builder takes scenes in memory alone.
  if (scene.residence() == Residence::memory)
    build(scene, file.path(), options, device);
  else
    build(SceneFile(scene.path()), file.path(), options, device);
  return &grid.emplace(file.path(), scene.residence());
}

masu_status open_tracer(const char* scene, const int* gpus, std::size_t gpu_count, masu_tracer** tracer,
                        const masu_tracer::OpenGrid& open_grid) {
  return guarded([&] {
    require(tracer, "tracer");
    *tracer = nullptr;
    require(scene, "scene");
    if (gpu_count > 0) require(gpus, "gpus");
    check_processor();
    const std::vector<int> numbers(gpus, gpus + gpu_count);
    for (const int gpu : numbers) {
      if (gpu >= 0 && gpu < cuda_device_count()) continue;
      std::string why = fmt::format("GPU {} isn't there: of {}", gpu, cuda_device_count());
      if (cuda_device_count() == 0) cuda_available(why);
      throw Error(ErrorCode::device, "device", why + ": use MASU_CPU");
    }
    *tracer = std::make_unique<masu_tracer>(scene, residence_for(gpu_count), numbers, open_grid).release();
  });
}

} // namespace

extern "C" {

const char* masu_error(void) {
  return error_of_thread().c_str();
}

const char* masu_version(void) {
  return MASU_VERSION;
}

masu_status masu_gpu_count(int* count) {
  return guarded([&] {
    require(count, "count");
    *count = cuda_device_count();
  });
}

masu_status masu_open(const char* scene, const char* grid, int device, masu_tracer** tracer) {
  return masu_open_devices(scene, grid, &device, device == MASU_CPU ? 0 : 1, tracer);
}

masu_status masu_open_devices(const char* scene, const char* grid, const int* gpus, size_t gpu_count,
                              masu_tracer** tracer) {
  return open_tracer(scene, gpus, gpu_count, tracer,
                     [&](const SceneFile& file, std::optional<GridFile>& opened) {
                       if (grid != nullptr) return &opened.emplace(grid, file.residence());
                       return build_in_memory(file, gpu_count > 0 ? gpus[0] : MASU_CPU, opened);
                     });
}

masu_status masu_open_brute_force(const char* scene, const int* gpus, size_t gpu_count,
                                  masu_tracer** tracer) {
  return open_tracer(scene, gpus, gpu_count, tracer,
                     [](const SceneFile&, std::optional<GridFile>&) { return nullptr; });
}

void masu_close(masu_tracer* tracer) {
  delete tracer;
}

masu_status masu_describe(const masu_tracer* tracer, masu_description* description) {
  return guarded([&] {
    require(tracer, "tracer");
    require(description, "description");
    const SceneFile& scene = tracer->scene;
    *description = {};
    const auto count = [&](const auto& view) {
      description->triangles = view.triangle_count;
      description->spheres = view.sphere_count;
      description->cones = view.cone_count;
    };
    scene.is_float64() ? count(scene.view<double>()) : count(scene.view<float>());
    description->materials = static_cast<std::uint32_t>(scene.counts().materials);
    const Vec3d origin = scene.origin();
    const Boxd box = in_world(origin, scene.bounds());
    for (int axis = 0; axis < 3; ++axis) {
      description->origin[axis] = origin[axis];
      description->bounds_min[axis] = box.min[axis];
      description->bounds_max[axis] = box.max[axis];
    }
    description->scene_bytes = scene.bytes();
    description->grid_bytes = tracer->grid ? tracer->grid->bytes() : 0;
    description->is_float64 = scene.is_float64() ? 1 : 0;
    description->error_bound = error_bound(scene, Precision::automatic);
    description->device = tracer->tracer.gpus().empty() ? MASU_CPU : tracer->tracer.gpus().front();
  });
}

masu_status masu_describe_primitive(const masu_tracer* tracer, uint32_t index, masu_primitive* primitive) {
  return guarded([&] {
    require(tracer, "tracer");
    require(primitive, "primitive");
    const auto [surface, m] = tracer->tracer.properties(index);
    const auto describe = [&](const auto& view) {
      *primitive = {index < view.triangle_count                       ? MASU_TRIANGLE
                    : index < view.triangle_count + view.sphere_count ? MASU_SPHERE
                                                                      : MASU_CONE,
                    surface.object,
                    surface.material,
                    {m.color.x, m.color.y, m.color.z},
                    m.diffuse,
                    m.specular,
                    m.shine,
                    m.transmittance,
                    m.refraction_index};
    };
    tracer->scene.is_float64() ? describe(tracer->scene.view<double>())
                               : describe(tracer->scene.view<float>());
  });
}

masu_status masu_nearest(const masu_tracer* tracer, const void* rays, size_t count, const masu_query* query,
                         const masu_hits* hits) {
  return guarded([&] {
    require(tracer, "tracer");
    require(hits, "hits");
    RayResults results;
    results.t = hits->t;
    results.primitive = hits->primitive;
    results.object = hits->object;
    results.uv = reinterpret_cast<float(*)[2]>(hits->uv);
    results.normal = reinterpret_cast<float(*)[3]>(hits->normal);
    results.face = hits->face;
    trace(*tracer, rays, count, query, Query::nearest_hit, results);
  });
}

masu_status masu_occluded(const masu_tracer* tracer, const void* rays, size_t count, const masu_query* query,
                          uint8_t* occluded) {
  return guarded([&] {
    require(tracer, "tracer");
    if (count > 0) require(occluded, "occluded");
    RayResults results;
    results.occluded = occluded;
    trace(*tracer, rays, count, query, Query::occlusion, results);
  });
}

masu_status masu_write_scene(const char* path, const masu_mesh* meshes, size_t mesh_count, masu_store store,
                             const double* origin) {
  return guarded([&] {
    require(path, "path");
    if (mesh_count > 0) require(meshes, "meshes");
    std::vector<IndexedMesh> indexed;
    for (const masu_mesh& mesh : std::span(meshes, mesh_count)) {
      if (mesh.triangle_count > 0) require(mesh.indices, "indices");
      if (mesh.vertex_count > 0 && mesh.vertices == nullptr) require(mesh.vertices64, "vertices");
      if (mesh.vertices != nullptr && mesh.vertices64 != nullptr)
        fail("vertices", "are given twice: as float and as double");
      IndexedMesh& added = indexed.emplace_back();
      added.vertices = mesh.vertex_count;
      added.triangles = mesh.triangle_count;
      added.indices = mesh.indices;
      added.vertex = [&mesh](std::size_t i) {
        const auto at = [&](const auto* v) {
          return Vec3d{static_cast<double>(v[3 * i]), static_cast<double>(v[3 * i + 1]),
                       static_cast<double>(v[3 * i + 2])};
        };
        return mesh.vertices != nullptr ? at(mesh.vertices) : at(mesh.vertices64);
      };
      if (mesh.color == nullptr) continue;
      added.color = {mesh.color[0], mesh.color[1], mesh.color[2]};
      if (!std::isfinite(added.color.x + added.color.y + added.color.z)) fail("color", "isn't finite");
    }
    std::optional<Vec3d> wanted;
    if (origin != nullptr) wanted = {origin[0], origin[1], origin[2]};
    write_scene(scene_of(indexed), choice<Store>(store, 3, "store"), path, wanted);
  });
}

void masu_default_grid_options(masu_grid_options* options) {
  if (options == nullptr) return;
  const GridOptions defaults;
  *options = {};
  options->division = "auto";
  options->target = defaults.target;
  options->alpha = defaults.alpha;
  options->step_cost = defaults.step_cost;
  options->detail = defaults.detail;
  options->nested = defaults.nested_log2;
  options->expansions = defaults.expansions;
}

masu_status masu_build_grid(const char* scene, const char* grid, const masu_grid_options* options) {
  return guarded([&] {
    require(scene, "scene");
    require(grid, "grid");
    if (is_same_file(scene, grid)) fail("grid", "is the scene file itself: name another");
    check_processor();
    masu_grid_options defaults;
    masu_default_grid_options(&defaults);
    const masu_grid_options& wanted = options != nullptr ? *options : defaults;
    const BuildOptions build_as = build_options(wanted);
    const SceneFile file(scene);
    tbb::task_arena arena(wanted.threads > 0 ? wanted.threads : tbb::task_arena::automatic);
    arena.execute([&] { build(file, grid, build_as, wanted.gpu != 0 ? 0 : MASU_CPU); });
  });
}
}
