/* Masu: rays traced through voxel grids and hierarchies, on a CPU or a CUDA GPU. The C interface of
 * libmasu.so.
 *
 * A scene is made from arrays (masu_scene_create()) or read from a file, a grid is built from a scene or
 * read; each can be written: files are their bytes, and the tools' files. A tracer puts both on a device
 * once; masu_nearest() and masu_occluded() are its queries. No function writes a file but those that say so.
 *
 * Functions that can fail return a status: MASU_OK, or what went wrong, and masu_error() then says it in one
 * line. After an error nothing was written to the results of a query in host memory that can be relied on. No
 * function terminates the process, and no damaged file and no ray can make one fault; what must be right are
 * pointers, counts and sizes.
 *
 * Structures begin with their size, which the program sets: `masu_query query = {sizeof query};`. So a
 * program and a library of different versions work together, or meet an error: what a newer one added is zero
 * in an older one's structures, and zeros are the defaults unless a function fills in others.
 *
 * Threads: any number may use an object at the same time, except for freeing it. Objects may be freed in any
 * order: a tracer keeps what it uses. Queries of rays in host memory return when their results are there;
 * they use all cores, or on a GPU streams of their own. Queries of rays in device memory are queued on the
 * stream that they are given, and are done when that is; what fails after the call returned is the stream's
 * error (at masu_nearest()).
 *
 * Results don't depend on the grid, on the device, nor on the number of threads: t, primitives and the rest
 * are the same bits on CPU and GPU, but with MASU_PRECISION_FAST. Hits are ordered by t from where the ray
 * enters the scene's bounds, which has more digits than t from a far origin: of two at the same reported t
 * the first is the nearer. Where it is equal, too, the lowest index comes first. Triangles in one plane are
 * at the same t where their corners are the same in the same order; others are a rounding apart.
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
  MASU_ERROR_USAGE = 1,      /* an argument */
  MASU_ERROR_INPUT = 2,      /* a file that can't be read or is invalid */
  MASU_ERROR_OUTPUT = 3,     /* a file that can't be written */
  MASU_ERROR_DEVICE = 4,     /* the GPU or its driver */
  MASU_ERROR_MEMORY = 5,     /* there isn't enough memory in the host */
  MASU_ERROR_INTERRUPTED = 6 /* go_on returned 0 */
} masu_status;

/* Whether a call is to go on: not 0. What takes long calls it about every tenth of a second, on the thread
 * that the call was made on and on no other, until it returns 0: then the call ends in a fraction of a second
 * as MASU_ERROR_INTERRUPTED, and what it uses is as before. `done` is the share of the work that is done,
 * from 0 to 1, as far as that is known. Results are the same with and without. On a GPU it is called between
 * kernels, of lists of rays once for a million; not by queries of rays in device memory, which are only
 * queued. It may call this library, but mustn't free what the call uses. */
typedef int (*masu_go_on)(void* user, double done);

/* What the last call of this thread that failed said: `place: what is wrong: what to do`. Valid until the
 * thread's next call. */
MASU_API const char* masu_error(void);

/* Such as "0.1.0". */
MASU_API const char* masu_version(void);

/* How many GPUs can be used: 0 without CUDA, or without one. */
MASU_API masu_status masu_gpu_count(int* count);

/* --- Scenes -------------------------------------------------------------------------------------------- */

typedef struct masu_scene masu_scene;

/* Triangles: an object. */
typedef struct masu_mesh {
  size_t size;
  const float* vertices;    /* 3 per vertex; or */
  const double* vertices64; /* 3 per vertex */
  size_t vertex_count;
  const uint32_t*
      indices; /* 3 per triangle, below vertex_count; NULL: triangle i has vertices 3i to 3i + 2 */
  size_t triangle_count;
  const float* color; /* 3: of the matte material; NULL: 0.8 each */
} masu_mesh;

/* Spheres, or cones: an object. With negative radii only the inside is visible. */
typedef struct masu_quadrics {
  size_t size;
  const float*
      values; /* per sphere 4: centre, radius; per cone 8: base, radius there, apex, radius there; or */
  const double*
      values64; /* the same. A cone is a truncated one's side, a cylinder's if the radii are equal */
  size_t count;
  const float* color; /* as masu_mesh */
} masu_quadrics;

