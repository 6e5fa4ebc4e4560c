// Comparison of grids, byte for byte.
#pragma once

#include "libgrid/structure/structure.h"
#include "tests/same_values.h"

#include <gtest/gtest.h>

namespace masu {

inline void expect_same(const Structure& a, const Structure& b) {
  EXPECT_EQ(a.block_log2, b.block_log2);
  EXPECT_EQ(a.nested_log2, b.nested_log2);
  EXPECT_TRUE(a.layout.division == b.layout.division);
  EXPECT_TRUE(same_values(a.references, b.references)) << a.references.size() << ' ' << b.references.size();
  EXPECT_TRUE(same_values(a.cells, b.cells)) << a.cells.size() << ' ' << b.cells.size();
  EXPECT_TRUE(same_values(a.voxel_map, b.voxel_map)) << a.voxel_map.size() << ' ' << b.voxel_map.size();
  EXPECT_TRUE(same_values(a.nodes, b.nodes)) << a.nodes.size() << ' ' << b.nodes.size();
}

} // namespace masu
