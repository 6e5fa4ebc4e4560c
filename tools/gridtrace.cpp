// gridtrace: reads a scene and its grid, and traces a list of rays through them, or prints the walk of one
// ray.
#include "libscene/file/output_file.h"
#include "renderer/rays/walk_report.h"
#include "tools/common/cli.h"
#include "tools/common/json.h"
#include "tools/common/number_list.h"
#include "tools/jobs/parted_file.h"
#include "tools/jobs/tracing_tool.h"
#include "tools/lists/ray_list.h"
#include "tools/render/frame_options.h"
#include "tools/report/walk_text.h"

#include <set>

namespace masu {
namespace {

// Of a walk that is printed: all of it, or an error. A ray's own walk is no larger than the grid and its
// lists, but rays may double in number with each depth.
constexpr std::size_t most_walk_rays = 32768;

struct Settings {
  TracingOptions tracing;
  RayListJob list{.format = {6}, .request = {.limit = 0}}; // limit of --all-hits; 0: the nearest alone
  std::string write, objects;
  Store ray_store = Store::automatic;
  bool any_hit = false, count_hits = false;
  HitName hit_name = HitName::object;
  // One ray's way.
  std::string ray, pixel;
  std::string json; // empty: a table; -: standard output
  bool all_rays = false;
  FrameOptions frame;