typedef enum masu_store {
  MASU_STORE_AUTO = 0, /* float32 unless its arithmetic is too coarse for the scene */
  MASU_STORE_FLOAT32 = 1,
  MASU_STORE_FLOAT64 = 2
} masu_store;

/* A mesh where it is in the world: vertices are M v + t, by an fma for each column from the last one on:
 * fma(M0, x, fma(M1, y, fma(M2, z, t))), in the arithmetic of the scene's store, to which v, M and t are
 * rounded first, t after the scene's origin is taken from it. M may be any matrix with an inverse, mirrors
 * too. */
typedef struct masu_placement {
  size_t size;
  double transform[12]; /* rows of M, each followed by its number of t */
  uint32_t mesh;        /* the number of a mesh */
  uint32_t mask;        /* of what hits it (masu_query): 0 means all bits */
  uint32_t world;       /* of the rays that see it, below 2^20; MASU_EVERY_WORLD: of all */
  uint32_t reserved;
} masu_placement;

#define MASU_EVERY_WORLD UINT32_MAX

typedef struct masu_geometry {
  size_t size;
  const masu_mesh* meshes;
  size_t mesh_count;
  const masu_quadrics* spheres;
  size_t sphere_count; /* of the objects */
  const masu_quadrics* cones;
  size_t cone_count;
  /* 3: coordinates are stored relative to it, so that errors follow the scene's extent and not its position
   * in the world. NULL: the bounds' centre, or zero if that is nearer than half their diagonal. */
  const double* origin;
  masu_store store;
  int reserved;
  masu_go_on go_on;                 /* NULL: to its end */
  void* user;                       /* for go_on */
  const masu_placement* placements; /* none: each mesh stands once as it is */
  size_t placement_count;
} masu_geometry;

/* Copies what the arrays hold, which may lie in host memory or a GPU's (colors and the origin in the host's),
 * where what writes them must be done. Primitives are numbered in the order of the arrays, triangles first,
 * then spheres, then cones, and so are objects. Triangles of which two corners are one point are kept, for
 * the numbers' sake, and can't be hit. Camera and lights are automatic ones, for gridrender. */
MASU_API masu_status masu_scene_create(const masu_geometry* geometry, masu_scene** scene);

/* Placed meshes. Each mesh is stored once, and a hierarchy of it is built once, however often it is placed;
 * what placements change is the hierarchy above them, by masu_tracer_place(). Spheres and cones stand beside
 * them. Hits are those of a scene of this store that has all placed vertices written out, relative to this
 * scene's origin as the rays are, to the bit, whatever the structure; there may be as many triangles, each
 * counted as often as it is placed, as such a scene may hold, 2^31 - 1. They are named differently: an object
 * is a placement's number, and from placement_count on one of the arrays of spheres and cones; a primitive
 * the triangle's number within its mesh, or that of a sphere or cone among them. Of hits at the same t the
 * lowest of both comes first.
 *
 * Such a scene isn't written, and no grid is built of it. MASU_STORE_AUTO is float32. The origin's default is
 * that of the boxes around what is placed, as are the described bounds and error_bound; triangles and bytes
 * are those that are stored. */

/* Reads and checks a scene file, of these functions or of nff2bin and mesh2bin. What happens to the file
 * afterwards changes nothing; one that is written while it is read is an error (MASU_ERROR_INPUT). */
MASU_API masu_status masu_scene_read(const char* path, masu_scene** scene);

/* Whole or not at all. */
MASU_API masu_status masu_scene_write(const masu_scene* scene, const char* path);

/* NULL is allowed. */
MASU_API void masu_scene_free(masu_scene* scene);

