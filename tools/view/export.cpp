#include "libgrid/statistics/cells.h"
#include "libscene/base/error.h"
#include "libscene/file/output_file.h"
#include "page_files.h"
#include "tools/view/viewer.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <numeric>
#include <string_view>

namespace masu {
namespace {

constexpr std::size_t most_slice_cells = 10000;
constexpr std::array<std::int32_t, 4> exported_divisions{8, 16, 32, 64};
constexpr std::array pixel_shares{1, 3, 5}; // sixths of a picture's side: where walks are picked
constexpr double points_per_side = 12;      // of a single slice, between which rays are walked

constexpr auto is_gone = [] { return false; };

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = i; k < i + 3; ++k)
      group = group << 8 | (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : digits[group >> (18 - 6 * k) & 63];
  }
  return text;
}

// Smaller by a fifth than deflated() makes it, which is for pictures that somebody waits for.
std::string deflated_text(std::string_view text) {
  uLongf size = compressBound(text.size());
  std::string bytes(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(text.data()),
                text.size(), Z_BEST_COMPRESSION) != Z_OK)
    throw std::bad_alloc();
  return bytes.substr(2, size - 6); // without the head and the sum of zlib's format
}

// All pictures of a view: {channel: [one a grid]}, of channels that don't depend on the grid the first one's.
Json channels_json(const Viewer& viewer, PictureRequest request) {
  Json all;
  for (const auto& [name, channel] : picture_channels()) {
    if (channel.is_cut) continue; // of any plane
    request.channel = channel;
    request.frame.sampling = request.channel.is_shaded() ? Sampling::corners : Sampling::centers;
    for (request.grid = 0; request.grid < viewer.grids(); ++request.grid) {
      const Picture picture = viewer.picture(request, is_gone);
      Json& json = all[name].emplace_back(Json{{"timing", timing_of(picture)}});
      if (request.grid == 0 || depends_on_grid(request.channel))
        json[has_values(request.channel) ? "values" : "jpeg"] = base64(picture.bytes);
    }
  }
  return all;
}

// --- Walks ------------------------------------------------------------------------------------------------

// A ray's walk through each grid: {hit, grids: [{cells, tests, ended, steps: [[place, tests, whether one of
// them was kept], …]}]}; a place is a cell's voxels, [first, end], or {node, box}.
Json walks_json(const Viewer& viewer, const std::vector<std::size_t>& grids, const Vec3d& origin,
                const Vec3d& direction, Precision precision) {
  Json walks{{"hit", nullptr}, {"grids", Json::array()}};
  const WalkRequest request{.tracing = {precision}, .ray = unbounded_ray(origin, direction)};
  for (const std::size_t grid : grids) {
    const Json walk = viewer.walk(grid, request, is_gone);
    const Json& ray = walk["rays"][0];
    Json steps = Json::array();
    for (const Json& step : ray["steps"]) {
      const Json &tests = step["tests"], &voxels = step["voxels"];
      const bool kept = std::ranges::any_of(tests, [](const Json& test) { return test["kept"].get<bool>(); });
      steps.push_back({voxels.is_null() ? Json{{"node", step["node"]}, {"box", step["box"]}}
                                        : Json::array({voxels["first"], voxels["end"]}),
                       tests.size(), kept});
    }
    walks["grids"].push_back({{"cells", ray["cells"]},
                              {"tests", ray["tests"]},
                              {"ended", walk["ended"][0]},
                              {"steps", std::move(steps)}});
    if (const Json& hit = ray["hit"]; !hit.is_null()) // every grid's
      walks["hit"] = {{"t", hit["t"]}, {"primitive", hit["primitive"]}, {"object", hit["object"]}};
  }
  return walks;
}

