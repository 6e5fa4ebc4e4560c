// Cuts the text into pieces while it is read, parses them in parallel, and joins them in order.
#include "libscene/nff/nff.h"

#include "libscene/automatic_camera.h"
#include "libscene/base/available_memory.h"
#include "libscene/base/error.h"
#include "libscene/base/host_array.h"
#include "libscene/file/input_file.h"
#include "libscene/nff/nff_piece.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fmt/format.h>
#include <optional>
#include <utility>

#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

namespace masu {
namespace {

using nff::Piece;
using nff::Text;

constexpr Material default_material{{1, 1, 1}, 1, 0, 0, 0, 1};

// A piece in the pipeline.
struct Job {
  HostArray<char> characters{}; // of the piece and some after it
  std::uint64_t size = 0;       // of the piece
  std::uint64_t lines_before = 0, bytes_after = 0;
  double share = 0; // of the text that ends with it; 0 where that isn't known
  Piece piece{};
  std::exception_ptr error{};
};

// Cuts a text into pieces while it is read. A piece ends before the first line that starts with an entity,
// piece_bytes after its own start or later.
class Cutter {
public:
  Cutter(const TextSource& source, const std::string& name, std::size_t piece_bytes)
      : source_(source), name_(name), piece_bytes_(std::max<std::size_t>(piece_bytes, 1)) {}

  bool is_at_end() const { return is_all_read_ && rest_.empty(); }

  void next(Job& job) {
    job.characters.assign(rest_.begin(), rest_.end());
    std::uint64_t searched = piece_bytes_ - 1; // a line can't start before
    std::optional<std::uint64_t> end;
    while (!(end = end_of_piece(job.characters, searched)))
      read(job.characters);
    job.size = *end;
    rest_.assign(job.characters.begin() + static_cast<std::ptrdiff_t>(job.size), job.characters.end());
    job.lines_before = lines_;
    lines_ += count_lines({job.characters.data(), job.size});
    bytes_ += job.size;
    constexpr std::uint64_t unknown = std::uint64_t{1} << 62;
    const std::uint64_t seen = bytes_ + rest_.size() + mark_bytes_;
    job.bytes_after = is_all_read_ ? 0 : source_.bytes ? *source_.bytes - seen : unknown;
    job.share = source_.bytes ? static_cast<double>(bytes_) / static_cast<double>(*source_.bytes) : 0;
  }

private:
  // The beginning of the first line at or after `searched`, which an entity starts; or the end of the text.
  // None where that isn't read yet: what is before `searched` needn't be searched again.
  std::optional<std::uint64_t> end_of_piece(const HostArray<char>& characters,
                                            std::uint64_t& searched) const {
    const std::string_view text(characters.data(), characters.size());
    // A comment ends with its line, so that no such line is inside one.
    for (std::size_t i = text.find('\n', searched); i != std::string_view::npos; i = text.find('\n', i + 1)) {
      searched = i;
      const std::size_t begin = text.find_first_not_of(" \t", i + 1);
      std::size_t end = std::min(begin, text.size());
      while (end != text.size() && end - begin < 3 && !nff::ends_token(text[end]))
        ++end;
      if (end == text.size() && !is_all_read_) return {};
      if (begin < end && is_entity(text.substr(begin, end - begin))) return i + 1;
    }
    if (is_all_read_) return text.size();
    searched = std::max(searched, text.size());
    return {};
  }
  // The lines of a view (from, at, …) aren't entities.
  static bool is_entity(std::string_view word) {
    return word == "pp" ||
           (word.size() == 1 && std::string_view("pscflbv").find(word[0]) != std::string_view::npos);
  }

  void read(HostArray<char>& characters) {
    constexpr std::size_t few = 4096;
    const std::size_t before = characters.size();
    const std::size_t more = before < piece_bytes_ ? piece_bytes_ - before + few : before / 4 + few;
    check_length(characters, more);
    characters.resize(before + more);
    const std::size_t got = source_.read(characters.data() + before, more);
    characters.resize(before + got);
    is_all_read_ = got < more;
    if (bytes_ == 0 && before == 0 && std::string_view(characters.data(), got).starts_with("\xEF\xBB\xBF")) {
      mark_bytes_ = 3;
      characters.erase(characters.begin(), characters.begin() + 3);
    }
  }
  // A text without entities is one piece, which takes this memory twice while it grows.
  void check_length(const HostArray<char>& characters, std::size_t more) const {
    if (characters.size() < std::size_t{64} << 20) return;
    const double needed = 2 * static_cast<double>(characters.size() + more), available = available_memory();
    if (needed > available)
      throw Error(
          ErrorCode::input, name_,
          fmt::format("has {:.1f} GB in which no line starts with an entity, and {:.1f} GB of memory are "
                      "available: start entities on lines of their own",
                      static_cast<double>(characters.size()) / 1e9, available / 1e9));
    if (std::memchr(characters.data(), 0, characters.size()) != nullptr)
      throw Error(ErrorCode::input, name_, "isn't a text: it has bytes that are zero");
  }
  // Lines end with LF, CR or both; no piece ends between these.
  static std::uint64_t count_lines(std::string_view text) {
    auto lines = std::count(text.begin(), text.end(), '\n');
    for (std::size_t i = text.find('\r'); i != std::string_view::npos; i = text.find('\r', i + 1))
      lines += i + 1 == text.size() || text[i + 1] != '\n' ? 1 : 0;
    return static_cast<std::uint64_t>(lines);
  }

