#include "gl/programs.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <inkedge/error.h>

#include "base/message.h"
#include "base/read_file.h"

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

// Compiles a shader; returns whether that succeeded.
std::pair<ShaderName, bool> tryCompile(const Api& api, Stage stage, std::string_view text) {
    ShaderName shader{api, api.CreateShader(glStage(stage))};
    const char* begin = text.data();
    const auto length = static_cast<GLint>(text.size());
    api.ShaderSource(shader.id(), 1, &begin, &length);
    api.CompileShader(shader.id());
    GLint compiled = GL_FALSE;
    api.GetShaderiv(shader.id(), GL_COMPILE_STATUS, &compiled);
    return {std::move(shader), compiled != GL_FALSE};
}

ShaderName compile(const Api& api, const ProgramText& program, const StageText& stage) {
    auto [shader, compiled] = tryCompile(api, stage.stage, stage.text);
    if (!compiled) refuse(program, fmt::format(" (files 0..: {})", stage.files), shaderLog(api, shader.id()));
    return std::move(shader);
}

// Links a program; returns whether that succeeded.
std::pair<ProgramName, bool> tryLink(const Api& api, const std::vector<ShaderName>& shaders) {
    ProgramName program{api, api.CreateProgram()};
    for (const ShaderName& shader : shaders) api.AttachShader(program.id(), shader.id());
    api.LinkProgram(program.id());
    GLint linked = GL_FALSE;
    api.GetProgramiv(program.id(), GL_LINK_STATUS, &linked);
    for (const ShaderName& shader : shaders) api.DetachShader(program.id(), shader.id());
    return {std::move(program), linked != GL_FALSE};
}

ProgramName build(const Api& api, const ProgramText& text) {
    std::vector<ShaderName> shaders;
    for (const StageText& stage : text.stages) shaders.push_back(compile(api, text, stage));
    auto [program, linked] = tryLink(api, shaders);
    if (!linked) refuse(text, "", programLog(api, program.id()));
    return std::move(program);
}

// Reports the driver's first error in a user's text: "0:7(12): error: ..." or "0(7) : error ...". The text around the
// user's has no errors, and drivers do not say which file an expression is in: every line is taken for the user's.
[[noreturn]] void refuseFunction(const std::filesystem::path& file, std::string_view log) {
    const std::string name = base::printable(file.string());
    for (std::size_t at = 0; at < log.size();) {
        const std::string_view line = log.substr(at, log.find('\n', at) - at);
        at += line.size() + 1;
        const std::size_t error = line.find("error");
        const std::size_t separator = line.find_first_of(":(");
        if (error == std::string_view::npos || separator > error) continue;
        int number = 0;
        if (std::from_chars(&line[separator] + 1, line.data() + line.size(), number).ec != std::errc{}) continue;
        const std::size_t said = std::min(line.find(": ", error), line.size() - 2) + 2;
        base::refuse(fmt::format("{}:{}: expected GLSL that the driver accepts, found: {}", name, number,
                                 base::printable(line.substr(said))));
    }
    base::refuse(fmt::format("{}: expected a function vec4 surface(Surface s), found: {}", name,
                             base::printable(log.substr(0, log.find('\n')))));
}

}  // namespace

GLuint Programs::id(Program program) {
    ProgramName& compiled = compiled_[static_cast<std::size_t>(program)];
    if (compiled.id() != 0) return compiled.id();

    compiled = build(api_, programText(program));
    return compiled.id();
}

GLuint Programs::function(std::string_view name) {
    const auto known = functions_.find(name);
    if (known != functions_.end()) return known->second.id();
    const auto text = std::ranges::find(functionTexts(), name, &ProgramText::name);
    if (text == functionTexts().end())
        throw Error{Error::Kind::Runtime, fmt::format("function {}: expected a shader of it, found none", name)};
    return functions_.emplace(name, build(api_, *text)).first->second.id();
}

GLuint Programs::customFunction(const std::filesystem::path& file) {
    std::uint64_t maxBytes = 1'048'576;
    const base::Bytes bytes =
        base::within(base::printable(file.string()), [&] { return base::readBytes(file, maxBytes); });
    const std::string text{base::textOf(bytes)};
    const auto known = customFunctions_.find(text);
    if (known != customFunctions_.end()) return known->second.id();
    const std::vector<StageText>& frame = functionTexts().front().stages;
    const std::string fragment = fmt::format("{}\n#line 1 0\n{}\n", frame.back().text, text);
    std::vector<ShaderName> shaders;
    shaders.push_back(compile(api_, functionTexts().front(), frame.front()));
    auto [shader, compiled] = tryCompile(api_, Stage::Fragment, fragment);
    if (!compiled) refuseFunction(file, shaderLog(api_, shader.id()));
    shaders.push_back(std::move(shader));
    auto [program, linked] = tryLink(api_, shaders);
    if (!linked) refuseFunction(file, programLog(api_, program.id()));
    return customFunctions_.emplace(text, std::move(program)).first->second.id();
}

}  // namespace inkedge::gl
