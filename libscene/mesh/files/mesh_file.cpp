#include "libscene/mesh/files/mesh_file.h"

#include "libscene/mesh/files/text_lines.h"

#include <array>

namespace masu {

void begin_object(MeshFile& file, const std::string& name, std::uint32_t material) {
  if (file.objects.empty() || file.objects.back().faces > 0) file.objects.emplace_back();
  file.objects.back() = {.name = name,
                         .material = material,
                         .first_face = file.face_sizes.size(),
                         .first_corner = file.corners.size()};
}

void add_face(MeshFile& file, std::span<const std::uint32_t> corners) {
  if (corners.size() < 3) {
    ++file.notes.points_and_lines;
    return;
  }
  MeshObject& object = file.objects.back();
  ++object.faces;
  object.corners += corners.size();
  file.corners.append(corners);
  file.face_sizes.push_back(static_cast<std::uint32_t>(corners.size()));
}

std::string extension_of(const std::filesystem::path& path) {
  const std::string extension = path.extension();
  return extension.empty() ? extension : extension.substr(1);
}

std::optional<MeshFormat> format_of_name(const std::string& extension) {
  constexpr std::array names{"obj", "ply", "off", "stl"};
  const auto found = std::ranges::find_if(names, [&](const char* name) { return is_word(extension, name); });
  return found != names.end() ? std::optional(static_cast<MeshFormat>(found - names.begin())) : std::nullopt;
}

std::optional<MeshFormat> format_of_content(std::string_view file) {
  if (file.starts_with("\xef\xbb\xbf")) file.remove_prefix(3);
  constexpr std::string_view blanks = " \t\r\n\v\f";
  // The first word that isn't in a comment.
  for (;;) {
    file.remove_prefix(std::min(file.find_first_not_of(blanks), file.size()));
    if (!file.starts_with('#')) break;
    file.remove_prefix(std::min(file.find_first_of("\r\n"), file.size()));
  }
  const std::string_view word = file.substr(0, file.find_first_of(blanks));
  if (is_word(word, "ply")) return MeshFormat::ply;
  if (is_word(word, "solid")) return MeshFormat::stl;
  if (word.size() <= 6 && word.ends_with("OFF")) return MeshFormat::off;
  constexpr std::array obj{"v", "vn", "vt", "f", "o", "g", "s", "usemtl", "mtllib"};
  return std::ranges::find(obj, word) != obj.end() ? std::optional(MeshFormat::obj) : std::nullopt;
}

MeshFile parse_mesh_file(const MeshText& text, MeshFormat format) {
  constexpr std::array parsers{parse_obj, parse_ply, parse_off, parse_stl};
  return parsers[static_cast<std::size_t>(format)](text);
}

} // namespace masu