  const TextSource& source_;
  const std::string& name_;
  std::size_t piece_bytes_;
  HostArray<char> rest_; // read, but after the last piece
  std::uint64_t lines_ = 0, bytes_ = 0, mark_bytes_ = 0;
  bool is_all_read_ = false;
};

// The joined pieces.
struct Assembly {
  Scene scene{};
  std::vector<nff::WrittenLight> lights;
  std::optional<nff::View> view;
  MaterialTable materials;
  Material material = default_material; // current at the end of the joined pieces
  bool holds_entities = false;
  std::uint64_t checked_bytes = 0; // of the scene, when there was memory for more
};

template <class... Arrays>
std::uint64_t bytes_of(const Arrays&... arrays) {
  return (std::uint64_t{0} + ... + (arrays.size() * sizeof(*arrays.data())));
}

// Throws where memory runs out.
void check_memory(Assembly& assembly, const std::string& name) {
  constexpr std::uint64_t step = std::uint64_t{256} << 20;
  const Scene& s = assembly.scene;
  const std::uint64_t bytes =
      bytes_of(s.triangles, s.normals, s.spheres, s.sphere_surfaces, s.cones, s.cone_surfaces);
  if (bytes < assembly.checked_bytes + step) return;
  assembly.checked_bytes = bytes;
  if (const double available = available_memory(); available < 2 * static_cast<double>(step))
    throw Error(
        ErrorCode::input, name,
        fmt::format("takes more than {:.1f} GB of memory, and {:.1f} GB more are available: split the "
                    "scene, or use a machine with more memory",
                    static_cast<double>(bytes) / 1e9, available / 1e9));
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
              std::uint32_t first_normals) {
  for (SceneTriangle& triangle : piece.triangles) {
    triangle.object += first_object;
    triangle.material = materials[triangle.material];
    if (triangle.normals != no_normals) triangle.normals += first_normals;
  }
  for (std::vector<Surface>* surfaces : {&piece.sphere_surfaces, &piece.cone_surfaces})
    for (Surface& surface : *surfaces)
      surface = {surface.object + first_object, materials[surface.material]};
}

// Adds the piece's counts. Throws when indices would overflow.
void join_counts(Assembly& assembly, const Piece& piece, const NffOptions& options, const std::string& name) {
  Scene& scene = assembly.scene;
  for (const auto count :
       {&ObjectCounts::polygons, &ObjectCounts::patches, &ObjectCounts::spheres, &ObjectCounts::cones})
    scene.objects.*count += piece.objects.*count;
  for (const auto count : {&SceneWarnings::degenerate_polygons, &SceneWarnings::degenerate_triangles,
                           &SceneWarnings::degenerate_spheres, &SceneWarnings::degenerate_cones,
                           &SceneWarnings::self_crossing_polygons})
    scene.warnings.*count += piece.warnings.*count;
  const std::uint64_t primitives = scene.triangles.size() + scene.spheres.size() + scene.cones.size() +
                                   piece.triangles.size() + piece.spheres.size() + piece.cones.size();
  if (scene.objects.sum() > max_objects)
    throw Error(ErrorCode::input, name,
                fmt::format("has more than {} objects: split the scene", max_objects));
  if (primitives > options.max_primitives)
    throw Error(ErrorCode::input, name,
                fmt::format("has more than {} primitives: split the scene", options.max_primitives));
}

void join(Assembly& assembly, Piece& piece, const NffOptions& options, const std::string& name) {
  Scene& scene = assembly.scene;
  const auto first_object = static_cast<std::uint32_t>(scene.objects.sum());
  join_counts(assembly, piece, options, name);
  renumber(piece, join_materials(assembly, piece), first_object,
           static_cast<std::uint32_t>(scene.normals.size()));
  scene.triangles.append(piece.triangles);
  scene.normals.append(piece.normals);
  scene.spheres.append(piece.spheres);
  scene.sphere_surfaces.append(piece.sphere_surfaces);
  scene.cones.append(piece.cones);
  scene.cone_surfaces.append(piece.cone_surfaces);
  assembly.lights.insert(assembly.lights.end(), piece.lights.begin(), piece.lights.end());
  if (piece.view) assembly.view = piece.view;
  if (piece.background) scene.background = *piece.background;
  assembly.holds_entities = assembly.holds_entities || piece.holds_entities;
  check_memory(assembly, name);
}

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

void parse_all(Cutter cutter, const std::string& name, const NffOptions& options, Assembly& assembly) {
  // One for each token of the pipeline: pieces leave it in order, so that the oldest job is free.
  std::vector<Job> jobs(2 * static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()));
  std::size_t started = 0;
  std::exception_ptr error, cut_error; // the first in the text; and what ended the reading
  std::atomic<bool> has_failed = false;

