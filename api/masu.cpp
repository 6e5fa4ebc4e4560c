// Tracers and queries of the C interface, and its errors.
#include "boundary.h"
#include "libgrid/hierarchy/hierarchy_builder.h"
#include "libgrid/structure/chosen_structure.h"
#include "libscene/base/parallel.h"
#include "libscene/base/printable.h"
#include "libscene/base/processor.h"
#include "objects.h"
#include "renderer/backend.h"
#include "renderer/rays/automatic_loop.h"
#include "renderer/rays/winding_numbers.h"
#include "renderer/tracer/placed_tracer.h"
#include "renderer/tracer/tracer.h"

#include <mutex>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace {

// What a tracer traces, until an update.
struct State {
  std::shared_ptr<const masu::SceneFile> scene;    // none of placed meshes
  std::shared_ptr<const masu::StructureFile> grid; // likewise, for brute force, and what was built on GPUs
  std::variant<masu::ResidentTracer, masu::PlacedTracer> tracer;
  bool is_on_gpu_alone = false;   // moved there: what `scene` and `grid` say of places is of before
  mutable masu::UsualLoops loops; // found out by the first query
  mutable std::mutex mutex;       // of what follows
  mutable std::shared_ptr<const masu::StructureFile> built_grid; // a copy of what was built on GPUs
  // For closest points and winding numbers, made by their first query.
  mutable std::shared_ptr<const State> by_hierarchy;
  mutable std::shared_ptr<const masu::WindingClusters> clusters;

  // gpus: none for the CPU.
  State(std::shared_ptr<const masu::SceneFile> scene_, std::shared_ptr<const masu::StructureFile> grid_,
        const std::vector<int>& gpus)
      : scene(std::move(scene_)), grid(std::move(grid_)),
        tracer(std::in_place_type<masu::ResidentTracer>, *scene, grid.get(),
               gpus.empty() ? masu::Device::cpu : masu::Device::cuda, gpus) {}
  // Made on GPUs: built there, or moved, from that grid.
  State(masu::ResidentTracer made, std::shared_ptr<const masu::SceneFile> scene_,
        std::shared_ptr<const masu::StructureFile> grid_ = nullptr)
      : scene(std::move(scene_)), grid(std::move(grid_)), tracer(std::move(made)),
        is_on_gpu_alone(grid != nullptr) {}
  explicit State(masu::PlacedTracer placed) : tracer(std::move(placed)) {}

  const masu::PlacedTracer* placed() const { return std::get_if<masu::PlacedTracer>(&tracer); } // or none
  const masu::ResidentTracer& resident() const { return std::get<masu::ResidentTracer>(tracer); }
};

} // namespace

struct masu_tracer {
  masu::SceneVertices vertices;
  std::mutex update; // one after the other

  masu_tracer(masu::SceneVertices vertices_, std::shared_ptr<const State> state)
      : vertices(std::move(vertices_)), state_(std::move(state)) {}

  // A query keeps the one that it begins with.
  std::shared_ptr<const State> state() const {
    const std::lock_guard lock(mutex_);
    return state_;
  }
  // The caller holds the one before.
  void set_state(std::shared_ptr<const State> next) {
    const std::lock_guard lock(mutex_);
    state_ = std::move(next);
  }

private:
  mutable std::mutex mutex_;
  std::shared_ptr<const State> state_;
};

namespace masu {
namespace {

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

} // namespace

masu_status report(masu_status status, std::string_view text) noexcept {
  try {
    error_of_thread() = printable(text);
  } catch (...) { // no memory for the text
    error_of_thread().clear();
  }
  return status;
}

} // namespace masu

