// Ear clipping of a polygon in a plane; triangulate.cpp projects it.
#pragma once

#include "libscene/mesh/point_tree.h"
#include "libscene/mesh/triangulate.h"

#include <span>
#include <vector>

namespace masu {

class EarClipper {
public:
  enum class Effort {
    limited,
    unlimited,
    untested, // as unlimited, but ears may contain vertices: for polygons that have no triangulation
  };

  // `ring`: indices of `points`, of positive signed area; no two neighbours are the same point. Magnitudes of
  // coordinates are at most 1. Both must outlive the clipper.
  EarClipper(std::span<const Point2> points, std::span<const std::uint32_t> ring);

  // Appends triangles: all, or until finding out whether ears contain other vertices has taken too many
  // steps, about so many that n log n of them are enough for most polygons. Then it returns false, and goes
  // on when it is called with another effort.
  bool run(Triangulation& result, Effort effort);

private:
  // The kinds of vertices, in the order in which they are cut off.
  enum class Rank : std::uint8_t {
    spike,   // both edges have the same direction: no area
    open,    // convex, and not known to be blocked
    grazed,  // nearly straight, or a vertex is nearly on its cut: would make a sliver
    flat,    // straight
    blocked, // the ear contains a vertex
    reflex,
  };
  struct Candidate {
    Rank rank;
    double shape; // sine of the corner / length² of the cut: short cuts first, slivers last
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

  Fit fit(std::uint32_t v);
  Fit fit(const std::array<Point2, 3>& ear, std::uint32_t other) const;
  void push(std::uint32_t v, Rank rank);
  Candidate pop();
  void classify(std::uint32_t v);
  void process(const Candidate& candidate, Triangulation& result);
  bool retest_blocked();
  void unlink(std::uint32_t v);
  void cut(std::uint32_t v, Triangulation& result);
  void emit(std::uint32_t v, Triangulation& result) const;

  std::span<const Point2> points_;
  std::vector<std::uint32_t> previous_, next_;
  std::vector<std::uint32_t> stamps_; // of each vertex's valid candidate: older ones are ignored
  std::vector<Rank> ranks_;
  std::vector<Candidate> heap_; // one valid candidate for each vertex of the ring
  PointTree obstacles_;         // vertices that can block an ear: all that aren't clearly convex
  std::size_t size_;            // vertices in the ring
  std::size_t retests_left_, steps_left_;
  Effort effort_ = Effort::limited;
  bool changed_ = false; // since blocked ears were last tested again
  std::uint32_t some_vertex_;
};

} // namespace masu
