#include "libgrid/overlap.h"

#include <array>

namespace masu {

TriangleOverlap::TriangleOverlap(const Triangle<double>& triangle, const Vec3d& half) {
  const std::array corners{triangle.a, triangle.b, triangle.c};
  const std::array edges{corners[1] - corners[0], corners[2] - corners[1], corners[0] - corners[2]};
  normal_ = cross(edges[0], edges[1]);
  const Vec3d steep{std::abs(normal_.x), std::abs(normal_.y), std::abs(normal_.z)};
  facing_ = steep.x >= steep.y && steep.x >= steep.z ? 0 : steep.y >= steep.z ? 1 : 2;

  // A needle's normal is mostly rounding: what that can move the plane by within the voxels concerned is
  // added.
  const double reach = length(edges[0]) + length(edges[1]) + length(half) * 2;
  const double doubt = 16 * RealTraits<double>::unit_roundoff * length(edges[0]) * length(edges[1]) * reach;
  const double offset = dot(normal_, corners[0]), radius = dot(steep, half) + doubt;
  plane_low_ = offset - radius;
  plane_high_ = offset + radius;

  for (int dropped = 0; dropped < 3; ++dropped) {
    const int i = (dropped + 1) % 3, j = (dropped + 2) % 3;
    for (std::size_t edge = 0; edge < 3; ++edge) {
      const double u = -edges[edge][j], v = edges[edge][i];
      const auto at = [&](const Vec3d& corner) { return u * corner[i] + v * corner[j]; };
      // Two corners lie on the edge itself, and are as good as one.
      const double on = at(corners[edge]), off = at(corners[(edge + 2) % 3]);
      const double radius_here = std::abs(u) * half[i] + std::abs(v) * half[j];
      axes_[dropped][edge] = {u, v, std::min(on, off) - radius_here, std::max(on, off) + radius_here};
    }
  }
}

bool TriangleOverlap::column(const Vec3d& center, double& low, double& high) const {
  const int w = facing_, u = (w + 1) % 3, v = (w + 2) % 3;
  for (const EdgeAxis& axis : axes_[w]) {
    if (!within(axis, center[u], center[v])) return false;
  }
  // normal · center within [plane_low_, plane_high_], solved for the coordinate along w.
  const double rest = normal_[u] * center[u] + normal_[v] * center[v];
  const double one = (plane_low_ - rest) / normal_[w], other = (plane_high_ - rest) / normal_[w];
  low = std::min(one, other);
  high = std::max(one, other);
  // A triangle without area has no plane: every voxel of the column is looked at.
  if (normal_[w] == 0) {
    low = -RealTraits<double>::largest;
    high = RealTraits<double>::largest;
  }
  return true;
}

bool TriangleOverlap::meets(const Vec3d& center) const {
  const double at = dot(normal_, center);
  if (!(at >= plane_low_ && at <= plane_high_)) return false;
  for (int dropped = 0; dropped < 3; ++dropped) {
    if (dropped == facing_) continue;
    const double i = center[(dropped + 1) % 3], j = center[(dropped + 2) % 3];
    for (const EdgeAxis& axis : axes_[dropped]) {
      if (!within(axis, i, j)) return false;
    }
  }
  return true;
}

bool meets(const Triangle<double>& triangle, const Boxd& voxel, double margin) {
  const Vec3d half = (voxel.max - voxel.min) * 0.5 + Vec3d{margin, margin, margin};
  const Vec3d center = (voxel.min + voxel.max) * 0.5;
  const TriangleOverlap test(triangle, half);
  double low, high;
  return test.column(center, low, high) && test.meets(center);
}

bool meets(const Sphere<double>& sphere, const Boxd& voxel, double margin) {
  double nearest = 0, farthest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double below = voxel.min[axis] - sphere.center[axis], above = sphere.center[axis] - voxel.max[axis];
    const double gap = std::max(0.0, std::max(below, above));
    const double far = std::max(std::abs(below), std::abs(above));
    nearest += gap * gap;
    farthest += far * far;
  }
  const double radius = std::abs(sphere.radius);
  const double outer = radius + margin, inner = std::max(0.0, radius - margin);
  return nearest <= outer * outer && farthest >= inner * inner;
}

namespace {

// The cone as a function: how far outside its side a point is, and where along the axis. The solid between
// the end planes is where side(p) ≤ 0; side is convex, so its least value over a convex body is found on the
// body's edges unless the axis passes through the body, and its greatest at the body's corners.
struct ConeSolid {
  ConeAxis<double> axis;
  double z_margin; // how far the end planes are moved out, as a share of the axis
  double margin;   // how much of side() counts as touching

