// The fields of a hit's record, as they are named and written.
#pragma once

#include "renderer/render_pixel.h"
#include "tools/lists/hit_file.h"

#include <string>
#include <vector>

namespace masu {

// What is written for a ray, one field after the other: t (float), object, primitive and face (int32, -1 for
// a miss), uv (2 floats), normal (3 floats), occluded (1 byte).
enum class HitField { t, object, primitive, face, uv, normal, occluded };

// Of a list such as "t,object". Throws Error(usage, --write, …).
std::vector<HitField> hit_fields(const std::string& names);
// How they are written.
std::vector<RecordField> record_fields(const std::vector<HitField>& fields);
// What is written where nothing else is asked for: t and the name of what is hit.
std::string usual_fields(HitName name);

} // namespace masu
