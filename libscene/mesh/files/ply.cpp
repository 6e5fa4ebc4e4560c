// PLY, Greg Turk's polygon format, as text and as binary of either byte order: vertices' x, y, z, nx, ny, nz
// and colours, and the lists of faces. Other properties and elements are passed over, in any order.
#include "libscene/base/error.h"
#include "libscene/mesh/files/file_material.h"
#include "libscene/mesh/files/mesh_file.h"
#include "libscene/mesh/files/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

namespace masu {
namespace {

// A number of that type; `is_swapped`: in the other order of bytes.
template <class T>
double number_of(const char* bytes, bool is_swapped) {
  std::array<char, sizeof(T)> raw{};
  std::memcpy(raw.data(), bytes, sizeof(T));
  if (is_swapped) std::ranges::reverse(raw);
  return static_cast<double>(std::bit_cast<T>(raw));
}

struct Type {
  std::string_view name, other;
  std::size_t bytes;
  bool is_whole;
  double one; // a colour's full intensity
  double (*number)(const char*, bool);
};
template <class T>
constexpr Type type_named(std::string_view name, std::string_view other) {
  constexpr bool is_whole = std::is_integral_v<T>;
  constexpr double one = is_whole ? static_cast<double>(std::numeric_limits<T>::max()) : 1;
  return {name, other, sizeof(T), is_whole, one, number_of<T>};
}
constexpr std::array types{
    type_named<std::int8_t>("char", "int8"),    type_named<std::uint8_t>("uchar", "uint8"),
    type_named<std::int16_t>("short", "int16"), type_named<std::uint16_t>("ushort", "uint16"),
    type_named<std::int32_t>("int", "int32"),   type_named<std::uint32_t>("uint", "uint32"),
    type_named<std::int64_t>("int64", "long"),  type_named<std::uint64_t>("uint64", "ulong"),
    type_named<float>("float", "float32"),      type_named<double>("double", "float64")};

// What is taken of the properties, in the order of `slot_names`.
enum Slot : std::size_t { x, y, z, nx, ny, nz, red, green, blue, slots, none = slots };
constexpr std::array<std::array<std::string_view, 2>, slots> slot_names{
    {{"x"}, {"y"}, {"z"}, {"nx"}, {"ny"}, {"nz"}, {"red", "r"}, {"green", "g"}, {"blue", "b"}}};
using Values = std::array<double, slots + 1>;

struct Property {
  std::string name;
  const Type* type = nullptr;
  const Type* length = nullptr; // of a list
  std::size_t slot = none;
  bool is_corners = false;
};
struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties{};