typedef struct masu_scene_description {
  size_t size;
  uint32_t triangles, spheres, cones; /* primitives are numbered in this order */
  uint32_t materials;
  uint64_t objects;
  double bounds_min[3], bounds_max[3]; /* of all primitives, in the world; min > max where there is none */
  double origin[3];                    /* the point in the world that stored coordinates are relative to */
  double error_bound; /* in scene units: how far from its surface a hit may be, with MASU_PRECISION_AUTO */
  uint64_t bytes;     /* in memory, and of its file */
  int is_float64;     /* whether coordinates are stored, and rays traced, in float64 */
  int reserved;
} masu_scene_description;

MASU_API masu_status masu_scene_describe(const masu_scene* scene, masu_scene_description* description);

typedef enum masu_kind { MASU_TRIANGLE = 0, MASU_SPHERE = 1, MASU_CONE = 2 } masu_kind;

typedef struct masu_primitive {
  size_t size;
  masu_kind kind;
  uint32_t object;   /* index in the NFF text, or of the mesh */
  uint32_t material; /* index */
  uint32_t face;     /* as masu_hits has it */
  float color[3], diffuse, specular, shine, transmittance, refraction_index; /* of the material */
} masu_primitive;

/* `index` is a primitive's, as hits report it. */
MASU_API masu_status masu_scene_primitive(const masu_scene* scene, uint32_t index, masu_primitive* primitive);

/* How many faults there are of a kind, and the first of them, up to 8: by the triangle, and for edges by the
 * corner, 0 to 2, from which the edge runs to the triangle's next one. */
typedef struct masu_faults {
  uint64_t count;
  uint32_t primitives[8], corners[8];
} masu_faults;

/* A scene's triangles, all as one mesh. Corners with the same stored coordinates are one point; edges have a
 * length, and are of triangles that can be hit. */
typedef struct masu_mesh_check {
  size_t size;
  uint64_t points, edges;
  /* Edges of an odd number of triangles. Where there is none, every line crosses the mesh an even number of
   * times, so the parity of masu_count_hits() tells inside from outside. */
  masu_faults open_edges;
  /* Of an even number of triangles that don't run along it half each way. Where there is none either, lines
   * enter as often as they leave, as masu_inside() needs. */
  masu_faults inconsistent_edges;
  masu_faults nonmanifold_edges;  /* of more than two */
  masu_faults faces_without_area; /* corners on a line, exactly, or one point */
  masu_faults duplicate_faces;    /* of the same points as one before, in any order */
} masu_mesh_check;

/* Its size must be set. Spheres, which are closed, and cones, which aren't, are left out. */
MASU_API masu_status masu_scene_check(const masu_scene* scene, masu_mesh_check* check);

/* --- Grids --------------------------------------------------------------------------------------------- */

typedef struct masu_grid masu_grid;

#define MASU_CPU (-1)

typedef enum masu_structure {
  MASU_STRUCTURE_GRID = 0,
  MASU_STRUCTURE_BVH = 1, /* a bounding volume hierarchy: no voxels */
  /* Whichever of both a sample of rays is expected to take the least time through, on what for_cpu says. If
   * a merge rule or a division is given, that grid. */
  MASU_STRUCTURE_FASTEST = 2,
  MASU_STRUCTURE_AUTO = 3 /* the default: a hierarchy; if a merge rule or a division is given, that grid */
} masu_structure;

typedef enum masu_merge {
  MASU_MERGE_AUTO = 0, /* none where a division is given, else none or irregular by a sample of rays */
  MASU_MERGE_NONE = 1,
  MASU_MERGE_X = 2,
  MASU_MERGE_BALANCE = 3,
  MASU_MERGE_IRREGULAR = 4
} masu_merge;

/* Of a hierarchy: high divides primitives where boxes would overlap; fast takes a third of the time. */
typedef enum masu_quality { MASU_QUALITY_HIGH = 0, MASU_QUALITY_FAST = 1 } masu_quality;

/* As gridbuild's options. masu_default_build_options() fills in the defaults, which aren't all zero; NULL
 * instead of the options means them. */
