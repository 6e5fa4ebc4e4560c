// Command lines that make no sense: each is a usage error of one line, and nothing is written.
#include "tests/tools/run_tool.h"

namespace masu {
namespace {

struct Table {
  const char *name, *commands; // as expect_refused() reads them
};
void PrintTo(const Table& table, std::ostream* out) {
  *out << table.name;
}

constexpr Table every_tool{"AllTools", R"(
[nffgen|nff2bin|gridbuild|gridrender|gridtrace]
[nffgen|nff2bin|gridbuild|gridrender|gridtrace] --no-such-option         > @
[nffgen|nff2bin|gridbuild|gridrender|gridtrace] a b c d
gridstat                                                                 > GRID
gridstat --no-such-option                                                > @
gridstat a b
)"};

// tests/grid/division_test.cpp has how divisions are written.
constexpr Table makers{"NffgenNff2binGridbuild", R"(
nffgen cube                                                              > cube
nffgen balls --size 0                                                    > size 0
nffgen balls --size -1                                                   > size -1
nffgen balls --size 10 -o ~/new                                          > size 10
nffgen balls --size two
nff2bin ~/a.nff
nff2bin ~/a.nff -o ~/new [--json|--store float16|--threads -1]
nff2bin ~/a.nff -o ~/a.nff                                               > @
nff2bin ~/a.nff -o ~/new --tessellate [0|-4|3|6|1028|12.0|x|99999999999999999999]
nff2bin ~/a.scene --info --tessellate 12                                 > ~/a.scene
nff2bin ~/a.scene -o ~/new.scene                                         > ~/a.scene: scene file already
nff2bin ~/a.nff -o ~/new --origin [nan,0,0|0,inf,0|0,0,1e300|1,2|1,2,3,4|here] > --origin
gridbuild ~/a.scene
gridbuild ~/a.scene -o ~/new --division [0|x|cleary:1e30|99999999999999999999|65535] > --division
gridbuild ~/a.scene -o ~/new [--space|--overlap|--merge|--threads] what
gridbuild ~/a.scene -o ~/new --merge x --quality fast                    > --quality
gridbuild ~/a.scene -o ~/new --structure bvh [--division 8|--overlap box] > @option: of grids
gridbuild ~/a.scene -o ~/new --merge irregular --target 4                > --target: balance
gridbuild ~/a.scene -o ~/new --merge x [--nested 2|--step-cost 1|--detail 1|--alpha 0.5|--expand 0] > @option: irregular
gridbuild ~/a.scene -o ~/new --division 8 [--nested 2|--target 4]        > @option
nff2bin ~/a.scene --info [--store float64|--origin none]                 > @option: scene file already
)"};

// Of a picture of 16 x 12 pixels.
constexpr Table gridrender{"Gridrender", R"(
gridrender ~/a.scene ~/a.grid                                            > -o
gridrender ~/a.scene -o ~/new.png                                        > GRID
gridrender ~/a.scene ~/a.grid -o ~/new.png --size [8|8x|x8|0x8|8x0|-8x8|8x8x8|65537x1|8X8|8x8_] > --size
gridrender ~/a.scene ~/a.grid -o ~/new.png --depth [0|-1|33|x]
gridrender ~/a.scene ~/a.grid -o ~/new.png [--backend|--sampling|--threads] what
gridrender ~/a.scene ~/a.grid -o [~/new.bmp|~/new|png|~/new.PNG|~/new.JPG]         > @
gridrender ~/a.scene ~/a.grid -o ~/new --format [bmp|jpeg]
gridrender ~/a.scene ~/a.grid -o ~/new.jpg --quality [0|101|-1|x|1.5]
gridrender ~/a.scene ~/a.grid [-o ~/new.png|-o ~/new.pfm|-o -|--hits ~/new] --quality 90 > --quality: JPEG
gridrender ~/a.scene ~/a.grid -o ~/new.jpg [--format png|--channels depth --no-picture] --quality 90 > --quality: JPEG
gridrender ~/a.scene ~/a.grid -o ~/new.jpg --size [65501x1|1x65501|65536x65536] > --format: JPEG
gridrender ~/a.scene ~/a.grid -o ~/new.png --from 0,0,0.5                > --at: the point that the view is from
gridrender ~/a.scene ~/a.grid -o ~/new.png --up 0,0,0                    > --up: no length
gridrender ~/a.scene ~/a.grid -o ~/new.png [--up 3,-4,1.5|--from 0,0,5 --at 0,0,-1] > --up: parallel
gridrender ~/a.scene ~/a.grid -o ~/new.png --from 1e13,0,0               > --from: 1e+12
gridrender ~/a.scene ~/a.grid -o ~/new.png --angle [0|-1|180|nan|inf]    > --angle
gridrender ~/a.scene ~/a.grid -o ~/new.png [--from|--at|--up] [1,2|1,2,3,4|1,2,x|1,,3|nan,0,0|0,inf,0|1_2_3] > @option
gridrender ~/a.scene ~/a.grid -o ~/new.png --crop=[16,0,1,1|0,12,1,1|0,0,17,1|0,0,1,13|15,0,2,1|0,11,1,2] > --crop
gridrender ~/a.scene ~/a.grid -o ~/new.png --crop=[0,0,2147483647,1|-1,0,1,1|0,0,0,1|0,0,1|0,0,1,1,1|a,0,1,1] > --crop
gridrender ~/a.scene ~/a.grid -o ~/new.png --devices=[gpu|0,|,0|0_1|-1|0,x|99999999999|all,0|cpu,0] > --devices
gridrender ~/a.scene ~/a.grid -o ~/new.png --devices [cpu --backend cuda|0 --backend cpu] > --devices
gridrender ~/a.scene ~/a.grid --turntable 2 -o ~/new[a|{Name}|{}].png    > @: {name}
gridrender ~/a.scene ~/a.grid --turntable 2 -o ~/new{index}.png --hits ~/new > @: {name}
gridrender ~/a.scene ~/a.grid --turntable 2 -o ~/new{index}.png --hits ~/new{index}.png > @: written twice
gridrender ~/a.scene ~/a.grid -o - --hits -                              > -: written twice
gridrender ~/a.scene ~/a.grid -o - --turntable 2                         > -: {index}
gridrender ~/a.scene ~/a.grid -o ~/new.png --channels colour             > --channels: isn't one of depth
gridrender ~/a.scene ~/a.grid -o ~/new.png --channels depth,             > --channels
gridrender ~/a.scene ~/a.grid -o ~/new.png --channels depth,depth        > --channels: twice
gridrender ~/a.scene ~/a.grid -o ~/new.png --channels depth --channel-format exr
gridrender ~/a.scene ~/a.grid --channels depth --stats ~/new             > --channels: needs -o
gridrender ~/a.scene ~/a.grid -o - --channels depth                      > --channels: file name
gridrender ~/a.scene ~/a.grid -o ~/new.png [--all-rays|--no-picture|--json|--write|--any-hit] > @
gridrender ~/a.scene ~/a.grid -o ~/new.png --channels depth --channel-high 9 > --channel-high: cells and tests
gridrender ~/a.scene ~/a.grid -o ~/new.png [--channel-format npy|--channel-high 1000|--hit-name face] > @option
gridrender ~/a.scene ~/a.grid --hits ~/new [--srgb|--format png]         > @option
gridrender ~/a.scene ~/a.grid -o ~/new.pfm --srgb                        > --srgb: PNG or JPEG
gridrender ~/a.scene ~/a.grid -o ~/new.png --brute-force                 > GRID: isn't used
gridrender ~/a.scene -o ~/new.png --brute-force --first-cell-hit         > --first-cell-hit: needs a grid
gridrender ~/a.scene ~/a.grid -o ~/new.png --hits ~/new.depth.pfm --channels depth > ~/new.depth.pfm: twice
gridrender ~/a.scene ~/a.grid --stats= ~/new -o ~/new.png                > command line: --stats=
gridrender ~/a.scene ~/a.grid --backend cpu --resume --stats ~/new       > --resume
gridrender ~/a.scene ~/a.grid --backend cpu --resume -o -                > -
gridrender ~/a.scene ~/a.grid --backend cpu --resume -o /dev/null --format png > /dev/null
)"};

// Of 17 x 13 rays, of two objects.
constexpr Table gridtrace{"Gridtrace", R"(
gridtrace ~/a.scene ~/a.grid -o ~/new                                    > RAYS
gridtrace ~/a.scene ~/a.grid ~/new                                       > -o
gridtrace ~/a.scene -o ~/new                                             > GRID
gridtrace ~/a.scene --brute-force -o ~/new                               > RAYS
gridtrace ~/a.scene ~/a.grid ~/new -o ~/new --turntable 2                > --turntable
gridtrace ~/a.scene ~/a.grid ~/new -o ~/new -o ~/new2
gridtrace ~/a.scene ~/a.grid ~/new -o ~/new --write [T|t,|,t|t,t|t;object|occluded] > --write
gridtrace ~/a.scene ~/a.grid ~/new -o ~/new --any-hit --write t          > --write
gridtrace ~/a.scene ~/a.grid ~/new -o ~/new --ray-numbers 7
gridtrace ~/a.scene ~/a.grid ~/new[.npy|.csv] -o ~/new --ray-numbers 8   > --ray-numbers: numbers alone
gridtrace ~/a.scene ~/a.grid ~/new[.npy|.csv] -o ~/new --ray-store float64 > --ray-store: numbers alone
gridtrace ~/a.scene ~/a.grid ~/new -o ~/new --hit-name face [--write t|--any-hit|--count-hits] > --hit-name
gridtrace ~/a.scene ~/a.grid [~/new -o ~/new|--ray 0,0,5,0,0,-1] --brute-force > GRID: isn't used
gridtrace ~/a.scene ~/new -o ~/new --brute-force --first-cell-hit        > --first-cell-hit: needs a grid
gridtrace ~/a.scene ~/a.grid ~/new -o ~/new.csv --all-hits 2 --write count,t > --write: count
gridtrace ~/a.scene ~/a.grid --pixel 1,1 [--depth 3|--spd-rules]         > @option: --all-rays
gridtrace ~/a.scene ~/a.grid --pixel 1,1 [--backend cuda|--devices 0|--devices all] > @option: on the CPU
gridtrace ~/a.scene ~/a.grid - -o ~/new --objects=[2|0-2|1-0|a|0,|-1] > --objects
gridtrace ~/a.scene ~/a.grid ~/new -o ~/new.f64                          > -o
gridtrace ~/a.scene ~/a.grid ~/new -o ~/new [--json|--depth 3]           > @option
gridtrace ~/a.scene ~/a.grid [~/new -o ~/new|--ray 0,0,5,0,0,-1] --size 8x8
gridtrace ~/a.scene ~/a.grid ~/new --pixel 1,1                           > RAYS
gridtrace ~/a.scene ~/a.grid --pixel 1,1 -o ~/new                        > --output
gridtrace ~/a.scene ~/a.grid --pixel 1,1 -o -                            > --output: list of rays
gridtrace ~/a.scene ~/a.grid --pixel 1,1 [--stats ~/new|--resume|--turntable 3] > @option
gridtrace ~/a.scene ~/a.grid --pixel 1,1 --ray 0,0,0,1,0,0
gridtrace ~/a.scene ~/a.grid --pixel 1,1 --json=~/a.scene                > ~/a.scene: is the input
gridtrace ~/a.scene ~/a.grid --pixel [17,0|0,13|-1,0]                    > walk: 17 x 13
gridtrace ~/a.scene ~/a.grid --pixel [1|1,|1,2,3|1.5,2|a,b|1,_2|99999999999,1] > --pixel
gridtrace ~/a.scene ~/a.grid --ray [1,2,3|1,2,3,4,5,6,7|x]               > --ray
gridtrace ~/a.scene ~/a.grid --ray [1,2,3,0,0,0|nan,0,0,1,0,0|0,0,0,inf,0,0] > walk: isn't valid
gridtrace ~/a.scene ~/a.grid --resume - -o ~/new                         > RAYS
gridtrace ~/a.scene ~/a.grid --resume ~/new --stats ~/new                > --resume
)"};

constexpr Table gridstat{"Gridstat", R"(
gridstat ~/a.grid --slice [z|z=|w=0|z=-1|z=99999|=0|z=0x|z@|z@x|z@nan|z@1e99|z@1_] -o ~/new.png > --slice
gridstat ~/a.grid --slice [zz=1|z=1.5|z=1e1|z=101%|z=-1%|z=nan%|z=%|z=99999999999999999999] -o ~/new.png > --slice
gridstat ~/a.grid --slice [z=0x1|z=_1|x@0x1p0] -o ~/new.png              > --slice
gridstat ~/a.grid --slice z=0 -o ~/new.svg --window=[1|0,0,1|0,0,1,1,|0,0,1,1,1|1,1,0,0|0,0,0,1] > --window
gridstat ~/a.grid --slice z=0 -o ~/new.svg --window=[nan,0,1,1|0,0,inf,1|100,100,101,101|0;0;1;1|0,0,1,1_] > --window
gridstat ~/a.grid --slice z=0 -o ~/new.svg --size [0|63|4097|-1|x|1e9]
gridstat ~/a.grid --slice z=0 -o ~/new.svg --depth [-1|49|x]
gridstat ~/a.grid --slice z=0 -o ~/new.svg --color volume --color-high 40 > --color-high: references or depth
gridstat ~/a.grid --slice z=0 -o ~/new.svg [--color red|--cells ~/new.csv|--json|--occupied]
gridstat ~/a.grid [--lines|--color depth|--depth 1|--window 0,0,1,1|--outline ~/a.scene|--title a|--size 99]
gridstat ~/a.grid [--occupied|--within 0,0,0,1,1,1|--expanded|--wireframe]
gridstat ~/a.grid --cells [~/new.obj|~/new|~/new.PLY|~/new.csv.gz]       > @
gridstat ~/a.grid --cells ~/new.csv --within=[1|0,0,0,1,1|a,b,c,d,e,f]
gridstat ~/a.grid --cells ~/new.csv --within=[1,1,1,0,0,0|nan,0,0,1,1,1|0,0,0,1,1,inf] > --within
gridstat ~/a.grid --cells ~/new.csv [--expanded|--wireframe]             > @
gridstat ~/a.grid --slice z=0                                            > --slice
gridstat ~/a.grid -o ~/new.png
gridstat ~/a.grid --slice z=0 -o [new.jpg|new.pfm|new|new.PNG|-]         > @
gridstat ~/a.grid [--csv --histogram|--csv --json|--occupancy ~/a.scene|--divisions 4]
gridstat --occupancy ~/a.scene --divisions [0|4,100000]                  > --divisions
)"};

constexpr Table gridbench{"Gridbench", R"(
gridbench tradeoff ~/a.scene -o ~/new [--divisions 0|--curve many]       > division
gridbench tradeoff ~/a.scene -o ~/new --precisions quick
gridbench tradeoff ~/a.scene -o ~/new ~/a.scene                          > @
gridbench tradeoff ~/a.scene -o ~/new --charts-only                      > --charts-only
gridbench tradeoff ~/a.scene -o ~/new --size 24                          > --size
gridbench tradeoff -o ~/new                                              > SCENE
)"};

class UsageErrors : public SmallSceneTest, public testing::WithParamInterface<Table> {};

TEST_P(UsageErrors, AreRefused) {
  expect_refused(1, GetParam().commands);
}

INSTANTIATE_TEST_SUITE_P(Of, UsageErrors,
                         testing::Values(every_tool, makers, gridrender, gridtrace, gridstat, gridbench),
                         [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace masu
