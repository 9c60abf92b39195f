/*
 * Inkedge for C: models in, line drawings, maps and lines out. The same calls as in C++ (inkedge/inkedge.h).
 *
 * Every function that may fail returns an inkedge_status; inkedge_message() says what was expected and what was found.
 * What it hands out through its last argument is then NULL, and otherwise belongs to the caller, who gives it to the
 * function named _free; those take NULL, too. Where settings are taken NULL stands for the defaults.
 *
 * Handles of one renderer may be used by one thread at a time, but for inkedge_renderer_stop(); all others may be read
 * by several threads at once. Matrices are rows first, for column vectors.
 */
#ifndef INKEDGE_H
#define INKEDGE_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define INKEDGE_C_API __attribute__((visibility("default")))
#else
#define INKEDGE_C_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* The exit codes of the command. */
typedef enum inkedge_status {
    INKEDGE_OK = 0,
    INKEDGE_RUNTIME = 1, /* something failed while drawing: out of memory, an OpenGL error */
    INKEDGE_USAGE = 2,   /* a setting or an argument is wrong */
    INKEDGE_INPUT = 3,   /* a file cannot be read or holds what is not supported */
    INKEDGE_CONTEXT = 4, /* no usable OpenGL context */
    INKEDGE_OUTPUT = 5,  /* a result cannot be written */
    INKEDGE_STOPPED = 6  /* inkedge_renderer_stop() was called */
} inkedge_status;

/* The last failure of a call by this thread, in one line; "" if there was none. Valid until the next failure. */
INKEDGE_C_API const char* inkedge_message(void);

/* "0.1.0" */
INKEDGE_C_API const char* inkedge_version(void);

/* ---- Settings: all that the command's flags set, by their names without dashes ---- */

typedef struct inkedge_settings inkedge_settings;

INKEDGE_C_API inkedge_status inkedge_settings_create(inkedge_settings** settings);
INKEDGE_C_API void inkedge_settings_free(inkedge_settings* settings);

/* Sets one from text: inkedge_set(settings, "line-width", "2"). INKEDGE_USAGE: no setting has the name, or it cannot
   take the text. */
INKEDGE_C_API inkedge_status inkedge_set(inkedge_settings* settings, const char* name, const char* text);
/* The value as text that inkedge_set() takes, "" where none is given; NULL: no setting has the name. Valid until the
   next call with these settings. */
INKEDGE_C_API const char* inkedge_get(inkedge_settings* settings, const char* name);
/* Sets what a preset ("technical") or a configuration file says. */
INKEDGE_C_API inkedge_status inkedge_set_preset(inkedge_settings* settings, const char* name);
INKEDGE_C_API inkedge_status inkedge_read_config(inkedge_settings* settings, const char* file);

/* ---- Arrays ---- */

typedef enum inkedge_type {
    INKEDGE_FLOAT32,
    INKEDGE_FLOAT64,
    INKEDGE_UINT8,
    INKEDGE_UINT16,
    INKEDGE_UINT32,
    INKEDGE_UINT64,
    INKEDGE_INT32,
    INKEDGE_INT64
} inkedge_type;

/* A table of the caller's numbers, in the machine's byte order; nothing need be aligned. */
typedef struct inkedge_array {
    const void* data; /* the number in row 0 and column 0 */
    inkedge_type type;
    size_t rows;             /* 0: there is no such array */
    size_t columns;          /* numbers a row */
    ptrdiff_t row_stride;    /* bytes from a number to that of the next row; 0: rows are packed */
    ptrdiff_t column_stride; /* bytes from a number to that of the next column; 0: packed */
} inkedge_array;

/* The samples of an image of the library's; row 0 is the top row. */
typedef struct inkedge_buffer {
    const void* data; /* of the pixel in the top left corner; valid as long as what it was asked of */
    inkedge_type type;
    int32_t width;
    int32_t height;
    int32_t channels;       /* side by side in each pixel */
    ptrdiff_t row_stride;   /* bytes */
    ptrdiff_t pixel_stride; /* bytes */
} inkedge_buffer;

