#include "libgrid/file/structure_file.h"

#include "libgrid/file/structure_checks.h"
#include "libscene/base/error.h"
#include "libscene/local_origin.h"

#include <algorithm>
#include <array>
#include <vector>

namespace masu {
namespace {

std::vector<std::uint8_t> grid_table(const Structure& grid, const StructureProvenance& provenance,
                                     const std::vector<fb::Section>& section_layout) {
  flatbuffers::FlatBufferBuilder builder;
  const auto sections = builder.CreateVectorOfStructs(section_layout);
  const auto rule = builder.CreateString(provenance.division_rule);
  const auto merge_rule = builder.CreateString(provenance.merge_rule);
  const fb::Hash geometry_hash(provenance.geometry_hash.low, provenance.geometry_hash.high);
  const fb::Box space = table_box(grid.layout.space);
  const fb::Vec3 origin = table_vector(provenance.origin);
  const bool is_hierarchy = grid.kind == StructureKind::hierarchy;
  const Vec3<std::uint32_t> n = cast<std::uint32_t>(grid.layout.division);
  const fb::Division division(n.x, n.y, n.z);
  builder.Finish(fb::CreateStructure(
      builder, &geometry_hash, provenance.primitives, &space, grid.layout.margin, &division,
      static_cast<std::uint32_t>(grid.block_log2), static_cast<std::uint32_t>(grid.nested_log2),
      provenance.space_rule == SpaceRule::cube ? fb::Space::cube : fb::Space::tight,
      provenance.overlap == Overlap::exact ? fb::Overlap::exact : fb::Overlap::box,
      is_hierarchy ? fb::StructureType::hierarchy : fb::StructureType::grid,
      is_hierarchy ? fb::Merge::none : static_cast<fb::Merge>(grid.kind),
      static_cast<fb::Quality>(provenance.quality), rule, merge_rule, provenance.build_seconds, sections,
      provenance.origin == Vec3d{0, 0, 0} ? nullptr : &origin));
  return {builder.GetBufferPointer(), builder.GetBufferPointer() + builder.GetSize()};
}

// A space that can be divided: finite, and with sides whose inverses are.
bool is_divisible(const Boxd& space) {
  const Vec3d side = space.max - space.min;
  return is_finite(space.min) && is_finite(space.max) && std::min({side.x, side.y, side.z}) >= 1e-300 &&
         std::max({side.x, side.y, side.z}) <= 1e300;
}

std::array<SectionData, 4> sections_of(const Structure& grid) {
  const auto section = [](fb::StructureSection kind, const auto& records) {
    return section_data(static_cast<std::uint32_t>(kind), std::span(records));
  };
  return {section(fb::StructureSection::voxel_map, grid.voxel_map),
          section(fb::StructureSection::cells, grid.cells),
          section(fb::StructureSection::references, grid.references),
          section(fb::StructureSection::nodes, grid.nodes)};
}

} // namespace

void write_structure(const Structure& grid, const StructureProvenance& provenance, const std::string& path) {
  const auto sections = sections_of(grid);
  const auto section_layout = lay_out(sections);
  write_container(path, structure_file_kind, grid_table(grid, provenance, section_layout), sections,
                  section_layout);
}

StructureFile structure_in_memory(const Structure& grid, const StructureProvenance& provenance) {
  return StructureFile(
      ContainerFile(make_container(structure_file_kind, sections_of(grid),
                                   [&](const auto& layout) { return grid_table(grid, provenance, layout); }),
                    "grid"));
}

StructureFile::StructureFile(const std::string& path, Residence residence)
    : StructureFile(ContainerFile(path, structure_file_kind, residence)) {}

StructureFile::StructureFile(ContainerFile container) : TableFile(std::move(container)) {
  const auto axis_good = [](std::uint32_t voxels) { return voxels >= 1 && voxels <= largest_division; };
  const fb::Division& n = *table_->division();
  check(axis_good(n.x()) && axis_good(n.y()) && axis_good(n.z()), "its division is impossible");
  check(is_divisible(box_of(*table_->space())), "its space is impossible");
  check(is_finite(origin()) && largest_magnitude(origin()) <= max_origin, "its origin is invalid");
  check(table_->block_log2() <= 5, "its blocks are impossible");
  read_sections(sections());
  records_ = records_of_sections();
  check_sizes();
  if (has_records_to_check()) {
    const char* const fault = fault_of(HostChecker{}, records());
    check(fault == nullptr, fault);
  }
  set_validated();
}

void StructureFile::check_sizes() const {
  const StructureRecords& held = records();
  const std::uint64_t words = held.words;
  const Vec3i n = held.layout.division;
  bool good = false;
  check(table_->structure() <= fb::StructureType::MAX && table_->quality() <= fb::Quality::MAX,
        "it is an unknown structure");
  check(table_->merge() <= fb::Merge::MAX, "its cells are merged in an unknown way");
  if (is_hierarchy()) {
    check(!is_merged() && held.node_count > 0 && words == 0 && held.cell_count == 0 && voxel_count(n) == 1,
          "it has no hierarchy");
    return;
  }
  check(held.node_count == 0, "its table is damaged");
  if (is_merged()) {
    const auto nested_log2 = table_->nested_log2();
    good = nested_log2 <= 15 && (std::max({n.x, n.y, n.z}) << nested_log2) <= largest_division &&
           words >= voxel_count(n) && words <= max_numbered + 1;
  } else {
    const auto block_log2 = static_cast<std::int32_t>(table_->block_log2());
    const std::uint64_t blocks = voxel_count(blocks_of(n, block_log2));
    good = words >= blocks && (words - blocks) % (std::uint64_t{1} << (3 * block_log2)) == 0 &&
           (block_log2 > 0 || words == blocks);
  }
  check(good, "its voxel map has the wrong size");
}

Vec3d StructureFile::origin() const {
  return table_->origin() != nullptr ? vector_of(*table_->origin()) : Vec3d{0, 0, 0};
}

GridLayout StructureFile::layout() const {
  const fb::Division& n = *table_->division();
  return {box_of(*table_->space()), cast<std::int32_t>(Vec3<std::uint32_t>{n.x(), n.y(), n.z()}),
          table_->margin()};
}

StructureRecords StructureFile::records_of_sections() const {
  return {voxel_map().data(),
          cells().data(),
          references().data(),
          nodes().data(),
          count<std::uint32_t>(fb::StructureSection::voxel_map),
          count<MergedCell>(fb::StructureSection::cells),
          count<PrimitiveIndex>(fb::StructureSection::references),
          count<HierarchyNode>(fb::StructureSection::nodes),
          table_->primitives(),
          is_hierarchy(),
          is_merged(),
          layout(),
          static_cast<std::int32_t>(table_->block_log2()),
          static_cast<std::int32_t>(table_->nested_log2())};
}

void StructureFile::check_geometry(const Hash& geometry_hash, std::uint64_t primitives) const {
  if (hash_of(*table_->geometry_hash()) != geometry_hash || table_->primitives() != primitives)
    throw Error(ErrorCode::input, path(), "was built from another geometry: build it again with gridbuild");
}

} // namespace masu