  const auto cut = [&](tbb::flow_control& control) -> Job* {
    Job& job = jobs[started % jobs.size()];
    const bool is_over = has_failed || cutter.is_at_end();
    if (!is_over) cut_error = caught([&] { cutter.next(job); });
    if (is_over || cut_error) {
      control.stop();
      return nullptr;
    }
    ++started;
    return &job;
  };
  const auto parse = [&](Job* job) {
    const Text text{
        {job->characters.data(), job->characters.size()}, name, job->lines_before, job->bytes_after};
    job->error = caught([&] { job->piece = nff::parse_piece(text, text.begin() + job->size); });
    return job;
  };
  const auto collect = [&](Job* job) {
    Piece piece = std::exchange(job->piece, {});
    if (error) return;
    error = job->error ? job->error : caught([&] { join(assembly, piece, options, name); });
    has_failed = error != nullptr;
    if (options.progress && job->share > 0) options.progress(job->share);
  };
  using tbb::filter_mode;
  tbb::parallel_pipeline(jobs.size(),
                         tbb::make_filter<void, Job*>(filter_mode::serial_in_order, cut) &
                             tbb::make_filter<Job*, Job*>(filter_mode::parallel, parse) &
                             tbb::make_filter<Job*, void>(filter_mode::serial_in_order, collect));
  if (error) std::rethrow_exception(error);
  if (cut_error) std::rethrow_exception(cut_error);
}

constexpr Vec3d default_direction{-1, 2, -1.2}; // of the view
constexpr double default_angle = 45;
constexpr Vec3i default_resolution{512, 512, 0};

// The view's up if given, else +z, or +y when the view is along z.
Vec3d complete_up(const nff::View& view, const Vec3d& forward) {
  constexpr double nearly_parallel = 1e-12;
  const Vec3d up = view.up.value_or(Vec3d{0, 0, 1});
  if (largest_magnitude(cross(direction(up), forward)) > nearly_parallel) return up;
  if (view.up)
    throw Error(ErrorCode::input, view.place, "the view's up is parallel to its line of sight: turn it");
  return {0, 1, 0};
}

// Replaces missing parts of `view` by defaults that show the whole scene.
Camera complete_view(const nff::View& view, const Scene& scene) {
  Camera camera{};
  camera.angle = view.angle.value_or(default_angle);
  camera.hither = view.hither.value_or(0.01);
  const Vec3i resolution = view.resolution.value_or(default_resolution);
  camera.width = resolution.x;
  camera.height = resolution.y;
  if (view.from && view.look_at) {
    camera.from = *view.from;
    camera.at = *view.look_at;
  } else {
    const Sphere<double> sphere = bounding_sphere(scene);
    const double distance = framing_distance(sphere.radius, camera.angle, camera.width, camera.height);
    const Vec3d back = direction(default_direction) * -distance;
    camera.at = view.look_at.value_or(sphere.center);
    camera.from = view.from.value_or(camera.at + back);
    if (camera.from == camera.at) camera.at = camera.from - back;
  }
  camera.up = complete_up(view, direction(camera.at - camera.from));
  return camera;
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

Scene parse(const TextSource& source, const std::string& name, const NffOptions& options) {
  Assembly assembly;
  parse_all(Cutter(source, name, options.piece_bytes), name, options, assembly);
  if (!assembly.holds_entities)
    throw Error(ErrorCode::input, name,
                "has no NFF entity: give a text with at least one of v b l f c s p pp");
  assembly.scene.materials = std::move(assembly.materials.materials);
  assembly.scene.has_camera = assembly.view.has_value();
  assembly.scene.camera = complete_view(assembly.view.value_or(nff::View{}), assembly.scene);
  finish_lights(assembly);
  return std::move(assembly.scene);
}

} // namespace

Scene parse_nff(std::string_view text, const std::string& name, const NffOptions& options) {
  return parse(TextSource::of(text), name, options);
}

Scene read_nff(const std::string& path, const NffOptions& options) {
  std::error_code unknown;
  if (path != "-" && (std::filesystem::is_regular_file(path, unknown) || unknown)) {
    const InputFile file(path);
    Scene scene = parse(TextSource::of(file), path, options);
    file.check_unchanged();
    return scene;
  }
  return parse(text_stream(path), path == "-" ? "stdin" : path, options);
}

} // namespace masu
