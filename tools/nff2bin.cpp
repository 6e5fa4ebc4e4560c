// nff2bin: converts NFF text to a scene file, and reports the content of either.
#include "libscene/file/mapped_file.h"
#include "libscene/file/scene_file.h"
#include "libscene/float32_precision.h"
#include "libscene/geometry/cone.h"
#include "libscene/mesh/tessellate.h"
#include "libscene/nff/nff.h"
#include "tools/cli.h"
#include "tools/progress.h"
#include "tools/provenance.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <optional>
#include <span>
#include <utility>

namespace masu {
namespace {

using Json = nlohmann::ordered_json;

struct Settings {
  std::string input, output;
  Store store = Store::automatic;
  int facets = 0; // --tessellate; 0: spheres and cones are kept
  bool info = false, json = false, quiet = false;
  Threads threads;
};

// The report of --info, of a text or of a scene file.
struct Summary {
  ObjectCounts objects;
  std::uint64_t triangles = 0, smooth = 0, spheres = 0, cones = 0;
  std::uint64_t corner_normals = 0; // records, which smooth triangles can share
  std::uint64_t materials = 0, reflecting = 0, transmitting = 0, lights = 0;
  std::int32_t width = 0, height = 0;
  Boxd bounds = empty_box<double>();
  bool is_float64 = false;
  std::optional<std::uint64_t> file_bytes; // where there is a file
  std::optional<SceneWarnings> warnings;   // of a text only
};

std::uint64_t count(const std::vector<Material>& materials, bool (*property)(const Material&)) {
  return static_cast<std::uint64_t>(std::count_if(materials.begin(), materials.end(), property));
}

template <class Stored>
std::uint64_t count_smooth(std::span<const Triangle<Stored>> triangles) {
  return static_cast<std::uint64_t>(
      std::count_if(triangles.begin(), triangles.end(),
                    [](const Triangle<Stored>& triangle) { return triangle.normals != no_normals; }));
}

Summary summary_of(const Scene& scene, Store store) {
  return {scene.objects,
          scene.triangles.size(),
          count_smooth<double>(scene.triangles),
          scene.spheres.size(),
          scene.cones.size(),
          scene.normals.size(),
          scene.materials.size(),
          count(scene.materials, reflects),
          count(scene.materials, transmits),
          scene.lights.size(),
          scene.camera.width,
          scene.camera.height,
          bounds(scene),
          !fits_float32(scene, store),
          {},
          scene.warnings};
}

template <class Stored>
Summary summary_of(const SceneFile& file) {
  const fb::Scene& table = file.table();
  const SceneView<Stored> view = file.view<Stored>();
  const fb::ObjectCounts& objects = *table.objects();
  return {{objects.polygons(), objects.patches(), objects.spheres(), objects.cones()},
          view.triangle_count,
          count_smooth<Stored>({view.triangles, view.triangle_count}),
          view.sphere_count,
          view.cone_count,
          view.normals_count,
          view.material_count,
          table.reflective_materials(),
          table.transmitting_materials(),
          view.light_count,
          table.camera()->width(),
          table.camera()->height(),
          file.bounds(),
          file.is_float64(),
          file.bytes(),
          {}};
}

// Bytes of all records; the file's table and padding add a few KiB.
template <class Stored>
std::uint64_t record_bytes(const Summary& s) {
  return s.triangles * sizeof(Triangle<Stored>) + s.corner_normals * sizeof(CornerNormals<Stored>) +
         s.spheres * (sizeof(Sphere<Stored>) + sizeof(Surface)) +
         s.cones * (sizeof(Cone<Stored>) + sizeof(Surface)) + s.materials * sizeof(Material) +
         s.lights * sizeof(Light<Stored>);
}

Json bounds_json(const Boxd& box) {
  if (is_empty(box)) return nullptr;
  return {{"min", {box.min.x, box.min.y, box.min.z}}, {"max", {box.max.x, box.max.y, box.max.z}}};
}

Json to_json(const Summary& s) {
  const ObjectCounts& o = s.objects;
  Json json{
      {"objects",
       {{"polygons", o.polygons},
        {"patches", o.patches},
        {"spheres", o.spheres},
        {"cones", o.cones},
        {"total", o.polygons + o.patches + o.spheres + o.cones}}},
      {"primitives",
       {{"triangles", s.triangles},
        {"spheres", s.spheres},
        {"cones", s.cones},
        {"total", s.triangles + s.spheres + s.cones}}},
      {"smooth_triangles", s.smooth},
      {"materials", {{"total", s.materials}, {"reflect", s.reflecting}, {"transmit", s.transmitting}}},
      {"lights", s.lights},
      {"resolution", {s.width, s.height}},
      {"bounds", bounds_json(s.bounds)},
      {"store", s.is_float64 ? "float64" : "float32"},
      {"bytes",
       {{"records", s.is_float64 ? record_bytes<double>(s) : record_bytes<float>(s)}, {"file", nullptr}}},
  };
  json.update(program_version());
  if (s.file_bytes) json["bytes"]["file"] = *s.file_bytes;
  if (s.warnings) {
    json["warnings"] = {{"degenerate_polygons", s.warnings->degenerate_polygons},
                        {"degenerate_triangles", s.warnings->degenerate_triangles},
                        {"degenerate_spheres", s.warnings->degenerate_spheres},
                        {"degenerate_cones", s.warnings->degenerate_cones},
                        {"self_crossing_polygons", s.warnings->self_crossing_polygons}};
  }
  return json;
}

void print_table(const Summary& s) {
  const auto line = [](const char* name, const std::string& value) {
    fmt::print("{:<12} {}\n", name, value);
  };
  const ObjectCounts& o = s.objects;
  line("objects",
       fmt::format("{}: polygons {}, patches {}, spheres {}, cones {}",
                   o.polygons + o.patches + o.spheres + o.cones, o.polygons, o.patches, o.spheres, o.cones));
  line("primitives",
       fmt::format("{}: triangles {} ({} smooth), spheres {}, cones {}", s.triangles + s.spheres + s.cones,
                   s.triangles, s.smooth, s.spheres, s.cones));
  line("materials", fmt::format("{}: {} reflect, {} transmit", s.materials, s.reflecting, s.transmitting));
  line("lights", fmt::format("{}", s.lights));
  line("resolution", fmt::format("{} x {}", s.width, s.height));
  const Boxd& b = s.bounds;
  line("bounds", is_empty(b) ? "none"
                             : fmt::format("({:g}, {:g}, {:g}) to ({:g}, {:g}, {:g})", b.min.x, b.min.y,
                                           b.min.z, b.max.x, b.max.y, b.max.z));
  const std::uint64_t records = s.is_float64 ? record_bytes<double>(s) : record_bytes<float>(s);
  line("store", fmt::format("{}, {} bytes of records{}", s.is_float64 ? "float64" : "float32", records,
                            s.file_bytes ? fmt::format(", {} of file", *s.file_bytes) : ""));
}

void report(const Summary& summary, const Settings& settings) {
  if (!settings.info) return;
  if (settings.json)
    fmt::print("{}\n", to_json(summary).dump(2));
  else
    print_table(summary);
}

void print_warnings(const SceneWarnings& warnings, const std::string& place) {
  const auto line = [&](std::uint64_t number, const char* what) {
    if (number > 0) fmt::print(stderr, "nff2bin: {}: warning: {} {}\n", place, number, what);
  };
  line(warnings.degenerate_polygons, "polygon(s) without area left out");
  line(warnings.degenerate_triangles, "vertices on triangles without area left out");
  line(warnings.degenerate_spheres, "sphere(s) of radius 0 left out");
  line(warnings.degenerate_cones, "cone(s) without length or without radius left out");
  line(warnings.self_crossing_polygons, "polygon(s) cross themselves: triangulated as well as possible");
}

// Warns where --store float32 loses accuracy: a scene far from the origin for its size, small objects in a
// large scene, or coordinates with more digits.
void warn_of_float32(const Scene& scene, Store store, const std::string& place) {
  if (store != Store::float32) return;
  const auto warn = [&](const std::string& what) {
    fmt::print(stderr, "nff2bin: {}: warning: {}: use --store float64\n", place, what);
  };
  const Float32Precision precision = float32_precision(scene);
  if (precision.is_far())
    warn(fmt::format("with float32 arithmetic surfaces may be {:.2g} off, and the scene is {:.2g} across",
                     precision.margin, precision.across));
  else if (precision.too_small > 0)
    warn(fmt::format("with float32 arithmetic surfaces may be {:.2g} off, and {} object(s) are hardly larger",
                     precision.margin, precision.too_small));
  else if (!scene.float32_suffices)
    warn("coordinates lose digits in float32");
}

bool is_scene_file(const std::string& path) {
  const MappedFile file(path);
  const auto& magic = scene_file_kind.magic;
  return file.bytes().size() >= magic.size() &&
         std::memcmp(file.bytes().data(), magic.data(), magic.size()) == 0;
}

// The error message for an N of --tessellate; empty where it is valid.
std::string check_facets(const std::string& text) {
  int facets = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), facets);
  if (error == std::errc{} && end == text.data() + text.size() && facets % 4 == 0 && facets >= min_facets &&
      facets <= max_facets)
    return {};
  return fmt::format("'{}' isn't a multiple of 4 from {} to {}", text, min_facets, max_facets);
}

