#include "libscene/spd/spd.h"

#include "libscene/base/error.h"
#include "libscene/spd/scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace masu {

namespace {

// In the order of SpdScene. The largest sizes are limited by
// balls, gears, mount, tetra: fewer than 2^31 objects;
// rings: coordinates below 1000, so that six digits are exact to 1 % of the rings' thickness;
// tree: the last twigs are 2e-4 long, with an error of 5e-6;
// nurbs, teapot: neighbouring corners still print as different numbers.
constexpr std::array<SpdInfo, 8> scenes = {{
    {SpdScene::balls, "balls", 4, 1, 9},
    {SpdScene::gears, "gears", 4, 1, 244},
    {SpdScene::mount, "mount", 6, 1, 14},
    {SpdScene::nurbs, "nurbs", 5, 1, 1000},
    {SpdScene::rings, "rings", 7, 1, 380},
    {SpdScene::teapot, "teapot", 12, 1, 1000},
    {SpdScene::tetra, "tetra", 6, 1, 15},
    {SpdScene::tree, "tree", 11, 1, 20},
}};

// In the same order.
constexpr std::array writers = {spd::write_balls, spd::write_gears,  spd::write_mount, spd::write_nurbs,
                                spd::write_rings, spd::write_teapot, spd::write_tetra, spd::write_tree};

} // namespace

std::span<const SpdInfo> spd_scenes() {
  return scenes;
}

const SpdInfo& spd_info(std::string_view name) {
  const auto info = std::ranges::find(scenes, name, &SpdInfo::name);
  if (info == scenes.end())
    throw Error(ErrorCode::usage, std::string(name),
                "isn't balls, gears, mount, nurbs, rings, teapot, tetra or tree");
  return *info;
}

void check_spd_size(SpdScene scene, int size) {
  const SpdInfo& info = scenes[static_cast<std::size_t>(scene)];
  if (size < info.min_size || size > info.max_size)
    throw Error(
        ErrorCode::usage, fmt::format("size {}", size),
        fmt::format("{} can't be made that size: choose {} to {}", info.name, info.min_size, info.max_size));
}

std::uint64_t spd_objects(SpdScene scene, int size) {
  const auto n = static_cast<std::uint64_t>(size);
  // Below 2^53, and so exact.
  const auto power = [&](int base) { return static_cast<std::uint64_t>(std::pow(base, size)); };
  switch (scene) {
  case SpdScene::balls:
    return (9 * power(9) - 1) / 8 + 1;
  case SpdScene::gears:
    return 146 * n * n * n + 1;
  case SpdScene::mount:
    return 2 * power(4) + 4;
  case SpdScene::nurbs:
    return 60 * n * n;
  case SpdScene::rings:
    return 60 * (n * (n + 1) * (2 * n + 1) / 6) + 1;
  case SpdScene::teapot:
    return 64 * n * n - 8 * n + n * n;
  case SpdScene::tetra:
    return power(4);
  case SpdScene::tree:
    return 2 * (2 * power(2) - 1) + 1;
  }
  return 0;
}

void write_spd(const SpdOptions& options, std::FILE* out, const std::string& place,
               const std::function<void(double)>& progress) {
  check_spd_size(options.scene, options.size);
  spd::NffWriter nff{out, place};
  const auto all = static_cast<double>(spd_objects(options.scene, options.size));
  if (progress)
    nff.progress = [&](std::uint64_t objects) {
      progress(std::min(static_cast<double>(objects) / all, 1.0));
    };
  writers[static_cast<std::size_t>(options.scene)](nff, options.size, options.background);
  finish(nff);
}

} // namespace masu
