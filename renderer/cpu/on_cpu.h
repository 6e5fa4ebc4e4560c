// What both kinds of queries need on the CPU: the code for a scene and a request, its time and its counts.
#pragma once

#include "libscene/base/parallel.h"
#include "libscene/base/stopwatch.h"
#include "renderer/backend.h"
#include "renderer/dispatch.h"
#include "renderer/rays/list_progress.h"

namespace masu {

template <class Total, class Part>
void add(Total& total, const Part& part) {
  if constexpr (Part::is_counted) total += part;
}

template <class Act>
double seconds_of(const Act& act) {
  const Stopwatch watch;
  act();
  return watch.seconds();
}

// Calls act(i) for each of a list whose queries take long, and of so many tests each, on all cores.
template <class Act>
void for_each_in_list(const RayList& list, const RaysRequest& request, std::uint64_t tests_each,
                      const Act& act) {
  ListProgress progress(request.progress, list.count, 16, tests_each);
  parallel_ranges(list.count, 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i != end; ++i) {
      progress.done(i);
      act(i);
    }
  });
}

// Calls act(SceneView, grid's view, Method, counts).
template <class Act>
void with_everything(const SceneFile& scene, const StructureFile* structure, const TracingRules& rules,
                     const Act& act) {
  with_store_and_arithmetic(
      scene, rules.precision,
      [&]<class TestRay, class Stored>(const SceneView<Stored>& view, Arithmetic<TestRay>) {
        with_method<TestRay, Stored>(records_of(structure), rules,
                                     [&](const auto& accelerator, auto method, auto counts) {
                                       act(view, accelerator, method, counts);
                                     });
      });
}

} // namespace masu
