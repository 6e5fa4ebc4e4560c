#include "libscene/nff/nff_piece.h"

#include "libscene/mesh/triangulate.h"

namespace masu::nff {
namespace {

constexpr const char* syntax_view =
    "v from x y z at x y z up x y z angle degrees hither d resolution width height";
constexpr const char* syntax_background = "b r g b";
constexpr const char* syntax_light = "l x y z [r g b]";
constexpr const char* syntax_fill = "f r g b Kd Ks shine T ior";
constexpr const char* syntax_sphere = "s x y z radius";
constexpr const char* syntax_cone = "c base.x y z radius apex.x y z radius";
constexpr const char* syntax_polygon = "p count, then x y z a vertex";
constexpr const char* syntax_patch = "pp count, then x y z nx ny nz a vertex";

// The state of parsing a piece. Vectors are members to reuse their memory.
struct Reader {
  Lexer lexer;
  Piece piece;
  std::optional<std::uint32_t> material; // the current fill's index in the piece, once an object has used it
  std::vector<Vec3d> vertices, normals;
  Triangulation triangulation;
  const char* view_position = nullptr; // of the last one
};

// Braced initialisers are evaluated from left to right.
Vec3d read_coordinates(Lexer& lexer, const char* syntax) {
  return Vec3d{lexer.coordinate(syntax), lexer.coordinate(syntax), lexer.coordinate(syntax)};
}

Vec3f read_color(Lexer& lexer, const char* syntax) {
  return Vec3f{lexer.factor(syntax), lexer.factor(syntax), lexer.factor(syntax)};
}

float read_unsigned_factor(Lexer& lexer, const char* syntax) {
  const char* const position = lexer.next();
  const float value = lexer.factor(syntax);
  if (value < 0) lexer.refuse(position, " is negative: Kd, Ks, shine and T must be 0 or more");
  return value;
}

Vec3d read_up(Lexer& lexer) {
  const char* const position = lexer.next();
  const Vec3d up = read_coordinates(lexer, syntax_view);
  if (largest_magnitude(up) == 0)
    fail(lexer.text(), position, "the view's up has no length: give it a direction");
  return up;
}

double read_angle(Lexer& lexer) {
  const char* const position = lexer.next();
  const double angle = lexer.number(syntax_view);
  if (!(angle > 0 && angle < 180))
    lexer.refuse(position, " is no view angle: give degrees between 0 and 180");
  return angle;
}

Vec3i read_resolution(Lexer& lexer) {
  constexpr std::uint64_t max = 65536;
  return Vec3i{static_cast<std::int32_t>(lexer.whole(1, max, syntax_view)),
               static_cast<std::int32_t>(lexer.whole(1, max, syntax_view)), 0};
}

void read_view(Reader& reader, const char* position) {
  Lexer& lexer = reader.lexer;
  View view;
  for (;;) {
    Lexer ahead = lexer;
    const std::string_view word = ahead.word();
    if (word == "from")
      view.from = read_coordinates(ahead, syntax_view);
    else if (word == "at")
      view.look_at = read_coordinates(ahead, syntax_view);
    else if (word == "up")
      view.up = read_up(ahead);
    else if (word == "angle")
      view.angle = read_angle(ahead);
    else if (word == "hither")
      view.hither = ahead.coordinate(syntax_view);
    else if (word == "resolution")
      view.resolution = read_resolution(ahead);
    else
      break;
    lexer = ahead;
  }
  if (view.from && view.look_at && *view.from == *view.look_at)
    fail(lexer.text(), position, "the view's from and at are the same point: move one of them");
  reader.piece.view = view;
  reader.view_position = position;
}

void read_light(Reader& reader) {
  Lexer& lexer = reader.lexer;
  WrittenLight light{};
  light.position = read_coordinates(lexer, syntax_light);
  if (lexer.next_is_number()) light.color = cast<double>(read_color(lexer, syntax_light));
  reader.piece.lights.push_back(light);
}

void read_fill(Reader& reader) {
  Lexer& lexer = reader.lexer;
  const auto factor = [&] { return read_unsigned_factor(lexer, syntax_fill); };
  Material fill{read_color(lexer, syntax_fill), factor(), factor(), factor(), factor(),
                lexer.factor(syntax_fill)};
  // Files often give 0 for opaque fills.
  if (transmits(fill) && fill.refraction_index <= 0) fill.refraction_index = 1;
  reader.piece.last_material = fill;
  reader.material.reset();
}

// The index of the current fill, which is added to the table when first used.
std::uint32_t material_in_use(Reader& reader) {
  Piece& piece = reader.piece;
  if (!reader.material) {
    if (piece.last_material)
      reader.material = piece.materials.index_of(*piece.last_material) + 1;
    else
      reader.material = Piece::inherited;
  }
  if (*reader.material == Piece::inherited) piece.uses_inherited = true;
  return *reader.material;
}

void read_sphere(Reader& reader) {
  Piece& piece = reader.piece;
  const auto object = static_cast<std::uint32_t>(piece.objects.sum());
  const Vec3d center = read_coordinates(reader.lexer, syntax_sphere);
  const double radius = reader.lexer.coordinate(syntax_sphere);
  ++piece.objects.spheres;
  if (radius == 0) {
    ++piece.warnings.degenerate_spheres;
    return;
  }
  piece.spheres.push_back({center, radius});
  piece.sphere_surfaces.push_back({object, material_in_use(reader)});
}

void read_cone(Reader& reader) {
  Piece& piece = reader.piece;
  Lexer& lexer = reader.lexer;
  const auto object = static_cast<std::uint32_t>(piece.objects.sum());
  Cone<double> cone{};
  cone.base = read_coordinates(lexer, syntax_cone);
  cone.base_radius = lexer.coordinate(syntax_cone);
  cone.apex = read_coordinates(lexer, syntax_cone);
  const char* const position = lexer.next();
  cone.apex_radius = lexer.coordinate(syntax_cone);
  if ((cone.base_radius < 0 && cone.apex_radius > 0) || (cone.base_radius > 0 && cone.apex_radius < 0))
    fail(lexer.text(), position,
         "the cone's radii have opposite signs: make both positive, or both negative");
  ++piece.objects.cones;
  if (cone.base == cone.apex || (cone.base_radius == 0 && cone.apex_radius == 0)) {
    ++piece.warnings.degenerate_cones;
    return;
  }
  piece.cones.push_back(cone);
  piece.cone_surfaces.push_back({object, material_in_use(reader)});
}

// Normals needn't have unit length: they are kept as written unless their square may be out of float32's
// range.
Vec3d read_normal(Lexer& lexer) {
  const char* const position = lexer.next();
  const Vec3d normal = read_coordinates(lexer, syntax_patch);
  const double size = largest_magnitude(normal);
  if (size == 0) fail(lexer.text(), position, "the patch's normal has no length: give it a direction");
  if (size > 1e-12 && size < 1e12) return normal;
  return {normal.x / size, normal.y / size, normal.z / size}; // 1 / size may overflow
}

std::uint64_t read_vertex_count(Lexer& lexer, std::uint64_t numbers_each, const char* syntax) {
  const char* const position = lexer.next();
  const std::uint64_t count = lexer.whole(3, 0xffffffffU, syntax);
  // A number takes two characters or more: a blank and a digit.
  const auto left = static_cast<std::uint64_t>(lexer.text().end() - position) + lexer.text().bytes_after;
  if (count > left / (2 * numbers_each))
    lexer.refuse(position, " vertices are more than the rest of the text can hold: correct the count, or "
                           "complete the file");
  return count;
}

void add_triangles(Reader& reader, std::uint32_t object, bool is_patch) {
  Piece& piece = reader.piece;
  const std::uint64_t material = material_in_use(reader);
  for (const auto& [a, b, c] : reader.triangulation.triangles) {
    std::uint64_t normals = no_normals;
    if (is_patch) {
      normals = piece.normals.size();
      piece.normals.push_back({reader.normals[a], reader.normals[b], reader.normals[c]});
    }
    piece.triangles.push_back(
        {reader.vertices[a], object, reader.vertices[b], material, reader.vertices[c], normals});
  }
}

// `p` and `pp`.
void read_polygon(Reader& reader, bool is_patch) {
  Piece& piece = reader.piece;
  Lexer& lexer = reader.lexer;
  const char* const syntax = is_patch ? syntax_patch : syntax_polygon;
  const auto object = static_cast<std::uint32_t>(piece.objects.sum());
  const std::uint64_t count = read_vertex_count(lexer, is_patch ? 6 : 3, syntax);
  reader.vertices.clear();
  reader.normals.clear();
  for (std::uint64_t i = 0; i < count; ++i) {
    reader.vertices.push_back(read_coordinates(lexer, syntax));
    if (is_patch) reader.normals.push_back(read_normal(lexer));
  }
  ++(is_patch ? piece.objects.patches : piece.objects.polygons);
  triangulate(reader.vertices, reader.triangulation);
  if (reader.triangulation.triangles.empty()) {
    ++piece.warnings.degenerate_polygons;
    return;
  }
  piece.warnings.degenerate_triangles += reader.triangulation.slivers;
  if (reader.triangulation.crosses_itself) ++piece.warnings.self_crossing_polygons;
  add_triangles(reader, object, is_patch);
}

void read_entity(Reader& reader) {
  const char* const position = reader.lexer.next();
  const std::string_view word = reader.lexer.word();
  if (word == "p") return read_polygon(reader, false);
  if (word == "s") return read_sphere(reader);
  if (word == "pp") return read_polygon(reader, true);
  if (word == "c") return read_cone(reader);
  if (word == "f") return read_fill(reader);
  if (word == "l") return read_light(reader);
  if (word == "v") return read_view(reader, position);
  if (word == "b") {
    reader.piece.background = read_color(reader.lexer, syntax_background);
    return;
  }
  if (is_number_start(*position))
    reader.lexer.refuse(position, " is one number too many: start an entity with v b l f c s p or pp");
  reader.lexer.refuse(position, " is no NFF entity: use v b l f c s p or pp, and # for comments");
}

} // namespace

Piece parse_piece(const Text& text, const char* to) {
  Reader reader{Lexer(text, text.begin()), {}, {}, {}, {}, {}};
  while (reader.lexer.next() < to) {
    read_entity(reader);
    reader.piece.holds_entities = true;
  }
  if (reader.piece.view) reader.piece.view->place = place_of(text, reader.view_position);
  return std::move(reader.piece);
}

} // namespace masu::nff
