/* Masu: rays traced through voxel grids, on a CPU or a CUDA GPU. The C interface of libmasu.so.
 *
 * Offline: masu_write_scene() makes a scene file (as nff2bin and mesh2bin do), masu_build_grid() a grid file
 * (as gridbuild does). Then masu_open() reads both, checks them, and puts them on a device once;
 * masu_nearest() and masu_occluded() are its queries, until masu_close().
 *
 * Functions that can fail return a status: MASU_OK, or what went wrong, and masu_error() then says it in one
 * line. After an error nothing was written to the results of a query in host memory that can be relied on. No
 * function terminates the process, and no damaged file and no ray can make one fault; what must be right are
 * pointers and counts.
 *
 * Threads: a tracer may be used by several threads at the same time, except for masu_close(). Queries of rays
 * in host memory return when their results are there; they use all cores, or on a GPU streams of their own.
 * Queries of rays in device memory are queued on the stream that they are given, and are done when that is;
 * what fails after the call returned is the stream's error (at masu_nearest()).
 *
 * Results don't depend on the grid, on the device, nor on the number of threads: t, primitives and the rest
 * are the same bits on CPU and GPU, but with MASU_PRECISION_FAST. Of hits at the same t the primitive with
 * the lowest index is reported.
 */
#ifndef MASU_H
#define MASU_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define MASU_API __attribute__((visibility("default")))
#else
#define MASU_API
#endif

