// Wavefront OBJ: the polygonal part of "Object Files (.obj)", Wavefront's Advanced Visualizer manual, app.
// B1.
#include "libscene/base/error.h"
#include "libscene/mesh/files/file_material.h"
#include "libscene/mesh/files/mesh_file.h"
#include "libscene/mesh/files/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <unordered_map>

namespace masu {
namespace {

// --- The materials of an OBJ, and the files that it takes them from (MTL) --------------------------------

bool is_texture(std::string_view word) {
  return word.starts_with("map_") || word == "bump" || word == "disp" || word == "refl" || word == "norm";
}

// One number or three; a spectrum, or CIE's XYZ, isn't used.
void read_color(TextLines& lines, Vec3f& color) {
  if (lines.is_at_end() || lines.peek() == "spectral" || lines.peek() == "xyz") return;
  const auto component = [&] { return static_cast<float>(lines.number("a component of a colour")); };
  color.x = component();
  color.y = lines.is_at_end() ? color.x : component();
  color.z = lines.is_at_end() ? color.x : component();
}

// What MTL says. Ke and Ka aren't used: nothing glows, and all have the same ambient light.
struct Description {
  PhongSurface surface{.color = {0.6F, 0.6F, 0.6F}};
  Vec3f specular{0, 0, 0};
  std::int64_t illumination = 1;
  std::optional<float> metalness{}, roughness{};
  bool has_textures = false;
};

Material material_of(const Description& of) {
  if (of.metalness || of.roughness)
    return metallic_material(of.surface.color, of.metalness.value_or(0), of.roughness.value_or(1),
                             1 - clamped(of.surface.opacity, 0, 1), 1);
  PhongSurface phong = of.surface;
  const Vec3f& mirror = of.specular;
  if (of.illumination >= 3 && of.illumination <= 9)
    phong.mirror = mean({clamped(mirror.x, 0, 1), clamped(mirror.y, 0, 1), clamped(mirror.z, 0, 1)});
  return phong_material(phong);
}

class ObjMaterials {
public:
  // The number of the material of that name: a grey one, until a file says more.
  std::uint32_t number_of(const std::string& name) {
    const auto [found, is_new] = numbers_.try_emplace(name, static_cast<std::uint32_t>(descriptions_.size()));
    if (is_new) descriptions_.emplace_back();
    return found->second;
  }

  // Reads a file of materials. Errors repeat nothing of it: an OBJ may name any file. Throws
  // Error(input, name:line, …).
  void read(std::string_view text, const std::string& name) {
    TextLines lines(text, name, '#');
    lines.quote_nothing();
    Description* material = nullptr;
    const auto number = [&] { return static_cast<float>(lines.number("a number")); };
    while (lines.next()) {
      const std::string_view word = lines.word();
      if (word == "newmtl") material = &descriptions_[number_of(std::string(lines.rest()))];
      if (material == nullptr) continue;
      if (word == "Kd") {
        read_color(lines, material->surface.color);
      } else if (word == "Ks") {
        read_color(lines, material->specular);
      } else if (word == "Ns") {
        material->surface.shine = number();
      } else if (word == "Ni") {
        material->surface.refraction_index = number();
      } else if (word == "d") {
        if (lines.peek() == "-halo") lines.word();
        material->surface.opacity = number();
      } else if (word == "Tr") {
        material->surface.opacity = 1 - number();
      } else if (word == "illum") {
        material->illumination = lines.whole("a number from 0 to 10");
      } else if (word == "Pm") {
        material->metalness = number();
      } else if (word == "Pr") {
        material->roughness = number();
      } else if (is_texture(word)) {
        material->has_textures = true;
      }
    }
  }

