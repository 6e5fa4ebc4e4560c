// STL, 3D Systems' facets, as text and as binary. Their normals aren't used: they wouldn't smooth anything.
#include "libscene/base/error.h"
#include "libscene/mesh/files/file_material.h"
#include "libscene/mesh/files/mesh_file.h"
#include "libscene/mesh/files/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace masu {
namespace {

void add_triangle(MeshFile& file) {
  const auto end = static_cast<std::uint32_t>(file.positions.size());
  const std::array corners{end - 3, end - 2, end - 1};
  add_face(file, corners);
}

// --- Text ------------------------------------------------------------------------------------------------

// Its words may be in any lines, but that a solid's name ends with its line.
class TextReader {
public:
  explicit TextReader(const MeshText& text) : lines_(text.bytes, text.name, '\0', text.progress) {}

  MeshFile read() {
    file_.materials.push_back({phong_material({})});
    while (lines_.next()) {
      need("solid");
      begin_object(file_, std::string(lines_.rest()), 0);
      std::string_view word;
      while (word = next("facet or endsolid"), is_word(word, "facet"))
        read_facet();
      if (!is_word(word, "endsolid")) fail(word, "facet or endsolid");
      lines_.rest(); // its name again
    }
    return std::move(file_);
  }

private:
  std::string_view next(const char* what) {
    if (lines_.is_at_end()) lines_.need_line(what);
    return lines_.word();
  }
  [[noreturn]] void fail(std::string_view word, const char* what) {
    lines_.go_to(word.data());
    lines_.fail_at_word(what);
  }
  void need(const char* what) {
    if (const std::string_view word = next(what); !is_word(word, what)) fail(word, what);
  }
  void read_facet() {
    std::string_view word = next("outer loop");
    if (is_word(word, "normal")) {
      for (int i = 0; i < 3; ++i)
        next("a component of a normal");
      word = next("outer loop");
    }
    if (!is_word(word, "outer")) fail(word, "outer loop");
    need("loop");
    if (file_.positions.size() > no_index - 3) lines_.fail("has more than 2^32 - 1 vertices: split the file");
    for (int i = 0; i < 3; ++i) {
      need("vertex");
      file_.positions.push_back({coordinate(), coordinate(), coordinate()});
    }
    need("endloop");
    need("endfacet");
    add_triangle(file_);
  }
  double coordinate() {
    if (lines_.is_at_end()) lines_.need_line("a coordinate");
    return lines_.number("a coordinate");
  }

  TextLines lines_;
  MeshFile file_;
};

// --- Binary ----------------------------------------------------------------------------------------------

constexpr std::size_t header_bytes = 84, facet_bytes = 50;

template <class T>
T read_as(const char* from) { // little endian, as all processors that this is for
  T value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

std::uint64_t facets_of(std::string_view bytes) {
  return read_as<std::uint32_t>(bytes.data() + header_bytes - 4);
}

// Not by the first word alone, which headers of binary files begin with, too: those have zero bytes.
bool is_text(std::string_view bytes) {
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n\v\f", bytes.starts_with("\xef\xbb\xbf") ? 3 : 0);
  if (begin == std::string_view::npos || !is_word(bytes.substr(begin, 5), "solid")) return false;
  constexpr std::size_t looked_at = 512;
  return (bytes.size() < header_bytes || bytes.size() != header_bytes + facets_of(bytes) * facet_bytes) &&
         bytes.substr(0, looked_at).find('\0') == std::string_view::npos;
}

// Two programs' ways to colour facets by five bits a channel: Magics' header has a colour for the others, and
// red in the lowest bits; VisCAM's has blue there.
struct Colors {
  bool is_magics = false;
  Vec3f usual{0.6F, 0.6F, 0.6F};

  explicit Colors(std::string_view header) {
    constexpr std::string_view key = "COLOR=";
    const std::size_t at = header.find(key);
    if (at == std::string_view::npos || at + key.size() + 3 > header.size()) return;
    is_magics = true;
    const auto channel = [&](std::size_t i) {
      return static_cast<float>(static_cast<unsigned char>(header[at + key.size() + i])) / 255;
    };
    usual = {channel(0), channel(1), channel(2)};
  }
  Vec3f of(std::uint16_t bits) const {
    if ((bits & 0x8000) == 0) return usual;
    const auto channel = [&](int shift) { return static_cast<float>(bits >> shift & 31) / 31; };
    return is_magics ? Vec3f{channel(0), channel(5), channel(10)}
                     : Vec3f{channel(10), channel(5), channel(0)};
  }
};

MeshFile parse_binary(const MeshText& text) {
  const std::string_view bytes = text.bytes;
  const auto fail = [&](const std::string& message) { throw Error(ErrorCode::input, text.name, message); };
  if (bytes.size() < header_bytes)
    fail("isn't an STL file: it neither begins with solid nor has a binary header: give one that does");
  const std::uint64_t facets = facets_of(bytes), there = (bytes.size() - header_bytes) / facet_bytes;
  if (facets > there)
    fail(fmt::format(
        "its binary header promises {} facets, and {} are there: it is cut, or isn't an STL file: "
        "complete it",
        facets, there));
  if (3 * facets > no_index) fail("has more than 2^32 - 1 vertices: split the file");
  MeshFile file;
  const Colors colors(bytes.substr(0, header_bytes - 4));
  file.positions.reserve(3 * facets);
  file.materials.push_back({phong_material({.color = colors.is_magics ? colors.usual : Vec3f{1, 1, 1}})});
  begin_object(file, "", 0);
  bool is_colored = false;
  for (std::uint64_t i = 0; i < facets; ++i) {
    const char* const facet = bytes.data() + header_bytes + i * facet_bytes;
    for (std::size_t k = 3; k < 12; k += 3) {
      const auto coordinate = [&](std::size_t j) {
        return static_cast<double>(read_as<float>(facet + (k + j) * sizeof(float)));
      };
      file.positions.push_back({coordinate(0), coordinate(1), coordinate(2)});
    }
    add_triangle(file);
    const auto color = read_as<std::uint16_t>(facet + 48);
    is_colored |= (color & 0x8000) != 0;
    if (!is_colored) continue;
    while (file.colors.size() < 3 * i)
      file.colors.push_back(colors.usual);
    for (int k = 0; k < 3; ++k)
      file.colors.push_back(colors.of(color));
  }
  file.objects[0].has_colors = is_colored;
  file.notes.trailing_bytes = bytes.size() - header_bytes - facets * facet_bytes;
  return file;
}

} // namespace

MeshFile parse_stl(const MeshText& text) {
  return is_text(text.bytes) ? TextReader(text).read() : parse_binary(text);
}

} // namespace masu