void convert(const Settings& settings) {
  const bool is_piped = settings.input == "-";
  Scene scene = [&] {
    Progress progress("reading", settings.quiet);
    NffOptions options;
    options.progress = progress.callback();
    return is_piped ? parse_nff(standard_input(), "stdin", options) : read_nff(settings.input, options);
  }();
  if (settings.facets > 0) scene = tessellated(std::move(scene), settings.facets);
  print_warnings(scene.warnings, is_piped ? "stdin" : settings.input);
  if (!settings.output.empty()) {
    write_scene(scene, settings.store, settings.output);
    warn_of_float32(scene, settings.store, is_piped ? "stdin" : settings.input);
  }
  if (!settings.info) return;
  Summary summary = summary_of(scene, settings.store);
  std::error_code failed; // where the output is a pipe
  const std::uint64_t bytes = std::filesystem::file_size(settings.output, failed);
  if (!failed) summary.file_bytes = bytes;
  report(summary, settings);
}

void run(const Settings& settings) {
  if (settings.output.empty() && !settings.info)
    throw Error(ErrorCode::usage, "command line", "nothing to do: give -o FILE, --info or both");
  if (settings.info && settings.output == "-")
    throw Error(ErrorCode::usage, "--info", "would be mixed with the scene on standard output: name a file");
  const auto limit = settings.threads.limit();
  check_files({settings.input}, {settings.output});
  if (settings.input == "-" || !is_scene_file(settings.input)) return convert(settings);
  if (!settings.output.empty())
    throw Error(ErrorCode::usage, settings.input,
                "is a scene file already: give an NFF file, or leave out -o");
  if (settings.facets > 0)
    throw Error(ErrorCode::usage, settings.input, "is a scene file already: --tessellate needs an NFF file");
  const SceneFile file(settings.input);
  report(file.is_float64() ? summary_of<double>(file) : summary_of<float>(file), settings);
}

} // namespace
} // namespace masu

