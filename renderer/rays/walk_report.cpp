#include "renderer/rays/walk_report.h"

#include "libgrid/statistics/cells.h"
#include "libgrid/statistics/statistics.h"
#include "libscene/base/error.h"
#include "renderer/cpu/on_cpu.h"
#include "renderer/view_precision.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace masu {
namespace {

// --- Where a cell is --------------------------------------------------------------------------------------

// By the planes that end it for walks down and up.
template <class Structure>
VoxelBox cell_voxels(const Structure& grid, const Vec3i& voxel) {
  return {cell_at(grid, voxel, {-1, -1, -1}).far, cell_at(grid, voxel, {0, 0, 0}).far};
}

template <class Structure>
Boxd box_of(const Structure& grid, const VoxelBox& voxels) {
  const auto corner = [&](const Vec3i& plane) {
    return cast<double>(grid.min) + cast<double>(grid.voxel_size) * cast<double>(plane);
  };
  return {corner(voxels.first), corner(voxels.end)};
}

// --- Recording --------------------------------------------------------------------------------------------

constexpr double never = std::numeric_limits<double>::infinity();

// Why a walk ends where nothing is hit, unless the ray's end is reached before.
WalkEnd end_without_hit(StructureForm form) {
  return form == StructureForm::none        ? WalkEnd::tested_all
         : form == StructureForm::hierarchy ? WalkEnd::visited_all
                                            : WalkEnd::left_grid;
}

// Where a ray is in a box, from its origin on: between t = enter and exit, or nowhere where enter > exit.
struct Interval {
  double enter, exit;
};
Interval interval_in(const Boxd& box, const Vec3d& origin, const Vec3d& inverse) {
  Interval interval{0, never};
  for (int axis = 0; axis < 3; ++axis) {
    const double low = (box.min[axis] - origin[axis]) * inverse[axis],
                 high = (box.max[axis] - origin[axis]) * inverse[axis];
    interval.enter = std::max(interval.enter, std::min(low, high));
    interval.exit = std::min(interval.exit, std::max(low, high));
  }
  return interval;
}

// Thrown where no other ray is to be traced.
struct EndedEarly {};

// Counts that write down what they are shown (trace.h). The calls come in the order of
// renderer/render_pixel.h: spawned rays wait in a stack, here as there.
template <class Real>
class RecordedWalk {
public:
  static constexpr bool is_counted = true, records_walk = true;

  // `scale`: what the traced t are to be multiplied by (scale_direction in ray_query.h).
  RecordedWalk(WalkReport& report, const WalkRequest& request, Real scale)
      : report_(report), request_(request), scale_(scale) {}

  // --- Rays

  void begun(Query query, const Ray<Real>& ray, bool meets_bounds, const ClippedRay<Real>& near) {
    show_progress();
    if (counted_ > request_.limits.counted) throw EndedEarly();
    WalkRay next;
    if (query == Query::occlusion) {
      next.kind = RayKind::shadow;
      next.parent = followed_;
    } else {
      if (!pending_.empty()) {
        std::tie(next.kind, next.parent) = pending_.back();
        pending_.pop_back();
      }
      followed_ = static_cast<std::int32_t>(report_.rays.size());
    }
    next.origin = cast<double>(ray.origin);
    next.direction = cast<double>(ray.direction);
    next.t_min = static_cast<double>(ray.t_min);
    next.t_max = ray.t_max < RealTraits<Real>::largest ? static_cast<double>(ray.t_max) : never;
    skipped_t_ = near.skipped;
    exit_ = 0;
    if (meets_bounds) next.end = end_without_hit(report_.form);
    if (meets_bounds && report_.form == StructureForm::none)
      next.steps.push_back({.box = report_.space, .enter = from_origin(0), .exit = never});
    const bool is_recorded =
        report_.rays.empty() ||
        (report_.more_rays == 0 && report_.rays.size() < request_.limits.rays && takes_room(sizeof(WalkRay)));
    ray_ = is_recorded ? &report_.rays.emplace_back() : &not_recorded_;
    *ray_ = std::move(next);
    step_ = is_recorded && !ray_->steps.empty() ? &ray_->steps.back() : nullptr;
    if (!is_recorded) {
      ++report_.more_rays;
      ++counted_;
    }
  }
  void camera_ray(bool) {}
  void secondary_ray(bool) {}
  void shadow_ray(bool) {}
  void reflection_ray() { pending_.push_back({RayKind::reflection, followed_}); }
  void refraction_ray() { pending_.push_back({RayKind::refraction, followed_}); }

  // --- Cells

  void cell(bool) { ++ray_->cells; }
  template <class Structure>
  void entered(const Structure& grid, const Walk<Real, Structure>& walk) {
    add_step([&] { return references_of(grid.references, walk.cell.list); },
             [&](WalkStep& step) {
               step.voxels = cell_voxels(grid, walk.voxel());
               step.box = box_of(grid, step.voxels);
               step.enter = from_origin(exit_);
               step.exit = from_origin(walk.exit);
             });
  }
  template <class Structure>
  void left(const Walk<Real, Structure>& walk, bool done) {
    exit_ = walk.exit;
    if (done) ray_->end = ray_->primitive != no_primitive ? WalkEnd::hit : WalkEnd::t_max;
  }
  void skipped(std::int32_t) {}

