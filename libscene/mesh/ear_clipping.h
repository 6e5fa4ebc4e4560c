// Ear clipping of one ring of points in a plane; triangulate.cpp brings a polygon into it.
#pragma once

#include "libscene/mesh/point_tree.h"
#include "libscene/mesh/triangulate.h"

#include <span>
#include <vector>

namespace masu {

class EarClipper {
public:
  // `ring` counts from `points`, counter-clockwise by its area; no two neighbours in it are the same point,
  // and magnitudes are at most 1. Both must outlive the clipper.
  EarClipper(std::span<const Point2> points, std::span<const std::uint32_t> ring);

  // Appends the triangles.
  void run(Triangulation& result);

private:
  // What a vertex is, in the order in which vertices are cut off.
  enum class Rank : std::uint8_t {
    spike,    // both edges leave the same way: no area
    open,     // convex, and nothing known to be in the way
    grazed,   // straight but for rounding, or a vertex on its cut is: would make a sliver
    flat,     // straight
    blocked, // a vertex is in the way
    reflex,
  };
  struct Candidate {
    Rank rank;
    double shape; // the corner's sine / the cut's length²: short cuts and no slivers first
    std::uint32_t vertex, stamp;
    bool operator<(const Candidate& other) const;
  };
  enum class Fit { clear, grazed, blocked };

  const Point2& before(std::uint32_t v) const { return points_[previous_[v]]; }
  const Point2& after(std::uint32_t v) const { return points_[next_[v]]; }
  double turn(std::uint32_t v) const { return orientation(before(v), points_[v], after(v)); }
  bool is_nearly_straight(std::uint32_t v, double turn) const;
  Rank rank_by_turn(std::uint32_t v, double turn) const;
  PointTree obstacles(std::span<const std::uint32_t> ring) const;
  bool turns_once(std::span<const std::uint32_t> ring) const;

  Fit fit(std::uint32_t v) const;
  Fit fit(const std::array<Point2, 3>& ear, std::uint32_t other) const;
  void push(std::uint32_t v, Rank rank);
  Candidate pop();
  void settle(std::uint32_t v);
  void act(const Candidate& candidate, Triangulation& result);
  bool look_again();
  void unlink(std::uint32_t v);
  void cut(std::uint32_t v, Triangulation& result);
  void emit(std::uint32_t v, Triangulation& result) const;

  std::span<const Point2> points_;
  std::vector<std::uint32_t> previous_, next_;
  std::vector<std::uint32_t> stamps_; // of a vertex's valid candidate: older ones are void
  std::vector<Rank> ranks_;
  std::vector<Candidate> heap_; // one valid candidate for each vertex in the ring
  PointTree obstacles_;         // what can be in the way: all but clearly convex vertices
  std::size_t size_;            // vertices in the ring
  std::size_t retests_left_;
  bool changed_ = false; // since blocked ears were last looked at again
  std::uint32_t some_vertex_;
};

} // namespace masu