int main(int argc, char** argv) {
  using namespace masu;
  return run_tool(
      "nff2bin", "Converts NFF text to a scene file, and reports the content of either.", argc, argv,
      [](CLI::App& app, const auto& parse) {
        Settings settings;
        app.add_option("IN", settings.input,
                       "NFF file, or - for standard input; with --info also a scene file")
            ->required();
        app.add_option("-o,--output", settings.output, "scene file to write");
        add_choice(
            app, "--store", settings.store,
            {{"auto", Store::automatic}, {"float32", Store::float32}, {"float64", Store::float64}},
            "number type of coordinates; auto: float32 unless its arithmetic is too coarse for the scene");
        app.add_option("--tessellate", settings.facets,
                       "replace spheres and cones by triangles, N facets around: 2N triangles per cone (N if "
                       "pointed), "
                       "12(N/4)^2 per sphere; the SPD uses 12")
            ->check(CLI::Validator(check_facets, fmt::format("{}..{}", min_facets, max_facets)))
            ->type_name("N");
        auto* const info = app.add_flag("--info", settings.info,
                                        "print the numbers of objects and primitives, bounds and memory");
        app.add_flag("--json", settings.json, "print --info as JSON")->needs(info);
        app.add_flag("-q,--quiet", settings.quiet, "no progress on standard error");
        settings.threads.add_to(app);
        parse();
        run(settings);
      });
}
