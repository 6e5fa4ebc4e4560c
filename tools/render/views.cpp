#include "tools/render/views.h"

#include "libscene/base/error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <unordered_set>

namespace masu {
namespace {

using ViewJson = nlohmann::json;

constexpr std::int32_t largest_side = 65536; // pixels

// --- A line of a list -------------------------------------------------------------------------------------

struct Line {
  std::string place; // path:line
  ViewJson json;

  [[noreturn]] void fail(const std::string& message) const { throw Error(ErrorCode::input, place, message); }

  // What the line leaves out stays.
  void read(const char* key, double& number) const {
    if (!json.contains(key)) return;
    if (!json[key].is_number()) fail(fmt::format("{} isn't a number", key));
    number = json[key].get<double>();
  }

  void read(const char* key, Vec3d& vector) const {
    if (!json.contains(key)) return;
    const ViewJson& value = json[key];
    if (!value.is_array() || value.size() != 3 || !std::ranges::all_of(value, &ViewJson::is_number))
      fail(fmt::format("{} isn't [x, y, z]", key));
    vector = {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
  }

  void read_size(Camera& camera) const {
    if (!json.contains("size")) return;
    const ViewJson& value = json["size"];
    const auto is_side = [](const ViewJson& side) {
      return side.is_number_integer() && side >= 1 && side <= largest_side;
    };
    if (!value.is_array() || value.size() != 2 || !std::ranges::all_of(value, is_side))
      fail(fmt::format("size isn't [width, height] with 1 to {} pixels each", largest_side));
    camera.width = value[0].get<std::int32_t>();
    camera.height = value[1].get<std::int32_t>();
  }

  // Empty where there is none.
  std::string name() const {
    if (!json.contains("name")) return {};
    if (!json["name"].is_string()) fail("name isn't a string");
    auto name = json["name"].get<std::string>();
    if (name.empty()) fail("name is empty: leave it out, or give a part of a file name");
    if (name == "." || name == "..")
      fail(fmt::format("name '{}' is a folder: give a part of a file name", name));
    const auto is_unsafe = [](char c) {
      return c == '/' || static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    };
    if (std::ranges::any_of(name, is_unsafe))
      fail("name has a / or a control character: give a part of a file name");
    return name;
  }
};

Line parsed(const std::string& text, std::string place) {
  Line line{std::move(place), ViewJson::parse(text, nullptr, false)};
  if (!line.json.is_object()) line.fail("isn't a JSON object: give {\"from\": [x, y, z], …} in one line");
  constexpr std::array known{"name", "from", "at", "up", "angle", "size"};
  for (const auto& [key, value] : line.json.items()) {
    if (std::ranges::find(known, key) == known.end())
      line.fail(fmt::format("'{}' isn't one of {}", key, fmt::join(known, ", ")));
  }
  return line;
}

// View `index` of `count`, as wide as the largest index.
std::string index_name(std::size_t index, std::size_t count) {
  return fmt::format("{:0{}}", index, fmt::formatted_size("{}", std::max<std::size_t>(count, 1) - 1));
}

} // namespace

std::optional<CameraFault> fault_of(const Camera& camera, const Boxd& places) {
  constexpr double shortest = 1e-100, nearly_parallel = 1e-12;
  constexpr Boxd finite{{-1e100, -1e100, -1e100}, {1e100, 1e100, 1e100}};
  for (const auto& [part, v, within] :
       {std::tuple("from", camera.from, places), {"at", camera.at, places}, {"up", camera.up, finite}}) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!(v[axis] >= within.min[axis] && v[axis] <= within.max[axis])) // not NaN either
        return CameraFault{part, fmt::format("has a coordinate that isn't from {:g} to {:g}",
                                             within.min[axis], within.max[axis])};
    }
  }
  if (!(camera.angle > 0 && camera.angle < 180))
    return CameraFault{"angle",
                       fmt::format("is {}: give more than 0 and less than 180 degrees", camera.angle)};
  const Vec3d sight = camera.at - camera.from;
  if (!(largest_magnitude(sight) > shortest)) return CameraFault{"at", "is the point that the view is from"};
  if (!(largest_magnitude(camera.up) > shortest)) return CameraFault{"up", "has no length"};
  if (!(largest_magnitude(cross(normalized(sight), normalized(camera.up))) > nearly_parallel))
    return CameraFault{"up", "is parallel to the line of sight: turn it"};
  return {};
}