/* ---- Scenes ---- */

typedef struct inkedge_scene inkedge_scene;

/* Reads a model; settings: those of the model and its limits. */
INKEDGE_C_API inkedge_status inkedge_scene_load(const char* file, const inkedge_settings* settings,
                                                inkedge_scene** scene);
/* The same of a file in memory, which is needed during the call only. name: what the file would be called; its
   extension says the format. */
INKEDGE_C_API inkedge_status inkedge_scene_read(const void* bytes, size_t size, const char* name,
                                                const inkedge_settings* settings, inkedge_scene** scene);

/* A mesh of triangles and its instances. Arrays of no rows are left out. */
typedef struct inkedge_mesh {
    const char* name;                  /* NULL: none */
    inkedge_array positions;           /* vertices x 3, real numbers */
    inkedge_array indices;             /* triangles x 3, whole numbers; none: each three positions are a triangle */
    inkedge_array normals;             /* vertices x 3, real numbers */
    inkedge_array texture_coordinates; /* vertices x 2, real numbers; v = 0 at the top of the picture */
    inkedge_array colors;              /* vertices x 3 or 4, real numbers, linear, 0 to 1 */
    inkedge_array transforms;          /* instances x 16: 4 x 4, mesh space -> world; none: one instance as it is */
    const char* const* names;          /* one an instance; NULL: all are called as the mesh is */
} inkedge_mesh;

/* Copies the arrays into a scene. */
INKEDGE_C_API inkedge_status inkedge_scene_make(const inkedge_mesh* meshes, size_t count,
                                                const inkedge_settings* settings, inkedge_scene** scene);
INKEDGE_C_API void inkedge_scene_free(inkedge_scene* scene);

INKEDGE_C_API uint64_t inkedge_scene_triangles(const inkedge_scene* scene);
/* Of all vertices in world space: the least x, y, z, then the greatest. */
INKEDGE_C_API void inkedge_scene_box(const inkedge_scene* scene, double box[6]);
/* What of the model is not drawn or not as it says; NULL from the last one on. Valid as long as the scene. */
INKEDGE_C_API const char* inkedge_scene_warning(const inkedge_scene* scene, size_t index);

/* ---- Cameras ---- */

typedef struct inkedge_camera inkedge_camera;

/* Of the settings of the camera, and of the size: what they leave open is chosen so that the whole model is seen. */
INKEDGE_C_API inkedge_status inkedge_camera_frame(const inkedge_scene* scene, const inkedge_settings* settings,
                                                  inkedge_camera** camera);
/* Of a calibration, for pictures of this size. k: 3 x 3, pixels, (0, 0) the middle of the top left pixel; pose: 4 x 4,
   camera space -> world; opencv: camera space has y down and z into the scene, else y up and z towards the eye. Near
   and far planes are fitted to the scene that is drawn. */
INKEDGE_C_API inkedge_status inkedge_camera_from_intrinsics(const double k[9], const double pose[16], int opencv,
                                                            int32_t width, int32_t height, inkedge_camera** camera);
/* Of OpenGL's matrices, 4 x 4. */
INKEDGE_C_API inkedge_status inkedge_camera_from_matrices(const double view[16], const double projection[16],
                                                          int32_t width, int32_t height, inkedge_camera** camera);
INKEDGE_C_API void inkedge_camera_free(inkedge_camera* camera);

/* World -> view space, and view space -> OpenGL's clip space in pictures of this size. The scene is the one that is
   drawn: where near and far planes are left open they are fitted to it. */
INKEDGE_C_API void inkedge_camera_view(const inkedge_camera* camera, double view[16]);
INKEDGE_C_API void inkedge_camera_projection(const inkedge_camera* camera, const inkedge_scene* scene, int32_t width,
                                             int32_t height, double projection[16]);
