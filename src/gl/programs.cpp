#include "gl/programs.h"

#include <string>
#include <vector>

#include <fmt/format.h>

#include <inkedge/error.h>

namespace inkedge::gl {
namespace {

GLenum glStage(Stage stage) {
    switch (stage) {
        case Stage::Vertex:
            return GL_VERTEX_SHADER;
        case Stage::Fragment:
            return GL_FRAGMENT_SHADER;
        case Stage::Compute:
            return GL_COMPUTE_SHADER;
        case Stage::Geometry:
            return GL_GEOMETRY_SHADER;
    }
    return GL_NONE;
}

[[noreturn]] void refuse(const ProgramText& program, const std::string& files, const std::string& log) {
    throw Error{Error::Kind::Runtime, fmt::format("program {}: expected the driver to accept it, found '{}'{}",
                                                  program.name, log.substr(0, log.find('\n')), files)};
}

std::string shaderLog(const Api& api, GLuint shader) {
    std::string log(4096, '\0');
    GLsizei length = 0;
    api.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return log;
}

std::string programLog(const Api& api, GLuint program) {
    std::string log(4096, '\0');
    GLsizei length = 0;
    api.GetProgramInfoLog(program, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return log;
}

ShaderName compile(const Api& api, const ProgramText& program, const StageText& stage) {
    ShaderName shader{api, api.CreateShader(glStage(stage.stage))};
    const char* text = stage.text.data();
    const auto length = static_cast<GLint>(stage.text.size());
    api.ShaderSource(shader.id(), 1, &text, &length);
    api.CompileShader(shader.id());
    GLint compiled = GL_FALSE;
    api.GetShaderiv(shader.id(), GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_FALSE) {
        refuse(program, fmt::format(" (files 0..: {})", stage.files), shaderLog(api, shader.id()));
    }
    return shader;
}

}  // namespace

GLuint Programs::id(Program program) {
    ProgramName& compiled = compiled_[static_cast<std::size_t>(program)];
    if (compiled.id() != 0) return compiled.id();

    const ProgramText& text = programText(program);
    ProgramName linked{api_, api_.CreateProgram()};
    std::vector<ShaderName> shaders;
    for (const StageText& stage : text.stages) {
        shaders.push_back(compile(api_, text, stage));
        api_.AttachShader(linked.id(), shaders.back().id());
    }
    api_.LinkProgram(linked.id());
    GLint ok = GL_FALSE;
    api_.GetProgramiv(linked.id(), GL_LINK_STATUS, &ok);
    if (ok == GL_FALSE) refuse(text, "", programLog(api_, linked.id()));
    for (const ShaderName& shader : shaders) api_.DetachShader(linked.id(), shader.id());
    compiled = std::move(linked);
    return compiled.id();
}

}  // namespace inkedge::gl
