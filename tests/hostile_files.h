// Scene and grid files taken apart, to be written again with invalid contents and correct hashes.
#pragma once

#include "libgrid/file/structure_file.h"
#include "libscene/file/scene_file.h"
#include "renderer/backend.h"
#include "tests/refused.h"
#include "tests/temporary_folder.h"
#include "tests/tiny_scene.h"

#include <cstring>
#include <functional>

namespace masu {

struct SectionBytes {
  std::uint32_t kind, record_bytes;
  Bytes bytes;

  template <class Record>
  Record get(std::size_t i) const {
    Record record;
    std::memcpy(&record, bytes.data() + i * sizeof record, sizeof record);
    return record;
  }
  // Calls change(record i).
  template <class Record, class Change>
  void edit(std::size_t i, const Change& change) {
    Record record = get<Record>(i);
    change(record);
    std::memcpy(bytes.data() + i * sizeof record, &record, sizeof record);
  }
};

inline std::vector<SectionBytes> sections_of(const std::string& path,
                                             const flatbuffers::Vector<const fb::Section*>& list) {
  const Bytes file = read_bytes(path);
  Prelude prelude;
  std::memcpy(&prelude, file.data(), sizeof prelude);
  std::vector<SectionBytes> sections;
  for (const fb::Section* section : list) {
    const auto from = file.begin() + static_cast<std::ptrdiff_t>(prelude.body_offset + section->offset());
    const auto size = static_cast<std::ptrdiff_t>(section->record_bytes() * section->count());
    sections.push_back({section->kind(), section->record_bytes(), Bytes(from, from + size)});
  }
  return sections;
}

// What scene and grid files have in common.
struct TakenApart {
  std::vector<SectionBytes> sections;
  std::function<void(std::vector<fb::Section>&)> falsify; // changes the table's list of sections
  std::function<void(Bytes&)> damage_table;

  SectionBytes& section(std::uint32_t kind) {
    return *std::ranges::find(sections, kind, &SectionBytes::kind);
  }
  void drop(std::uint32_t kind) {
    std::erase_if(sections, [&](const SectionBytes& s) { return s.kind == kind; });
  }

  // make_table(layout) returns the table's bytes.
  template <class MakeTable>
  void write(const std::string& path, const FileKind& kind, const MakeTable& make_table) const {
    std::vector<SectionData> data;
    for (const SectionBytes& s : sections)
      data.push_back({s.kind, s.record_bytes, s.bytes.size() / s.record_bytes, s.bytes.data()});
    const auto layout = lay_out(data);
    auto listed = layout;
    if (falsify) falsify(listed);
    Bytes table = make_table(listed);
    if (damage_table) damage_table(table);
    write_container(path, kind, table, data, layout);
  }
};

struct SceneParts : TakenApart {
  fb::Store store;
  fb::Vec3 origin;
  fb::Camera camera;
  fb::Color background;
  float ambient;
  fb::ObjectCounts objects;
  fb::Box bounds;
  std::uint64_t reflective_materials, transmitting_materials;

  explicit SceneParts(const std::string& path) : SceneParts(SceneFile(path)) {}
  explicit SceneParts(const SceneFile& file)
      : store(file.table().store()), origin(*file.table().origin()), camera(*file.table().camera()),
        background(*file.table().background()), ambient(file.table().ambient()),
        objects(*file.table().objects()), bounds(*file.table().bounds()),
        reflective_materials(file.table().reflective_materials()),
        transmitting_materials(file.table().transmitting_materials()) {
    sections = sections_of(file.path(), *file.table().sections());
  }

  SectionBytes& section(fb::SceneSection kind) {
    return TakenApart::section(static_cast<std::uint32_t>(kind));
  }
  void drop(fb::SceneSection kind) { TakenApart::drop(static_cast<std::uint32_t>(kind)); }

  void write(const std::string& path) const {
    TakenApart::write(path, scene_file_kind, [&](const std::vector<fb::Section>& layout) {
      flatbuffers::FlatBufferBuilder builder;
      builder.Finish(fb::CreateScene(builder, store, &origin, &camera, &background, ambient, &objects,
                                     &bounds, reflective_materials, transmitting_materials,
                                     builder.CreateVectorOfStructs(layout)));
      return Bytes(builder.GetBufferPointer(), builder.GetBufferPointer() + builder.GetSize());
    });
  }
};

struct GridParts : TakenApart {
  fb::Hash geometry_hash;
  std::uint64_t primitives;
  fb::Box space;
  double margin;
  fb::Division division;
  std::uint32_t block_log2, nested_log2;
  fb::StructureType structure;
  fb::Merge merge;
  fb::Quality quality;
  std::string rule, merge_rule;
  std::optional<fb::Vec3> origin{};

  explicit GridParts(const std::string& path) : GridParts(StructureFile(path)) {}
  explicit GridParts(const StructureFile& file)
      : geometry_hash(*file.table().geometry_hash()), primitives(file.table().primitives()),
        space(*file.table().space()), margin(file.table().margin()), division(*file.table().division()),
        block_log2(file.table().block_log2()), nested_log2(file.table().nested_log2()),
        structure(file.table().structure()), merge(file.table().merge()), quality(file.table().quality()),
        rule(file.table().division_rule()->str()), merge_rule(file.table().merge_rule()->str()) {
    sections = sections_of(file.path(), *file.table().sections());
  }