#ifdef __cplusplus
extern "C" {
#endif
/* NOLINTBEGIN(modernize-use-using): C */

/* The first four are the tools' exit codes. */
typedef enum masu_status {
  MASU_OK = 0,
  MASU_ERROR_USAGE = 1,  /* an argument */
  MASU_ERROR_INPUT = 2,  /* a file that can't be read or is invalid */
  MASU_ERROR_OUTPUT = 3, /* a file that can't be written */
  MASU_ERROR_DEVICE = 4, /* the GPU or its driver */
  MASU_ERROR_MEMORY = 5  /* there isn't enough memory in the host */
} masu_status;

/* What the last call of this thread that failed said: `place: what is wrong: what to do`. Valid until the
 * thread's next call. */
MASU_API const char* masu_error(void);

/* Such as "0.1.0". */
MASU_API const char* masu_version(void);

/* How many GPUs can be used: 0 without CUDA, or without one. */
MASU_API masu_status masu_gpu_count(int* count);

/* --- Tracers ------------------------------------------------------------------------------------------- */

typedef struct masu_tracer masu_tracer;

#define MASU_CPU (-1)

/* Reads, checks and, on a GPU, uploads a scene file and a grid file of the same geometry. `device` is
 * MASU_CPU or a GPU's number, from 0. What happens to the files afterwards changes nothing; a file that is
 * written while it is read is an error (MASU_ERROR_INPUT).
 *
 * `grid` may be NULL: then a grid is built as masu_build_grid() builds MASU_GRID_FASTEST for and on the
 * device, and kept in memory. That takes seconds for some million primitives, at every call; a grid file
 * takes them once.
 */
MASU_API masu_status masu_open(const char* scene, const char* grid, int device, masu_tracer** tracer);

/* The same on several GPUs, by their numbers; none: on the CPU. Each GPU gets the files. They share queries
 * of rays in host memory; rays in the memory of one of them are traced by that one. Results are independent
 * of the number of GPUs. */
MASU_API masu_status masu_open_devices(const char* scene, const char* grid, const int* gpus, size_t gpu_count,
                                       masu_tracer** tracer);

/* Without a grid: every ray is tested against every primitive, which only comparisons want. On the CPU if
 * there are no GPUs. */
MASU_API masu_status masu_open_brute_force(const char* scene, const int* gpus, size_t gpu_count,
                                           masu_tracer** tracer);

/* Waits for what runs, and gives memory back. NULL is allowed. */
MASU_API void masu_close(masu_tracer* tracer);

typedef struct masu_description {
  uint32_t triangles, spheres, cones; /* primitives are numbered in this order */
  uint32_t materials;
  double bounds_min[3], bounds_max[3]; /* of all primitives, in the world; min > max where there is none */
  uint64_t scene_bytes, grid_bytes;    /* of the files, or as a file for a grid in memory; 0 for no grid */
  int is_float64;                      /* whether coordinates are stored, and rays traced, in float64 */
  int device;                          /* the first one, or MASU_CPU */
  double origin[3];                    /* the point in the world that stored coordinates are relative to */
  double error_bound; /* in scene units: how far from its surface a hit may be, with MASU_PRECISION_AUTO */
} masu_description;

MASU_API masu_status masu_describe(const masu_tracer* tracer, masu_description* description);

typedef enum masu_kind { MASU_TRIANGLE = 0, MASU_SPHERE = 1, MASU_CONE = 2 } masu_kind;

typedef struct masu_primitive {
  masu_kind kind;
  uint32_t object;   /* index in the NFF text, or of the mesh */
  uint32_t material; /* index */
  float color[3], diffuse, specular, shine, transmittance, refraction_index; /* of the material */
} masu_primitive;

/* `index` is a primitive's, as hits report it. */
MASU_API masu_status masu_describe_primitive(const masu_tracer* tracer, uint32_t index,
                                             masu_primitive* primitive);

/* --- Queries ------------------------------------------------------------------------------------------- */

/* The points origin + t direction with tmin < t < tmax, 0 <= tmin. t counts in lengths of the direction,
 * which may be any. A ray hits nothing if a number is NaN, tmin >= tmax, the origin is infinite or beyond
 * 1e15 (in double arithmetic 1e105), or the direction's largest component isn't from 1e-15 to 1e15. A
 * negative tmin counts as 0. */
typedef struct masu_ray {
  float origin[3], tmin;
  float direction[3], tmax; /* tmax may be INFINITY */
} masu_ray;

typedef struct masu_ray64 {
  double origin[3], tmin;
  double direction[3], tmax;
} masu_ray64;

typedef enum masu_ray_format {
  MASU_RAYS_FLOAT32 = 0,   /* masu_ray */
  MASU_RAYS_FLOAT32_6 = 1, /* 6 floats: origin, direction; tmin is 0, tmax infinity */
  MASU_RAYS_FLOAT64 = 2,   /* masu_ray64 */
  MASU_RAYS_FLOAT64_6 = 3  /* 6 doubles */
} masu_ray_format;

typedef enum masu_precision {
  MASU_PRECISION_AUTO = 0,   /* robust; double for a scene in float64 */
  MASU_PRECISION_FAST = 1,   /* float32 by textbook formulas: for comparison */
  MASU_PRECISION_ROBUST = 2, /* float32, watertight triangles, bounded errors */
  MASU_PRECISION_DOUBLE = 3
} masu_precision;

/* Zeros are the defaults; NULL instead of a query means them. */
typedef struct masu_query {
  masu_ray_format format;
  masu_precision precision;
  int coherent; /* not 0: neighbours have similar origins and directions: how a GPU schedules fewer than four
                   million rays, or any in its memory; results are the same */
  void* stream; /* cudaStream_t of rays in device memory; NULL: the default stream */
  int relative; /* not 0: the rays' origins are relative to the scene's (masu_description), where floats keep
                   their digits, and rays on a GPU needn't be copied; 0: they are in the world */
} masu_query;

#define MASU_NONE UINT32_MAX

/* Arrays of `count` elements, or NULL for what isn't wanted. */
typedef struct masu_hits {
  float* t;            /* in lengths of the direction; infinity for a miss */
  uint32_t* primitive; /* its index; MASU_NONE for a miss */
  uint32_t* object;    /* as masu_primitive has it; MASU_NONE for a miss */
  float* uv;           /* 2 per ray: a triangle's point is (1 - u - v) a + u b + v c; 0 on others */
  float* normal;       /* 3 per ray: geometric, unit length, on the primitive's front; 0 for a miss */
  uint32_t* face; /* of a scene from mesh2bin, the number of the file's face, through all objects in their
                     order; of others as primitive; MASU_NONE for a miss */
} masu_hits;

/* The nearest hit of each ray. Rays and results all lie in host memory, or all in memory of a GPU of
 * the tracer's, which is found out from the pointers (with a tracer on the CPU: in host memory). Rays need
 * the alignment of their numbers; rays on a GPU are traced where they lie if they are MASU_RAYS_FLOAT32
 * aligned to 16 bytes, else a copy is.
 *
 * Of rays in device memory the status says whether the query could be queued: arguments, memory for copies,
 * launches. A kernel that fails afterwards (say because its memory was freed too early) is reported as CUDA
 * reports it: by the next call that looks at the stream or waits for it (cudaStreamQuery(),
 * cudaStreamSynchronize()), or as MASU_ERROR_DEVICE by a later query on that GPU. Results are valid once the
 * stream was found done without an error. Arrays must stay until it is done, also where the query returned an
 * error. After a late error the process can do nothing more on that GPU: close the tracer, and start another
 * process. */
MASU_API masu_status masu_nearest(const masu_tracer* tracer, const void* rays, size_t count,
                                  const masu_query* query, const masu_hits* hits);

/* Whether each ray hits anything: 1 or 0. */
MASU_API masu_status masu_occluded(const masu_tracer* tracer, const void* rays, size_t count,
                                   const masu_query* query, uint8_t* occluded);

/* --- Offline ------------------------------------------------------------------------------------------- */

/* Triangles: an object. Zeros are defaults. */
typedef struct masu_mesh {
  const float* vertices;    /* 3 per vertex; or */
  const double* vertices64; /* 3 per vertex */
  size_t vertex_count;
  const uint32_t* indices; /* 3 per triangle, below vertex_count */
  size_t triangle_count;
  const float* color; /* 3: of the matte material; NULL: 0.8 each */
} masu_mesh;

typedef enum masu_store {
  MASU_STORE_AUTO = 0, /* float32 unless its arithmetic is too coarse for the scene */
  MASU_STORE_FLOAT32 = 1,
  MASU_STORE_FLOAT64 = 2
} masu_store;

/* Writes a scene file, whole or not at all. Triangle i of mesh m is primitive i plus the triangles of the
 * meshes before m, and of object m. Triangles without area are kept, for the numbers' sake, and can't be hit.
 * Camera and lights are automatic ones, for gridrender.
 *
 * Coordinates are stored relative to `origin`, 3 numbers, so that errors follow the scene's extent and not
 * its position in the world. NULL: the bounds' centre, or zero if that is nearer than half their diagonal. */
MASU_API masu_status masu_write_scene(const char* path, const masu_mesh* meshes, size_t mesh_count,
                                      masu_store store, const double* origin);

typedef enum masu_grid_kind {
  MASU_GRID_AUTO = 0,
  MASU_GRID_UNIFORM = 1,
  MASU_GRID_X = 2,
  MASU_GRID_BALANCE = 3,
  MASU_GRID_IRREGULAR = 4,
  MASU_GRID_BVH = 5,    /* a bounding volume hierarchy: no voxels */
  MASU_GRID_FASTEST = 6 /* a grid or bvh: what a sample of rays is expected to take the least time through */
} masu_grid_kind;

/* As gridbuild's options. masu_default_grid_options() fills in the defaults; NULL instead means them. */
typedef struct masu_grid_options {
  masu_grid_kind kind;
  const char* division; /* "auto", "64", "64x64x32", "cleary:1", … */
  int box_overlap;      /* not 0: a voxel lists whose bounding box meets it, else whose surface does */
  int cube_space; /* not 0: the smallest cube about the origin is divided, else the primitives' bounds */
  uint32_t target;
  double alpha, step_cost, detail;
  int nested, expansions;
  int gpu;     /* not 0: built on the first GPU */
  int threads; /* 0: all cores */
  int for_cpu; /* not 0: what is chosen automatically is chosen for tracing on a CPU, else on a GPU */
} masu_grid_options;

MASU_API void masu_default_grid_options(masu_grid_options* options);

/* Writes the grid file of a scene file, whole or not at all. */
MASU_API masu_status masu_build_grid(const char* scene, const char* grid, const masu_grid_options* options);

/* NOLINTEND(modernize-use-using) */
#ifdef __cplusplus
}
#endif

#endif