namespace {

using namespace masu;

void require_gpu(int number) {
  const int count = cuda_device_count();
  if (number >= 0 && number < count) return;
  std::string why = fmt::format("GPU {} isn't there: of {}", number, count);
  if (count == 0) cuda_available(why);
  throw Error(ErrorCode::device, "device", why + ": use MASU_CPU");
}

constexpr RayFormat ray_formats[] = {{8, false}, {6, false}, {8, true}, {6, true}};
RayFormat place_format(const masu_query& query) {
  const auto format = choice<int>(query.format, 4, "format");
  if (format != MASU_RAYS_FLOAT32 && format != MASU_RAYS_FLOAT64)
    fail("format", "is of rays: places are MASU_RAYS_FLOAT32 or MASU_RAYS_FLOAT64");
  if (query.faces != MASU_FACES_BOTH) fail("faces", "are both looked for");
  return {3, format == MASU_RAYS_FLOAT64, query.relative != 0};
}

static_assert(static_cast<int>(Precision::automatic) == MASU_PRECISION_AUTO &&
              static_cast<int>(Precision::doubled) == MASU_PRECISION_DOUBLE);
static_assert(static_cast<int>(RayLoop::warp_refill) == MASU_LOOP_WARP_REFILL - MASU_LOOP_THREAD_PER_RAY);

// Fewer are traced in little more time than it takes to find out how.
constexpr std::size_t rays_worth_a_sample = std::size_t{1} << 22;

RayResults results_of(const masu_hits* hits) {
  const masu_hits wanted = taken(hits, "masu_hits");
  RayResults results;
  results.t = wanted.t;
  results.t64 = wanted.t64;
  results.primitive = wanted.primitive;
  results.object = wanted.object;
  results.uv = reinterpret_cast<float(*)[2]>(wanted.uv);
  results.normal = reinterpret_cast<float(*)[3]>(wanted.normal);
  results.face = wanted.face;
  results.front = wanted.front;
  results.position = reinterpret_cast<double(*)[3]>(wanted.position);
  results.shading = reinterpret_cast<float(*)[3]>(wanted.shading);
  return results;
}

RayFilters filters_of(const masu_query& query) {
  return {query.exclude,      query.ray_masks,       query.object_masks,
          query.object_count, query.exclude_objects, query.worlds};
}

// An array that may be null: that it lies where the others do, and as its numbers must.
template <class T>
void check_array(int place, const T* array, const char* name) {
  if (array == nullptr) return;
  if (device_of(array) != place)
    fail(name, "don't lie where the other arrays do: take memory of one kind and device for all");
  if (reinterpret_cast<std::uintptr_t>(array) % alignof(T) != 0)
    fail(name, "aren't aligned as their numbers must be");
}

// What a tracer keeps, made by its first query. Of threads that ask at once each makes it, and the first is
// kept: a thread that waited for another might be what that one waits for.
template <class T, class Make>
std::shared_ptr<const T> kept(const State& tracer, std::shared_ptr<const T>& kept_there,
                              const Make& make_it) {
  {
    const std::lock_guard lock(tracer.mutex);
    if (kept_there) return kept_there;
  }
  std::shared_ptr<const T> made = make_it();
  const std::lock_guard lock(tracer.mutex);
  if (!kept_there) kept_there = std::move(made);
  return kept_there;
}

// What it traces through; null for brute force and placed meshes.
std::shared_ptr<const StructureFile> grid_of(const State& state) {
  if (state.grid || state.placed() != nullptr || !state.resident().is_hierarchy()) return state.grid;
  return kept(state, state.built_grid,
              [&] { return std::make_shared<const StructureFile>(state.resident().built_hierarchy()); });
}

std::shared_ptr<const State> with_fast_hierarchy(const std::shared_ptr<const SceneFile>& scene,
                                                 const std::vector<int>& gpus,
                                                 const std::function<void(double)>& progress) {
  if (!gpus.empty())
    return std::make_shared<const State>(ResidentTracer::by_fast_hierarchy(*scene, gpus, progress), scene);
  auto hierarchy =
      std::make_shared<const StructureFile>(built_in_memory(*scene, fast_hierarchy_options(), progress));
  return std::make_shared<const State>(scene, std::move(hierarchy), gpus);
}

// What answers soonest: a hierarchy, or for a scene that none holds a grid.
std::shared_ptr<const State> soonest(const std::shared_ptr<const SceneFile>& scene,
                                     const std::vector<int>& gpus,
                                     const std::function<void(double)>& progress) {
  const bool fits =
      scene->primitive_count() <= max_hierarchy_primitives &&
      scene->with_view_but_triangles([&]<class Stored>(const SceneView<Stored>&) {
        return fits_hierarchy(layout_in<Stored>(scene->bounds(), {1, 1, 1}, SpaceRule::tight).space);
      });
  if (fits) return with_fast_hierarchy(scene, gpus, progress);
  auto grid = std::make_shared<const StructureFile>(
      usual_grid(*scene, gpus.empty() ? MASU_CPU : gpus.front(), progress));
  return std::make_shared<const State>(scene, std::move(grid), gpus);
}

// The same scene by a hierarchy, or none for brute force.
std::shared_ptr<const State> by_hierarchy(const std::shared_ptr<const State>& state,
                                          const std::function<void(double)>& progress) {
  if (!state->grid || state->grid->is_hierarchy()) return state;
  return kept(*state, state->by_hierarchy,
              [&] { return with_fast_hierarchy(state->scene, state->resident().gpus(), progress); });
}

// Traces rays where they lie; the results must be there, too.
void trace(const masu_tracer& tracer_handle, const void* rays, std::size_t count, const masu_query* options,
           Query query, const RayResults& results, std::uint32_t limit = 1) {
  if (count == 0) return;
  const bool is_of_places = query == Query::closest_point;
  require(rays, is_of_places ? "places" : "rays");
  const masu_query wanted = options != nullptr ? taken(options, "masu_query") : masu_query{};
  RaysRequest request;
  request.query = query;
  request.limit = limit;
  request.faces = choice<Faces>(wanted.faces, 3, "faces");
  request.tracing.precision = choice<Precision>(wanted.precision, 4, "precision");
  GoOn go_on(wanted.go_on, wanted.user);
  request.progress = go_on.progress();
  RayList list(rays, count,
               is_of_places ? place_format(wanted) : ray_formats[choice<int>(wanted.format, 4, "format")]);
  list.format.is_relative = wanted.relative != 0;
  list.filters = filters_of(wanted);
  const int place = device_of(rays);
  const auto check = [place](const auto* array) { check_array(place, array, "results"); };
  for_each_array(results, check);
  const RayFilters& f = list.filters;
  for (const std::uint32_t* const array :
       {f.excluded, f.object_masks, f.ray_masks, f.excluded_objects, f.worlds})
    check(array);
  auto state = tracer_handle.state();
  if (is_of_places) on_threads_up_to(wanted.threads, [&] { state = by_hierarchy(state, request.progress); });
  const auto loop = choice<int>(wanted.loop, 4, "loop");
  if (loop != MASU_LOOP_AUTO) request.loop = static_cast<RayLoop>(loop - MASU_LOOP_THREAD_PER_RAY);
  const auto trace_by = [&](const auto& tracer) {
    if (place == host_memory) {
      on_threads_up_to(wanted.threads, [&] { tracer.trace(list, results, request); });
      return;
    }
    const std::vector<int>& gpus = tracer.gpus();
    if (std::ranges::count(gpus, place) == 0)
      fail(is_of_places ? "places" : "rays",
           fmt::format("lie in memory of GPU {}, the tracer is on {}", place,
                       gpus.empty() ? "the CPU" : fmt::format("GPU {}", fmt::join(gpus, ", "))));
    tracer.trace_on_device(list, results, request, wanted.stream, place);
  };
  if (const PlacedTracer* const placed = state->placed()) {
    if (loop == MASU_LOOP_AUTO) request.loop = placed->usual_loop(wanted.coherent != 0);
    return trace_by(*placed);
  }
  const ResidentTracer& tracer = state->resident();
  if (loop == MASU_LOOP_AUTO && tracer.device() == Device::cuda && !is_of_places &&
      !needs_hits_in_order(list, results, request)) {
    if (tracer.is_hierarchy())
      request.loop = wanted.coherent != 0 ? RayLoop::thread_per_ray : RayLoop::automatic;
    else if (state->grid)
      request.loop = place == host_memory && count >= rays_worth_a_sample
                         ? automatic_loop(tracer, list, request.query, request.tracing.precision)
                         : state->loops.of(tracer, wanted.coherent != 0);
  }
  trace_by(tracer);
}

// Queries whose results are one array, a number for each ray.
template <class Number>
masu_status trace_to(Number* RayResults::*array, Number* given, const char* name, const masu_tracer* tracer,
                     const void* rays, std::size_t count, const masu_query* options, Query query) {
  return guarded([&] {
    require(tracer, "tracer");
    if (count > 0) require(given, name);
    RayResults results;
    results.*array = given;
    trace(*tracer, rays, count, options, query, results);
  });
}

// The array, if there is one: aligned, and written, where the program's stream still writes in a GPU's
// memory. What is done with it there comes after the default stream's work.
template <class Number>
const Number* ready(const Number* numbers, void* stream, const char* place) {
  if (numbers == nullptr) return nullptr;
  if (reinterpret_cast<std::uintptr_t>(numbers) % sizeof(Number) != 0)
    fail(place, "aren't aligned as their numbers must be");
  if (const int device = device_of(numbers); device != host_memory && stream != nullptr)
    wait_for_stream(stream, device);
  return numbers;
}

Vertices vertices_of(const masu_vertices& given, const SceneVertices& scene) {
  if (scene.count == 0) fail("scene", "has no triangles, which alone can be moved");
  require_numbers(given.values, given.values64, scene.count, "vertices");
  if (given.count != scene.count)
    fail("vertices", fmt::format("are {}, the scene was made of {}", given.count, scene.count));
  return {ready(given.values, given.stream, "vertices"), ready(given.values64, given.stream, "vertices"),
          given.count,
          scene.indices ? std::span<const std::uint32_t>(*scene.indices) : std::span<const std::uint32_t>()};
}

PlacementMoves moves_of(const masu_transforms& given) {
  require_numbers(given.values, given.values64, given.count, "transforms");
  return {ready(given.values, given.stream, "transforms"), ready(given.values64, given.stream, "transforms"),
          given.count, ready(given.indices, given.stream, "transforms"), given.square != 0};
}

// Refitted where the tracer traces; where that can't be, built anew in host memory. The hierarchy of before
// is kept there, for who asks for it.
std::shared_ptr<const State> moved(const State& before, const Vertices& vertices) {
  const std::shared_ptr<const StructureFile> hierarchy = grid_of(before);
  require_hierarchy(hierarchy.get());
  if (before.resident().device() == Device::cuda) {
    if (std::optional<ResidentTracer> tracer = before.resident().moved(vertices))
      return std::make_shared<const State>(*std::move(tracer), before.scene, hierarchy);
  }
  auto scene = std::make_shared<const SceneFile>(moved_scene(*before.scene, vertices));
  auto grid = std::make_shared<const StructureFile>(refitted_grid(*hierarchy, *scene));
  return std::make_shared<const State>(std::move(scene), std::move(grid), before.resident().gpus());
}

// Has a tracer go on with next(the state before it). Isolated, or a thread that waits might take another task
// of the program that updates.
template <class Next>
masu_status update(masu_tracer* tracer, const Next& next) {
  return guarded([&] {
    require(tracer, "tracer");
    const std::lock_guard lock(tracer->update);
    const auto before = tracer->state();
    tbb::this_task_arena::isolate([&] { tracer->set_state(next(*before)); });
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

masu_status masu_tracer_create(const masu_scene* scene, const masu_grid* grid,
                               const masu_tracer_options* options, masu_tracer** tracer) {
  return make(tracer, "tracer", [&] {
    require(scene, "scene");
    check_processor();
    const masu_tracer_options wanted =
        options != nullptr ? taken(options, "masu_tracer_options") : masu_tracer_options{};
    if (wanted.gpu_count > 0) require(wanted.gpus, "gpus");
    if (wanted.brute_force != 0 && grid != nullptr) fail("grid", "isn't used by brute force");
    const std::vector<int> gpus(wanted.gpus, wanted.gpus + wanted.gpu_count);
    for (const int gpu : gpus)
      require_gpu(gpu);
    GoOn go_on(wanted.go_on, wanted.user);
    if (scene->placed != nullptr) {
      if (grid != nullptr) fail("grid", "isn't used for placed meshes: a hierarchy is built of each");
      return std::make_unique<masu_tracer>(
          scene->vertices, std::make_shared<const State>(PlacedTracer(
                               scene->placed, choice<HierarchyQuality>(wanted.quality, 2, "quality"),
                               wanted.brute_force != 0, gpus, go_on.progress())));
    }
    if (grid == nullptr && wanted.brute_force == 0)
      return std::make_unique<masu_tracer>(scene->vertices, soonest(scene->file, gpus, go_on.progress()));
    return std::make_unique<masu_tracer>(
        scene->vertices,
        std::make_shared<const State>(scene->file, grid != nullptr ? grid->file : nullptr, gpus));
  });
}

masu_status masu_tracer_grid(const masu_tracer* tracer, masu_grid** grid) {
  return make(grid, "grid", [&] {
    require(tracer, "tracer");
    const std::shared_ptr<const StructureFile> file = grid_of(*tracer->state());
    if (file == nullptr) fail("tracer", "has no grid");
    return std::make_unique<masu_grid>(masu_grid{file});
  });
}

masu_status masu_tracer_update(masu_tracer* tracer, const masu_vertices* vertices) {
  return update(tracer, [&](const State& before) {
    const masu_vertices given = taken(vertices, "masu_vertices");
    if (before.placed() != nullptr) fail("tracer", "is of placed meshes: masu_tracer_place() moves them");
    return moved(before, vertices_of(given, tracer->vertices));
  });
}

masu_status masu_tracer_place(masu_tracer* tracer, const masu_transforms* transforms) {
  return update(tracer, [&](const State& before) {
    const masu_transforms given = taken(transforms, "masu_transforms");
    if (before.placed() == nullptr) fail("tracer", "has no placements: masu_tracer_update() moves vertices");
    return std::make_shared<const State>(before.placed()->moved(moves_of(given)));
  });
}

void masu_tracer_free(masu_tracer* tracer) {
  delete tracer;
}

masu_status masu_nearest(const masu_tracer* tracer, const void* rays, size_t count, const masu_query* query,
                         const masu_hits* hits) {
  return guarded([&] {
    require(tracer, "tracer");
    trace(*tracer, rays, count, query, Query::nearest_hit, results_of(hits));
  });
}

masu_status masu_occluded(const masu_tracer* tracer, const void* rays, size_t count, const masu_query* query,
                          uint8_t* occluded) {
  return trace_to(&RayResults::occluded, occluded, "occluded", tracer, rays, count, query, Query::occlusion);
}

masu_status masu_all_hits(const masu_tracer* tracer, const void* rays, size_t count, const masu_query* query,
                          uint32_t limit, const masu_hits* hits, uint32_t* counts) {
  return guarded([&] {
    require(tracer, "tracer");
    RayResults results = results_of(hits);
    results.count = counts;
    trace(*tracer, rays, count, query, Query::all_hits, results, limit);
  });
}

masu_status masu_count_hits(const masu_tracer* tracer, const void* rays, size_t count,
                            const masu_query* query, uint32_t* counts) {
  return trace_to(&RayResults::count, counts, "counts", tracer, rays, count, query, Query::count_hits);
}

masu_status masu_inside(const masu_tracer* tracer, const void* rays, size_t count, const masu_query* query,
                        uint8_t* inside) {
  return guarded([&] {
    require(tracer, "tracer");
    if (count > 0) require(inside, "inside");
    if (query != nullptr && taken(query, "masu_query").faces != MASU_FACES_BOTH)
      fail("faces", "of one side don't tell inside from outside");
    RayResults results;
    results.inside = inside;
    trace(*tracer, rays, count, query, Query::count_hits, results);
  });
}

masu_status masu_closest(const masu_tracer* tracer, const void* places, size_t count, const masu_query* query,
                         const masu_hits* hits, double* points) {
  return guarded([&] {
    require(tracer, "tracer");
    RayResults results = hits != nullptr ? results_of(hits) : RayResults{};
    if (points != nullptr) results.position = reinterpret_cast<double(*)[3]>(points);
    if (results.front != nullptr) fail("front", "isn't found for places: take masu_inside()");
    if (query != nullptr) place_format(taken(query, "masu_query"));
    trace(*tracer, places, count, query, Query::closest_point, results);
  });
}

masu_status masu_winding(const masu_tracer* tracer, const void* places, size_t count, const masu_query* query,
                         double bound, double* winding, uint8_t* inside) {
  return guarded([&] {
    require(tracer, "tracer");
    const masu_query wanted = query != nullptr ? taken(query, "masu_query") : masu_query{};
    if (const RayFilters filters = filters_of(wanted); filters.any() || filters.any_of_placed())
      fail("masu_query", "has exclude, masks or worlds: winding numbers are of all triangles");
    if (tracer->state()->placed() != nullptr)
      fail("tracer", "the scene has placements: winding numbers are of scenes without them");
    require_range(bound, 0, 1, "bound");
    const RayList list(places, count, place_format(wanted));
    if (count == 0) return;
    require(places, "places");
    if (device_of(places) != host_memory) fail("places", "must lie in host memory");
    if (reinterpret_cast<std::uintptr_t>(places) % (list.format.bytes_per_ray() / 3) != 0)
      fail("places", "aren't aligned as their numbers must be");
    check_array(host_memory, winding, "winding");
    check_array(host_memory, inside, "inside");
    GoOn go_on(wanted.go_on, wanted.user);
    const auto progress = go_on.progress();
    on_threads_up_to(wanted.threads, [&] {
      const auto state = by_hierarchy(tracer->state(), progress);
      if (state->is_on_gpu_alone)
        fail("tracer", "was moved on a GPU: winding numbers are computed in host memory");
      const std::shared_ptr<const StructureFile> hierarchy = grid_of(*state);
      const auto clusters = kept(*state, state->clusters, [&] {
        return std::make_shared<const WindingClusters>(winding_clusters(*state->scene, hierarchy.get()));
      });
      winding_numbers(*state->scene, hierarchy.get(), *clusters, relative_to(state->scene->origin(), list),
                      bound, winding, inside, progress);
    });
  });
}

masu_status masu_interpolate(const masu_values* values, const uint32_t* primitive, const float* uv,
                             size_t count, float* interpolated) {
  return guarded([&] {
    const masu_values given = taken(values, "masu_values");
    if (count == 0 || given.width == 0) return;
    if (given.count > 0 && given.triangle_count > 0) require(given.values, "values");
    require(primitive, "primitive");
    if (given.per_face == 0) require(uv, "uv");
    if (given.per_face != 0 && given.indices != nullptr) fail("indices", "aren't used by values per face");
    require(interpolated, "interpolated");
    const int place = device_of(primitive);
    check_array(place, primitive, "primitive");
    check_array(place, uv, "uv");
    check_array(place, interpolated, "interpolated");
    check_array(place, given.values, "values");
    check_array(place, given.indices, "indices");
    const CornerValues of{given.values,  given.width,          given.count,
                          given.indices, given.triangle_count, given.per_face != 0};
    const InterpolatedHits hits{primitive, reinterpret_cast<const float(*)[2]>(uv), interpolated};
    if (place != host_memory) return interpolate_cuda(of, hits, count, place, given.stream);
    parallel_ranges(count, 1024, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i != end; ++i)
        for (std::size_t k = 0; k < of.width; ++k)
          hits.results[i * of.width + k] = masu::interpolated(of, hits, i, k);
    });
  });
}
}
