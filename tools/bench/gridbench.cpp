// gridbench: how fast rays are traced, how fast what they need is loaded, and where arithmetic breaks.
#include "tools/bench/bench.h"
#include "tools/cli.h"

int main(int argc, char** argv) {
  using namespace masu;
  return run_tool("gridbench", "Measures tracing and loading: how fast, and how right.", argc, argv,
                  [](CLI::App& app, const auto& parse) {
                    add_frame(app);
                    add_rays(app);
                    add_load(app);
                    add_tradeoff(app);
                    add_stability(app);
                    add_oracle(app);
                    app.require_subcommand(1);
                    parse();
                  });
}