  double z(const Vec3d& p) const { return dot(p - axis.base, axis.axis) * axis.inverse_square; }
  double radius(double at) const { return axis.base_radius + axis.growth * at; }
  double off_axis(const Vec3d& p, double at) const { return length(p - (axis.base + axis.axis * at)); }
  double side(const Vec3d& p) const {
    const double at = z(p);
    return off_axis(p, at) - radius(at);
  }
};

struct Segment {
  Vec3d from, to;
};

// The part of the segment between the end planes; false when there is none.
bool clip_to_ends(const ConeSolid& cone, Segment& segment) {
  const double z0 = cone.z(segment.from), z1 = cone.z(segment.to);
  double s0 = 0, s1 = 1;
  for (const double end : {-cone.z_margin, 1 + cone.z_margin}) {
    const bool lower = end < 0.5;
    const bool out0 = lower ? z0 < end : z0 > end, out1 = lower ? z1 < end : z1 > end;
    if (out0 && out1) return false;
    if (out0) s0 = std::max(s0, (end - z0) / (z1 - z0));
    if (out1) s1 = std::min(s1, (end - z0) / (z1 - z0));
  }
  if (s0 > s1) return false;
  const Vec3d along = segment.to - segment.from;
  segment = {segment.from + along * s0, segment.from + along * s1};
  return true;
}

// Whether some point of the segment, between the end planes, is within the margin of the solid: ρ² - (R +
// margin)² ≤ 0 at an end, or at the quadratic's lowest place.
bool enters_solid(const ConeSolid& cone, const Segment& segment) {
  const Vec3d along = segment.to - segment.from;
  const double z0 = cone.z(segment.from), dz = dot(along, cone.axis.axis) * cone.axis.inverse_square;
  const Vec3d off = segment.from - (cone.axis.base + cone.axis.axis * z0);
  const Vec3d across = along - cone.axis.axis * dz;
  const double radius = std::max(0.0, cone.radius(z0)), slope = cone.axis.growth * dz;
  const double a = dot(across, across) - slope * slope;
  const double b = dot(off, across) - slope * radius;
  // The squares' difference tells where to look; side() itself, which keeps its digits, decides.
  const double lowest = -b / a;
  return cone.side(segment.from) <= cone.margin || cone.side(segment.to) <= cone.margin ||
         (lowest > 0 && lowest < 1 && cone.side(segment.from + along * lowest) <= cone.margin);
}

bool axis_meets(const ConeSolid& cone, const Boxd& box) {
  double low = -cone.z_margin, high = 1 + cone.z_margin;
  for (int k = 0; k < 3; ++k) {
    const double from = cone.axis.base[k], by = cone.axis.axis[k];
    if (by == 0) {
      if (from < box.min[k] || from > box.max[k]) return false;
      continue;
    }
    const double t0 = (box.min[k] - from) / by, t1 = (box.max[k] - from) / by;
    low = std::max(low, std::min(t0, t1));
    high = std::min(high, std::max(t0, t1));
  }
  return low <= high;
}

Vec3d corner(const Boxd& box, unsigned which) {
  return {(which & 1) != 0 ? box.max.x : box.min.x, (which & 2) != 0 ? box.max.y : box.min.y,
          (which & 4) != 0 ? box.max.z : box.min.z};
}

// The chord that an end plane cuts from a face of the box, if any.
bool cut_face(const ConeSolid& cone, double end, const std::array<Vec3d, 4>& face, Segment& chord) {
  int found = 0;
  for (std::size_t i = 0; i < 4 && found < 2; ++i) {
    const Vec3d &p = face[i], &q = face[(i + 1) % 4];
    const double zp = cone.z(p) - end, zq = cone.z(q) - end;
    if ((zp < 0) == (zq < 0)) continue;
    const Vec3d at = p + (q - p) * (zp / (zp - zq));
    (found == 0 ? chord.from : chord.to) = at;
    ++found;
  }
  return found == 2;
}

} // namespace

bool meets(const Cone<double>& cone, const Boxd& voxel, double margin) {
  ConeSolid solid{cone_axis<double>(cone), 0, 0};
  const double inverse_length = std::sqrt(solid.axis.inverse_square);
  // side() changes by no more than this a unit of length: most voxels are decided by their centre.
  const double steepest = std::hypot(1.0, solid.axis.growth * inverse_length);
  solid.z_margin = margin * inverse_length;
  solid.margin = margin * steepest;
  const Vec3d center = (voxel.min + voxel.max) * 0.5;
  const double reach = length(voxel.max - voxel.min) * 0.5 + 2 * margin;
  if (std::abs(solid.side(center)) > steepest * reach) return false;
  // A margin along the axis takes a flat cone's rims far out or in; but all of it is between their radii.
  const auto [narrow, wide] = std::minmax({solid.radius(0), solid.radius(1)});
  const double off_axis = solid.off_axis(center, solid.z(center));
  if (off_axis < narrow - reach || off_axis > wide + reach) return false;

  // What is between the end planes of the voxel: its edges, and the chords those planes cut from its faces.
  bool enters = axis_meets(solid, voxel), leaves = false;
  const auto look_at = [&](const Segment& segment) {
    enters = enters || enters_solid(solid, segment);
    leaves = leaves || solid.side(segment.from) >= -solid.margin || solid.side(segment.to) >= -solid.margin;
  };
  for (unsigned from = 0; from < 8; ++from) {
    for (unsigned bit = 1; bit < 8; bit <<= 1) {
      if ((from & bit) != 0) continue;
      Segment edge{corner(voxel, from), corner(voxel, from | bit)};
      if (clip_to_ends(solid, edge)) look_at(edge);
    }
  }
  for (unsigned bit = 1; bit < 8; bit <<= 1) {
    const unsigned u = bit == 4 ? 1 : bit << 1, v = 7 ^ bit ^ u;
    for (const unsigned side : {0U, bit}) {
      const std::array face{corner(voxel, side), corner(voxel, side | u), corner(voxel, side | u | v),
                            corner(voxel, side | v)};
      for (const double end : {-solid.z_margin, 1 + solid.z_margin}) {
        Segment chord{};
        if (cut_face(solid, end, face, chord)) look_at(chord);
      }
    }
  }
  return enters && leaves;
}

} // namespace masu
