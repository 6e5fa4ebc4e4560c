// gridbench: speed of tracing and loading, and accuracy.
#include "tools/bench/bench.h"
#include "tools/common/cli.h"

int main(int argc, char** argv) {
  using namespace masu;
  return run_tool("gridbench", "Measures the speed and accuracy of tracing, and the speed of loading.", argc,
                  argv, [](CLI::App& app, const auto& parse) {
                    add_frame(app);
                    add_rays(app);
                    add_lists(app);
                    add_scale(app);
                    add_load(app);
                    add_refit(app);
                    add_tradeoff(app);
                    add_stability(app);
                    add_oracle(app);
                    add_crossings(app);
                    add_difference(app);
                    app.require_subcommand(1);
                    app.footer("Example:\n  gridbench rays balls.scene balls.grid");
                    parse();
                  });
}
