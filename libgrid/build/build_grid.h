// Building a grid as somebody asks for it: from words to a grid, and to what its file tells of it.
#pragma once

#include "libgrid/build/builder.h"
#include "libgrid/build/division.h"
#include "libgrid/build/merge.h"
#include "libgrid/file/grid_file.h"

namespace masu {

// automatic leaves a division that is given as it is, and chooses between none and irregular where it isn't
// (choose.h).
enum class MergeChoice { automatic, none, x, balance, irregular };

struct BuildOptions {
  DivisionRule division;
  MergeChoice choice = MergeChoice::automatic;
  MergeRule merge; // but for its kind, which is the choice's
  SpaceRule space = SpaceRule::tight;
  Overlap overlap = Overlap::exact;
};

// Of the builder's scene; `bounds` is that of all its primitives. Throws Error(usage, "--division", …) where
// the machine hasn't the memory, and as the builder does.
template <class Stored>
Grid build_grid(GridBuilder<Stored>& builder, const Boxd& bounds, const BuildOptions& recipe);

// As the grid's file is to tell it.
GridOrigin origin_of(const Grid& grid, const BuildOptions& recipe, const Hash& scene_hash,
                     std::uint64_t primitives);

} // namespace masu
