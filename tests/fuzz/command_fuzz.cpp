// Text as a command line, with what belongs to it. A line that starts with $ is a variable of the environment, with % a
// line of the file own.conf, with @ one of the file views.json; every other line is an argument. The command runs in a
// folder of its own, which no name leads out of, for no name holds a slash; no OpenGL works, so that what it draws are
// lines from object space.
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <string>
#include <vector>

#include "base/temporary_folder.h"
#include "fuzz/promise.h"

/// The command's main(), which the build calls so here.
int inkedgeCommand(int argc, char** argv);

namespace {

namespace fs = std::filesystem;
using inkedge::fuzz::expect;

constexpr const char* cube =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nf 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\n"
    "f 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
constexpr const char* sheet =
    R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0,"name":"a\nb"},{"camera":0,"translation":[0.5,0.5,4]}],
"cameras":[{"type":"perspective","perspective":{"yfov":0.7,"znear":0.1}}],"materials":[{"name":"m"}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],
"accessors":[{"componentType":5126,"type":"VEC3","count":3,"bufferView":0}],
"bufferViews":[{"buffer":0,"byteLength":36}],
"buffers":[{"byteLength":36,"uri":"data.bin"}]})";

struct Call {
    std::vector<std::string> arguments{"inkedge"};
    std::vector<std::pair<std::string, std::string>> environment;
    std::string config;
    std::string views;
};

// What would only take long, or end this process: many views, child processes, an alarm.
bool isFit(const std::string& argument) {
    const auto has = [&](const char* text) { return argument.find(text) != std::string::npos; };
    if (argument == "doctor" || argument == "tune" || has("--time")) return false;
    const std::size_t colon = argument.find(':');
    const bool many = has("turntable") || has("sphere");
    return !many || colon == std::string::npos || argument.size() - colon <= 3;
}

Call callOf(std::string text) {
    std::ranges::replace(text, '/', '_');
    std::ranges::replace(text, '\0', '0');
    Call call;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string line = text.substr(begin, end - begin);
        begin = end + 1;
        const std::string rest = line.empty() ? line : line.substr(1);
        const std::size_t equals = rest.find('=');
        if (line.starts_with('$') && equals != std::string::npos && equals > 0)
            call.environment.emplace_back("INKEDGE_" + rest.substr(0, equals), rest.substr(equals + 1));
        else if (line.starts_with('%'))
            call.config += rest + '\n';
        else if (line.starts_with('@') && call.views.size() < 512)
            call.views += rest + '\n';
        else if (isFit(line))
            call.arguments.push_back(line);
    }
    return call;
}

// The files that a call reads; it may write over the others.
std::vector<std::string> inputsOf(const Call& call) {
    std::vector<std::string> inputs;
    const std::vector<std::string>& all = call.arguments;
    for (std::size_t i = 2; i < all.size(); ++i) {
        if (i == 2 && (all[i] == "model.obj" || all[i] == "sheet.gltf")) inputs.push_back(all[i]);
        if (i == 2 && all[i] == "sheet.gltf") inputs.emplace_back("data.bin");
        if (all[i - 1] == "--config" && all[i] == "own.conf") inputs.push_back(all[i]);
        if (all[i - 1] == "--views" && all[i] == "views.json") inputs.push_back(all[i]);
    }
    return inputs;
}

// The folder that the command runs in.
class Folder {
public:
    Folder() {
        ::setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent", 1);
        ::setenv("MESA_GL_VERSION_OVERRIDE", "3.3", 1);
        ::dup2(::open("/dev/null", O_WRONLY | O_CLOEXEC), STDOUT_FILENO);
    }

    void fill(const Call& call) {
        fs::current_path(folder_.path());
        std::string data(36, 'A');
        data[13] = 'B';
        data[25] = 'C';
        inputs_ = {{"model.obj", cube},
                   {"sheet.gltf", sheet},
                   {"data.bin", data},
                   {"own.conf", call.config},
                   {"views.json", call.views}};
        for (const auto& [name, content] : inputs_) put(name, content);
        put("linked", "what is behind a link may be replaced");
        fs::create_symlink("linked", "link.svg");
        fs::create_symlink("nothing", "gone.svg");
    }

    void expectInputsKept(const Call& call) const {
        for (const std::string& name : inputsOf(call))
            expect(contents(name) == inputs_.at(name), name + " as it was", "another");
        expect(fs::is_symlink("link.svg") && fs::is_symlink("gone.svg"), "links that stay", "files in their folder");
        for (const std::string& name : folder_.names()) expect(!name.starts_with(".inkedge-"), "no file by half", name);
    }

    void clear() const {
        for (const std::string& name : folder_.names()) fs::remove_all(name);
        fs::current_path(before_);  // the fuzzer's own files may have names from there
    }

private:
    const fs::path before_ = fs::current_path();
    const TemporaryFolder folder_;
    std::map<std::string, std::string> inputs_;
};

// What the command says on stderr while an action runs.
template <class Action>
std::string saidBy(Action&& action) {
    const int kept = ::dup(STDERR_FILENO);
    const int memory = ::memfd_create("stderr", MFD_CLOEXEC);
    ::dup2(memory, STDERR_FILENO);
    action();
    ::dup2(kept, STDERR_FILENO);
    std::string text(static_cast<std::size_t>(::lseek(memory, 0, SEEK_END)), '\0');
    const ssize_t count = ::pread(memory, text.data(), text.size(), 0);
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    ::close(memory);
    ::close(kept);
    return text;
}

void expectLines(const std::string& said, int exitCode) {
    std::string last;
    int errors = 0;
    for (std::size_t begin = 0; begin < said.size();) {
        const std::size_t end = said.find('\n', begin);
        expect(end != std::string::npos, "whole lines", said);
        last = said.substr(begin, end - begin);
        begin = end + 1;
        errors += last.starts_with("inkedge: error: ") ? 1 : 0;
        expect(last.starts_with("inkedge: "), "lines that start with inkedge:", last);
        expect(std::ranges::none_of(last, [](unsigned char c) { return std::iscntrl(c) != 0; }), "printable text",
               last);
    }
    if (exitCode == 0) return;
    expect(exitCode > 0 && exitCode <= 5, "an exit status from 0 to 5", std::to_string(exitCode));
    expect(last.starts_with("inkedge: error: "), "an error for the exit status " + std::to_string(exitCode), said);
    expect(errors == 1, "one error", said);
    expect(!last.ends_with("; report this, please"), "an error that we expect", last);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static Folder folder;
    Call call = callOf({reinterpret_cast<const char*>(data), size});
    folder.fill(call);
    std::vector<char*> argv;
    for (std::string& argument : call.arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    for (const auto& [name, value] : call.environment) ::setenv(name.c_str(), value.c_str(), 1);
    int exitCode = 0;
    const std::string said =
        saidBy([&] { exitCode = inkedgeCommand(static_cast<int>(call.arguments.size()), argv.data()); });
    for (const auto& [name, value] : call.environment) ::unsetenv(name.c_str());
    const bool compares = call.arguments.size() > 1 && call.arguments[1] == "compare";
    if (!compares || exitCode != 1) expectLines(said, exitCode);  // 1: the pictures differ
    folder.expectInputsKept(call);
    folder.clear();
    return 0;
}
