// The grid file: a container (libscene/file/container.h) whose table is schemas/structure.fbs.
#pragma once

#include "libgrid/grid/division.h"
#include "libgrid/structure/structure.h"
#include "libscene/file/container.h"
#include "schemas/structure_generated.h"

#include <string>

namespace masu {

inline constexpr FileKind structure_file_kind{
    {'M', 'A', 'S', 'U', 'G', 'R', 'D', '\0'}, 5, "grid", "build it again with gridbuild"};

// How a grid came about, as its file tells it.
struct StructureProvenance {
  Hash geometry_hash; // the scene's (scene_file.h)
  std::uint64_t primitives = 0;
  Vec3d origin{0, 0, 0}; // likewise: where it is in the world (local_origin.h)
  SpaceRule space_rule{};
  Overlap overlap{};
  std::string division_rule;
  std::string merge_rule{};   // of a merged grid
  HierarchyQuality quality{}; // of a hierarchy
  double build_seconds = -1;  // -1: not recorded, so that equal builds give equal files
};

// Writes the grid to `path`, whole or not at all. Throws Error(output).
void write_structure(const Structure& grid, const StructureProvenance& provenance, const std::string& path);

// A grid file, checked: every index in it can be followed. Of one whose records stay in the file, only the
// table is; who copies them checks them (structure_checks.h).
class StructureFile : public TableFile<fb::Structure, fb::StructureSection> {
public:
  // Throws Error(input, path, …) for a file that can't be read, isn't a grid or is damaged.
  explicit StructureFile(const std::string& path, Residence residence = Residence::memory);
  explicit StructureFile(ContainerFile container);

  // Of the scene that it was built from: the point in the world that all places are relative to.
  Vec3d origin() const;
  GridLayout layout() const;
  bool is_hierarchy() const { return table_->structure() == fb::StructureType::hierarchy; }
  bool is_merged() const { return table_->merge() != fb::Merge::none; }
  HierarchyQuality quality() const { return static_cast<HierarchyQuality>(table_->quality()); }
  std::span<const std::uint32_t> voxel_map() const {
    return TableFile::records<std::uint32_t>(fb::StructureSection::voxel_map);
  }
  std::span<const MergedCell> cells() const {
    return TableFile::records<MergedCell>(fb::StructureSection::cells);
  }
  std::span<const PrimitiveIndex> references() const {
    return TableFile::records<PrimitiveIndex>(fb::StructureSection::references);
  }
  std::span<const HierarchyNode> nodes() const {
    return TableFile::records<HierarchyNode>(fb::StructureSection::nodes);
  }
  // The same arrays, and how long they are also where the records stay in the file.
  const StructureRecords& records() const { return records_; }

  // Throws Error(input) unless the grid was built from a scene of this geometry hash and so many primitives.
  void check_geometry(const Hash& geometry_hash, std::uint64_t primitives) const;

private:
  StructureRecords records_of_sections() const;
  void check_sizes() const;

  StructureRecords records_{}; // found once: a query of one ray needs them, too
};

// What write_structure() would write, in memory.
StructureFile structure_in_memory(const Structure& grid, const StructureProvenance& provenance);

} // namespace masu
