// How two pictures or channels differ, pixel by pixel.
#include "libscene/file/output_file.h"
#include "renderer/image/png_file.h"
#include "tools/bench/bench.h"
#include "tools/bench/difference.h"
#include "tools/common/cli.h"
#include "tools/common/printable.h"
#include "tools/common/provenance.h"
#include "tools/common/version.h"

#include <nlohmann/json.hpp>

#include <memory>

namespace masu {
namespace {

struct Settings {
  std::string a, b, output;
  std::string json; // empty: a line; -: standard output
};

std::string line_of(const Difference& difference) {
  std::string text =
      fmt::format("RMSE {:.6g}, largest difference {:.6g}", difference.rmse, difference.largest);
  if (difference.largest > 0) text += fmt::format(" at pixel {},{}", difference.x, difference.y);
  text += fmt::format("; {} of {} pixels differ", difference.different_pixels, difference.pixels.size());
  if (difference.incomparable_pixels > 0)
    text += fmt::format(", {} of them by a number that is infinite or NaN in one only",
                        difference.incomparable_pixels);
  return text + "\n";
}

std::string json_of(const Difference& difference) {
  nlohmann::ordered_json json = provenance();
  json.update({{"width", difference.width},
               {"height", difference.height},
               {"rmse", difference.rmse},
               {"largest", difference.largest},
               {"largest_at", nlohmann::ordered_json::array({difference.x, difference.y})},
               {"different_pixels", difference.different_pixels},
               {"incomparable_pixels", difference.incomparable_pixels}});
  if (!(difference.largest > 0)) json["largest_at"] = nullptr;
  return json_text(json) + "\n";
}

void print_difference(const Settings& settings) {
  if (is_standard_output(settings.output) && (settings.json.empty() || is_standard_output(settings.json)))
    throw Error(ErrorCode::usage, "-o", "is standard output, where the difference is printed: name a file");
  check_files({settings.a, settings.b}, {settings.output, settings.json});
  if (!settings.output.empty() && !is_standard_output(settings.output) && !settings.output.ends_with(".png"))
    throw Error(ErrorCode::usage, settings.output, "must end in .png: differences are drawn as PNG");
  const FloatPicture a = read_picture(settings.a), b = read_picture(settings.b);
  const Difference difference = difference_of(a, b, settings.b);
  if (!settings.output.empty())
    write_png(difference_picture(difference), settings.output, {{"Software", program_name()}});
  if (settings.json.empty())
    write_text_file("-", line_of(difference));
  else
    write_text_file(settings.json, json_of(difference));
}

} // namespace

void add_difference(const CommandLine& gridbench) {
  const auto owned = std::make_shared<Settings>(); // by the callback
  Settings& settings = *owned;
  const CommandLine command = gridbench.add_subcommand("difference", "How two pictures or channels differ");
  command.footer("Example:\n  gridbench difference balls.png centers.png -o difference.png");
  command.add_option("A", settings.a, "picture or channel: PNG, PFM, .npy").required();
  command.add_option("B", settings.b, "another one of the same size").required();
  command.add_file("-o,--output", settings.output, "draw the differences: FILE.png");
  command.add_json(settings.json);
  command.calls([owned] { print_difference(*owned); });
}

} // namespace masu