typedef struct masu_build_options {
  size_t size;
  masu_structure structure;
  masu_merge merge;     /* which voxels of a grid share a cell */
  const char* division; /* "auto", "64", "64x64x32", "cleary:1", …; NULL: "auto" */
  int box_overlap;      /* not 0: a voxel lists whose bounding box meets it, else whose surface does */
  int cube_space; /* not 0: the smallest cube about the origin is divided, else the primitives' bounds */
  double alpha, step_cost, detail;
  uint32_t target;
  int nested, expand;
  int device;  /* where to build: a GPU's number, or MASU_CPU; the grid is the same */
  int threads; /* 0: all cores */
  int for_cpu; /* not 0: what is chosen automatically is chosen for tracing on a CPU, else on a GPU */
  masu_quality quality;
  int reserved;
  masu_go_on go_on; /* NULL: to its end */
  void* user;       /* for go_on */
} masu_build_options;

/* Its size must be set. */
MASU_API masu_status masu_default_build_options(masu_build_options* options);

MASU_API masu_status masu_grid_build(const masu_scene* scene, const masu_build_options* options,
                                     masu_grid** grid);

/* A hierarchy of a scene whose primitives have moved: `scene` is made of as many as the one that `grid` was
 * built from, in their order. Nodes and references are `grid`'s, their boxes are computed again, which takes
 * a tenth of a build or less. Hits are those through a grid that is built anew; rays take longer the more the
 * neighbourhood of primitives has changed. Build with MASU_QUALITY_FAST what will move: what
 * MASU_QUALITY_HIGH has divided is whole again. Where a triangle of which two corners were one point can be
 * hit now, a hierarchy is built anew. */
MASU_API masu_status masu_grid_refit(const masu_grid* grid, const masu_scene* scene, masu_grid** refitted);

/* As masu_scene_read() and masu_scene_write(). */
MASU_API masu_status masu_grid_read(const char* path, masu_grid** grid);
MASU_API masu_status masu_grid_write(const masu_grid* grid, const char* path);

/* NULL is allowed. */
MASU_API void masu_grid_free(masu_grid* grid);

typedef struct masu_grid_description {
  size_t size;
  masu_structure structure; /* grid or bvh */
  masu_merge merge;         /* never MASU_MERGE_AUTO */
  uint32_t division[3];     /* voxels along each axis; of an irregular grid at the top */
  uint32_t reserved;
  uint64_t cells, nodes; /* cells of a merged grid, nodes of a bvh; else 0 */
  uint64_t references, bytes;
} masu_grid_description;

MASU_API masu_status masu_grid_describe(const masu_grid* grid, masu_grid_description* description);

/* --- Tracers ------------------------------------------------------------------------------------------- */

typedef struct masu_tracer masu_tracer;

/* Zeros are the defaults, and NULL instead means them: on the CPU. */
typedef struct masu_tracer_options {
  size_t size;
  /* GPUs by their numbers, from 0; none: on the CPU. Each gets scene and grid. They share queries of rays in
   * host memory; rays in the memory of one of them are traced by that one. */
  const int* gpus;
  size_t gpu_count;
  int brute_force; /* not 0: without a grid every ray is tested against every primitive, for comparison */
  masu_quality quality; /* of the hierarchies of placed meshes */
  masu_go_on go_on;     /* of the build where there is no grid; NULL: to its end */
  void* user;           /* for go_on */
} masu_tracer_options;

/* `grid` must be of the scene's geometry. Where it is NULL, what answers soonest is built: on each device a
 * hierarchy of MASU_QUALITY_FAST, or on the first one a grid where the scene is too large for that. */
MASU_API masu_status masu_tracer_create(const masu_scene* scene, const masu_grid* grid,
                                        const masu_tracer_options* options, masu_tracer** tracer);

/* Where the vertices of a scene's triangles are now. */
typedef struct masu_vertices {
  size_t size;
  const float* values;    /* 3 per vertex, in the world; or */
  const double* values64; /* the same */
  size_t count;           /* as many as the scene was made of: of all meshes, one after the other; of a scene
                             from a file three per triangle */
  void* stream;           /* cudaStream_t that writes those in device memory; NULL: the default stream */
} masu_vertices;

