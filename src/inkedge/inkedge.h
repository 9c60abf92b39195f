#pragma once

// All of the library.
#include <inkedge/backends.h>
#include <inkedge/bounds.h>
#include <inkedge/camera.h>
#include <inkedge/compare.h>
#include <inkedge/edge_kinds.h>
#include <inkedge/encode_png.h>
#include <inkedge/error.h>
#include <inkedge/export.h>
#include <inkedge/image.h>
#include <inkedge/job.h>
#include <inkedge/line_types.h>
#include <inkedge/lines.h>
#include <inkedge/load_scene.h>
#include <inkedge/maps.h>
#include <inkedge/mesh.h>
#include <inkedge/renderer.h>
#include <inkedge/scene.h>
#include <inkedge/setting_table.h>
#include <inkedge/settings.h>
#include <inkedge/stage_time.h>
#include <inkedge/surface_functions.h>
#include <inkedge/version.h>
#include <inkedge/views.h>
#include <inkedge/write.h>
#include <inkedge/write_file.h>
