// The walks through a bounding volume hierarchy. They all find the same hits, to the bit, those of the first,
// whatever they visit on the way; so only that one counts. Each has three parts: what a ray meets of a node's
// boxes (boxes.h, boxes_avx2.h: one test a processor), what it remembers to come back to, and what comes
// next.
//
//   walk                   which rays                     remembers           next           earns
//   HierarchyWalk          all on a GPU; on a CPU what    groups of nodes     nearest met
//     hierarchy_walk.h     counts, or has no AVX2
//   begin_packet()         a warp's first ones, by        32 boxes, shared    as met, four   P 1.08
//     packet_begin.h       thread_per_ray, if alike                           at a time
//   advance_group()        a warp's last 16, by 2 or      as HierarchyWalk    nearest met    P 1.04 D 1.09
//     lane_groups.h        4 lanes each                                                      R 1.03 S 1.11
//   NearestFirstWalk       one on a CPU that doesn't      nodes, of each      nearest met    P 1.34 D 1.38
//     nearest_first_avx2.h count                          node in order                      R 1.16 S 1.31
//   EightWalks             lists on a CPU                 the same of eight   nearest met    D 1.41 R 1.66
//     in_step_avx2.h                                                          of each        S 1.23
//   PacketWalk             of lists what is alike, as     nodes, and which    nearest that   P 1.35
//     packet_avx2.h        most camera rays are           rows may meet them  any meets
//
// Through placed meshes there are others of the first three (libgrid/placed); the last two go there, too.
//
// Earns: the rate over that of the next simpler walk (HierarchyWalk; for EightWalks NearestFirstWalk, for
// PacketWalk EightWalks), where it isn't within .02 of it, for rays P primary, D diffuse, R random, S shadow;
// the geometric mean of teapot of size 60, mount of 10, tetra of 9, balls, tree, gears and, on the GPU,
// rings, of which mount, balls, tree and rings are in triangles (nff2bin --tessellate 12). On an H200, and on
// 16 cores of the Intel Xeon beside it, before any hits came by slots, by
//
//   gridbench rays SCENE HIERARCHY [--backend cpu --size 512x512 --random 1048576]
//
// once as it is, and once built with the walk's name below set to false, and with it those of the walks that
// are tried before it.
#pragma once

namespace masu::walks_in_use {

inline constexpr bool packet_begin = true, lane_groups = true; // on a GPU
inline constexpr bool nearest_first = true, in_step = true, packets = true;

} // namespace masu::walks_in_use
