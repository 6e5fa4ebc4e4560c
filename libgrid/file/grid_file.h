// The grid file: a container (libscene/file/container.h) whose table is schemas/grid.fbs.
#pragma once

#include "libgrid/build/build.h"
#include "libgrid/build/division.h"
#include "libgrid/file/grid_checks.h"
#include "libscene/file/container.h"
#include "schemas/grid_generated.h"

#include <string>

namespace masu {

inline constexpr FileKind grid_file_kind{
    {'M', 'A', 'S', 'U', 'G', 'R', 'D', '\0'}, 4, "grid", "build it again with gridbuild"};

// How a grid came about, as its file tells it.
struct GridProvenance {
  Hash geometry_hash; // the scene's (scene_file.h)
  std::uint64_t primitives = 0;
  Vec3d origin{0, 0, 0}; // likewise: where it is in the world (local_origin.h)
  SpaceRule space_rule{};
  Overlap overlap{};
  std::string division_rule;
  std::string merge_rule{};
  double build_seconds = -1; // -1: not recorded, so that equal builds give equal files
};

// Writes the grid to `path`, whole or not at all. Throws Error(output).
void write_grid(const Grid& grid, const GridProvenance& provenance, const std::string& path);

class GridFile;

// The same in memory: a grid file that was never written.
GridFile grid_in_memory(const Grid& grid, const GridProvenance& provenance);

// A grid file, checked: every index in it can be followed. Of one whose records stay in the file, only the
// table is; who copies them checks them (grid_checks.h).
class GridFile {
public:
  // Throws Error(input, path, …) for a file that can't be read, isn't a grid or is damaged.
  explicit GridFile(const std::string& path, Residence residence = Residence::memory);
  // Writes a file of the same bytes (container.h).
  void write(const std::string& path) const { container_.write(path); }
  // Throws Error(input, path, …) where it is mapped and the file was written since it was opened.
  void check_unchanged() const { container_.check_unchanged(); }

  const fb::Grid& table() const { return *table_; }
  const Hash& hash() const { return container_.hash(); }
  const std::string& path() const { return container_.path(); }
  std::uint64_t bytes() const { return container_.bytes(); }
  Residence residence() const { return container_.residence(); }
  const LoadSeconds& load_seconds() const { return container_.load_seconds(); }
  // Of the scene that it was built from: the point in the world that all places are relative to.
  Vec3d origin() const;
  GridLayout layout() const;
  bool is_hierarchy() const { return table_->merge() == fb::Merge::hierarchy; }
  bool is_merged() const { return table_->merge() != fb::Merge::none && !is_hierarchy(); }
  std::span<const std::uint32_t> voxel_map() const;
  std::span<const MergedCell> cells() const;
  std::span<const PrimitiveIndex> references() const;
  std::span<const HierarchyNode> nodes() const;
  // The same arrays, and how long they are also where the records stay in the file.
  GridRecords records() const;
  // Of records that stay in the file, which there must be.
  template <class T>
  SectionReader reader(fb::GridSection kind) const {
    return container_.reader<T>(sections(), static_cast<std::uint32_t>(kind));
  }

  // Throws Error(input) unless the grid was built from a scene of this geometry hash and so many primitives.
  void check_geometry(const Hash& geometry_hash, std::uint64_t primitives) const;

  // Point into its memory; of a uniform grid, of a merged one, of a hierarchy. Real is the arithmetic's type.
  template <class Real>
  GridView<Real> view() const;
  template <class Real>
  MergedGridView<Real> merged_view() const;
  template <class Real>
  HierarchyView<Real> hierarchy_view() const {
    return {nodes().data(), references().data()};
  }

private:
  friend GridFile grid_in_memory(const Grid&, const GridProvenance&);
  explicit GridFile(ContainerFile container);
  void check(bool good, const char* what) const;
  void check_sizes() const;
  std::span<const fb::Section> sections() const;

  ContainerFile container_;
  const fb::Grid* table_;
};

// Of a grid in memory.
template <class Real>
GridView<Real> view_of(const Grid& grid);
template <class Real>
MergedGridView<Real> merged_view_of(const Grid& grid);
template <class Real>
HierarchyView<Real> hierarchy_view_of(const Grid& grid) {
  return {grid.nodes.data(), grid.references.data()};
}

// Calls act(the grid's view), which is of the type for its kind.
template <class Real, class Act>
void with_grid_view(const Grid& grid, const Act& act) {
  if (grid.kind == GridKind::hierarchy) return act(hierarchy_view_of<Real>(grid));
  grid.kind == GridKind::uniform ? act(view_of<Real>(grid)) : act(merged_view_of<Real>(grid));
}

} // namespace masu