/* Moves the triangles of the tracer's scene, between the same vertices as before, and refits its hierarchy
 * (masu_grid_refit() says what that is worth); spheres and cones stay. On GPUs all of it happens in their
 * memory, where the vertices may lie, too: two million triangles take some milliseconds. Hits are those of a
 * new scene of these vertices with the same origin and store, and so is the error bound, which follows the
 * coordinates that are farthest from that origin.
 *
 * The scene and the grid that the tracer was made of stay as they are: the tracer alone has moved, and they
 * may be shared. When the call returns, it has, and the vertices aren't needed any more. Queries that other
 * threads have under way are of the positions before or after, all rays of one alike; what was queued on a
 * GPU before is of those before, and is waited for.
 *
 * After an error the tracer is as it was: MASU_ERROR_USAGE for a tracer without a hierarchy, another number
 * of vertices, coordinates that aren't finite or that the scene's store doesn't hold. */
MASU_API masu_status masu_tracer_update(masu_tracer* tracer, const masu_vertices* vertices);

/* Where placements are now. */
typedef struct masu_transforms {
  size_t size;
  const float* values;     /* 12 each, as masu_placement has them; or */
  const double* values64;  /* the same */
  size_t count;            /* all of the scene's; or as many as there are indices */
  const uint32_t* indices; /* of each the placement's number, of one that is there twice the last counts;
                              NULL: in their order */
  int square;              /* not 0: 16 each, of which the last four aren't read */
  int reserved;
  void* stream; /* cudaStream_t that writes those in device memory; NULL: the default stream */
} masu_transforms;

/* Moves placements of the tracer's scene; as masu_tracer_update() it is of this tracer alone, queries are of
 * before or after, and after an error the tracer is as it was: MASU_ERROR_USAGE for another number of
 * transforms, one without an inverse or that scales by more than 2^40 or its inverse does, and what reaches
 * too far. */
MASU_API masu_status masu_tracer_place(masu_tracer* tracer, const masu_transforms* transforms);

/* What a tracer traces through, given or built; of what GPUs have built, a copy. An error for brute force; of
 * a tracer that was moved on a GPU, what it was before. */
MASU_API masu_status masu_tracer_grid(const masu_tracer* tracer, masu_grid** grid);

/* Waits for what runs, and gives memory back. NULL is allowed. */
MASU_API void masu_tracer_free(masu_tracer* tracer);

/* --- Queries ------------------------------------------------------------------------------------------- */

/* The points origin + t direction with tmin < t < tmax, 0 <= tmin, of t as it is reported; a hit's t depends
 * on neither: a ray that goes on with its last hit's t as tmin doesn't find that hit again. t counts in
 * lengths of the direction, which may be any. A ray hits nothing if a number is NaN, tmin >= tmax, the origin
 * is infinite or beyond 1e15 (in double arithmetic 1e105), or the direction's largest component isn't from
 * 1e-15 to 1e15. A negative tmin counts as 0. */
typedef struct masu_ray {
  float origin[3], tmin;
  float direction[3], tmax; /* tmax may be INFINITY */
} masu_ray;

/* Traced in float32 arithmetic (MASU_PRECISION_ROBUST, MASU_PRECISION_FAST), it goes on in double until it is
 * near the scene, and is rounded there; t counts from its origin. */
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

typedef enum masu_faces { MASU_FACES_BOTH = 0, MASU_FACES_FRONT = 1, MASU_FACES_BACK = 2 } masu_faces;

/* How a GPU schedules rays for nearest hits and occlusion without filters, sides, t64 and front; of others it
 * is chosen. Results are the same. */
typedef enum masu_loop {
  MASU_LOOP_AUTO = 0, /* by a look at the rays; through a grid by a sample of them or of the scene's */
  MASU_LOOP_THREAD_PER_RAY = 1, /* neighbours that take equally long: primary rays, few hits */
  MASU_LOOP_WARP = 2,           /* similar ones through a grid, where some try many primitives; through a
                                   hierarchy MASU_LOOP_THREAD_PER_RAY */
  MASU_LOOP_WARP_REFILL = 3     /* that differ: threads that are done fetch the next ray */
} masu_loop;

