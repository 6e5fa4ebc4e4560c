#include "libscene/spd/scenes.h"

#include "libscene/base/error.h"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <iterator>
#include <utility>

namespace masu::spd {

namespace {

constexpr std::size_t block = 1 << 16; // bytes written at once

// Scenes are about one unit wide: smaller magnitudes are rounding errors of an exact zero.
constexpr double smallest = 1e-12;

[[noreturn]] void fail(const NffWriter& nff) {
  throw Error(ErrorCode::output, nff.place,
              fmt::format("can't be written ({}): choose another file", std::strerror(errno)));
}

void flush(NffWriter& nff) {
  errno = 0;
  if (std::fwrite(nff.text.data(), 1, nff.text.size(), nff.out) != nff.text.size()) fail(nff);
  nff.text.clear();
  if (nff.progress) nff.progress(nff.objects);
}

void put_line(NffWriter& nff, std::string_view keyword, std::initializer_list<double> numbers) {
  nff.text += keyword;
  const char* separator = keyword.empty() ? "" : " ";
  for (const double x : numbers)
    fmt::format_to(std::back_inserter(nff.text), "{}{:.6g}", std::exchange(separator, " "),
                   std::abs(x) < smallest ? 0 : x);
  nff.text += '\n';
  if (nff.text.size() >= block) flush(nff);
}

} // namespace

void put_view(NffWriter& nff, const View& view) {
  const auto& [from, at, up, hither, background, angle, resolution] = view;
  const auto pixels = static_cast<double>(resolution);
  put_line(nff, "b", {background.x, background.y, background.z});
  put_line(nff, "v", {});
  put_line(nff, "from", {from.x, from.y, from.z});
  put_line(nff, "at", {at.x, at.y, at.z});
  put_line(nff, "up", {up.x, up.y, up.z});
  put_line(nff, "angle", {angle});
  put_line(nff, "hither", {hither});
  put_line(nff, "resolution", {pixels, pixels});
}

void put_lights(NffWriter& nff, std::initializer_list<Vec3d> positions) {
  for (const Vec3d& position : positions)
    put_line(nff, "l", {position.x, position.y, position.z});
}

void put_material(NffWriter& nff, const Material& m) {
  put_line(nff, "f",
           {m.red, m.green, m.blue, m.diffuse, m.specular, m.shine, m.transmittance, m.index_of_refraction});
}

void put_sphere(NffWriter& nff, const Vec3d& center, double radius) {
  ++nff.objects;
  put_line(nff, "s", {center.x, center.y, center.z, radius});
}

void put_cone(NffWriter& nff, const Vec3d& base, double base_radius, const Vec3d& apex, double apex_radius) {
  ++nff.objects;
  put_line(nff, "c", {base.x, base.y, base.z, base_radius, apex.x, apex.y, apex.z, apex_radius});
}

void put_polygon(NffWriter& nff, std::span<const Vec3d> corners) {
  ++nff.objects;
  put_line(nff, "p", {static_cast<double>(corners.size())});
  for (const Vec3d& corner : corners)
    put_line(nff, "", {corner.x, corner.y, corner.z});
}

void put_polygon(NffWriter& nff, std::initializer_list<Vec3d> corners) {
  put_polygon(nff, std::span(corners.begin(), corners.size()));
}

void put_triangle(NffWriter& nff, const Corner& a, const Corner& b, const Corner& c) {
  ++nff.objects;
  put_line(nff, "pp", {3});
  for (const auto& [p, n] : {a, b, c})
    put_line(nff, "", {p.x, p.y, p.z, n.x, n.y, n.z});
}

void finish(NffWriter& nff) {
  flush(nff);
  if (std::fflush(nff.out) != 0) fail(nff);
}

} // namespace masu::spd