// Rays in the plane of a slice, from each point on its sides to those of the other sides; and those of `rays`
// that lie there, which are taken away from them.
Json plane_json(const Viewer& viewer, const std::vector<std::size_t>& grids, const Json& slice,
                std::size_t per_side, std::vector<Ray<double>>& rays) {
  const auto axis = slice["axis"].get<int>();
  const auto position = slice["position"].get<double>();
  std::vector<Vec3d> points;
  for (int side = 0; side < 4; ++side) {
    for (std::size_t i = 0; i < per_side; ++i) {
      const double along = (static_cast<double>(i) + 0.4871) / static_cast<double>(per_side); // on no face
      const std::array<double, 2> shares =
          side % 2 == 0 ? std::array{side == 0 ? 0.0 : 1.0, along} : std::array{along, side == 1 ? 0.0 : 1.0};
      Vec3d point;
      point.set(axis, position);
      for (std::size_t k = 0; k < 2; ++k)
        point.set(slice["axes"][k].get<int>(),
                  slice["min"][k].get<double>() +
                      shares[k] * slice["voxels"][k].get<double>() * slice["step"][k].get<double>());
      points.push_back(point);
    }
  }
  std::vector<std::array<std::size_t, 2>> ends;
  for (std::size_t from = 0; from < points.size(); ++from)
    for (std::size_t to = 0; to < points.size(); ++to)
      if (from / per_side != to / per_side) ends.push_back({from, to});
  const double near =
      0.001 * (slice["range"][1].get<double>() - slice["range"][0].get<double>()); // of rounded numbers
  std::erase_if(rays, [&](Ray<double> ray) {
    if (ray.direction[axis] != 0 || !(std::abs(ray.origin[axis] - position) <= near)) return false;
    ray.origin.set(axis, position);
    ends.push_back({points.size(), points.size() + 1});
    points.push_back(ray.origin);
    points.push_back(ray.origin + ray.direction);
    return true;
  });
  Json json{{"axis", axis}, {"position", position}, {"points", points}, {"walks", Json::array()}};
  for (const auto& [from, to] : ends) {
    Json walk = walks_json(viewer, grids, points[from], points[to] - points[from], viewer.precision());
    walk["ends"] = {from, to};
    json["walks"].push_back(std::move(walk));
  }
  return json;
}

std::int32_t picked_pixel(int share, std::int32_t side) {
  return static_cast<std::int32_t>(std::int64_t{share} * side / 6);
}

Json view_json(const Viewer& viewer, const std::vector<std::size_t>& grids, const Camera& camera) {
  PictureRequest request{.frame = {.camera = camera}, .quality = {85, true}};
  Json json{{"camera", camera_json(camera)}, {"channels", channels_json(viewer, request)}};
  for (request.grid = 0; request.grid < viewer.grids(); ++request.grid)
    json["counts"].push_back(viewer.counts(request, is_gone));
  for (const int row : pixel_shares) {
    for (const int column : pixel_shares) {
      const auto [ray, precision] =
          viewer.camera_ray(camera, picked_pixel(column, camera.width), picked_pixel(row, camera.height));
      Json walk = walks_json(viewer, grids, ray.origin, ray.direction, precision);
      walk.update({{"origin", ray.origin}, {"direction", ray.direction}});
      json["walks"].push_back(std::move(walk));
    }
  }
  return json;
}