  const Property* find(std::size_t slot) const {
    const auto found = std::ranges::find(properties, slot, &Property::slot);
    return found != properties.end() ? &*found : nullptr;
  }
};
struct Header {
  enum { unknown, text, little, big } format = unknown;
  std::vector<Element> elements;
};

// --- The header ------------------------------------------------------------------------------------------

const Type* type_of(TextLines& lines) {
  const auto found = std::ranges::find_if(
      types, [word = lines.peek()](const Type& type) { return type.name == word || type.other == word; });
  if (found == types.end()) lines.fail_at_word("a property's type (char to uint64, float or double)");
  lines.word();
  return &*found;
}

Property property_of(TextLines& lines, bool is_face, bool is_vertex) {
  Property property;
  if (lines.peek() == "list") {
    lines.word();
    property.length = type_of(lines);
    if (!property.length->is_whole)
      lines.fail("a list's length isn't of a type of whole numbers: correct it");
  }
  property.type = type_of(lines);
  property.name = lines.word();
  if (property.name.empty() || !lines.is_at_end())
    lines.fail("is no property of one type and name, nor a list of two types and a name: correct it");
  const bool is_list = property.length != nullptr;
  property.is_corners =
      is_face && is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
  if (property.is_corners && !property.type->is_whole)
    lines.fail("numbers of vertices aren't of a type of whole numbers: correct it");
  for (std::size_t slot = 0; is_vertex && !is_list && slot < slots; ++slot)
    if (std::ranges::find(slot_names[slot], property.name) != slot_names[slot].end()) property.slot = slot;
  return property;
}

void check_element(const TextLines& lines, const Element& element) {
  if (element.count == 0) return;
  if (element.name == "vertex" && !(element.find(x) && element.find(y) && element.find(z)))
    lines.fail("the header's vertices lack x, y or z: give them all");
  if (element.name == "face" && std::ranges::none_of(element.properties, &Property::is_corners))
    lines.fail("the header's faces have no list vertex_indices: give it");
}

// A line that isn't known passes: some programs write comments without saying so.
Header header_of(TextLines& lines) {
  Header header;
  if (!lines.next() || !is_word(lines.word(), "ply"))
    lines.fail("isn't a PLY file: its first line isn't ply");
  for (;;) {
    lines.need_line("a line of its header up to end_header");
    const std::string_view word = lines.word();
    if (word == "end_header") break;
    if (word == "format") {
      const std::string_view format = lines.word();
      header.format = format == "ascii"                  ? Header::text
                      : format == "binary_little_endian" ? Header::little
                      : format == "binary_big_endian"    ? Header::big
                                                         : Header::unknown;
      if (header.format == Header::unknown || lines.word() != "1.0")
        lines.fail(
            "isn't of the formats ascii 1.0, binary_little_endian 1.0 and binary_big_endian 1.0: convert it");
    } else if (word == "element") {
      Element element{std::string(lines.word())};
      const std::int64_t count = lines.whole("a number of elements");
      if (count < 0 || !lines.is_at_end()) lines.fail("is no element with a name and a number: correct it");
      if (element.name == "tristrips")
        lines.fail("has triangle strips, which aren't read: convert them to faces");
      if (std::ranges::count(header.elements, element.name, &Element::name) > 0)
        lines.fail("names an element a second time: correct it");
      element.count = static_cast<std::uint64_t>(count);
      header.elements.push_back(std::move(element));
    } else if (word == "property") {
      if (header.elements.empty()) lines.fail("is a property of no element: correct it");
      Element& element = header.elements.back();
      element.properties.push_back(property_of(lines, element.name == "face", element.name == "vertex"));
    }
  }
  if (header.format == Header::unknown) lines.fail("the header names no format: give it");
  for (const Element& element : header.elements)
    check_element(lines, element);
  return header;
}

// --- Values ----------------------------------------------------------------------------------------------

// A line an element.
class TextValues {
public:
  explicit TextValues(TextLines& lines) : lines_(lines) {}
  void begin(const Element& element, std::uint64_t number) {
    if (!lines_.next())
      lines_.fail_at_end(fmt::format("{} {} of {}", excerpt(element.name), number, element.count));
  }
  double next(const Type&) { return lines_.number("a number"); }
  void end() {
    if (!lines_.is_at_end())
      lines_.fail("has more numbers than the header's properties: correct one of them");
  }
  std::uint64_t most(const Element&) const { return lines_.bytes_left() / 2; }
  void check_room(std::uint64_t) const {}
  [[noreturn]] void fail(const std::string& message) const { lines_.fail(message); }
  std::uint64_t finish() {
    if (lines_.next()) lines_.fail("is after the last element that the header promises: correct its counts");
    return 0;
  }

private:
  TextLines& lines_;
};

class BinaryValues {
public:
  BinaryValues(std::string_view bytes, bool is_big, const std::string& name)
      : bytes_(bytes), is_swapped_(is_big != (std::endian::native == std::endian::big)), name_(name) {}
  void begin(const Element& element, std::uint64_t number) {
    element_ = &element;
    number_ = number;
  }
  double next(const Type& type) {
    check_room(type.bytes);
    const double number = type.number(bytes_.data(), is_swapped_);
    bytes_.remove_prefix(type.bytes);
    return number;
  }
  void end() {}
  std::uint64_t most(const Element& element) const {
    std::size_t least = 0;
    for (const Property& p : element.properties)
      least += (p.length != nullptr ? p.length : p.type)->bytes;
    return least == 0 ? 0 : bytes_.size() / least;
  }
  void check_room(std::uint64_t bytes) const {
    if (bytes > bytes_.size())
      fail(fmt::format("the file ends in {} {} of {}: it is cut, or its counts are wrong: complete it",
                       excerpt(element_->name), number_, element_->count));
  }
  [[noreturn]] void fail(const std::string& message) const { throw Error(ErrorCode::input, name_, message); }
  std::uint64_t finish() const { return bytes_.size(); }

private:
  std::string_view bytes_;
  bool is_swapped_;
  const std::string& name_;
  const Element* element_ = nullptr;
  std::uint64_t number_ = 0;
};

// --- Elements --------------------------------------------------------------------------------------------

template <class Source>
std::uint64_t length_of(Source& source, const Property& property) {
  const double length = source.next(*property.length);
  if (!(length >= 0 && length < 0x1p32) || length != std::floor(length))
    source.fail("a list's length isn't a whole number from 0 on: correct it");
  const auto count = static_cast<std::uint64_t>(length);
  source.check_room(count * property.type->bytes);
  return count;
}

// Calls take(values, corners) for each of the element.
template <class Source, class Take>
void read_element(Source& source, const Element& element, std::uint64_t vertices, const Take& take) {
  Values values{};
  std::vector<std::uint32_t> corners;
  if (element.properties.empty()) return; // and no line, as no byte
  for (std::uint64_t i = 0; i < element.count; ++i) {
    source.begin(element, i);
    for (const Property& property : element.properties) {
      if (property.length == nullptr) {
        values[property.slot] = source.next(*property.type);
        continue;
      }
      const std::uint64_t length = length_of(source, property);
      if (property.is_corners) corners.clear();
      for (std::uint64_t k = 0; k < length; ++k) {
        const double value = source.next(*property.type);
        if (!property.is_corners) continue;
        if (!(value >= 0 && value < static_cast<double>(vertices)) || value != std::floor(value))
          source.fail(fmt::format("face {} has vertex {} of {}, which are numbered from 0: correct it", i,
                                  value, vertices));
        corners.push_back(static_cast<std::uint32_t>(value));
      }
    }
    source.end();
    take(values, corners);
  }
}

template <class Source>
void read_vertices(Source& source, const Element& element, MeshFile& file) {
  if (element.count > no_index) source.fail("has more than 2^32 - 1 vertices: split the file");
  const auto has_one = [&](Slot a, Slot b, Slot c) {
    return element.find(a) || element.find(b) || element.find(c);
  };
  const bool has_normals = has_one(nx, ny, nz), has_colors = has_one(red, green, blue);
  const auto full_intensity = [&](Slot slot) {
    const Property* const property = element.find(slot);
    return property != nullptr ? property->type->one : 1;
  };
  const Vec3d one{full_intensity(red), full_intensity(green), full_intensity(blue)};
  const std::uint64_t count = std::min(element.count, source.most(element));
  file.positions.reserve(count);
  if (has_normals) file.normals.reserve(count);
  if (has_colors) file.colors.reserve(count);
  read_element(source, element, 0, [&](const Values& v, std::span<const std::uint32_t>) {
    file.positions.push_back({v[x], v[y], v[z]});
    if (has_normals) file.normals.push_back({v[nx], v[ny], v[nz]});
    if (has_colors)
      file.colors.push_back({static_cast<float>(v[red] / one.x), static_cast<float>(v[green] / one.y),
                             static_cast<float>(v[blue] / one.z)});
  });
}

template <class Source>
MeshFile read_elements(Source source, const Header& header) {
  MeshFile file;
  file.materials.push_back({phong_material({})});
  begin_object(file, "", 0);
  std::uint64_t vertices = 0;
  for (const Element& element : header.elements)
    if (element.name == "vertex") vertices = element.count;
  for (const Element& element : header.elements) {
    if (element.name == "vertex")
      read_vertices(source, element, file);
    else
      read_element(source, element, vertices, [&](const Values&, std::span<const std::uint32_t> corners) {
        if (element.name == "face") add_face(file, corners);
      });
  }
  file.notes.trailing_bytes = source.finish();
  file.objects[0].has_normals = !file.normals.empty();
  file.objects[0].has_colors = !file.colors.empty();
  return file;
}

} // namespace

MeshFile parse_ply(const MeshText& text) {
  TextLines lines(text.bytes, text.name, '\0', text.progress);
  const Header header = header_of(lines);
  if (header.format == Header::text) return read_elements(TextValues(lines), header);
  return read_elements(BinaryValues(text.bytes.substr(text.bytes.size() - lines.bytes_left()),
                                    header.format == Header::big, text.name),
                       header);
}

} // namespace masu
