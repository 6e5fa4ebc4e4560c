// Camera rays.
#pragma once

#include "libscene/geometry/ray.h"
#include "libscene/scene.h"

#include <numbers>

namespace masu {

// corners: a ray through every corner of every pixel, (width + 1) × (height + 1) of them, four averaged per
// pixel. centers: a ray through every pixel's centre. sparse: sparse_side × sparse_side rays evenly over the
// picture, whatever its size, to find out what it shows.
enum class Sampling { corners, centers, sparse };
inline constexpr std::int32_t sparse_side = 64;

// Rays at a pixel's corners are shared with its neighbours: there is a row and a column more of them.
MASU_HD inline std::int32_t rays_beyond_pixels(Sampling sampling) {
  return sampling == Sampling::corners ? 1 : 0;
}

// A part of a picture's camera rays, which are numbered from the top left. No columns: all of them.
struct RayWindow {
  std::int32_t first_column = 0, first_row = 0, columns = 0, rows = 0;
};

// Of a whole picture.
inline RayWindow all_rays(const Camera& camera, Sampling sampling) {
  if (sampling == Sampling::sparse) return {0, 0, sparse_side, sparse_side};
  const std::int32_t more = rays_beyond_pixels(sampling);
  return {0, 0, camera.width + more, camera.height + more};
}

// A window of camera rays. The view's angle spans the whole image's height from edge to edge; a ray is the
// same bits in every window.
template <class Real>
struct CameraRays {
  Vec3<Real> eye;
  Vec3<Real> forward, right, up; // right and up reach from the image's middle to its edge at distance 1
  std::int32_t width, height;    // of the whole picture in pixels; sparse: in rays
  std::int32_t first_column, first_row, columns, rows;
  Real offset; // of a column or row, in half pixels: 0 corners, 1 centres
  Real hither; // rays start this far ahead; 0: at the eye
};

// The camera must have a direction, and `up` another one.
template <class Real>
CameraRays<Real> camera_rays(const Camera& camera, Sampling sampling, bool with_hither,
                             const RayWindow& part = {}) {
  const Vec3d forward = normalized(camera.at - camera.from);
  const Vec3d right = normalized(cross(forward, camera.up));
  const Vec3d up = cross(right, forward);
  const double reach = std::tan(camera.angle * std::numbers::pi / 360);
  const double aspect = static_cast<double>(camera.width) / camera.height;
  const RayWindow window = part.columns > 0 ? part : all_rays(camera, sampling);
  const bool sparse = sampling == Sampling::sparse;
  return {cast<Real>(camera.from),
          cast<Real>(forward),
          cast<Real>(right * (reach * aspect)),
          cast<Real>(up * reach),
          sparse ? sparse_side : camera.width,
          sparse ? sparse_side : camera.height,
          window.first_column,
          window.first_row,
          window.columns,
          window.rows,
          sampling == Sampling::corners ? Real(0) : Real(1),
          with_hither ? static_cast<Real>(camera.hither) : Real(0)};
}

// column, row: in the window.
template <class Real>
MASU_HD inline Ray<Real> camera_ray(const CameraRays<Real>& rays, std::int32_t column, std::int32_t row) {
  const Real x =
      (2 * static_cast<Real>(rays.first_column + column) + rays.offset) / static_cast<Real>(rays.width) - 1;
  const Real y =
      1 - (2 * static_cast<Real>(rays.first_row + row) + rays.offset) / static_cast<Real>(rays.height);
  const Vec3<Real> towards = fma(rays.right, x, fma(rays.up, y, rays.forward));
  const Real ahead = rays.hither;
  return unbounded_ray(ahead > 0 ? fma(towards, ahead, rays.eye) : rays.eye, normalized(towards));
}

} // namespace masu
