/* draw_c MODEL OUT.png OUT.svg: the installed library from C. */
#include <inkedge.h>
#include <stdio.h>

static int failed(const char* what) {
    fprintf(stderr, "%s: %s\n", what, inkedge_message());
    return 1;
}

int main(int argc, char** argv) {
    inkedge_settings* settings = NULL;
    inkedge_scene* scene = NULL;
    inkedge_renderer* renderer = NULL;
    inkedge_maps* maps = NULL;
    inkedge_lines* lines = NULL;
    inkedge_buffer depth;
    if (argc != 4) return 2;
    if (inkedge_settings_create(&settings) != INKEDGE_OK) return failed("settings");
    if (inkedge_set(settings, "size", "256x192") != INKEDGE_OK) return failed("size");
    if (inkedge_set(settings, "maps", "depth") != INKEDGE_OK) return failed("maps");
    if (inkedge_scene_load(argv[1], settings, &scene) != INKEDGE_OK) return failed("model");
    if (inkedge_renderer_create(settings, &renderer) != INKEDGE_OK) return failed("renderer");
    if (inkedge_render(renderer, scene, NULL, settings, &maps) != INKEDGE_OK) return failed("picture");
    if (inkedge_maps_get(maps, "depth", &depth) != INKEDGE_OK) return failed("depth");
    if (depth.type != INKEDGE_FLOAT32 || depth.width != 256 || depth.height != 192) return failed("depth's shape");
    if (inkedge_maps_write(maps, argv[2]) != INKEDGE_OK) return failed(argv[2]);
    if (inkedge_find_lines(renderer, scene, NULL, settings, &lines) != INKEDGE_OK) return failed("lines");
    if (inkedge_lines_write(lines, settings, argv[3]) != INKEDGE_OK) return failed(argv[3]);
    printf("inkedge %s of C: %lu lines\n", inkedge_version(), (unsigned long)inkedge_lines_count(lines));
    if (inkedge_lines_count(lines) == 0) return 1;
    inkedge_lines_free(lines);
    inkedge_maps_free(maps);
    inkedge_renderer_free(renderer);
    inkedge_scene_free(scene);
    inkedge_settings_free(settings);
    return 0;
}
