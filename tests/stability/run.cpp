#include "stability/run.h"

#include "libgrid/grid/division.h"
#include "libgrid/hierarchy/hierarchy_builder.h"
#include "libgrid/structure/builder.h"
#include "libgrid/trace/trace.h"
#include "libscene/base/parallel.h"
#include "renderer/dispatch.h"
#include "stability/oracle/embree_scene.h"
#include "stability/oracle/exact_hit.h"
#include "stability/oracle/judge_surfaces.h"
#include "stability/same_bits.h"

namespace masu::stability {
namespace {

template <class M, class Stored, class Accelerator>
Hit<typename M::Real> find(const SceneView<Stored>& scene, const Accelerator& accelerator,
                           const Ray<double>& listed) {
  using Real = typename M::Real;
  Ray<Real> ray = loaded<Real>(&listed, own_format<double>, 0);
  const Real scale = scale_direction(ray);
  NoCounts counts;
  Hit<Real> hit = nearest_hit<M>(scene, accelerator, ray, counts);
  hit.t *= scale;
  return hit;
}

template <class Real>
bool same_hit(const Hit<Real>& a, const Hit<Real>& b) {
  return a.primitive == b.primitive && same_bits(a.t, b.t);
}

template <class TestRay, class Stored>
std::vector<Found> trace(const SceneView<Stored>& scene, const std::vector<Structure>& grids,
                         const std::vector<Ray<double>>& rays, StopRule stop) {
  using Real = typename TestRay::Real;
  using M = Method<TestRay, with_all_kinds>;
  std::vector<Found> found(rays.size());
  std::vector<Hit<Real>> first(rays.size());
  const auto for_each_ray = [&](const auto& act) { parallel_for(rays.size(), act); };
  if (stop == StopRule::first_cell) {
    AnyStructure<Real> any = any_structure<Real>(StructureRecords(grids.front()));
    any.stop = stop;
    for_each_ray([&](std::size_t i) {
      const Hit<Real> hit = find<M>(scene, any, rays[i]);
      found[i] = {static_cast<double>(hit.t), hit.primitive, true};
    });
    return found;
  }
  for_each_ray([&](std::size_t i) {
    first[i] = find<M>(scene, NoStructure{}, rays[i]);
    found[i] = {static_cast<double>(first[i].t), first[i].primitive, true};
  });
  for (const Structure& grid : grids) {
    with_structure_view<Real>(grid, [&](const auto& view) {
      for_each_ray([&](std::size_t i) {
        found[i].same = found[i].same && same_hit(find<M>(scene, view, rays[i]), first[i]);
      });
    });
  }
  return found;
}

template <class Stored>
std::vector<Structure> build(const SceneView<Stored>& view, const Boxd& bounds,
                             const std::vector<StructureWanted>& wanted) {
  std::vector<Structure> grids;
  for (const StructureWanted& grid : wanted) {
    const auto layout = layout_in<Stored>(bounds, grid.division);
    if (grid.kind == StructureKind::hierarchy && !fits_hierarchy(layout.space)) continue;
    StructureOptions options{grid.kind};
    grids.push_back(build_structure(view, layout, Overlap::exact, options));
  }
  return grids;
}

bool judges_hits(Judge judge) {
  return judge == Judge::closest || judge == Judge::enclosed;
}

// The modes in which the scene can be traced, those of float32 arithmetic first.
template <class Stored>
std::vector<Mode> modes_for(const SceneView<Stored>& scene, Judge judge, bool with_embree) {
  if (std::is_same_v<Stored, double>) return {doubled};
  std::vector<Mode> modes{fast, robust};
  if (judge == Judge::closest) modes.insert(modes.begin() + 1, first_cell);
  if (with_embree && judges_hits(judge) && scene.triangle_count == scene.primitive_count())
    modes.insert(modes.end(), {embree, embree_robust});
  modes.push_back(doubled);
  return modes;
}

std::vector<Found> trace_by_embree(const SceneView<float>& scene, const std::vector<Ray<double>>& rays,
                                   EmbreeFlags flags) {
  std::vector<Ray<float>> rounded(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i)
    rounded[i] = loaded<float>(rays.data(), own_format<double>, i);
  std::vector<float> t(rays.size());
  std::vector<PrimitiveIndex> primitive(rays.size());
  EmbreeScene(scene, flags).trace(rounded, t.data(), primitive.data());
  std::vector<Found> found(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i)
    found[i] = {static_cast<double>(t[i]), primitive[i], true};
  return found;
}

// Closest hits in each mode.
template <class Stored>
std::vector<std::vector<Found>> found_in(const std::vector<Mode>& modes, const SceneView<Stored>& view,
                                         const std::vector<Structure>& grids,
                                         const std::vector<Ray<double>>& rays) {
  std::vector<std::vector<Found>> found;
  for (const Mode& mode : modes) {
    if constexpr (std::is_same_v<Stored, float>) {
      if (mode.by != Implementation::masu) {
        found.push_back(trace_by_embree(view, rays, {mode.by == Implementation::embree_robust, false}));
        continue;
      }
    }
    with_arithmetic(view, mode.precision, [&]<class TestRay>(Arithmetic<TestRay>) {
      found.push_back(trace<TestRay>(view, grids, rays, mode.stop));
    });
  }
  return found;
}

// How far rounding to the store moves a vertex, or a sphere's surface by its centre and radius, at most.
template <class Stored>
double rounding_of_store(const Boxd& bounds) {
  if (std::is_same_v<Stored, double>) return 0;
  constexpr double three_coordinates_and_a_radius = 2.74;
  return three_coordinates_and_a_radius * static_cast<double>(RealTraits<float>::unit_roundoff) *
         largest_magnitude(bounds);
}

template <class Stored>
std::vector<Tally> judged_closest(const SceneView<Stored>& view, const Boxd& bounds,
                                  const Trial<Stored>& trial, const std::vector<Mode>& modes,
                                  std::vector<std::vector<Found>> found) {
  TestScene<double> original = trial.original.value_or(TestScene<double>{});
  const auto oracle = trial.original ? oracle::SceneOracle(original.view()) : oracle::SceneOracle(view);
  const double rounding = trial.original ? rounding_of_store<Stored>(bounds) : 0;
  // Of equal primitives Embree may find any.
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (modes[i].by == Implementation::masu) continue;
    for (Found& one : found[i])
      if (one.primitive != no_primitive) one.primitive = oracle.first_alike(one.primitive);
  }
  std::vector<Tally> tallies;
  // Modes with the same error bound are compared with the same reference hits.
  for (std::size_t begin = 0, end = 0; begin < modes.size(); begin = end) {
    const double slack = slack_for(modes[begin].precision, bounds);
    end = begin;
    while (end < modes.size() && slack_for(modes[end].precision, bounds) == slack)
      ++end;
    const auto part = judged(oracle, trial.rays, slack + rounding, unit_roundoff_of(modes[begin].precision),
                             std::span(found).subspan(begin, end - begin));
    tallies.insert(tallies.end(), part.begin(), part.end());
  }
  return tallies;
}

// What follows a hit.
template <class Stored>
std::vector<Tally> judged_by(Judge judge, const SceneView<Stored>& view, const Boxd& bounds,
                             const std::vector<Structure>& grids, const Trial<Stored>& trial,
                             const std::vector<Mode>& modes) {
  std::vector<Tally> tallies;
  for (const Mode& mode : modes) {
    with_arithmetic(view, mode.precision, [&]<class TestRay>(Arithmetic<TestRay>) {
      switch (judge) {
      case Judge::leaving:
        tallies.push_back(judged_leaving<TestRay>(view, grids, trial, slack_for(mode.precision, bounds)));
        break;
      case Judge::glass:
        tallies.push_back(judged_glass<TestRay>(view, grids, trial));
        break;
      default:
        tallies.push_back(judged_refraction<TestRay>(view, trial));
        break;
      }
    });
  }
  return tallies;
}

bool is_within(const Sweep& sweep, const Mode& mode, bool float64, double step) {
  if (float64) return sweep.doubled64.holds(step);
  return (mode.precision == Precision::doubled ? sweep.doubled : sweep.robust).holds(step);
}

// Of robust with embree-robust.
template <class Stored>
std::optional<Disagreement>
disagreement_of(const SceneView<Stored>& view, const std::vector<Ray<double>>& rays,
                const std::vector<Mode>& modes, const std::vector<std::vector<Found>>& found) {
  if constexpr (std::is_same_v<Stored, float>) {
    const std::vector<Found>* ours = nullptr;
    for (std::size_t i = 0; exact_hits_available && i < modes.size(); ++i) {
      if (modes[i].name == robust.name) ours = &found[i];
      if (modes[i].by == Implementation::embree_robust)
        return disagreement({view.triangles, view.triangle_count}, rays, *ours, found[i]);
    }
  }
  return {};
}

template <class Stored>
void run_step(const Sweep& sweep, Trial<Stored> trial, double step, bool with_embree,
              const std::function<void(const Row&)>& report) {
  constexpr bool float64 = std::is_same_v<Stored, double>;
  const SceneView<Stored> view = trial.scene.view();
  const Boxd bounds = trial.scene.bounds();
  const std::vector<Mode> modes = modes_for(view, sweep.judge, with_embree);
  const std::vector<Structure> grids = build(view, bounds, trial.grids);
  std::vector<Tally> tallies;
  std::optional<Disagreement> disagreement;
  if (judges_hits(sweep.judge)) {
    const std::vector<std::vector<Found>> found = found_in(modes, view, grids, trial.rays);
    disagreement = disagreement_of(view, trial.rays, modes, found);
    if (sweep.judge == Judge::closest)
      tallies = judged_closest(view, bounds, trial, modes, found);
    else
      std::transform(found.begin(), found.end(), std::back_inserter(tallies), judged_enclosed);
  } else {
    tallies = judged_by(sweep.judge, view, bounds, grids, trial, modes);
  }
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const Mode& mode = modes[i];
    const bool promised =
        mode.precision != Precision::fast && mode.stop == StopRule::proven && mode.by == Implementation::masu;
    report({sweep.name, sweep.parameter, step, mode, float64, promised,
            promised && is_within(sweep, mode, float64, step), tallies[i],
            mode.by == Implementation::embree_robust ? disagreement : std::nullopt});
  }
}

} // namespace

