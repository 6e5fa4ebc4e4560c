// Cuts the text into pieces, parses them in parallel, and joins them in order.
#include "libscene/nff/nff.h"

#include "libscene/error.h"
#include "libscene/file/input_file.h"
#include "libscene/nff/nff_piece.h"
#include "libscene/nff/nff_view.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <filesystem>
#include <fmt/format.h>
#include <limits>
#include <utility>

#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

namespace masu {
namespace {

using nff::Piece;
using nff::Text;

constexpr std::uint64_t max_objects = 0x7fffffff; // object indices are int32, with -1 for none
constexpr Material default_material{{1, 1, 1}, 1, 0, 0, 0, 1};

// Whether the line at `line` starts with an entity. The lines of a view (from, at, …) aren't entities.
bool is_entity_start(const char* line, const char* end) {
  const char* start = line;
  while (start != end && (*start == ' ' || *start == '\t'))
    ++start;
  const char* word_end = start;
  while (word_end != end && word_end - start < 3 && nff::kind_of(*word_end) == nff::Character::other)
    ++word_end;
  const std::string_view word(start, static_cast<std::size_t>(word_end - start));
  return word == "pp" ||
         (word.size() == 1 && std::string_view("pscflbv").find(word[0]) != std::string_view::npos);
}

// The end of the piece that starts at `from`: the first line that starts with an entity, piece_bytes later or
// more.
const char* piece_end(const Text& text, const char* from, std::size_t piece_bytes) {
  if (static_cast<std::size_t>(text.end() - from) <= piece_bytes) return text.end();
  const std::size_t start = static_cast<std::size_t>(from - text.begin()) + piece_bytes;
  // A comment ends with its line, so that no such line is inside one.
  for (std::size_t i = text.characters.find('\n', start); i != std::string_view::npos;
       i = text.characters.find('\n', i + 1))
    if (is_entity_start(text.begin() + i + 1, text.end())) return text.begin() + i + 1;
  return text.end();
}

// The joined pieces.
struct Assembly {
  Scene scene{};
  std::vector<nff::WrittenLight> lights;
  std::optional<nff::View> view;
  MaterialTable materials;
  Material material = default_material; // current at the end of the joined pieces
  std::uint64_t objects = 0;
  bool holds_entities = false;
};

// Appends `piece`, which ends after a fraction `share` of the text. Reserves what the whole text is expected
// to need, at most four times the current size.
template <class Record>
void append(std::vector<Record>& all, std::vector<Record>&& piece, double share) {
  const std::size_t needed = all.size() + piece.size();
  if (all.empty() && share == 1) {
    all = std::move(piece);
    return;
  }
  if (needed > all.capacity()) {
    const double expected = 1.02 * static_cast<double>(needed) / share;
    all.reserve(static_cast<std::size_t>(std::min(expected, 4 * static_cast<double>(needed))));
  }
  all.insert(all.end(), piece.begin(), piece.end());
}

std::vector<std::uint32_t> join_materials(Assembly& assembly, const Piece& piece) {
  std::vector<std::uint32_t> numbers(piece.materials.materials.size() + 1, 0);
  if (piece.uses_inherited) numbers[Piece::inherited] = assembly.materials.index_of(assembly.material);
  for (std::size_t i = 1; i < numbers.size(); ++i)
    numbers[i] = assembly.materials.index_of(piece.materials.materials[i - 1]);
  if (piece.last_material) assembly.material = *piece.last_material;
  return numbers;
}

// Replaces the piece's indices of objects, materials and normals by the scene's.
void renumber(Piece& piece, const std::vector<std::uint32_t>& materials, std::uint32_t first_object,
              std::uint64_t first_normals) {
  for (Triangle<double>& triangle : piece.triangles) {
    triangle.object += first_object;
    triangle.material = materials[triangle.material];
    if (triangle.normals != no_normals) triangle.normals += first_normals;
  }
  for (std::vector<Surface>* surfaces : {&piece.sphere_surfaces, &piece.cone_surfaces})
    for (Surface& surface : *surfaces)
      surface = {surface.object + first_object, materials[surface.material]};
}

void add(ObjectCounts& all, const ObjectCounts& more) {
  all.polygons += more.polygons;
  all.patches += more.patches;
  all.spheres += more.spheres;
  all.cones += more.cones;
}

void add(SceneWarnings& all, const SceneWarnings& more) {
  all.degenerate_polygons += more.degenerate_polygons;
  all.degenerate_triangles += more.degenerate_triangles;
  all.degenerate_spheres += more.degenerate_spheres;
  all.degenerate_cones += more.degenerate_cones;
  all.self_crossing_polygons += more.self_crossing_polygons;
}

// Adds the piece's counts. Throws when indices would overflow.
void join_counts(Assembly& assembly, const Piece& piece, const std::string& name) {
  Scene& scene = assembly.scene;
  add(scene.objects, piece.objects);
  add(scene.warnings, piece.warnings);
  assembly.objects =
      scene.objects.polygons + scene.objects.patches + scene.objects.spheres + scene.objects.cones;
  const std::uint64_t primitives = scene.triangles.size() + scene.spheres.size() + scene.cones.size() +
                                   piece.triangles.size() + piece.spheres.size() + piece.cones.size();
  if (assembly.objects > max_objects)
    throw Error(ErrorCode::input, name,
                fmt::format("has more than {} objects: split the scene", max_objects));
  if (primitives > max_primitives)
    throw Error(ErrorCode::input, name,
                fmt::format("has more than {} primitives: split the scene", max_primitives));
}

void join(Assembly& assembly, Piece&& piece, double share, const std::string& name) {
  Scene& scene = assembly.scene;
  const auto first_object = static_cast<std::uint32_t>(assembly.objects);
  join_counts(assembly, piece, name);
  renumber(piece, join_materials(assembly, piece), first_object, scene.normals.size());
  append(scene.triangles, std::move(piece.triangles), share);
  append(scene.normals, std::move(piece.normals), share);
  append(scene.spheres, std::move(piece.spheres), share);
  append(scene.sphere_surfaces, std::move(piece.sphere_surfaces), share);
  append(scene.cones, std::move(piece.cones), share);
  append(scene.cone_surfaces, std::move(piece.cone_surfaces), share);
  assembly.lights.insert(assembly.lights.end(), piece.lights.begin(), piece.lights.end());
  if (piece.view) assembly.view = piece.view;
  if (piece.background) scene.background = *piece.background;
  assembly.holds_entities = assembly.holds_entities || piece.holds_entities;
}

// A piece in the pipeline.
struct Job {
  const char* from = nullptr;
  const char* to = nullptr;
  Piece piece{};
  std::exception_ptr error{};
};

// Calls body() and returns what it throws. oneTBB's pipeline may leak tokens when a filter throws, and
// rethrows any one of several exceptions.
template <class Body>
std::exception_ptr caught(const Body& body) {
  try {
    body();
    return nullptr;
  } catch (...) {
    return std::current_exception();
  }
}

void parse_all(const Text& text, const char* from, const NffOptions& options, Assembly& assembly) {
  const std::size_t piece_bytes = std::max<std::size_t>(options.piece_bytes, 1);
  const int cores = tbb::this_task_arena::max_concurrency();
  tbb::task_arena arena(options.threads > 0 ? std::min(options.threads, cores) : cores);
  // One for each token of the pipeline: pieces leave it in order, so that the oldest job is free.
  std::vector<Job> jobs(2 * static_cast<std::size_t>(arena.max_concurrency()));
  std::size_t started = 0;
  std::exception_ptr error; // the first in the text
  std::atomic<bool> has_failed = false;

  const auto cut = [&](tbb::flow_control& control) -> Job* {
    if (from == text.end() || has_failed) {
      control.stop();
      return nullptr;
    }
    Job& job = jobs[started++ % jobs.size()];
    job.from = std::exchange(from, piece_end(text, from, piece_bytes));
    job.to = from;
    return &job;
  };
  const auto parse = [&](Job* job) {
    job->error = caught([&] { job->piece = nff::parse_piece(text, job->from, job->to); });
    return job;
  };
  const auto collect = [&](Job* job) {
    Piece piece = std::exchange(job->piece, {});
    if (error) return;
    const double share =
        static_cast<double>(job->to - text.begin()) / static_cast<double>(text.characters.size());
    error = job->error ? job->error : caught([&] { join(assembly, std::move(piece), share, text.name); });
    has_failed = error != nullptr;
    if (options.progress) options.progress(share);
  };
  using tbb::filter_mode;
  arena.execute([&] {
    tbb::parallel_pipeline(jobs.size(),
                           tbb::make_filter<void, Job*>(filter_mode::serial_in_order, cut) &
                               tbb::make_filter<Job*, Job*>(filter_mode::parallel, parse) &
                               tbb::make_filter<Job*, void>(filter_mode::serial_in_order, collect));
  });
  if (error) std::rethrow_exception(error);
}

// Lights, and the ambient light for n lights, √n/(2n) by the SPD's rule.
void finish_lights(Assembly& assembly) {
  Scene& scene = assembly.scene;
  if (assembly.lights.empty()) assembly.lights.push_back({scene.camera.from, {}});
  const double n = static_cast<double>(assembly.lights.size());
  const double each = std::sqrt(n) / (2 * n);
  scene.ambient = static_cast<float>(each);
  scene.lights.reserve(assembly.lights.size());
  for (const nff::WrittenLight& light : assembly.lights)
    scene.lights.push_back({light.position, light.color.value_or(Vec3d{each, each, each})});
}

} // namespace

Scene parse_nff(std::string_view characters, const std::string& name, const NffOptions& options) {
  const Text text{characters, name};
  Assembly assembly;
  const char* const start = text.begin() + (characters.starts_with("\xEF\xBB\xBF") ? 3 : 0);
  if (characters.size() <= options.piece_bytes)
    join(assembly, nff::parse_piece(text, start, text.end()), 1, name);
  else
    parse_all(text, start, options, assembly);
  if (!assembly.holds_entities)
    throw Error(ErrorCode::input, name,
                "has no NFF entity: give a text with at least one of v b l f c s p pp");
  assembly.scene.materials = std::move(assembly.materials.materials);
  assembly.scene.has_camera = assembly.view.has_value();
  assembly.scene.camera = nff::complete_view(assembly.view.value_or(nff::View{}), assembly.scene, text);
  finish_lights(assembly);
  return std::move(assembly.scene);
}

Scene read_nff(const std::string& path, const NffOptions& options) {
  std::error_code unknown;
  if (path != "-" && (std::filesystem::is_regular_file(path, unknown) || unknown))
    return parse_nff(FileContents(path).text(), path, options);
  return parse_nff(read_text_input(path), path == "-" ? "stdin" : path, options);
}

} // namespace masu