Boxd camera_places(const SceneFile& scene) {
  const double reach = scene.is_float64() ? 1e100 : max_float32_reach; // as of scene files
  const Vec3d& o = scene.origin();
  return {{o.x - reach, o.y - reach, o.z - reach}, {o.x + reach, o.y + reach, o.z + reach}};
}

RayWindow cropped(const char* option, const std::string& text, const Camera& camera, Sampling sampling) {
  std::array<std::int32_t, 4> c{};
  if (!read_numbers(text, ',', c) || c[0] < 0 || c[1] < 0 || c[2] < 1 || c[3] < 1)
    throw Error(ErrorCode::usage, option, fmt::format("'{}' isn't X,Y,W,H with at least one pixel", text));
  const auto [x, y, width, height] = c;
  if (x >= camera.width || y >= camera.height || width > camera.width - x || height > camera.height - y)
    throw Error(ErrorCode::usage, option,
                fmt::format("{},{},{},{} isn't within a picture of {}x{}", x, y, width, height, camera.width,
                            camera.height));
  const std::int32_t more = sampling == Sampling::corners ? 1 : 0;
  return {x, y, width + more, height + more};
}

std::vector<View> parse_views(const std::string& text, const std::string& path, const Camera& base,
                              const Boxd& places) {
  std::istringstream in(text);
  in.exceptions(std::ios::badbit); // else what memory doesn't suffice for would be taken for the end
  std::vector<View> views;
  std::vector<std::string> lines;
  std::string content;
  for (std::size_t number = 1; std::getline(in, content); ++number) {
    if (content.find_first_not_of(" \t\r") == std::string::npos) continue;
    const Line line = parsed(content, fmt::format("{}:{}", path, number));
    Camera camera = base;
    line.read("from", camera.from);
    line.read("at", camera.at);
    line.read("up", camera.up);
    line.read("angle", camera.angle);
    line.read_size(camera);
    if (const auto fault = fault_of(camera, places))
      line.fail(fmt::format("{} {}", fault->part, fault->what));
    views.push_back({line.name(), camera});
    lines.push_back(line.place);
  }
  if (views.empty()) throw Error(ErrorCode::input, path, "has no view: give a JSON object per line");
  std::unordered_map<std::string, std::size_t> known; // names
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (views[i].name.empty()) views[i].name = index_name(i, views.size());
    const auto [first, is_new] = known.emplace(views[i].name, i);
    if (!is_new)
      throw Error(ErrorCode::input, lines[i],
                  fmt::format("name '{}' is that of {}: give each view a name of its own", views[i].name,
                              lines[first->second]));
  }
  return views;
}

std::vector<View> turntable(const Camera& camera, int count) {
  const Vec3d axis = normalized(camera.up);
  const Vec3d arm = camera.from - camera.at;
  const Vec3d along = axis * dot(axis, arm);
  std::vector<View> views;
  for (int i = 0; i < count; ++i) {
    View view{index_name(static_cast<std::size_t>(i), static_cast<std::size_t>(count)), camera};
    const double turn = 2 * std::numbers::pi * i / count;
    if (i > 0)
      view.camera.from =
          camera.at + along + (arm - along) * std::cos(turn) + cross(axis, arm) * std::sin(turn);
    views.push_back(std::move(view));
  }
  return views;
}

std::vector<std::string> file_names(const std::string& pattern, const std::vector<View>& views) {
  if (pattern.empty()) return std::vector<std::string>(views.size());
  std::vector<std::string> names;
  std::unordered_set<std::string> known;
  for (std::size_t i = 0; i < views.size(); ++i) {
    std::string name = pattern;
    const auto replace = [&](std::string_view placeholder, const std::string& by) {
      for (std::size_t at = 0; (at = name.find(placeholder, at)) != std::string::npos; at += by.size())
        name.replace(at, placeholder.size(), by);
    };
    // The name last: it may itself contain what looks like a placeholder.
    replace("{index}", index_name(i, views.size()));
    replace("{name}", views[i].name);
    if (!known.insert(name).second)
      throw Error(ErrorCode::usage, pattern,
                  fmt::format("would be written by each of {} views: put {{index}} or {{name}} into it",
                              views.size()));
    names.push_back(std::move(name));
  }
  return names;
}

} // namespace masu