  bool is_walk() const { return !ray.empty() || !pixel.empty(); }
  Query query() const {
    return any_hit                  ? Query::occlusion
           : count_hits             ? Query::count_hits
           : list.request.limit > 0 ? Query::all_hits
                                    : Query::nearest_hit;
  }
  // As needs_hits_in_order() (renderer/tracer.h) has it.
  bool hits_in_order() const {
    return count_hits || list.request.limit > 0 || list.request.faces != Faces::both ||
           !list.excluded.empty() || !objects.empty() || write.find("t64") != std::string::npos ||
           write.find("front") != std::string::npos;
  }
};

// Whether a file of text has a line for each hit.
bool lists_hits(const Settings& settings) {
  return settings.list.request.limit > 0 && settings.list.hits.ends_with(".csv");
}

std::string written_fields(const Settings& settings) {
  if (!settings.write.empty()) return settings.write;
  const std::string of_hit = usual_fields(settings.hit_name);
  const Query query = settings.query();
  if (query == Query::occlusion) return "occluded";
  if (query == Query::count_hits) return "count";
  if (query == Query::all_hits) return (lists_hits(settings) ? "" : "count,") + of_hit + ",front";
  return of_hit;
}

// Of fields that the query doesn't find.
void check_fields(const Settings& settings) {
  const Query query = settings.query();
  for (const HitField field : hit_fields(written_fields(settings))) {
    const auto needs = [](bool is_there, const char* why) {
      if (!is_there) throw Error(ErrorCode::usage, "--write", why);
    };
    if (field == HitField::occluded)
      needs(query == Query::occlusion, "occluded needs --any-hit");
    else if (field == HitField::inside)
      needs(query == Query::count_hits, "inside needs --count-hits");
    else if (field == HitField::count && lists_hits(settings))
      needs(false, "count isn't of a hit, and a .csv has a line for each: leave it out");
    else if (field == HitField::count)
      needs(query == Query::count_hits || query == Query::all_hits, "count needs --count-hits or --all-hits");
    else
      needs(query != Query::occlusion && query != Query::count_hits,
            query == Query::occlusion ? "can only be occluded with --any-hit"
                                      : "can only be count and inside with --count-hits");
  }
}

void check(const Settings& settings, const Ranks& ranks) {
  const auto fail = [](const char* option, const char* why) { throw Error(ErrorCode::usage, option, why); };
  const TracingOptions& tracing = settings.tracing;
  tracing.check("gridtrace");
  if (settings.is_walk()) {
    if (!settings.list.rays.empty()) fail("RAYS", "is a list: leave it out, or leave out --ray and --pixel");
    check_files({tracing.scene, tracing.grid}, {settings.json});
    return;
  }
  if (settings.list.rays.empty()) fail("RAYS", "is missing: name a list of rays, or give --ray or --pixel");
  if (settings.list.hits.empty() && tracing.report().empty())
    fail("-o", "is missing: nothing would be written");
  check_fields(settings);
  if (settings.hits_in_order() && !tracing.stats.empty())
    fail("--stats", "is for nearest hits and --any-hit alone, of both faces: take --times");
  if (tracing.resume && settings.list.hits.empty()) fail("--resume", "needs -o: nothing else is kept");
  check_hits_name("-o", settings.list.hits);
  if (ranks.count() > 1 || tracing.resume) {
    if (settings.list.rays == "-") fail("RAYS", "must name a file, for ranks and --resume");
    if (!settings.list.hits.empty()) check_is_file(settings.list.hits);
  }
  check_files({tracing.scene, tracing.grid, settings.list.rays, settings.list.excluded},
              {settings.list.hits, tracing.stats, tracing.times});
}

// --- A list -----------------------------------------------------------------------------------------------

// Masks of a list such as 0,3,7-9: 1 of the objects in it, 0 of the others.
std::vector<std::uint32_t> object_masks(const std::string& list, std::uint64_t objects) {
  std::vector<std::uint32_t> masks(objects);
  for (const std::string& word : split(list)) {
    std::array<std::uint64_t, 2> range{};
    if (const auto one = read_number<std::uint64_t>(word))
      range = {*one, *one};
    else if (!read_numbers(word, '-', range) || range[0] > range[1])
      throw Error(ErrorCode::usage, "--objects",
                  fmt::format("'{}' is neither a number nor FIRST-LAST", word));
    if (range[1] >= objects)
      throw Error(ErrorCode::usage, "--objects",
                  fmt::format("{} isn't below {}, the number of objects", range[1], objects));
    std::fill(masks.begin() + static_cast<std::ptrdiff_t>(range[0]),
              masks.begin() + static_cast<std::ptrdiff_t>(range[1]) + 1, 1);
  }
  return masks;
}

RayListJob ray_list_job(const Settings& settings, const OpenedScene& opened) {
  RayListJob job = settings.list;
  job.format.is_float64 = settings.ray_store == Store::automatic ? job.rays.ends_with(".f64")
                                                                 : settings.ray_store == Store::float64;
  job.fields = hit_fields(written_fields(settings));
  job.request.tracing = settings.tracing.tracing();
  job.request.query = settings.query();
  if (!settings.objects.empty())
    job.object_masks = object_masks(settings.objects, opened.scene.counts().objects);
  job.repeat = settings.tracing.repeat;
  job.resume = resume_of(settings.tracing, opened);
  return job;
}

// --- Walk of one ray --------------------------------------------------------------------------------------

WalkRequest walk_request(const Settings& settings, const OpenedScene& opened) {
  FrameRequest frame = settings.frame.frame(settings.tracing.rules);
  WalkRequest walk{frame.tracing};
  if (!settings.pixel.empty()) {
    const auto pixel = parse_numbers<std::int32_t, 2>("--pixel", settings.pixel, "X,Y");
    frame.camera = settings.frame.camera(opened.scene);
    settings.frame.check(frame.camera, opened.scene);
    walk = camera_walk(opened.tracer, frame, pixel[0], pixel[1]);
  } else {
    const auto n = parse_numbers<double, 6>("--ray", settings.ray, "X,Y,Z,DX,DY,DZ");
    walk.ray = unbounded_ray<double>({n[0], n[1], n[2]}, {n[3], n[4], n[5]});
  }
  walk.all_rays = settings.all_rays;
  walk.rules = frame.rules;
  walk.limits.rays = most_walk_rays;
  walk.limits.counted = 0;
  return walk;
}

// On the CPU.
void print_walk(const Settings& settings) {
  const OpenedScene opened("gridtrace", settings.tracing, {});
  const WalkReport report = trace_walk(opened.tracer, walk_request(settings, opened));
  if (report.more_rays > 0)
    throw Error(ErrorCode::usage, "--all-rays",
                fmt::format("finds more than {} rays: give a smaller --depth", most_walk_rays));
  if (settings.json.empty()) return write_text_file("-", walk_table(report));
  nlohmann::ordered_json json = provenance();
  json.update(opened.hashes());
  json.update(walk_json(report));
  write_text_file(settings.json, json_text(json) + "\n");
}

// --- The command line -------------------------------------------------------------------------------------

// Groups of options.
constexpr const char *hits_group = "Hits", *rays_group = "Rays",
                     *walk_group = "Walk of one ray, cell by cell", *camera_group = "Camera of --pixel";

void add_list_options(const CommandLine& command, Settings& settings) {
  command.group(hits_group);
  command.add_option(
      "-o,--output", settings.list.hits,
      "write a record for each ray: float t (infinity for a miss), int32 object (-1 for a miss), "
      "or what --write says; .npy: a NumPy array; .csv: text, with --all-hits a line for each hit; "
      "- is standard output",
      "HITS");
  command.add_option(
      "--write", settings.write,
      "fields of a record: a list of t, t64 (of 64 bits), object, primitive, face, uv, normal, front "
      "(default t,object); with --all-hits also count (default count,t,object,front; in .csv without "
      "count); with --count-hits count and inside; with --any-hit occluded",
      "LIST");
  add_hit_name(command, settings.hit_name, "what a record names without --write");
  const Option any =
      command.add_flag("--any-hit", settings.any_hit, "find out whether anything is hit at tmin < t < tmax");
  const Option all =
      command
          .add_option("--all-hits", settings.list.request.limit,
                      "write up to K hits of each ray in their order, a closed mesh's crossings "
                      "at edges and corners once",
                      "K")
          .range(1U, 1U << 16); // records have as many
  const Option counts = command.add_flag(
      "--count-hits", settings.count_hits,
      "count them; inside: whether the ray starts in a closed mesh (0 or 1; 2 where fronts and "
      "backs are met otherwise than of closed meshes)");
  any.excludes({all, counts});
  all.excludes({counts});
  command.add_choice("--faces", settings.list.request.faces,
                     {{"both", Faces::both}, {"front", Faces::front}, {"back", Faces::back}},
                     "faces that are hit");
  command.add_option(
      "--objects", settings.objects,
      "objects that alone are hit: a list of numbers, as hits name them, and ranges such as 7-9", "LIST");
  command.group(rays_group);
  command
      .add_option(
          "--ray-numbers", settings.list.format.numbers,
          "numbers per ray in a file of numbers: 6 (origin, direction) or 8 (origin, tmin, direction, "
          "tmax)")
      .among({"6", "8"})
      .shows_default();
  command.add_choice("--ray-store", settings.ray_store,
                     {{"auto", Store::automatic}, {"float32", Store::float32}, {"float64", Store::float64}},
                     "type of these numbers; auto: float64 where the file's name ends in .f64");
  command.add_file(
      "--exclude", settings.list.excluded,
      "a primitive for each ray that it doesn't hit, or -1: int32 numbers, or a NumPy array of them");
  command.add_flag("--relative", settings.list.format.is_relative,
                   "rays are relative to the scene's local origin, and not in the world");
}

void add_walk_options(const CommandLine& command, Settings& settings) {
  command.group(walk_group);
  const Option ray = command.add_option("--ray", settings.ray, "print the walk of this ray, instead of RAYS",
                                        "X,Y,Z,DX,DY,DZ");
  const Option pixel =
      command
          .add_option("--pixel", settings.pixel,
                      "print the walk of this camera ray, counted from the picture's top left", "X,Y")
          .excludes({ray});
  command.add_flag("--all-rays", settings.all_rays, "and of all rays that it spawns, shadow rays too");
  settings.frame.add_secondary(command);
  command.add_json(settings.json);
  command.group(camera_group);
  settings.frame.add_camera(command);
  settings.frame.add_sampling(command);
  command.group_needs(camera_group, pixel);
}

void add_options(const CommandLine& command, Settings& settings) {
  command.footer("Example:\n  gridtrace balls.scene balls.grid rays.npy -o hits.npy --write t,normal");
  settings.tracing.add_files(command);
  command.add_option("RAYS", settings.list.rays,
                     "list of rays: numbers; .npy, a NumPy array of shape (N, 6) or (N, 8); .csv, text "
                     "whose first line is ox,oy,oz,dx,dy,dz, with tmin and tmax among them or not; - is "
                     "standard input");
  add_list_options(command, settings);
  add_walk_options(command, settings);
  settings.tracing.add_to(command);
}

// Options that would have no effect are errors.
void refuse_useless(const CommandLine& command, const Settings& settings) {
  const bool is_walk = settings.is_walk();
  const std::set<std::string> of_lists{hits_group, rays_group, "Reports"};
  for (const auto& [name, group] : command.given_options()) {
    if (is_walk ? !of_lists.contains(group) && name != "--resume" : group != walk_group) continue;
    throw Error(ErrorCode::usage, name,
                is_walk ? "is for a list of rays: leave it out with --ray and --pixel"
                        : "is for the walk of one ray: give --ray or --pixel");
  }
  const bool says_its_numbers = settings.list.rays.ends_with(".npy") || settings.list.rays.ends_with(".csv"),
             needs_no_name = !settings.write.empty() || settings.any_hit || settings.count_hits,
             is_one_ray = is_walk && !settings.all_rays;
  const char *const numbers = "is for numbers alone: a .npy or .csv says it itself",
                    *const secondary = "is for the rays that one spawns: give --all-rays",
                    *const on_cpu = "has no effect: the walk of one ray is found on the CPU";
  command.refuse(
      {{"--ray-numbers", says_its_numbers, numbers},
       {"--ray-store", says_its_numbers, numbers},
       {"--hit-name", needs_no_name, "is for records without --write, of hits: leave one of them out"},
       {"--depth", is_one_ray, secondary},
       {"--spd-rules", is_one_ray, secondary},
       {"--backend", is_walk && settings.tracing.backend == Backend::cuda, on_cpu},
       {"--devices", is_walk && settings.tracing.devices != "cpu", on_cpu}});
}

} // namespace
} // namespace masu

