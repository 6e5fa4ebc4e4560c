// gridbench: speed and accuracy of tracing.
#include "tools/bench/command.h"
#include "tools/common/cli.h"

int main(int argc, char** argv) {
  using namespace masu;
  return run_tool("gridbench", "Measures the speed and accuracy of tracing.", argc, argv,
                  [](const CommandLine& command, const auto& parse) {
                    add_frame(command);
                    add_rays(command);
                    add_tradeoff(command);
                    add_stability(command);
                    add_oracle(command);
                    add_crossings(command);
                    add_difference(command);
                    command.footer("Example:\n  gridbench rays balls.scene balls.grid");
                    parse();
                  });
}