  // --- Nodes

  void visited(std::uint32_t index, const HierarchyNode& node, const Vec3<Real>& origin,
               const Vec3<Real>& inverse, Real farthest, const MetBoxes& met) {
    if (index == 0) depths_.clear();
    const int depth = index == 0 ? 0 : depths_[index];
    for (int child = 0; child < std::popcount(node_slots(node)); ++child)
      depths_[node.first_node + static_cast<std::uint32_t>(child)] = depth + 1;
    add_step([&] { return static_cast<std::uint32_t>(std::popcount(met.bits & 0xffffff)); },
             [&](WalkStep& step) {
               step.node = {index, depth};
               const auto along = [&](const Boxd& box) {
                 return interval_in(box, cast<double>(origin), cast<double>(inverse));
               };
               step.box = empty_box<double>();
               for (int slot = 0; slot < boxes_per_node; ++slot) {
                 const std::uint32_t byte = slot_byte(node.slots, slot);
                 if (byte == 0) continue;
                 const Boxd box = box_of(node, slot);
                 step.box = join(step.box, box);
                 if ((met.bits & met_bits(byte)) != 0)
                   ++step.node.met;
                 else if (along(box).enter <= along(box).exit &&
                          along(box).enter > static_cast<double>(farthest))
                   ++step.node.beyond;
                 else
                   ++step.node.missed;
               }
               step.enter = from_origin(static_cast<Real>(along(step.box).enter));
               step.exit = from_origin(static_cast<Real>(along(step.box).exit));
             });
  }

  // --- Tests

  void triangle_test() { ++ray_->tests; }
  void sphere_test() { ++ray_->tests; }
  void cone_test() { ++ray_->tests; }
  void tested(PrimitiveIndex primitive, Real t) {
    show_progress();
    test_ = {primitive, from_origin(t), false};
    if (step_ != nullptr)
      step_->tests.push_back(test_);
    else
      ++counted_;
  }
  void kept() {
    if (step_ != nullptr) step_->tests.back().kept = true;
    if (report_.form == StructureForm::hierarchy) ray_->end = WalkEnd::hit;
    ray_->t = static_cast<float>(test_.t);
    ray_->primitive = test_.primitive;
  }

private:
  // A step has all its tests, and no steps are left out before it.
  template <class References, class Describe>
  void add_step(const References& references, const Describe& describe) {
    show_progress();
    step_ = nullptr;
    const bool is_next = ray_ != &not_recorded_ && ray_->steps.size() + 1 == ray_->cells;
    WalkStep step;
    step.references = is_next ? references() : 0;
    if (!is_next || !takes_room(sizeof(WalkStep) + step.references * sizeof(WalkTest))) {
      ++counted_;
      return;
    }
    describe(step);
    ray_->steps.push_back(std::move(step));
    step_ = &ray_->steps.back();
  }
  bool takes_room(std::size_t bytes) {
    if (bytes > request_.limits.bytes - bytes_) return false;
    bytes_ += bytes;
    return true;
  }
  void show_progress() {
    if ((++events_ & 1023) == 0 && request_.progress) request_.progress();
  }
  // As a query reports it.
  double from_origin(Real t) const {
    return t < RealTraits<Real>::largest ? static_cast<double>((t + skipped_t_) * scale_) : never;
  }

