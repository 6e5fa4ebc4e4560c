// A ray's walk as JSON, and as a table for people.
#pragma once

#include "renderer/rays/walk_report.h"

#include <nlohmann/json.hpp>

#include <string>

namespace masu {

// {grid: {division, space} or null, rays: [{kind, parent, origin, direction, t_min, t_max, hit: {t,
// primitive, object, position} or null, cells, tests, end, steps: [{voxels: {first, end} or null, node:
// {index, depth, boxes_met, boxes_missed, boxes_beyond} or null, box: {min, max}, enter, exit, references,
// tests: [{primitive, t, kept}]}]}]}. null stands for what isn't there, and for an infinite t: of a miss, of
// a ray without end.
nlohmann::ordered_json walk_json(const WalkReport& report);

// Lines of at most 80 characters, unless numbers are long.
std::string walk_table(const WalkReport& report);

} // namespace masu
