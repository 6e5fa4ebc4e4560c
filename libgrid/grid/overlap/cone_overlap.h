// Whether a box meets the side of a cut-off cone.
#pragma once

#include "libscene/geometry/cone.h"

#include <algorithm>

namespace masu {

// The cone as an implicit surface: side(p) is a point's signed distance from the side at its position z(p)
// along the axis, measured across the axis. The solid between the end planes is where side(p) ≤ 0. side is
// convex: its minimum over a polyhedron is on an edge, unless the axis passes through the polyhedron, and its
// maximum is at a vertex.
struct ConeSolid {
  ConeAxis<double> axis;
  double z_margin; // how far the end planes are moved out, as a fraction of the axis
  double margin;   // how much of side() counts as touching

  MASU_HD double z(const Vec3d& p) const { return dot(p - axis.base, axis.axis) * axis.inverse_square; }
  MASU_HD double radius(double along) const { return axis.base_radius + axis.growth * along; }
  MASU_HD double off_axis(const Vec3d& p, double along) const {
    return length(p - (axis.base + axis.axis * along));
  }
  MASU_HD double side(const Vec3d& p) const {
    const double along = z(p);
    return off_axis(p, along) - radius(along);
  }
};

struct Segment {
  Vec3d from, to;
};

// The part of the segment between the end planes; false when there is none.
MASU_HD inline bool clip_to_ends(const ConeSolid& cone, Segment& segment) {
  const double z0 = cone.z(segment.from), z1 = cone.z(segment.to);
  double s0 = 0, s1 = 1;
  for (const bool lower : {true, false}) {
    const double end = lower ? -cone.z_margin : 1 + cone.z_margin;
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

// Whether a point of the segment, which is between the end planes, is within the margin of the solid: one of
// its ends, or the minimum of the quadratic ρ² - R².
MASU_HD inline bool enters_solid(const ConeSolid& cone, const Segment& segment) {
  const Vec3d along = segment.to - segment.from;
  const double z0 = cone.z(segment.from), dz = dot(along, cone.axis.axis) * cone.axis.inverse_square;
  const Vec3d off = segment.from - (cone.axis.base + cone.axis.axis * z0);
  const Vec3d across = along - cone.axis.axis * dz;
  const double radius = std::max(0.0, cone.radius(z0)), slope = cone.axis.growth * dz;
  const double a = dot(across, across) - slope * slope;
  const double b = dot(off, across) - slope * radius;
  // The quadratic suffers cancellation, and only says where its minimum is; side() decides.
  const double minimum = -b / a;
  return cone.side(segment.from) <= cone.margin || cone.side(segment.to) <= cone.margin ||
         (minimum > 0 && minimum < 1 && cone.side(segment.from + along * minimum) <= cone.margin);
}

MASU_HD inline bool axis_meets(const ConeSolid& cone, const Boxd& box) {
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

MASU_HD inline Vec3d corner(const Boxd& box, unsigned which) {
  return {(which & 1) != 0 ? box.max.x : box.min.x, (which & 2) != 0 ? box.max.y : box.min.y,
          (which & 4) != 0 ? box.max.z : box.min.z};
}

// The chord that an end plane cuts from a face of the box, if any.
MASU_HD inline bool cut_face(const ConeSolid& cone, double end, const Vec3d (&face)[4], Segment& chord) {
  int found = 0;
  for (int i = 0; i < 4 && found < 2; ++i) {
    const Vec3d &p = face[i], &q = face[(i + 1) % 4];
    const double zp = cone.z(p) - end, zq = cone.z(q) - end;
    if ((zp < 0) == (zq < 0)) continue;
    (found == 0 ? chord.from : chord.to) = p + (q - p) * (zp / (zp - zq));
    ++found;
  }
  return found == 2;
}

// Whether the box meets the cone's side, thickened by margin. `voxel` is not grown.
MASU_HD inline bool meets(const Cone<double>& cone, const Boxd& voxel, double margin) {
  ConeSolid solid{cone_axis<double>(cone), 0, 0};
  const double inverse_length = std::sqrt(solid.axis.inverse_square);
  // The gradient of side() is no longer than `steepest`: for most voxels their centre's value decides.
  const double slope = solid.axis.growth * inverse_length;
  const double steepest = std::sqrt(1 + slope * slope);
  solid.z_margin = margin * inverse_length;
  solid.margin = margin * steepest;
  const Vec3d center = (voxel.min + voxel.max) * 0.5;
  const double reach = length(voxel.max - voxel.min) * 0.5 + 2 * margin;
  if (std::abs(solid.side(center)) > steepest * reach) return false;
  // A margin along the axis takes a flat cone's rims far out or in; but all of it is between their radii.
  const double narrow = std::min(solid.radius(0), solid.radius(1)),
               wide = std::max(solid.radius(0), solid.radius(1));
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
    for (unsigned side = 0; side <= bit; side += bit) {
      const Vec3d face[] = {corner(voxel, side), corner(voxel, side | u), corner(voxel, side | u | v),
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