/* OpenCV's K in pictures of this size, and its world -> camera. */
INKEDGE_C_API void inkedge_camera_intrinsics(const inkedge_camera* camera, int32_t width, int32_t height, double k[9]);
INKEDGE_C_API void inkedge_camera_world_to_camera(const inkedge_camera* camera, double matrix[16]);

/* ---- Drawing ---- */

typedef struct inkedge_renderer inkedge_renderer;
typedef struct inkedge_maps inkedge_maps;
typedef struct inkedge_lines inkedge_lines;

/* Settings: backend and device. The OpenGL context is made by the first call that needs it. */
INKEDGE_C_API inkedge_status inkedge_renderer_create(const inkedge_settings* settings, inkedge_renderer** renderer);
INKEDGE_C_API void inkedge_renderer_free(inkedge_renderer* renderer);
/* From any thread: ends the call that the renderer is in, if it is in one, with INKEDGE_STOPPED. */
INKEDGE_C_API void inkedge_renderer_stop(inkedge_renderer* renderer);

/* The picture and the maps that the setting "maps" names. camera NULL: as inkedge_camera_frame(). */
INKEDGE_C_API inkedge_status inkedge_render(inkedge_renderer* renderer, const inkedge_scene* scene,
                                            const inkedge_camera* camera, const inkedge_settings* settings,
                                            inkedge_maps** maps);
INKEDGE_C_API void inkedge_maps_free(inkedge_maps* maps);
/* "picture", or a map by its name as the setting "maps" has it: "depth", "normal", "ids". INKEDGE_USAGE: there is no
   such map, or it was not asked for. */
INKEDGE_C_API inkedge_status inkedge_maps_get(const inkedge_maps* maps, const char* name, inkedge_buffer* buffer);
/* Writes the picture and the maps that were asked for: .png, .tif, .exr, .npz; whole or not at all. */
INKEDGE_C_API inkedge_status inkedge_maps_write(const inkedge_maps* maps, const char* file);
/* Camera, names, settings, backend and times as JSON. Valid until the next call with these maps. */
INKEDGE_C_API inkedge_status inkedge_maps_metadata(inkedge_maps* maps, const inkedge_scene* scene,
                                                   const inkedge_settings* settings, const char** json);

/* The lines of a view as polylines. */
INKEDGE_C_API inkedge_status inkedge_find_lines(inkedge_renderer* renderer, const inkedge_scene* scene,
                                                const inkedge_camera* camera, const inkedge_settings* settings,
                                                inkedge_lines** lines);
INKEDGE_C_API void inkedge_lines_free(inkedge_lines* lines);

typedef struct inkedge_line {
    const char* type; /* "outline", "crease", ... */
    int visible;
    int closed;      /* the last point is joined to the first, which is not repeated */
    uint32_t id;     /* from 1; 0: none */
    uint32_t object; /* the instance that it lies on, as in the map "ids": from 1 */
    uint32_t patch;  /* from 1 */
    double width;    /* share of its pen's width, over 0, at most 1 */
    size_t points;   /* two or more */
    size_t stride;   /* bytes from a point's numbers to the next point's */
    const double* pixels;    /* x, y of the first point: output pixels, (0, 0) the picture's top left corner, y down */
    const double* positions; /* x, y, z: world space */
    const double* strengths; /* one number, 0 to 1: of lines of form */
} inkedge_line;

INKEDGE_C_API size_t inkedge_lines_count(const inkedge_lines* lines);
/* Valid as long as the lines. INKEDGE_USAGE: there are not so many. */
INKEDGE_C_API inkedge_status inkedge_lines_get(const inkedge_lines* lines, size_t index, inkedge_line* line);
/* Writes them: .svg, .pdf, .dxf, .json; whole or not at all. Settings: as they were found with. */
INKEDGE_C_API inkedge_status inkedge_lines_write(const inkedge_lines* lines, const inkedge_settings* settings,
                                                 const char* file);

#ifdef __cplusplus
}
#endif

#endif
