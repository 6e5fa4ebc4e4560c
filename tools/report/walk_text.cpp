#include "tools/report/walk_text.h"

#include "tools/common/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace masu {
namespace {

Json finite(double t) {
  return std::isfinite(t) ? Json(t) : Json();
}

bool hits(const WalkRay& ray) {
  return ray.primitive != no_primitive;
}
Vec3d position(const WalkRay& ray) {
  return ray.origin + ray.direction * static_cast<double>(ray.t);
}

bool is_grid(StructureForm form) {
  return form == StructureForm::uniform || form == StructureForm::merged;
}

Json json_of(const WalkStep& step, StructureForm form) {
  Json tests = Json::array();
  for (const WalkTest& test : step.tests)
    tests.push_back({{"primitive", test.primitive}, {"t", finite(test.t)}, {"kept", test.kept}});
  const Json voxels = is_grid(form) ? Json{{"first", step.voxels.first}, {"end", step.voxels.end}} : Json();
  const WalkNode& node = step.node;
  const Json visited = form == StructureForm::hierarchy ? Json{{"index", node.index},
                                                               {"depth", node.depth},
                                                               {"boxes_met", node.met},
                                                               {"boxes_missed", node.missed},
                                                               {"boxes_beyond", node.beyond}}
                                                        : Json();
  return {{"voxels", voxels},          {"node", visited},
          {"box", step.box},           {"enter", finite(step.enter)},
          {"exit", finite(step.exit)}, {"references", step.references},
          {"tests", std::move(tests)}};
}

Json json_of(const WalkRay& ray, StructureForm form) {
  Json steps = Json::array();
  for (const WalkStep& step : ray.steps)
    steps.push_back(json_of(step, form));
  const Json hit = hits(ray) ? Json{{"t", ray.t},
                                    {"primitive", ray.primitive},
                                    {"object", ray.object},
                                    {"position", position(ray)}}
                             : Json();
  return {{"kind", name_of(ray.kind)},
          {"parent", ray.parent < 0 ? Json() : Json(ray.parent)},
          {"origin", ray.origin},
          {"direction", ray.direction},
          {"t_min", ray.t_min},
          {"t_max", finite(ray.t_max)},
          {"hit", hit},
          {"cells", ray.cells},
          {"tests", ray.tests},
          {"end", name_of(ray.end)},
          {"steps", std::move(steps)}};
}

// --- Tables -----------------------------------------------------------------------------------------------

std::string text_of(const Vec3d& v) {
  return fmt::format("{:.6g} {:.6g} {:.6g}", v.x, v.y, v.z);
}
std::string counted(std::uint64_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

// 12 or 12-15 along each axis.
std::string text_of(const VoxelBox& box) {
  std::string text;
  for (int axis = 0; axis < 3; ++axis) {
    const std::int32_t first = box.first[axis], last = box.end[axis] - 1;
    if (axis > 0) text += ' ';
    text += first == last ? fmt::format("{}", first) : fmt::format("{}-{}", first, last);
  }
  return text;
}

std::string outcome(const WalkTest& test) {
  if (!std::isfinite(test.t)) return "miss";
  return test.kept ? fmt::format("{:<8.7g} kept", test.t) : fmt::format("{:.7g}", test.t);
}

// A cell's voxels, or a node and what became of its boxes.
std::string place_of(const WalkStep& step, StructureForm form) {
  if (is_grid(form)) return text_of(step.voxels);
  if (form == StructureForm::none) return "everything";
  const WalkNode& node = step.node;
  return fmt::format("{:<6} {:>5} {:>4} {:>6} {:>6}", node.index, node.depth, node.met, node.missed,
                     node.beyond);
}

void append(std::string& text, const WalkRay& ray, std::size_t index, StructureForm form) {
  auto out = std::back_inserter(text);
  fmt::format_to(out, "ray {}: {}{}\n", index, name_of(ray.kind),
                 ray.parent < 0 ? "" : fmt::format(", spawned by ray {}", ray.parent));
  fmt::format_to(out, "  origin {}   direction {}\n", text_of(ray.origin), text_of(ray.direction));
  if (ray.t_min > 0 || std::isfinite(ray.t_max))
    fmt::format_to(out, "  t_min {:.7g}   t_max {:.7g}\n", ray.t_min, ray.t_max);
  const bool is_hierarchy = form == StructureForm::hierarchy;
  const std::string title = is_hierarchy ? "node   depth  met missed beyond" : "voxels x y z";
  std::size_t widest = title.size();
  for (const WalkStep& step : ray.steps)
    widest = std::max(widest, place_of(step, form).size());
  if (!ray.steps.empty())
    fmt::format_to(out, "{:>5} {:<{}} {:>9} {:>9}  tests: primitive, t\n", is_hierarchy ? "step" : "cell",
                   title, widest, "t enter", "t exit");
  for (std::size_t i = 0; i < ray.steps.size(); ++i) {
    const WalkStep& step = ray.steps[i];
    const std::size_t line = text.size();
    fmt::format_to(out, "{:>5} {:<{}} {:>9.6g} {:>9.6g}  ",
                   form != StructureForm::none ? fmt::format("{}", i) : "-", place_of(step, form), widest,
                   step.enter, step.exit);
    const std::size_t indent = text.size() - line;
    if (step.tests.empty()) text += "none\n";
    for (std::size_t k = 0; k < step.tests.size(); ++k)
      fmt::format_to(out, "{:>{}}{:<7} {}\n", "", k == 0 ? 0 : indent, step.tests[k].primitive,
                     outcome(step.tests[k]));
  }
  if (hits(ray))
    fmt::format_to(out, "  hit: t {:.9g}, primitive {}, object {}, at {}\n", ray.t, ray.primitive, ray.object,
                   text_of(position(ray)));
  else
    text += "  hit: none\n";
  fmt::format_to(out, "  end: {}\n  {}, {}\n", description_of(ray),
                 counted(ray.cells, is_hierarchy ? "node" : "cell"), counted(ray.tests, "test"));
}

} // namespace

Json walk_json(const WalkReport& report) {
  Json rays = Json::array();
  for (const WalkRay& ray : report.rays)
    rays.push_back(json_of(ray, report.form));
  const Json division = is_grid(report.form) ? Json(report.division) : Json();
  const Json grid =
      report.form == StructureForm::none ? Json() : Json{{"division", division}, {"space", report.space}};
  return {{"grid", grid}, {"rays", std::move(rays)}};
}

std::string walk_table(const WalkReport& report) {
  std::string text;
  std::uint64_t cells = 0, tests = 0;
  for (std::size_t i = 0; i < report.rays.size(); ++i) {
    append(text, report.rays[i], i, report.form);
    cells += report.rays[i].cells;
    tests += report.rays[i].tests;
  }
  if (report.rays.size() > 1)
    text += fmt::format("all {} rays: {}, {}\n", report.rays.size(),
                        counted(cells, report.form == StructureForm::hierarchy ? "node" : "cell"),
                        counted(tests, "test"));
  return text;
}

} // namespace masu