  // All, in the order of their numbers; adds those with textures to the notes.
  std::vector<FileMaterial> all(ImportNotes& notes) const {
    std::vector<FileMaterial> materials;
    for (const Description& description : descriptions_) {
      materials.push_back({material_of(description)});
      notes.textured_materials += description.has_textures ? 1 : 0;
    }
    return materials;
  }

private:
  std::vector<Description> descriptions_;
  std::unordered_map<std::string, std::uint32_t> numbers_;
};

// --- Shapes ----------------------------------------------------------------------------------------------

// The largest number that was used before the file had so many of its kind: those may follow.
struct Pending {
  std::uint64_t largest = 0, line = 0;
};

class ObjReader {
public:
  explicit ObjReader(const MeshText& text) : text_(text), lines_(text.bytes, text.name, '#', text.progress) {
    lines_.join_lines();
  }

  MeshFile read() {
    begin_object(file_, object_, material_);
    while (lines_.next())
      read_line(lines_.word());
    check(pending_position_, file_.positions.size(), "vertices");
    check(pending_normal_, file_.normals.size(), "normals");
    for (MeshObject& object : file_.objects)
      object.has_colors = !file_.colors.empty();
    file_.materials = materials_.all(file_.notes);
    return std::move(file_);
  }

private:
  void read_line(std::string_view word) {
    if (word == "v") {
      read_vertex();
    } else if (word == "vn") {
      const double x = lines_.number("a component of a normal"), y = lines_.number("a component of a normal"),
                   z = lines_.number("a component of a normal");
      file_.normals.push_back({x, y, z});
    } else if (word == "f" || word == "fo") {
      read_face();
    } else if (word == "l" || word == "p") { // segments or points
      std::uint64_t corners = 0;
      while (!lines_.word().empty())
        ++corners;
      file_.notes.points_and_lines += corners - (word == "l" && corners > 0 ? 1 : 0);
    } else if (word == "o" || word == "g") {
      const std::string name(lines_.rest());
      if (!name.empty() && name != object_) begin_object(file_, object_ = name, material_);
    } else if (word == "usemtl") {
      use_material(std::string(lines_.rest()));
    } else if (word == "mtllib") {
      read_libraries();
    } else if (!has_no_shape(word)) {
      ++file_.notes.unknown_lines;
    }
  }

  static bool has_no_shape(std::string_view word) {
    constexpr std::array words{"vt",       "s",      "mg",     "lod",        "bevel",    "c_interp",
                               "d_interp", "usemap", "maplib", "shadow_obj", "trace_obj"};
    return std::ranges::find(words, word) != words.end();
  }

  // x y z, x y z w, or x y z and a colour (some write an alpha, too).
  void read_vertex() {
    std::array<double, 7> n{};
    std::size_t count = 0;
    for (; !lines_.is_at_end() && count < n.size(); ++count)
      n[count] = lines_.number("a coordinate");
    if (count < 3 || count == 5 || !lines_.is_at_end())
      lines_.fail(
          "a vertex has three coordinates, or a fourth, or a colour of three or four numbers: correct it");
    if (count == 4 && n[3] == 0)
      lines_.fail("the fourth coordinate of a vertex is 0: it has no place: correct it");
    const double w = count == 4 ? n[3] : 1;
    if (file_.positions.size() == no_index) lines_.fail("has more than 2^32 - 1 vertices: split the file");
    file_.positions.push_back({n[0] / w, n[1] / w, n[2] / w});
    if (count < 6 && file_.colors.empty()) return;
    constexpr float none = std::numeric_limits<float>::quiet_NaN();
    if (file_.colors.empty()) file_.colors.assign(file_.positions.size() - 1, {none, none, none});
    file_.colors.push_back(
        count < 6 ? Vec3f{none, none, none}
                  : Vec3f{static_cast<float>(n[3]), static_cast<float>(n[4]), static_cast<float>(n[5])});
  }

  void read_face() {
    corners_.clear();
    normals_.clear();
    bool has_normals = false;
    while (!lines_.is_at_end()) {
      const std::array<std::int64_t, 3> corner = read_corner();
      corners_.push_back(index_of(corner[0], file_.positions.size(), pending_position_, "vertices"));
      normals_.push_back(
          corner[2] == 0 ? no_index : index_of(corner[2], file_.normals.size(), pending_normal_, "normals"));
      has_normals |= corner[2] != 0;
    }
    if (corners_.empty()) lines_.fail("a face without vertices: write their numbers");
    if (corners_.size() >= 3 && (has_normals || !file_.corner_normals.empty())) {
      if (file_.corner_normals.empty()) file_.corner_normals.assign(file_.corners.size(), no_index);
      file_.corner_normals.append(normals_);
      file_.objects.back().has_normals |= has_normals;
    }
    add_face(file_, corners_);
  }