double slack_for(Precision precision, const Boxd& bounds) {
  return precision == Precision::doubled ? rounding_margin<double>(bounds) : rounding_margin<float>(bounds);
}
double unit_roundoff_of(Precision precision) {
  return precision == Precision::doubled ? RealTraits<double>::unit_roundoff
                                         : static_cast<double>(RealTraits<float>::unit_roundoff);
}

void run(const Sweep& sweep, const RunSettings& settings, const std::function<void(const Row&)>& report) {
  for_each_trial(sweep, settings.rays, settings.seed, [&](auto trial, double step) {
    run_step(sweep, std::move(trial), step, settings.embree, report);
  });
}

std::vector<Found> found_through(const SceneFile& scene, const StructureFile& grid,
                                 std::span<const Ray<double>> rays, const Mode& mode) {
  std::vector<Found> found(rays.size());
  TracingRules rules;
  rules.precision = mode.precision;
  rules.stop = mode.stop;
  with_store_and_arithmetic(
      scene, mode.precision,
      [&]<class TestRay, class Stored>(const SceneView<Stored>& view, Arithmetic<TestRay>) {
        with_method<TestRay, Stored>(grid.records(), rules,
                                     [&]<class M>(const auto& accelerator, M, const auto&) {
                                       parallel_for(rays.size(), [&](std::size_t i) {
                                         const auto hit = find<M>(view, accelerator, rays[i]);
                                         found[i] = {static_cast<double>(hit.t), hit.primitive, true};
                                       });
                                     });
      });
  return found;
}

} // namespace masu::stability
