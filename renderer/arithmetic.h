// From a precision to the rays that trace with it.
#pragma once

#include "libscene/geometry/textbook.h"
#include "libscene/scene_view.h"
#include "renderer/precision.h"

namespace masu {

// The ray of an arithmetic, as a type.
template <class TestRay_>
struct Arithmetic {
  using TestRay = TestRay_;
};

// Calls act(Arithmetic) with the precision's ray; `precision` is resolved.
template <class Act>
void with_arithmetic(const SceneView<float>&, Precision precision, const Act& act) {
  switch (precision) {
  case Precision::fast:
    return act(Arithmetic<TextbookRay>{});
  case Precision::doubled:
    return act(Arithmetic<WatertightRay<double>>{});
  default:
    return act(Arithmetic<WatertightRay<float>>{});
  }
}
template <class Act>
void with_arithmetic(const SceneView<double>&, Precision, const Act& act) {
  act(Arithmetic<WatertightRay<double>>{});
}

// Calls act(SceneView of the scene's own store, Arithmetic). Throws Error(usage) as resolved() does.
template <class Act>
void with_store_and_arithmetic(const SceneFile& scene, Precision precision, const Act& act) {
  precision = resolved(precision, scene);
  scene.with_view([&](const auto& view) {
    with_arithmetic(view, precision, [&](auto arithmetic) { act(view, arithmetic); });
  });
}

} // namespace masu
