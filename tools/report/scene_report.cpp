#include "tools/report/scene_report.h"

#include "libscene/file/output_file.h"
#include "libscene/geometry/margin.h"
#include "tools/common/json.h"
#include "tools/common/number_list.h"
#include "tools/common/print.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <span>
#include <system_error>

namespace masu {
namespace {

// Of a scene in memory or in a file.
struct Report {
  ObjectCounts objects;
  std::uint64_t triangles = 0, smooth = 0, spheres = 0, cones = 0;
  std::uint64_t corner_normals = 0; // records, which smooth triangles can share
  std::uint64_t faces = 0;          // records: of the triangles, where their faces have other numbers
  std::uint64_t materials = 0, reflecting = 0, transmitting = 0, lights = 0;
  std::array<std::int32_t, 2> resolution{};
  Vec3d origin{0, 0, 0};
  Boxd bounds = empty_box<double>(); // in the world
  bool is_float64 = false;
  Float32Precision float32;                // what float32 would do to it, or did
  bool is_rounded = false;                 // to float32 already: by how much isn't known
  std::optional<std::uint64_t> file_bytes; // where there is a file
  std::optional<Hash> geometry_hash;       // likewise
  std::optional<SceneWarnings> warnings;   // of a scene in memory
};

// What both have in the same records.
template <class Stored, class Triangles>
Report report_of(const SceneSpans<Stored, Triangles>& scene, std::span<const Material> materials) {
  const auto count = [](const auto& records, const auto& property) {
    return static_cast<std::uint64_t>(std::ranges::count_if(records, property));
  };
  Report report;
  report.triangles = scene.triangles.size();
  report.smooth = count(scene.triangles, [](const auto& t) { return t.normals != no_normals; });
  report.spheres = scene.spheres.size();
  report.cones = scene.cones.size();
  report.materials = materials.size();
  report.reflecting = count(materials, reflects);
  report.transmitting = count(materials, transmits);
  report.lights = scene.lights.size();
  return report;
}

Report report_of(const Scene& scene, const Vec3d& origin, Store store, const Float32Precision& float32) {
  Report report = report_of(spans_of(scene, origin), scene.materials);
  report.objects = scene.objects;
  report.corner_normals = scene.normals.size();
  report.faces = scene.faces.size();
  report.resolution = {scene.camera.width, scene.camera.height};
  report.origin = origin;
  report.bounds = bounds(scene);
  report.is_float64 = store == Store::float64;
  report.float32 = float32;
  report.warnings = scene.warnings;
  return report;
}

template <class Stored>
Report report_of(const SceneFile& file) {
  const SceneView<Stored> view = file.view<Stored>();
  const SceneSpans<Stored> spans = spans_of(view, file.lighting<Stored>());
  const fb::ObjectCounts& objects = *file.table().objects();
  Report report = report_of(spans, {view.materials, file.counts().materials});
  report.objects = {objects.polygons(), objects.patches(), objects.spheres(), objects.cones()};
  report.corner_normals = file.counts().normals;
  report.faces = view.faces != nullptr ? view.triangle_count : 0;
  report.resolution = {file.table().camera()->width(), file.table().camera()->height()};
  report.origin = file.origin();
  report.bounds = in_world(file.origin(), file.bounds());
  report.is_float64 = file.is_float64();
  report.float32 = float32_precision(spans);
  report.is_rounded = !file.is_float64();
  report.file_bytes = file.bytes();
  report.geometry_hash = file.geometry_hash();
  return report;
}

// Bytes of all records; the file's table and padding add a few KiB.
template <class Stored>
std::uint64_t record_bytes(const Report& r) {
  return r.triangles * sizeof(Triangle<Stored>) + r.corner_normals * sizeof(CornerNormals<Stored>) +
         r.faces * sizeof(std::uint32_t) + r.spheres * (sizeof(Sphere<Stored>) + sizeof(Surface)) +
         r.cones * (sizeof(Cone<Stored>) + sizeof(Surface)) + r.materials * sizeof(Material) +
         r.lights * sizeof(Light<Stored>);
}
std::uint64_t record_bytes(const Report& r) {
  return r.is_float64 ? record_bytes<double>(r) : record_bytes<float>(r);
}

const char* store_name(const Report& r) {
  return r.is_float64 ? "float64" : "float32";
}

// --- Why a scene has its store --------------------------------------------------------------------------

// `name` for scripts, `text` for people.
struct Reason {
  const char* name;
  std::string text;
};

// Why float32 isn't precise enough.
Reason reason_against(const Float32Precision& p) {
  if (!p.in_range)
    return {"out_of_range",
            fmt::format("float32 takes coordinates from {:g} to {:g}", min_float32_reach, max_float32_reach)};
  if (p.is_far())
    return {"far_from_origin", fmt::format("with float32 arithmetic, so far from its origin, surfaces may be "
                                           "{:.2g} off, and the scene is {:.2g} across",
                                           p.margin, p.across)};
  if (p.standing_alone > 0)
    return {"small_parts", fmt::format("with float32 arithmetic surfaces may be {:.2g} off, and {} part(s) "
                                       "that stand alone are hardly larger",
                                       p.margin, p.standing_alone)};
  return {"moved_cones",
          fmt::format("float32 moves {} flat cone(s) by more than {:.2g}", p.moved_cones, p.margin)};
}

// The rule's reason, where the store is the rule's.
Reason reason_for(const Report& r) {
  const bool suffices = r.float32.suffices();
  if (suffices == r.is_float64) return {"asked", fmt::format("asked for by --store {}", store_name(r))};
  return suffices ? Reason{"precise", "precise enough to tell the scene's parts apart"}
                  : reason_against(r.float32);
}

std::string rounding_text(const Report& r) {
  const Float32Precision& p = r.float32;
  if (p.margin == 0) return "";
  const std::string bound = fmt::format("error bound {:.2g}", p.margin);
  if (r.is_rounded) return fmt::format("unknown, the file is rounded; {}", bound);
  if (!std::isfinite(p.rounding)) return "out of range";
  return fmt::format("coordinates by at most {:.2g}, {:.2g} of the {}", p.rounding, p.rounding / p.margin,
                     bound);
}

// --- Output ---------------------------------------------------------------------------------------------

// The error bound of the arithmetic that fits the store, with coordinates relative to an origin.
double error_bound(const Report& r, const Vec3d& origin) {
  if (is_empty(r.bounds)) return 0;
  const Boxd box = relative_to(origin, r.bounds);
  return r.is_float64 ? rounding_margin<double>(box) : rounding_margin<float>(box);
}

Json float32_json(const Report& r) {
  const Float32Precision& p = r.float32;
  Json json{{"suffices", p.suffices()},
            {"rounding", nullptr},
            {"error_bound", p.margin},
            {"rounding_of_error_bound", nullptr},
            {"across", is_empty(r.bounds) ? 0 : p.across},
            {"small_parts", p.standing_alone},
            {"moved_cones", p.moved_cones},
            {"in_range", p.in_range}};
  if (!r.is_rounded && std::isfinite(p.rounding)) {
    json["rounding"] = p.rounding;
    if (p.margin > 0) json["rounding_of_error_bound"] = p.rounding / p.margin;
  }
  return json;
}

Json to_json(const Report& r) {
  const ObjectCounts& o = r.objects;
  Json json{
      {"objects",
       {{"polygons", o.polygons},
        {"patches", o.patches},
        {"spheres", o.spheres},
        {"cones", o.cones},
        {"total", o.polygons + o.patches + o.spheres + o.cones}}},
      {"primitives",
       {{"triangles", r.triangles},
        {"spheres", r.spheres},
        {"cones", r.cones},
        {"total", r.triangles + r.spheres + r.cones}}},
      {"smooth_triangles", r.smooth},
      {"face_numbers", r.faces},
      {"materials", {{"total", r.materials}, {"reflect", r.reflecting}, {"transmit", r.transmitting}}},
      {"lights", r.lights},
      {"resolution", r.resolution},
      {"bounds", is_empty(r.bounds) ? Json() : Json(r.bounds)},
      {"origin", r.origin},
      {"error_bound", error_bound(r, r.origin)},
      {"error_bound_without_origin", error_bound(r, {0, 0, 0})},
      {"store", store_name(r)},
      {"store_reason", reason_for(r).name},
      {"float32", float32_json(r)},
      {"bytes", {{"records", record_bytes(r)}, {"file", r.file_bytes ? Json(*r.file_bytes) : Json()}}},
      {"geometry_hash", r.geometry_hash ? Json(to_hex(*r.geometry_hash)) : Json()},
  };
  json.update(program_version());
  if (r.warnings) {
    json["warnings"] = {{"degenerate_polygons", r.warnings->degenerate_polygons},
                        {"degenerate_triangles", r.warnings->degenerate_triangles},
                        {"degenerate_spheres", r.warnings->degenerate_spheres},
                        {"degenerate_cones", r.warnings->degenerate_cones},
                        {"self_crossing_polygons", r.warnings->self_crossing_polygons}};
  }
  return json;
}

void print_table(const Report& r) {
  const Rows row{12};
  const ObjectCounts& o = r.objects;
  row("objects", "{}: polygons {}, patches {}, spheres {}, cones {}",
      grouped(o.polygons + o.patches + o.spheres + o.cones), grouped(o.polygons), grouped(o.patches),
      grouped(o.spheres), grouped(o.cones));
  row("primitives", "{}: triangles {} ({} smooth), spheres {}, cones {}",
      grouped(r.triangles + r.spheres + r.cones), grouped(r.triangles), grouped(r.smooth), grouped(r.spheres),
      grouped(r.cones));
  if (r.faces > 0) row("faces", "{} numbers: triangles have others than their faces", grouped(r.faces));
  row("materials", "{}: {} reflect, {} transmit", grouped(r.materials), grouped(r.reflecting),
      grouped(r.transmitting));
  row("lights", "{}", r.lights);
  row("resolution", "{} x {}", r.resolution[0], r.resolution[1]);
  const Boxd& b = r.bounds;
  if (is_empty(b))
    row("bounds", "none");
  else
    row("bounds", "({:g}, {:g}, {:g}) to ({:g}, {:g}, {:g})", b.min.x, b.min.y, b.min.z, b.max.x, b.max.y,
        b.max.z);
  if (const double bound = error_bound(r, r.origin); r.origin == Vec3d{0, 0, 0})
    row("origin", "none: error bound {:.2g}", bound);
  else
    row("origin", "({:.17g}, {:.17g}, {:.17g}): error bound {:.2g}, without it {:.2g}", r.origin.x,
        r.origin.y, r.origin.z, bound, error_bound(r, {0, 0, 0}));
  row("store", "{}: {}", store_name(r), reason_for(r).text);
  if (const std::string rounding = rounding_text(r); !rounding.empty())
    row(r.is_float64 ? "  float32" : "  rounding", "{}", rounding);
  row("bytes", "{} of records{}", grouped(record_bytes(r)),
      r.file_bytes ? fmt::format(", {} of file", grouped(*r.file_bytes)) : "");
  if (r.geometry_hash) row("geometry", "{}", to_hex(*r.geometry_hash));
}

void print(const Report& report, bool json) {
  json ? fmt::print("{}\n", json_text(to_json(report))) : print_table(report);
}

// warn(number, what): a line about what a tool couldn't take from its input as it was, unless `number` is 0.
auto warning_of(const char* tool, const std::string& input) {
  return [tool, &input](std::uint64_t number, const char* what) {
    if (number > 0) print_note("{}: {}: warning: {} {}\n", tool, printable(input), number, what);
  };
}

// Of --origin; nothing for auto. Throws Error(usage).
std::optional<Vec3d> wanted_origin(const std::string& text) {
  if (text == "auto") return {};
  return text == "none" ? Vec3d{0, 0, 0} : parse_vector("--origin", text);
}

} // namespace

void SceneOutput::add_to(const CommandLine& command) {
  command.group("Scene file");
  command.add_file("-o,--output", path, "scene file to write");
  command.add_choice(
      "--store", store,
      {{"auto", Store::automatic}, {"float32", Store::float32}, {"float64", Store::float64}},
      "number type of coordinates; auto: float32 unless its arithmetic is too coarse for the scene");
  command
      .add_option(
          "--origin", origin,
          "the point that coordinates are stored relative to, so that errors follow the scene's extent "
          "and not its place: auto (the bounds' centre, or zero where that is nearer than half their "
          "diagonal), none (zero) or X,Y,Z",
          "ORIGIN")
      .shows_default();
  const Option info_option = command.add_flag(
      "--info", info, "print the numbers of objects and primitives, bounds, store and memory");
  command.add_flag("--json", json, "print --info as JSON").needs(info_option);
}

void SceneOutput::check() const {
  if (path.empty() && !info)
    throw Error(ErrorCode::usage, "command line", "nothing to do: give -o FILE, --info or both");
  if (info && is_standard_output(path))
    throw Error(ErrorCode::usage, "--info", "would be mixed with the scene on standard output: name a file");
  static_cast<void>(wanted_origin(origin));
}

void print_warnings(const char* tool, const std::string& input, const SceneWarnings& warnings) {
  const auto warn = warning_of(tool, input);
  warn(warnings.degenerate_polygons, "polygon(s) without area, which no ray can hit");
  warn(warnings.degenerate_triangles, "vertices on triangles without area left out");
  warn(warnings.degenerate_spheres, "sphere(s) of radius 0 left out");
  warn(warnings.degenerate_cones, "cone(s) without length or without radius left out");
  warn(warnings.self_crossing_polygons, "polygon(s) cross themselves: triangulated as well as possible");
}

void print_warnings(const char* tool, const std::string& input, const ImportNotes& notes) {
  const auto warn = warning_of(tool, input);
  warn(notes.points_and_lines, "point(s) and line(s) left out");
  warn(notes.invalid_faces, "face(s) that no ray can hit: a coordinate isn't finite or is beyond 1e100");
  if (notes.float32_error > 0)
    print_note("{}: {}: warning: Assimp reads this format in float32: coordinates are off by up to {:.2g}; "
               "convert it to PLY or OBJ, which are read with all digits\n",
               tool, printable(input), notes.float32_error);
  warn(notes.unknown_lines, "line(s) left out that are no polygons, groups or materials of an OBJ");
  warn(notes.missing_libraries, "material file(s) not found: what they describe is grey");
  warn(notes.trailing_bytes, "byte(s) after the last face left out");
  warn(notes.textured_materials, "material(s) have textures, which are ignored: only base colours are used");
  warn(notes.omitted_cameras, "camera(s) left out: only the first is used, if it is a perspective camera");
  warn(notes.omitted_lights, "light(s) left out: not point, spot, area or directional lights");
}

void write_and_report(const char* tool, const std::string& input, const Scene& scene,
                      const SceneOutput& output) {
  print_warnings(tool, input, scene.warnings);
  const Vec3d origin = origin_for(scene, wanted_origin(output.origin), "--origin");
  const Float32Precision float32 = float32_precision(scene, origin);
  const Store store = resolved(output.store, float32);
  Report report;
  if (output.info) report = report_of(scene, origin, store, float32);
  if (!output.path.empty()) {
    report.geometry_hash = write_scene(scene, store, output.path, origin);
    std::error_code failed; // where the output is a pipe
    const std::uint64_t bytes = std::filesystem::file_size(output.path, failed);
    if (!failed) report.file_bytes = bytes;
    if (store == Store::float32 && !float32.suffices())
      print_note("{}: {}: warning: {}: use --store float64\n", tool, printable(input),
                 reason_against(float32).text);
  }
  if (output.info) print(report, output.json);
}

void print_report(const SceneFile& file, bool json) {
  print(file.is_float64() ? report_of<double>(file) : report_of<float>(file), json);
}

} // namespace masu
