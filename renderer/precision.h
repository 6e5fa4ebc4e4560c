// Which arithmetic traces.
#pragma once

#include "libscene/base/error.h"
#include "libscene/file/scene_file.h"
#include "libscene/geometry/margin.h"

#include <array>

namespace masu {

// fast: float32 by textbook formulas (libscene/geometry/textbook.h), to be measured against. robust: float32
// that loses no hit beyond the bound of libscene/geometry/margin.h. doubled: the same in float64. automatic:
// what the scene's store asks for, robust for float32 and doubled for float64; of pictures what the view
// asks for, too (view_precision.h).
enum class Precision { automatic, fast, robust, doubled };

// The one that `automatic` stands for by the store alone; others stay. Throws Error(usage) for float32
// arithmetic on a scene whose coordinates don't fit it: its results would be wrong without a word.
inline Precision resolved(Precision precision, const SceneFile& scene) {
  if (precision == Precision::automatic) return scene.is_float64() ? Precision::doubled : Precision::robust;
  if (scene.is_float64() && precision != Precision::doubled) {
    throw Error(ErrorCode::usage, "precision",
                scene.path() +
                    " holds float64 coordinates, which float32 arithmetic would round: take double, "
                    "or make the scene with nff2bin --store float32");
  }
  return precision;
}

// How far from its surface a hit may be, in scene units: the bound of margin.h, which `fast` doesn't keep.
inline double error_bound(const SceneFile& scene, Precision precision) {
  return is_empty(scene.bounds())                           ? 0
         : resolved(precision, scene) == Precision::doubled ? rounding_margin<double>(scene.bounds())
                                                            : rounding_margin<float>(scene.bounds());
}

inline const char* name_of(Precision precision) {
  constexpr std::array names{"auto", "fast", "robust", "double"};
  return names.at(static_cast<std::size_t>(precision));
}

} // namespace masu
