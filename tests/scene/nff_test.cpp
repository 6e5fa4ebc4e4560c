#include "libscene/nff/nff.h"
#include "tests/random_test.h"
#include "tests/refused.h"
#include "tests/same_values.h"
#include "tests/temporary_folder.h"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <bit>
#include <numbers>
#include <optional>

namespace masu {
namespace {

using Nff = RandomTest;

Scene parse(std::string_view text, const NffOptions& options = {}) {
  return parse_nff(text, "t", options);
}

// --- Scenes as tokens, which can be written in many ways

using Entity = std::vector<std::string>;

// Up to six significant digits, as most files have.
std::string number_text(Chance& chance) {
  const int digits = chance.whole(1, 999999), decimals = chance.whole(0, 6);
  return fmt::format("{}{:.{}f}", chance.whole(0, 1) ? "-" : "", digits / std::pow(10.0, decimals), decimals);
}

Entity with_numbers(Chance& chance, Entity entity, int count) {
  for (int i = 0; i < count; ++i)
    entity.push_back(number_text(chance));
  return entity;
}

Entity random_view(Chance& chance) {
  Entity entity{"v"};
  const auto part = [&](const Entity& tokens) { entity.insert(entity.end(), tokens.begin(), tokens.end()); };
  if (chance.whole(0, 3)) part(with_numbers(chance, {"from"}, 3));
  if (chance.whole(0, 3)) part({"angle", "33.5"});
  if (chance.whole(0, 3)) part(with_numbers(chance, {"at"}, 3));
  if (chance.whole(0, 3)) part({"hither", "1"});
  if (chance.whole(0, 3)) part({"resolution", "64", "32"});
  if (chance.whole(0, 3)) part({"up", "0.1", "0.2", "1"});
  return entity;
}

Entity random_entity(Chance& chance) {
  switch (chance.whole(0, 9)) {
  case 0:
    return random_view(chance);
  case 1:
    return with_numbers(chance, {"b"}, 3);
  case 2:
    return with_numbers(chance, {"l"}, chance.whole(0, 1) ? 3 : 6);
  case 3:
    return {"f",   chance.one_of<std::string>({"0.1", "0.2"}), "1", "1",
            "0.5", chance.one_of<std::string>({"0", "1"}),     "3", "0",
            "0"};
  case 4:
    return {"c", "0", "0", "0", "1", "0", "0", number_text(chance), "0.5"};
  case 5:
    return {"pp", "3", "0", "0", "0", "0", "0", "1", "1", "0", number_text(chance),
            "0",  "1", "1", "0", "1", "0", "1", "1", "1"};
  case 6: {
    const int vertices = chance.whole(3, 9);
    return with_numbers(chance, {"p", std::to_string(vertices)}, 3 * vertices);
  }
  case 7:
    return {"s", "1", "2", "3", chance.one_of<std::string>({"0", "1", "-1"})};
  default:
    return with_numbers(chance, {"s"}, 4);
  }
}

std::vector<Entity> random_entities(Chance& chance, int count) {
  std::vector<Entity> entities(static_cast<std::size_t>(count));
  for (Entity& entity : entities)
    entity = random_entity(chance);
  return entities;
}

std::string plainly(const std::vector<Entity>& entities) {
  std::string text;
  for (const Entity& entity : entities) {
    for (const std::string& token : entity)
      text += token + (&token == &entity.back() ? "\n" : " ");
  }
  return text;
}

// Another spelling of the number: a sign, leading zeros, an exponent, no zero before the point.
std::string respelled(Chance& chance, const std::string& number) {
  const bool is_negative = number[0] == '-';
  const std::string digits = number.substr(is_negative ? 1 : 0);
  std::string result = is_negative ? "-" : chance.whole(0, 2) == 0 ? "+" : "";
  const std::size_t point = digits.find('.');
  if (chance.whole(0, 2) == 0) {
    const std::size_t decimals = point == std::string::npos ? 0 : digits.size() - point - 1;
    result.append(static_cast<std::size_t>(chance.whole(0, 2)), '0');
    result += digits.substr(0, point);
    if (decimals > 0) result += digits.substr(point + 1);
    if (chance.whole(0, 3) == 0) result += ".";
    result += chance.whole(0, 1) ? "e-" : "E-0";
    return result += std::to_string(decimals);
  }
  return result += digits.rfind("0.", 0) == 0 && chance.whole(0, 1) ? digits.substr(1) : digits;
}

std::string random_blank(Chance& chance) {
  std::string blank;
  for (int i = chance.whole(1, 3); i > 0; --i)
    blank += chance.one_of<std::string>({" ", "\t", "\n", "\r\n", "\r", "\v", "\f", "\n\n", "#\n",
                                         "# s 1 2 3 4\n", "#f 1 1 1 1 1 1 1 1\r\n", "# pp 3 \xC3\xA4 v\r"});
  return blank;
}

std::string in_some_way(Chance& chance, const std::vector<Entity>& entities) {
  std::string text = chance.whole(0, 1) ? "\xEF\xBB\xBF" : "";
  if (chance.whole(0, 1)) text += random_blank(chance);
  for (const Entity& entity : entities)
    for (std::size_t i = 0; i < entity.size(); ++i) {
      const bool is_number = entity[i].find_first_of("0123456789") != std::string::npos;
      const bool is_count = i == 1 && entity[0][0] == 'p';
      text += is_number && !is_count ? respelled(chance, entity[i]) : entity[i];
      text += chance.whole(0, 1) ? " " : random_blank(chance);
    }
  return text;
}

NffOptions random_options(Chance& chance) {
  return {static_cast<std::size_t>(chance.whole(1, 200))};
}

// --- Comparison

// Without padding.
std::vector<Triangle<double>> padless(const GrowingArray<SceneTriangle>& triangles) {
  return {triangles.begin(), triangles.end()};
}

// SceneWarnings or ObjectCounts, in their order.
template <class Counts>
auto counts(const Counts& of) {
  return std::bit_cast<std::array<std::uint64_t, sizeof of / sizeof(std::uint64_t)>>(of);
}

void expect_same(const Scene& a, const Scene& b) {
  EXPECT_TRUE(same_values(a.lights, b.lights)) << "lights";
  EXPECT_TRUE(same_values(a.materials, b.materials)) << "materials";
  EXPECT_TRUE(same_values(padless(a.triangles), padless(b.triangles))) << "triangles";
  EXPECT_TRUE(same_values(a.normals, b.normals)) << "normals";
  EXPECT_TRUE(same_values(a.spheres, b.spheres)) << "spheres";
  EXPECT_TRUE(same_values(a.sphere_surfaces, b.sphere_surfaces)) << "sphere surfaces";
  EXPECT_TRUE(same_values(a.cones, b.cones)) << "cones";
  EXPECT_TRUE(same_values(a.cone_surfaces, b.cone_surfaces)) << "cone surfaces";
  EXPECT_EQ(counts(a.warnings), counts(b.warnings));
  EXPECT_EQ(counts(a.objects), counts(b.objects));
  EXPECT_TRUE(same_values(std::array{a.camera}, std::array{b.camera})) << "camera";
  EXPECT_TRUE(a.background == b.background);
  EXPECT_EQ(a.ambient, b.ambient);
  EXPECT_EQ(a.has_camera, b.has_camera);
}

// The error's message, or nothing.
std::optional<std::string> error_of(std::string_view text, const NffOptions& options = {}) {
  try {
    parse(text, options);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::input);
    EXPECT_EQ(error.place()[0], 't');
    EXPECT_FALSE(error.message().empty());
    return error.text();
  }
  return {};
}

// --- The same scene

TEST_F(Nff, SceneIsIndependentOfSpelling) {
  for (int i = 0; i < 300 && !testing::Test::HasFailure(); ++i) {
    const auto entities = random_entities(chance_, chance_.whole(1, 40));
    const auto expected_error = error_of(plainly(entities));
    const std::string text = in_some_way(chance_, entities);
    SCOPED_TRACE(text);
    if (expected_error) // a view without direction, by chance
      EXPECT_TRUE(error_of(text, random_options(chance_)));
    else
      expect_same(parse(plainly(entities)), parse(text, random_options(chance_)));
  }
}

TEST_F(Nff, SceneIsIndependentOfPieces) {
  for (int i = 0; i < 100 && !testing::Test::HasFailure(); ++i) {
    const std::string text = "f 1 0 0 1 0 0 0 1\n" + plainly(random_entities(chance_, chance_.whole(1, 400)));
    if (error_of(text)) continue;
    const Scene scene = parse(text);
    for (const std::size_t bytes : {std::size_t{0}, std::size_t{1}, std::size_t{100}, std::size_t{1000}})
      for (const int threads : {1, 2, 7})
        tbb::task_arena(threads).execute([&] { expect_same(scene, parse(text, {bytes})); });
  }
}

TEST_F(Nff, ErrorIsIndependentOfPieces) {
  for (int i = 0; i < 300 && !testing::Test::HasFailure(); ++i) {
    std::string text = plainly(random_entities(chance_, 50));
    for (int k = chance_.whole(1, 3); k > 0; --k)
      text[static_cast<std::size_t>(chance_.whole(0, static_cast<int>(text.size()) - 1))] =
          chance_.one_of<char>({'x', ' ', '\n', '#', '-', '.', 'p', 's', '9'});
    EXPECT_EQ(error_of(text), error_of(text, random_options(chance_))) << text;
  }
}

TEST_F(Nff, MorePrimitivesThanAreAllowedAreRefused) {
  std::string text = "p 4 0 0 0 1 0 0 1 1 0 0 1 0\n";
  for (int i = 0; i < 8; ++i)
    text += fmt::format("s {} 0 0 1\nc {} 0 0 1 {} 0 1 1\n", i, i, i);
  constexpr std::uint64_t primitives = 2 + 8 + 8;
  for (const std::size_t piece_bytes : {std::size_t{1}, std::size_t{1} << 20}) {
    NffOptions options;
    options.piece_bytes = piece_bytes;
    options.max_primitives = primitives;
    EXPECT_EQ(error_of(text, options), std::nullopt);
    options.max_primitives = primitives - 1;
    EXPECT_EQ(error_of(text, options), "t: has more than 17 primitives: split the scene");
  }
  EXPECT_EQ(NffOptions{}.max_primitives, 0x7fffffffU);
}

// --- Damage

const std::string small_scene =
    "# a bit of everything\n"
    "v\nfrom 0 -5 1\nat 0 0 0\nup 0 0 1\nangle 45\nhither 0.01\nresolution 64 48\n"
    "b 0.1 0.2 0.3\nl 1 2 3\nl 1 2 4 0.5 0.5 0.5\nf 1 0 0 0.5 0.5 3 0.2 1.5\n"
    "p 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
    "pp 3\n0 0 0 0 0 1\n1 0 0 0 0.1 1\n1 1 0 0.1 0 1\n"
    "p 5\n0 0 0\n1 0 0\n1 1 0\n0.5 0.5 0\n0 1 0\n"
    "c 0 0 0 1 0 0 1 0.5\ns 1e0 -2 +3 .5 # the end";

TEST_F(Nff, EveryTruncationParsesOrThrows) {
  EXPECT_FALSE(error_of(small_scene));
  for (std::size_t length = 0; length < small_scene.size(); ++length) {
    // An exact allocation, so that a sanitizer detects a read past the end.
    const std::vector<char> part(small_scene.data(), small_scene.data() + length);
    error_of({part.data(), part.size()}, {length % 2 == 0 ? std::size_t{16} : std::size_t{1} << 20});
  }
}

TEST_F(Nff, EveryChangedByteParsesOrThrows) {
  for (std::size_t at = 0; at < small_scene.size(); ++at)
    for (const char c :
         {'\0', '\n', ' ', '#', '-', '.', 'e', '9', '\xFF', static_cast<char>(chance_.whole(0, 255))}) {
      std::string changed = small_scene;
      changed[at] = c;
      error_of(changed, random_options(chance_));
    }
}

TEST_F(Nff, GarbageParsesOrThrows) {
  for (int i = 0; i < 2000; ++i) {
    std::string text;
    for (int k = chance_.whole(0, 60); k > 0; --k)
      text += chance_.one_of<std::string>(
          {"p ",      "3 ",          "pp ",    "s ",           "c ",   "1 ",  "0 ", "-1 ", "1e300 ",
           "1e-300 ", "f ",          "v ",     "from ",        "up ",  "at ", "\n", "l ",  "b ",
           "2.5 ",    "resolution ", "angle ", "99999999999 ", "\xFF", "#",   "e",  "."});
    error_of(text, random_options(chance_));
  }
}

TEST_F(Nff, ErrorsHavePositionAndCause) {
  const std::vector<std::array<std::string, 3>> cases{
      {"", "t: ", "has no NFF entity"},
      {" # s 0 0 0 1", "t: ", "has no NFF entity"},
      {"x 1 2 3", "t:1:1: ", "'x' is no NFF entity"},
      {"s 0 0 0 1\n  sphere 0 0 0 1", "t:2:3: ", "'sphere' is no NFF entity"},
      {"s 0 0 0 1\r\n\r\nq", "t:3:1: ", "no NFF entity"},
      {"s 0 0 0 1\r\rq", "t:3:1: ", "no NFF entity"},
      {"\xEF\xBB\xBFq", "t:1:1: ", "no NFF entity"},
      {"s 0 0 0 1 2", "t:1:11: ", "'2' is one number too many"},
      {"s 0 0 x 1", "t:1:7: ", "'x' where a number is expected"},
      {"s 0 0 0,1 1", "t:1:7: ", "'0,1'"},
      {"s 0 0 1e 1", "t:1:7: ", "'1e'"},
      {"s 0 0 0x10 1", "t:1:7: ", "'0x10'"},
      {"s 0 0 +-1 1", "t:1:7: ", "'+-1'"},
      {"s 0 0 - 1", "t:1:7: ", "'-'"},
      {"s 0 0 . 1", "t:1:7: ", "'.'"},
      {"s 0 0 1.2.3 1", "t:1:7: ", "'1.2.3'"},
      {"s 0 0\nnan 1", "t:2:1: ", "'nan'"},
      {"s 0 0\n-inf 1", "t:2:1: ", "'-inf'"},
      {"s 0 0 infinity 1", "t:1:7: ", "'infinity'"},
      {"s 0 0 1e400 1", "t:1:7: ", "out of a double's range"},
      {"s 0 0 -1e-400 1", "t:1:7: ", "out of a double's range"},
      {"s 0 0 2e100 1", "t:1:7: ", "is too large"},
      {"l 0 0 -2e100", "t:1:7: ", "is too large"},
      {"s 0 0 0", "t:1:8: ", "the text ends where a number is missing"},
      {"s 0 0 0 # the end\n", "t:2:1: ", "the text ends"},
      {"s 0 0\ns 0 0 0 1", "t:2:1: ", "'s' where a number is expected"},
      {"p 2\n0 0 0\n1 1 1", "t:1:3: ", "'2' is no whole number from 3"},
      {"p -3 0 0 0", "t:1:3: ", "'-3' is no whole number"},
      {"p 3.5 0 0 0 1 0 0 0 1 0 0 0 0", "t:1:3: ", "'3.5' is no whole number"},
      {"p 4000000000 0 0 0", "t:1:3: ", "more than the rest of the text can hold"},
      {"pp 99999999999 0 0 0", "t:1:4: ", "'99999999999' is no whole number"},
      {"pp 4294967295\n0 0 0 0 0 1", "t:1:4: ", "4294967295"},
      {"p 3\n0 0 0\n1 0 0\n0 1          ", "t:4:14: ", "the text ends"},
      {"pp 3 0 0 0 0 0 1 1 0 0 0 0 0 0 1 0 0 0 1", "t:1:24: ", "normal has no length"},
      {"l 0 0", "t:1:6: ", "l x y z [r g b]"},
      {"l 0 0 0 1\ns 0 0 0 1", "t:2:1: ", "'s' where a number is expected"},
      {"l 0 0 0 1 1\n", "t:2:1: ", "the text ends"},
      {"l 0 0 0 1 1 1 1", "t:1:15: ", "one number too many"},
      {"f 1 1 1 -0.5 0 0 0 0", "t:1:9: ", "'-0.5' is negative"},
      {"f 1 1 1 1 -1 0 0 0", "t:1:11: ", "negative"},
      {"f 1 1 1 1 1 0 -1 0", "t:1:15: ", "negative"},
      {"f 1e39 1 1 1 1 0 1 0", "t:1:3: ", "too large"},
      {"b 1 1 1e99", "t:1:7: ", "too large"},
      {"c 0 0 0 1 0 0 1 -1", "t:1:17: ", "opposite signs"},
      {"\nv from 1 2 3 at 1 2 3", "t:2:1: ", "same point"},
      {"v from 0 0 0 at 0 0 1 up 0 0 0", "t:1:26: ", "up has no length"},
      {" v from 0 0 0 at 0 0 1 up 0 0 -5", "t:1:2: ", "line of sight"},
      {"v from 1 1 1 at 2 2 2 up 0.1 0.1 0.1", "t:1:1: ", "line of sight"},
      {"v angle 0", "t:1:9: ", "no view angle"},
      {"v angle 180", "t:1:9: ", "no view angle"},
      {"v resolution 0 5", "t:1:14: ", "whole number from 1 to 65536"},
      {"v resolution 5 65537", "t:1:16: ", "whole number from 1 to 65536"},
      {"v resolution 5 1.5", "t:1:16: ", "whole number"},
      {"v resolution 5 -8", "t:1:16: ", "'-8'"},
      {"v\nfrom 1 2", "t:2:9: ", "the text ends"},
      {std::string("\x7f\x45LF\2\1\0\0\0", 9), "t:1:1: ", "no NFF entity"},
      {"v from 0 0 0 to 1 1 1", "t:1:14: ", "'to' is no NFF entity"},
      {"from 0 0 0", "t:1:1: ", "'from' is no NFF entity"},
  };
  for (const auto& [text, place, message] : cases) {
    const std::string error = error_of(text).value_or("parses");
    EXPECT_EQ(error.substr(0, place.size()), place) << text << "\n" << error;
    EXPECT_NE(error.find(message), std::string::npos) << text << "\n" << error;
  }
}

TEST_F(Nff, MissingFileIsNamed) {
  EXPECT_TRUE(is_refused([](const std::string& path) { read_nff(path); }, "/no/such/file.nff"));
}

TEST_F(Nff, FileParsesAsItsText) {
  const TemporaryFolder folder;
  write_text(folder.file("t"), small_scene);
  expect_same(read_nff(folder.file("t")), parse(small_scene));
}

// --- Numbers

std::string random_digits(Chance& chance, int least, int most) {
  std::string digits;
  for (int i = chance.whole(least, most); i > 0; --i)
    digits += static_cast<char>('0' + chance.whole(0, 9));
  return digits;
}

TEST_F(Nff, NumbersRoundToNearest) {
  for (int i = 0; i < 50000; ++i) {
    std::string number = chance_.whole(0, 1) ? "-" : "";
    number += random_digits(chance_, 1, 12);
    if (chance_.whole(0, 3)) number.append(".").append(random_digits(chance_, 0, 12));
    if (chance_.whole(0, 9) == 0) number.append("e").append(std::to_string(chance_.whole(-60, 60)));
    const double expected = std::strtod(number.c_str(), nullptr);
    ASSERT_EQ(parse("s " + number + " 0 0 1").spheres[0].center.x, expected) << number;
  }
}

// --- Contents of a scene

TEST_F(Nff, ViewIsReadAsWritten) {
  const Scene scene = parse("v up 0 1 0.5 resolution 640 480 hither 0.25 angle 30 at 4 5 6 from 1 2 3");
  EXPECT_TRUE(scene.has_camera);
  EXPECT_TRUE(same_values(std::array{scene.camera},
                          std::array{Camera{{1, 2, 3}, {4, 5, 6}, {0, 1, 0.5}, 30, 0.25, 640, 480}}));
}

TEST_F(Nff, LastViewAndBackgroundApply) {
  const Scene scene = parse("v from 1 2 3 at 0 0 0\nb 1 1 1\nv from 4 5 6 at 0 0 0 angle 20\nb 0.5 0.25 0");
  EXPECT_TRUE(scene.camera.from == (Vec3d{4, 5, 6}));
  EXPECT_EQ(scene.camera.angle, 20);
  EXPECT_TRUE(scene.background == (Vec3f{0.5F, 0.25F, 0}));
}

TEST_F(Nff, ViewAlongZHasADefaultUp) {
  const Camera camera = parse("v from 0 0 9 at 0 0 0").camera;
  EXPECT_TRUE(camera.up == (Vec3d{0, 1, 0}));
}

// The angle between the view direction and a point, in degrees.
double off_axis(const Camera& camera, const Vec3d& point) {
  const double scale = 1 / largest_magnitude(camera.at - camera.from);
  const Vec3d sight = normalized((camera.at - camera.from) * scale);
  const Vec3d to = normalized((point - camera.from) * scale);
  return std::acos(std::min(1.0, dot(sight, to))) * 180 / std::numbers::pi;
}

TEST_F(Nff, DefaultViewShowsTheWholeScene) {
  for (int i = 0; i < 200; ++i) {
    const double scale = std::pow(10.0, chance_.uniform(-90, 90));
    const Vec3d offset = chance_.in_cube(1) * (scale * chance_.whole(0, 1000));
    const auto text = [](const Vec3d& p) { return fmt::format(" {:.17g} {:.17g} {:.17g}", p.x, p.y, p.z); };
    std::vector<Vec3d> corners;
    std::string polygons;
    for (int k = 0; k < 12; ++k) {
      corners.push_back(offset + chance_.in_cube(1) * scale);
      polygons += (k % 3 == 0 ? "\np 3" : "") + text(corners.back());
    }
    const Scene scene = parse(polygons);
    EXPECT_FALSE(scene.has_camera);
    EXPECT_EQ(scene.camera.angle, 45);
    for (const Vec3d& corner : corners)
      ASSERT_LE(off_axis(scene.camera, corner), 22.5 + 1e-6);
  }
}

TEST_F(Nff, DefaultViewOfATinySceneHasADirection) {
  for (const char* text : {"b 0 0 0", "s 0 0 0 0", "s 5 5 5 1e-90", "s 1e12 0 0 1e-9", "s 0 0 0 1e-99",
                           "v from 0 0 0\ns 0 0 0 1", "v at 0 0 0", "v"}) {
    const Camera camera = parse(text).camera;
    EXPECT_FALSE(camera.from == camera.at) << text;
    const Vec3d sight = camera.at - camera.from;
    EXPECT_GT(largest_magnitude(cross(sight * (1 / largest_magnitude(sight)), camera.up)), 0.1) << text;
    EXPECT_EQ(camera.width, 512);
    EXPECT_EQ(camera.height, 512);
    EXPECT_EQ(camera.hither, 0.01);
  }
}

TEST_F(Nff, LightsShareTheDefaultIntensity) {
  std::string lights;
  for (int n = 1; n <= 9; ++n) {
    const Scene of_n = parse(lights += "l 0 0 1000\n");
    const double each = std::sqrt(n) / (2 * n);
    EXPECT_FLOAT_EQ(of_n.ambient, static_cast<float>(each));
    for (const Light<double>& light : of_n.lights)
      EXPECT_FLOAT_EQ(static_cast<float>(light.intensity.y), static_cast<float>(each)) << n << " lights";
  }
  const Scene scene = parse("l 1 2 3\nl 4 5 6 0.5 0.25 2\nl 7 8 9\nl 0 0 1");
  ASSERT_EQ(scene.lights.size(), 4U);
  EXPECT_FLOAT_EQ(scene.ambient, 0.25F); // √4 / 8
  EXPECT_TRUE(scene.lights[0].intensity == (Vec3d{0.25, 0.25, 0.25}));
  EXPECT_TRUE(scene.lights[1].intensity == (Vec3d{0.5, 0.25, 2}));
  EXPECT_TRUE(scene.lights[1].position == (Vec3d{4, 5, 6}));
}

TEST_F(Nff, DefaultLightIsAtTheCamera) {
  const Scene scene = parse("v from 1 2 3 at 0 0 0");
  ASSERT_EQ(scene.lights.size(), 1U);
  EXPECT_TRUE(scene.lights[0].position == (Vec3d{1, 2, 3}));
  EXPECT_TRUE(scene.lights[0].intensity == (Vec3d{0.5, 0.5, 0.5}));
  EXPECT_FLOAT_EQ(scene.ambient, 0.5F);
  EXPECT_TRUE(scene.background == (Vec3f{0, 0, 0}));
}

TEST_F(Nff, MaterialsAreUsedAndDistinct) {
  const std::string text = "s 0 0 0 1\n"
                           "f 1 0 0 1 0 0 0 1\ns 0 0 0 1\ns 0 0 0 1\n"
                           "f 0 1 0 1 0 0 0 1\n"
                           "f 0 0 1 1 0 0 0 1\ns 0 0 0 0\n"
                           "f 1 0 0 1 0 0 0 1\nc 0 0 0 1 0 0 1 1\n"
                           "f 1 1 1 1 0 0 0 1\np 3 0 0 0 1 0 0 0 1 0\n";
  for (const std::size_t bytes : {1, 1000000}) {
    const Scene scene = parse(text, {bytes});
    ASSERT_EQ(scene.materials.size(), 2U);
    EXPECT_TRUE(scene.materials[0].color == (Vec3f{1, 1, 1})); // the default, equal to the last f
    EXPECT_EQ(scene.materials[0].diffuse, 1);
    EXPECT_EQ(scene.materials[0].refraction_index, 1);
    EXPECT_TRUE(scene.materials[1].color == (Vec3f{1, 0, 0}));
    EXPECT_EQ(scene.sphere_surfaces[0].material, 0U);
    EXPECT_EQ(scene.sphere_surfaces[2].material, 1U);
    EXPECT_EQ(scene.cone_surfaces[0].material, 1U);
    EXPECT_EQ(scene.triangles[0].material, 0U);
  }
}

TEST_F(Nff, RefractionIndexZeroOfATransmittingMaterialIsOne) {
  EXPECT_EQ(parse("f 1 1 1 1 0 0 0.5 0\ns 0 0 0 1").materials[0].refraction_index, 1);
  EXPECT_EQ(parse("f 1 1 1 1 0 0 0.5 -2\ns 0 0 0 1").materials[0].refraction_index, 1);
  EXPECT_EQ(parse("f 1 1 1 1 0 0 0 0\ns 0 0 0 1").materials[0].refraction_index, 0);
}

TEST_F(Nff, DegenerateObjectsAreDroppedButCounted) {
  const Scene scene = parse("p 3 0 0 0 1 1 1 2 2 2\n"
                            "s 0 0 0 0\ns 0 0 0 -1\n"
                            "c 1 1 1 1 1 1 1 2\nc 0 0 0 0 0 0 1 0\nc 0 0 0 1 0 0 1 0\n"
                            "pp 3 0 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 0 1\n"
                            "p 4 0 0 0 2 2 0 2 0 0 0 2 0");
  EXPECT_EQ(counts(scene.warnings), (std::array<std::uint64_t, 5>{1, 0, 1, 2, 1}));
  EXPECT_EQ(counts(scene.objects), (std::array<std::uint64_t, 4>{2, 1, 2, 3}));
  ASSERT_EQ(scene.spheres.size(), 1U);
  EXPECT_EQ(scene.sphere_surfaces[0].object, 2U);
  ASSERT_EQ(scene.cones.size(), 1U);
  EXPECT_EQ(scene.cone_surfaces[0].object, 5U);
  EXPECT_EQ(scene.triangles[0].object, 6U);
  EXPECT_EQ(scene.triangles[0].normals, 0U);
  EXPECT_EQ(scene.triangles[1].object, 7U);
  EXPECT_EQ(scene.triangles[1].normals, no_normals);
}

TEST_F(Nff, PatchNormalsBelongToTheirCorners) {
  // Each normal's z encodes its vertex.
  const Scene scene = parse("p 3 0 0 0 1 0 0 0 1 0\n"
                            "pp 5  0 0 0 0 0 1  4 0 0 0 0 2  4 4 0 0 0 3  2 1 0 0 0 4  0 4 0 0 0 5\n"
                            "pp 3  0 0 0 0 0 1e50  4 0 0 0 0 1e-50  4 4 0 0 0 -3",
                            {1});
  ASSERT_EQ(scene.triangles.size(), 5U);
  ASSERT_EQ(scene.normals.size(), 4U);
  const std::vector<Vec3d> vertices{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {0, 4, 0}};
  for (std::size_t i = 1; i < 4; ++i) {
    const Triangle<double>& triangle = scene.triangles[i];
    const CornerNormals<double>& normals = scene.normals[triangle.normals];
    EXPECT_TRUE(triangle.a == vertices.at(static_cast<std::size_t>(normals.a.z - 1)));
    EXPECT_TRUE(triangle.b == vertices.at(static_cast<std::size_t>(normals.b.z - 1)));
    EXPECT_TRUE(triangle.c == vertices.at(static_cast<std::size_t>(normals.c.z - 1)));
  }
  // Normals whose square is out of float32's range are scaled.
  const CornerNormals<double>& last = scene.normals[3];
  EXPECT_TRUE(last.a == (Vec3d{0, 0, 1}) && last.b == (Vec3d{0, 0, 1}) && last.c == (Vec3d{0, 0, -3}));
}

TEST_F(Nff, PolygonsKeepTheirOrderAndOrientation) {
  const Scene scene = parse("p 4 0 0 0 1 0 0 1 1 0 0 1 0\np 4 0 1 0 1 1 0 1 0 0 0 0 0");
  ASSERT_EQ(scene.triangles.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const Triangle<double>& t = scene.triangles[i];
    EXPECT_EQ(t.object, i / 2);
    EXPECT_EQ(cross(t.b - t.a, t.c - t.a).z > 0, i < 2);
  }
}

} // namespace
} // namespace masu
