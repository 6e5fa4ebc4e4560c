// What an observer on a hill sees of the land: prints a map.
#include <masu/masu.hpp>

#include <cmath>
#include <iostream>

namespace {

constexpr std::uint32_t side = 64; // vertices

float ground(float x, float y) {
  return 3 * std::sin(0.3f * x) * std::cos(0.23f * y) + 1.5f * std::sin(0.11f * x * y / 10 + 1);
}

} // namespace

int main() try {
  std::vector<float> vertices;
  std::vector<std::uint32_t> indices;
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) {
      const float px = static_cast<float>(x), py = static_cast<float>(y);
      vertices.insert(vertices.end(), {px, py, ground(px, py)});
      const std::uint32_t i = y * side + x;
      if (x + 1 < side && y + 1 < side)
        indices.insert(indices.end(), {i, i + 1, i + side, i + 1, i + side + 1, i + side});
    }
  // From 2 above the ground to 0.2 above each vertex: 0 < t < 1 is the way between.
  const masu::Tracer tracer(masu::Scene(vertices, indices));
  const float eye[3] = {36, 33, ground(36, 33) + 2};
  std::vector<masu_ray> rays;
  for (std::size_t i = 0; i < vertices.size(); i += 3)
    rays.push_back({{eye[0], eye[1], eye[2]},
                    0,
                    {vertices[i] - eye[0], vertices[i + 1] - eye[1], vertices[i + 2] + 0.2f - eye[2]},
                    1});
  const std::vector<std::uint8_t> occluded = tracer.occluded(rays);
  std::size_t visible = 0;
  for (std::size_t i = 0; i < occluded.size(); ++i) {
    visible += 1u - occluded[i];
    std::cout << (occluded[i] ? '.' : '#') << ((i + 1) % side ? "" : "\n");
  }
  std::cout << visible << " of " << occluded.size() << " points are visible\n";
} catch (const masu::Exception& error) {
  std::cerr << "line_of_sight: " << error.what() << "\n";
  return error.status;
}
