#pragma once

#include <string>

/// Docstrings. Those of calls that take settings list them, out of the table of settings.
namespace inkedge::python {
namespace documentation {

extern const char* const module;
extern const char* const setting;
extern const char* const scene;
extern const char* const instance;
extern const char* const camera;
extern const char* const cameraMatrices;
extern const char* const renderer;
extern const char* const maps;
extern const char* const lines;
extern const char* const backend;
extern const char* const linesComparison;
extern const char* const pictureComparison;
extern const char* const compareLines;
extern const char* const comparePictures;

[[nodiscard]] std::string load();
[[nodiscard]] std::string fromArrays();
[[nodiscard]] std::string frame();
[[nodiscard]] std::string lookAt();
extern const char* const fromMatrices;
extern const char* const fromIntrinsics;
extern const char* const matrices;
[[nodiscard]] std::string render();
[[nodiscard]] std::string renderLines();

}  // namespace documentation
}  // namespace inkedge::python