  // The numbers of its vertex, texture vertex and normal; 0: none. 1, 1/2, 1//3 or 1/2/3.
  std::array<std::int64_t, 3> read_corner() {
    const char* const start = lines_.position();
    const std::string_view word = lines_.word();
    const char *p = word.data(), *const end = p + word.size();
    std::array<std::int64_t, 3> numbers{};
    for (std::size_t i = 0;; ++i, ++p) {
      bool is_valid = i < numbers.size();
      if (is_valid && p != end && *p != '/') {
        const auto [after, fault] = std::from_chars(p, end, numbers[i]);
        is_valid = fault == std::errc() && numbers[i] != 0;
        p = after;
      }
      is_valid &= numbers[0] != 0 && (p == end || *p == '/');
      if (!is_valid) {
        lines_.go_to(start);
        lines_.fail_at_word("a corner like 1, 1/2, 1//3 or 1/2/3");
      }
      if (p == end) return numbers;
    }
  }

  std::uint32_t index_of(std::int64_t number, std::size_t count, Pending& pending, const char* what) const {
    const std::int64_t index = number > 0 ? number - 1 : static_cast<std::int64_t>(count) + number;
    if (index < 0 || index >= no_index)
      lines_.fail(fmt::format("names number {} of {} {}: correct it", number, count, what));
    const auto unsigned_index = static_cast<std::uint64_t>(index);
    if (unsigned_index >= count && unsigned_index >= pending.largest)
      pending = {unsigned_index, lines_.line()};
    return static_cast<std::uint32_t>(index);
  }
  void check(const Pending& pending, std::size_t count, const char* what) const {
    if (pending.line != 0 && pending.largest >= count)
      throw Error(ErrorCode::input, fmt::format("{}:{}", text_.name, pending.line),
                  fmt::format("names number {} of {} {}: correct it, or complete the file",
                              pending.largest + 1, count, what));
  }

  void use_material(const std::string& name) {
    material_ = materials_.number_of(name);
    if (file_.objects.back().material != material_)
      begin_object(file_, file_.objects.back().faces > 0 ? object_ + "/" + name : object_, material_);
  }

  // Names may have blanks, and so has a list of them. Where there is none of them, the file beside the mesh
  // of the same name is taken.
  void read_libraries() {
    const std::string all(lines_.rest());
    if (read_library(all)) return;
    std::size_t missing = 0, count = 0;
    for (std::size_t begin = 0; (begin = all.find_first_not_of(" \t", begin)) != std::string::npos; ++count) {
      const std::size_t end = std::min(all.find_first_of(" \t", begin), all.size());
      if (end - begin == all.size() || !read_library(all.substr(begin, end - begin))) ++missing;
      begin = end;
    }
    const auto beside = std::filesystem::path(text_.name).filename().replace_extension(".mtl");
    if (missing == count && count > 0 && read_library(beside)) missing = 0;
    file_.notes.missing_libraries += missing;
  }
  bool read_library(const std::string& name) {
    const std::optional<std::string> library = text_.other_file ? text_.other_file(name) : std::nullopt;
    if (library) materials_.read(*library, excerpt(name, 128)); // any text may be named a file
    return library.has_value();
  }

  const MeshText& text_;
  TextLines lines_;
  MeshFile file_;
  ObjMaterials materials_;
  std::string object_ = "defaultobject";
  std::uint32_t material_ = materials_.number_of("");
  Pending pending_position_, pending_normal_;
  std::vector<std::uint32_t> corners_, normals_; // of a face
};

} // namespace

MeshFile parse_obj(const MeshText& text) {
  return ObjReader(text).read();
}

} // namespace masu