/* Zeros are the defaults; NULL instead of a query means them. */
typedef struct masu_query {
  size_t size;
  masu_ray_format format;
  masu_precision precision;
  int coherent; /* not 0: neighbours have similar origins and directions: how a GPU schedules them; results
                   are the same */
  int relative; /* not 0: the rays' origins are relative to the scene's (masu_scene_description), where floats
                   keep their digits, and rays on a GPU needn't be copied; 0: they are in the world */
  void* stream; /* cudaStream_t of rays in device memory; NULL: the default stream */
  int threads;  /* of the host, for rays in its memory; 0: all cores */
  masu_faces faces;        /* that are hit */
  const uint32_t* exclude; /* where the rays are: for each a primitive that it doesn't hit, or MASU_NONE; such
                              as the one that it starts on. NULL: none */
  /* Where the rays are. An object is hit by rays whose mask shares a bit with its own (Embree's ray masks):
   * bits for each of the scene's objects, and for each ray. Without ray_masks rays have all bits, and masks
   * of 1 and 0 say which objects are hit. NULL: all are. */
  const uint32_t* object_masks;
  size_t object_count; /* of object_masks: the scene's */
  const uint32_t* ray_masks;
  masu_loop loop;
  int reserved;
  masu_go_on go_on; /* NULL: to its end */
  void* user;       /* for go_on */
  /* Of placed meshes alone, where the rays are. exclude_objects: of each ray the object whose primitive
   * `exclude` is, both or neither. worlds: the one that a ray is in, of whose placements it hits those of its
   * world and of every world; NULL: 0. With ray_masks alone the placements' own masks count; with
   * object_masks both. */
  const uint32_t* exclude_objects;
  const uint32_t* worlds;
} masu_query;

#define MASU_NONE UINT32_MAX

/* Arrays of `count` elements, or NULL for what isn't wanted. */
typedef struct masu_hits {
  size_t size;
  float* t;            /* in lengths of the direction; infinity for a miss */
  uint32_t* primitive; /* its index; MASU_NONE for a miss */
  uint32_t* object;    /* as masu_primitive has it; MASU_NONE for a miss */
  float* uv;           /* 2 per ray: a triangle's point is (1 - u - v) a + u b + v c; 0 on others */
  float* normal;       /* 3 per ray: geometric, unit length, on the primitive's front; 0 for a miss */
  uint32_t* face; /* of a scene from mesh2bin, the number of the file's face, through all objects in their
                     order; of others as primitive; MASU_NONE for a miss */
  double* t64;    /* t, with all digits that the query's precision has */
  uint8_t* front; /* 1 where the ray meets the front, else 0: exactly; of lists of all hits so that their sum
                   * is right for closed meshes, also where they are met at an edge or by a sliver */
  double* position; /* 3 per ray: the point of the primitive that is hit, in the rays' coordinates; NaN for a
                       miss */
  float* shading;   /* 3 per ray: the shading normal, of unit length: interpolated between the normals at the
                       corners where a scene from a file has them, else as `normal` */
} masu_hits;

/* Values at the corners of triangles: rows of `width` floats. */
typedef struct masu_values {
  size_t size;
  const float* values;
  size_t width, count; /* floats of a row; rows */
  /* 3 per triangle: the rows of its corners; NULL: triangle i has rows 3i to 3i + 2. */
  const uint32_t* indices;
  size_t triangle_count;
  int per_face; /* not 0: triangle i has row i at all its corners, and indices are NULL */
  int reserved;
  void* stream; /* cudaStream_t where arrays lie in device memory; NULL: the default stream */
} masu_values;

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

/* (1 - u - v) a + u b + v c for each hit, as masu_hits has primitive and uv: a row of `width` floats each, of
 * the values at the hit triangle's corners; rounded once or twice. Zeros for what is no triangle of `values`,
 * such as a miss, and where a corner's index isn't a row's. All arrays lie in host memory, or all in the
 * memory of one GPU, where the work is queued on the stream; per_face needs no uv. */
MASU_API masu_status masu_interpolate(const masu_values* values, const uint32_t* primitive, const float* uv,
                                      size_t count, float* interpolated);

