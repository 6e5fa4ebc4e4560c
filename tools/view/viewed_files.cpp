#include "libgrid/structure/chosen_structure.h"
#include "libscene/base/printable.h"
#include "libscene/file/input_file.h"
#include "libscene/mesh/files/mesh_scene.h"
#include "libscene/nff/nff.h"
#include "libscene/spd/spd.h"
#include "tools/common/progress.h"
#include "tools/report/scene_report.h"
#include "tools/view/viewer.h"

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <span>

namespace masu {
namespace {

// What is built unasked, and the option of gridbuild that builds it.
struct Wanted {
  const char* name;
  StructureKind kind;
  const char *option, *value;
};
constexpr Wanted all_wanted[] = {{"uniform", StructureKind::uniform, "--merge", "none"},
                                 {"balance", StructureKind::balance, "--merge", "balance"},
                                 {"irregular", StructureKind::irregular, "--merge", "irregular"},
                                 {"bvh", StructureKind::hierarchy, "--structure", "bvh"}};

void build(ViewedFiles& files, std::span<const Wanted> wanted, bool quiet) {
  std::string made = files.made_by.empty() ? "" : " " + files.path;
  for (const auto& [name, kind, option, value] : wanted) {
    Progress progress("building", quiet);
    StructureFile file =
        built_in_memory(files.scene, {.structure = {kind}, .division = {}}, std::ref(progress));
    const std::string path =
        fmt::format("{}-{}.grid", std::filesystem::path(files.path).stem().string(), name);
    made += " " + path;
    files.structures.push_back(
        {path, std::move(file), {{"gridbuild", files.path, "-o", path, option, value}}});
  }
  if (!quiet) print_note("gridview: made in memory:{}\n", printable(made));
}

// As nffgen and nff2bin would: NFF text has six digits of a number.
Scene standard_scene(const SpdInfo& info) {
  char* bytes = nullptr;
  std::size_t size = 0;
  const std::unique_ptr<char*, void (*)(char**)> freed(&bytes, [](char** text) { std::free(*text); });
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(open_memstream(&bytes, &size), std::fclose);
  if (stream == nullptr) throw std::bad_alloc();
  write_spd({info.scene, info.standard}, stream.get(), std::string(info.name)); // which flushes it
  return parse_nff({bytes, size}, std::string(info.name));
}

// Meshes of the formats that Masu's own readers read: what Assimp does with damaged files is for mesh2bin,
// which reads them in a process of their own.
Scene read_mesh_scene(const std::string& path, const std::function<void(double)>& progress) {
  const std::filesystem::path parts(path);
  const std::string extension = extension_of(parts);
  const ImportOptions options{.progress = progress};
  const HostBytes contents = InputFile(path).contents();
  std::optional<MeshFormat> format = format_of_name(extension);
  if (!format && extension.empty())
    format = format_of_content({reinterpret_cast<const char*>(contents.data()), contents.size()});
  if (!format)
    throw Error(ErrorCode::input, path, "is no scene, NFF, OBJ, PLY, STL or OFF: convert it by mesh2bin");
  const MeshFile mesh = read_mesh_file(contents, *format, parts.parent_path(), path, options);
  ImportedScene imported = viewed_scene_of(mesh, path, options);
  print_warnings("gridview", path, imported.notes);
  return std::move(imported.scene);
}

Scene read_scene(const std::string& path, bool is_nff, bool quiet) {
  Progress progress("reading", quiet);
  Scene scene =
      is_nff ? read_nff(path, {.progress = std::ref(progress)}) : read_mesh_scene(path, std::ref(progress));
  print_warnings("gridview", path, scene.warnings);
  return scene;
}

} // namespace

ViewedFiles viewed_files(const std::string& scene, const std::vector<std::string>& grids,
                         const std::string& demo, bool quiet) {
  if (!grids.empty()) check_scene_input(scene);
  const std::string stem = demo.empty() ? std::filesystem::path(scene).stem().string() : demo;
  const bool is_file = demo.empty() && (!grids.empty() || is_scene_file(scene)),
             is_nff = scene.ends_with(".nff");
  ViewedFiles files{is_file ? scene : stem + ".scene",
                    is_file ? SceneFile(scene)
                            : scene_in_memory(demo.empty() ? read_scene(scene, is_nff, quiet)
                                                           : standard_scene(spd_info(demo)),
                                              Store::automatic)};
  if (!demo.empty())
    files.made_by = {{"nffgen", demo, "-o", demo + ".nff"}, {"nff2bin", demo + ".nff", "-o", files.path}};
  else if (!is_file)
    files.made_by = {{is_nff ? "nff2bin" : "mesh2bin", scene, "-o", files.path}};
  for (const std::string& grid : grids)
    files.structures.push_back({grid, StructureFile(grid)});
  if (grids.empty()) build(files, std::span(all_wanted).last(demo.empty() ? 2 : 4), quiet);
  return files;
}

} // namespace masu