int main(int argc, char** argv) {
  using namespace masu;
  Ranks ranks;
  return ranks.ended(run_tool(
      "gridtrace", "Traces a list of rays through a scene's grid, or prints the walk of one ray.", argc, argv,
      [&](const CommandLine& command, const auto& parse) {
        Settings settings;
        add_options(command, settings);
        parse();
        ranks.start();
        TracingOptions& tracing = settings.tracing;
        if (tracing.brute_force && settings.list.rays.empty() && !settings.is_walk())
          std::swap(settings.list.rays, tracing.grid); // SCENE RAYS
        const auto limit = limit_threads(tracing, ranks);
        refuse_useless(command, settings);
        check(settings, ranks);
        if (settings.is_walk()) {
          if (ranks.rank() == 0) print_walk(settings);
          return;
        }
        const OpenedScene opened("gridtrace", tracing, gpus_of(tracing, ranks));
        const bool quiet = tracing.quiet || ranks.rank() > 0;
        const TracingReport report =
            trace_ray_list(opened.tracer, ray_list_job(settings, opened), ranks, quiet);
        if (ranks.rank() > 0) return;
        if (const TaskTotals& totals = report.totals; totals.invalid > 0)
          print_note(
              "gridtrace: {}: {} of {} rays aren't valid and hit nothing: NaN, infinite or beyond 1e15, or "
              "a direction below 1e-15\n",
              printable(settings.list.rays), totals.invalid, totals.rays);
        write_reports("gridtrace", tracing, opened, ranks, report, quiet);
      },
      {Ranks::prints_help, [&] { return ranks.is_first_to_fail(); }}));
}