/* Whether each ray hits anything: 1 or 0. */
MASU_API masu_status masu_occluded(const masu_tracer* tracer, const void* rays, size_t count,
                                   const masu_query* query, uint8_t* occluded);

/* The first `limit` hits of each ray, from 1 to 2^31 - 1, in their order: each array of `hits` has a row of
 * `limit` elements for each ray, the hits and then misses. counts: how many hits a row has; may be NULL.
 *
 * Hits are crossings: where a ray passes an edge or a corner that triangles share, one of those on either
 * side is crossed, so that every line crosses a closed mesh as often inwards as outwards, exactly. Spheres
 * are crossed twice, and cones, which have no caps, up to twice; where only the inside is visible, once.
 *
 * MASU_PRECISION_FAST is an error here, and with faces, exclude, masks, t64 and front. */
MASU_API masu_status masu_all_hits(const masu_tracer* tracer, const void* rays, size_t count,
                                   const masu_query* query, uint32_t limit, const masu_hits* hits,
                                   uint32_t* counts);

/* How many hits each ray has, all of them. */
MASU_API masu_status masu_count_hits(const masu_tracer* tracer, const void* rays, size_t count,
                                     const masu_query* query, uint32_t* counts);

/* Whether each ray starts inside the surfaces, whose fronts are outside: 1 where one more of its hits
 * is of a back than of a front, 0 where as many are; else 2, and the surfaces aren't closed, or their fronts
 * not outside, or one lies in another. Any direction will do. An origin that is nearer to a surface than
 * error_bound (masu_scene_description) may be on either side of it. */
MASU_API masu_status masu_inside(const masu_tracer* tracer, const void* rays, size_t count,
                                 const masu_query* query, uint8_t* inside);

/* The generalised winding number of the triangles about each place, as masu_closest() has them: 1 in a closed
 * mesh whose fronts are outside, 0 outside; where surfaces are open, overlap or are turned, the sum of what
 * the place sees of them, signed solid angles over 4 pi. winding: within `bound`, from 0 to 1, but for
 * roundings; inside: 1 where the number is at least 1/2, else 0, which is exact unless the number is nearer
 * to 1/2 than `bound`. Either may be NULL; inside alone takes less time. Of a place that masu_closest() finds
 * nothing for the number is NaN. On the surface it may be that of either side.
 *
 * On the CPU, wherever the tracer is, and the same with any number of threads; with another hierarchy numbers
 * differ within the bound. MASU_ERROR_USAGE where the scene has spheres, cones or placements, with exclude
 * and masks, and by a tracer that was moved on a GPU. */
MASU_API masu_status masu_winding(const masu_tracer* tracer, const void* places, size_t count,
                                  const masu_query* query, double bound, double* winding, uint8_t* inside);

/* The point of the surfaces that is closest to each place. places: 3 numbers each, floats
 * where query->format is MASU_RAYS_FLOAT32, doubles where it is MASU_RAYS_FLOAT64. points: 3 numbers of each
 * closest point, in the places' coordinates; may be NULL. Of `hits`, which may be NULL, t and t64 are the
 * distance, uv and normal those of the point; front must be NULL, for at an edge neither side is nearer
 * (masu_inside() tells). Where there is no surface, or a number of the place is NaN or beyond 1e37, t is
 * infinite and the point NaN. Of primitives at the same distance the one with the lowest index is reported.
 *
 * Places and results lie where rays and results may, and are queued likewise (masu_nearest()). Of the query,
 * exclude and masks say what isn't looked for; `threads`, `relative` and `stream` are as for rays. All is
 * computed in double: off by some roundings of the largest coordinate. Where the tracer's grid isn't a
 * hierarchy, the first call builds one, and on GPUs puts the scene there once more. */
MASU_API masu_status masu_closest(const masu_tracer* tracer, const void* places, size_t count,
                                  const masu_query* query, const masu_hits* hits, double* points);

/* NOLINTEND(modernize-use-using) */
#ifdef __cplusplus
}
#endif

#endif