  SectionBytes& section(fb::StructureSection kind) {
    return TakenApart::section(static_cast<std::uint32_t>(kind));
  }
  void drop(fb::StructureSection kind) { TakenApart::drop(static_cast<std::uint32_t>(kind)); }
  // Sets word i of a section, appending it if necessary.
  void set(fb::StructureSection kind, std::size_t i, std::uint32_t value) {
    Bytes& bytes = section(kind).bytes;
    bytes.resize(std::max(bytes.size(), 4 * (i + 1)));
    std::memcpy(bytes.data() + 4 * i, &value, 4);
  }

  void write(const std::string& path) const {
    TakenApart::write(path, structure_file_kind, [&](const std::vector<fb::Section>& layout) {
      flatbuffers::FlatBufferBuilder builder;
      const auto list = builder.CreateVectorOfStructs(layout);
      const auto rule_text = builder.CreateString(rule);
      const auto merge_text = builder.CreateString(merge_rule);
      builder.Finish(fb::CreateStructure(builder, &geometry_hash, primitives, &space, margin, &division,
                                         block_log2, nested_log2, fb::Space::tight, fb::Overlap::exact,
                                         structure, merge, quality, rule_text, merge_text, -1, list,
                                         origin ? &*origin : nullptr));
      return Bytes(builder.GetBufferPointer(), builder.GetBufferPointer() + builder.GetSize());
    });
  }
};

// A named way to make a file invalid.
template <class Parts>
struct Wrong {
  const char* name;
  std::function<void(Parts&)> spoil;
};
template <class Parts>
void PrintTo(const Wrong<Parts>& wrong, std::ostream* out) {
  *out << wrong.name;
}
inline const auto by_name = [](const auto& test) { return std::string(test.param.name); };

template <class Parts, class Field>
Wrong<Parts> set(const char* name, Field Parts::*field, const std::type_identity_t<Field>& value) {
  return {name, [=](Parts& p) { p.*field = value; }};
}
// Makes the table list sections falsely.
template <class Parts>
Wrong<Parts> listed(const char* name, const std::function<void(std::vector<fb::Section>&)>& change) {
  return {name, [change](Parts& p) { p.falsify = change; }};
}
template <class Parts>
Wrong<Parts> table(const char* name, const std::function<void(Bytes&)>& change) {
  return {name, [change](Parts& p) { p.damage_table = change; }};
}

using WrongGrid = Wrong<GridParts>;
inline WrongGrid word(const char* name, fb::StructureSection kind, std::size_t i, std::uint32_t value) {
  return {name, [=](GridParts& p) { p.set(kind, i, value); }};
}
inline WrongGrid in_map(const char* name, std::size_t i, std::uint32_t value) {
  return word(name, fb::StructureSection::voxel_map, i, value);
}
inline WrongGrid in_lists(const char* name, std::size_t i, std::uint32_t value) {
  return word(name, fb::StructureSection::references, i, value);
}
inline WrongGrid without(const char* name, fb::StructureSection kind) {
  return {name, [kind](GridParts& p) { p.drop(kind); }};
}
inline WrongGrid resized(const char* name, fb::StructureSection kind, std::size_t bytes) {
  return {name, [=](GridParts& p) { p.section(kind).bytes.resize(bytes); }};
}
inline WrongGrid division(const char* name, std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  return set(name, &GridParts::division, {x, y, z});
}
inline WrongGrid blocks(const char* name, std::uint32_t log2) {
  return set(name, &GridParts::block_log2, log2);
}
inline WrongGrid merged_as(const char* name, int merge) {
  return set(name, &GridParts::merge, static_cast<fb::Merge>(merge));
}
inline WrongGrid structured_as(const char* name, int type) {
  return set(name, &GridParts::structure, static_cast<fb::StructureType>(type));
}

// What a GPU's tracer does with files before it traces.
inline void upload(const SceneFile& scene) {
  upload_files_cuda(scene, nullptr, 0);
}
inline void upload(const StructureFile& grid) {
  const TemporaryFolder folder;
  const std::string path = folder.file("good.scene");
  write_scene(tiny_scene(), Store::float32, path);
  upload_files_cuda(SceneFile(path, Residence::file), &grid, 0);
}

// Whether the file is refused: in memory, mapped, and by a GPU where there is one.
template <class File>
testing::AssertionResult is_refused_as(const std::string& path) {
  const auto in_memory = is_refused([](const std::string& name) { const File file(name); }, path);
  const auto mapped = [](const std::string& name) { const File file(name, Residence::mapping); };
  const auto uploaded = [](const std::string& name) { upload(File(name, Residence::file)); };
  if (!in_memory) return in_memory;
  const auto in_mapping = is_refused(mapped, path);
  return in_mapping && cuda_device_count() > 0 ? is_refused(uploaded, path) : in_mapping;
}

// Expects the file at `path`, which is valid, to be refused when it is spoilt.
template <class File, class Parts>
void expect_refused(const std::string& path, const Wrong<Parts>& wrong) {
  Parts parts(path);
  parts.write(path);
  ASSERT_NO_THROW(const File unspoilt(path));
  wrong.spoil(parts);
  parts.write(path);
  EXPECT_TRUE(is_refused_as<File>(path));
}

inline void expect_grid_refused(const Structure& grid, const std::string& merge_rule,
                                const WrongGrid& wrong) {
  const TemporaryFolder folder;
  const std::string path = folder.file("hostile.grid");
  write_structure(grid, tiny_grid_provenance({1, 2}, merge_rule), path);
  expect_refused<StructureFile>(path, wrong);
}

} // namespace masu