Json data_of(const Viewer& viewer, const ExportSettings& settings,
             const std::function<void(double)>& progress) {
  Camera camera = viewer.scene().camera();
  camera.width = settings.width;
  camera.height = settings.height;
  const std::vector<SharePlane>& planes = settings.slices;
  const auto most_boxes = static_cast<std::size_t>(settings.most_boxes);
  const auto per_side = static_cast<std::size_t>(
      std::max(1.0, std::floor(points_per_side / std::sqrt(static_cast<double>(planes.size())))));
  Json data{{"scene", viewer.description()},
            {"size", {settings.width, settings.height}},
            {"points_per_side", per_side},
            {"opens_with", settings.opens_with}};
  data["scene"]["divisions"] = exported_divisions;
  // Indices of Viewer: the grids that were given, and some divisions, which have no pictures.
  std::vector<std::size_t> grids(viewer.grids());
  std::iota(grids.begin(), grids.end(), std::size_t{0});
  for (const std::int32_t division : exported_divisions)
    grids.push_back(viewer.grids() +
                    static_cast<std::size_t>(std::ranges::find(divisions, division) - divisions.begin()));
  for (const std::size_t grid : grids) {
    data["statistics"].push_back(viewer.statistics(grid, is_gone));
    const ViewedGrid& viewed = viewer.grid(grid, is_gone);
    const GridLayout finest = finest_layout(viewed.file); // in which voxels lie
    data["layouts"].push_back({{"min", finest.space.min}, {"step", voxel_size(finest)}});
    Json slices = Json::array();
    for (std::size_t i = 0; i < planes.size(); ++i) {
      Json slice = viewer.slice(grid, planes[i], most_slice_cells, is_gone);
      if (grid > 0 && slice["outline"] == data["slices"][0][i]["outline"])
        slice.erase("outline"); // the first one's
      slices.push_back(std::move(slice));
    }
    data["slices"].push_back(std::move(slices));
    Json boxes = Json::array({viewer.boxes(grid, {}, most_boxes, is_gone)}); // of any depth, then of each
    for (std::int32_t depth = 0; depth <= viewed.greatest_depth; ++depth)
      boxes.push_back(viewer.boxes(grid, depth, most_boxes, is_gone));
    data["boxes"].push_back(std::move(boxes));
  }
  std::vector<Ray<double>> rays = settings.rays;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    Json plane = plane_json(viewer, grids, data["slices"][0][i], per_side, rays);
    plane["share"] = planes[i].share;
    data["planes"].push_back(std::move(plane));
  }
  if (!rays.empty()) throw Error(ErrorCode::usage, "--rays", "has one that lies in no slice");
  for (const std::int32_t side : {camera.width, camera.height}) {
    Json& pixels = data["pixels"].emplace_back();
    for (const int share : pixel_shares)
      pixels.push_back(picked_pixel(share, side));
  }
  const std::vector<View> views = turntable(camera, settings.views);
  for (std::size_t i = 0; i < views.size(); ++i) {
    data["views"].push_back(view_json(viewer, grids, views[i].camera));
    progress(static_cast<double>(i + 1) / static_cast<double>(views.size()));
  }
  data.update(provenance());
  return data;
}

// Replaces what stands from `begin` to `end`, both included.
void replace(std::string& text, std::string_view begin, std::string_view end, const std::string& by) {
  const std::size_t first = text.find(begin), last = text.find(end, first);
  if (first == std::string::npos || last == std::string::npos)
    throw Error(ErrorCode::output, "page", fmt::format("has no {}", begin));
  text.replace(first, last + end.size() - first, by);
}

} // namespace

void export_page(const Viewer& viewer, const ExportSettings& settings,
                 const std::function<void(double)>& progress) {
  const std::string data = json_text(data_of(viewer, settings, progress), -1);
  std::string scripts = fmt::format("<script>const EXPORTED = '{}';</script>\n", base64(deflated_text(data)));
  std::string page(page_file("page.html"));
  for (const auto& [name, text] : page_files)
    if (name.ends_with(".js")) scripts += fmt::format("<script>\n{}</script>\n", text);
  replace(page, "<script defer", "</script>\n</head>", "</head>");
  // Nothing is loaded from anywhere.
  replace(
      page, "<meta charset", ">",
      "<meta charset=\"utf-8\">\n<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
      "img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'\">");
  replace(page, "<link rel=\"stylesheet\"", ">", fmt::format("<style>\n{}</style>", page_file("page.css")));
  replace(page, "</body>", "</body>", scripts + "</body>");
  write_text_file(settings.path, page);
}

} // namespace masu