  WalkReport& report_;
  const WalkRequest& request_;
  Real scale_;
  std::vector<std::pair<RayKind, std::int32_t>> pending_{}; // spawned, and by which ray
  std::int32_t followed_ = -1;                              // the last ray that isn't a shadow ray
  // Of the ray that is traced now.
  WalkRay* ray_ = nullptr;   // one of the report's, or not_recorded_
  WalkStep* step_ = nullptr; // null where its tests are only counted
  WalkTest test_{};
  std::unordered_map<std::uint32_t, int> depths_{}; // of nodes visited, and of theirs
  Real skipped_t_ = 0, exit_ = 0;
  WalkRay not_recorded_{};
  std::size_t bytes_ = 0;     // of WalkLimits
  std::uint64_t counted_ = 0; // of WalkLimits
  std::uint64_t events_ = 0;
};

// Of a ray that was traced from where t is `skipped`.
void add_skipped(double skipped, WalkRay& ray) {
  ray.t = static_cast<float>(static_cast<double>(ray.t) + skipped);
  for (WalkStep& step : ray.steps) {
    step.enter += skipped;
    step.exit += skipped;
    for (WalkTest& test : step.tests)
      test.t += skipped;
  }
}

template <class M, class Stored, class Structure>
void record(const SceneFile& file, const SceneView<Stored>& scene, const Structure& structure,
            const WalkRequest& request, WalkReport& report) {
  using Real = typename M::Real;
  Ray<double> given = request.ray;
  if (request.all_rays) given = unbounded_ray(given.origin, given.direction);
  if (request.all_rays && std::abs(length(given.direction) - 1) > 1e-6)
    given.direction = normalized(given.direction);
  RayFormat format = own_format<double>;
  if (!request.is_relative) format.origin = file.origin();
  const Ray<Real> start = loaded<Real>(&given, format, 0);
  const ListedRay<Real> listed = listed_ray<Real>(&given, format, 0, scene.clip);
  if (!is_valid(start))
    throw Error(ErrorCode::usage, "walk",
                "the ray isn't valid: its numbers aren't finite or too large, or its direction is too small");
  if (request.all_rays) {
    const Ray<Real> ray = unbounded_ray(listed.ray.origin, listed.ray.direction);
    RecordedWalk<Real> walk(report, request, 1);
    HitRecord hit{};
    try {
      report.radiance = radiance<M>(scene, file.lighting<Stored>(), structure, request.rules, ray, hit, walk);
    } catch (const EndedEarly&) {
      report.ended_early = true;
    }
  } else {
    Ray<Real> scaled = listed.ray;
    RecordedWalk<Real> walk(report, request, scale_direction(scaled));
    static_cast<void>(trace_listed<Query::nearest_hit, M>(scene, structure, listed.ray, walk));
  }
  WalkRay& first = report.rays.front();
  add_skipped(listed.skipped, first);
  first.origin = cast<double>(start.origin);
  first.direction = cast<double>(start.direction);
  first.t_min = static_cast<double>(start.t_min);
  first.t_max = start.t_max < RealTraits<Real>::largest ? static_cast<double>(start.t_max) : never;
  for (WalkRay& traced : report.rays)
    if (traced.primitive != no_primitive) traced.object = surface_of(scene, traced.primitive).object;
}

void move_to_world(const Vec3d& origin, WalkReport& report) {
  report.space = in_world(origin, report.space);
  for (WalkRay& ray : report.rays) {
    ray.origin = ray.origin + origin;
    for (WalkStep& step : ray.steps)
      step.box = in_world(origin, step.box);
  }
}

} // namespace

WalkReport trace_walk(const ResidentTracer& tracer, const WalkRequest& request) {
  check_depth(request.rules.depth);
  const StructureFile* const structure = tracer.structure();
  WalkReport report;
  report.space = tracer.scene().bounds();
  if (structure != nullptr) report.form = form_of(structure->records());
  if (structure != nullptr && !structure->is_hierarchy()) {
    report.space = structure->layout().space;
    report.division = finest_layout(*structure).division;
  }
  TracingRules rules = request.tracing;
  rules.count = true; // the code for all kinds
  with_everything(tracer.scene(), structure, rules,
                  [&]<class M, class C>(const auto& scene, const auto& accelerator, M, C) {
                    if constexpr (std::is_same_v<C, Counts>)
                      record<M>(tracer.scene(), scene, accelerator, request, report);
                  });
  move_to_world(tracer.scene().origin(), report);
  tracer.scene().check_unchanged();
  if (structure != nullptr) structure->check_unchanged();
  return report;
}

WalkRequest camera_walk(const ResidentTracer& tracer, const FrameRequest& request, std::int32_t column,
                        std::int32_t row) {
  const RayWindow all = all_rays(request.camera, request.sampling);
  if (column < 0 || row < 0 || column >= all.columns || row >= all.rows)
    throw Error(
        ErrorCode::usage, "walk",
        fmt::format("{},{} isn't one of the picture's {} x {} rays", column, row, all.columns, all.rows));
  const RayWindow window{column, row, 1, 1};
  const Camera camera = relative_to(tracer.scene().origin(), request.camera);
  const auto ray_in = [&]<class Real>(Real) {
    const Ray<Real> ray =
        camera_ray(camera_rays<Real>(camera, request.sampling, request.hither, window), 0, 0);
    return loaded<double>(&ray, own_format<Real>, 0);
  };
  WalkRequest walk{request.tracing};
  walk.tracing.precision = picture_precision(tracer, request);
  walk.ray = walk.tracing.precision == Precision::doubled ? ray_in(double{}) : ray_in(float{});
  walk.is_relative = true;
  walk.rules = request.rules;
  return walk;
}

const char* name_of(RayKind kind) {
  constexpr std::array names{"camera", "reflection", "refraction", "shadow"};
  return names.at(static_cast<std::size_t>(kind));
}

const char* name_of(WalkEnd end) {
  constexpr std::array names{"missed_bounds", "hit", "t_max", "left_grid", "visited_all", "tested_all"};
  return names.at(static_cast<std::size_t>(end));
}

std::string description_of(const WalkRay& ray) {
  const auto by_kind = [&](const char* of_shadow, const char* of_other) {
    return ray.kind == RayKind::shadow ? of_shadow : of_other;
  };
  const std::array reasons{"the ray misses the scene's bounds",
                           by_kind("something is hit: the light is occluded",
                                   "nothing that is still to come can be nearer than the hit"),
                           by_kind("the light is reached: it isn't occluded", "the ray's end is reached"),
                           "the ray leaves the grid",
                           by_kind("all boxes on the way were visited: the light isn't occluded",
                                   "all boxes on the way were visited"),
                           "every primitive was tested"};
  return reasons.at(static_cast<std::size_t>(ray.end));
}

} // namespace masu
