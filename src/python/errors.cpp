#include "python/errors.h"

#include <array>
#include <string_view>

namespace inkedge::python {
namespace {

struct KindOfError {
    Error::Kind kind;
    const char* name;
    PyObject* const* alsoA;  // the class of Python's own that it is, too
    const char* meaning;
};

const std::array kinds{
    KindOfError{Error::Kind::Runtime, "inkedge.RuntimeError", &PyExc_RuntimeError,
                "Something failed while drawing: out of memory, an error of OpenGL, a fork that cannot draw."},
    KindOfError{Error::Kind::Usage, "inkedge.UsageError", &PyExc_ValueError, "A setting or an argument is wrong."},
    KindOfError{Error::Kind::Input, "inkedge.InputError", &PyExc_OSError,
                "A file cannot be read, or holds what is not supported."},
    KindOfError{Error::Kind::Context, "inkedge.ContextError", &PyExc_RuntimeError,
                "There is no usable OpenGL context."},
    KindOfError{Error::Kind::Output, "inkedge.OutputError", &PyExc_OSError, "A result cannot be written."},
    KindOfError{Error::Kind::Stopped, "inkedge.StoppedError", &PyExc_RuntimeError, "The work was asked to stop."},
};

// Classes live as long as the process.
PyObject* base = nullptr;
PyObject* warning = nullptr;
std::array<PyObject*, kinds.size()> classes{};

PyObject* classOf(Error::Kind kind) {
    for (std::size_t i = 0; i < kinds.size(); ++i)
        if (kinds[i].kind == kind) return classes[i];
    return base;
}

void translate(std::exception_ptr thrown) {
    try {
        if (thrown) std::rethrow_exception(thrown);
    } catch (const Error& error) {
        PyErr_SetObject(classOf(error.kind()), textOf(error.what()).ptr());
    }
}

void add(py::module_& module, std::string_view name, PyObject* type) {
    module.add_object(std::string{name.substr(name.find('.') + 1)}.c_str(), type);
}

}  // namespace

void addErrors(py::module_& module) {
    base = PyErr_NewExceptionWithDoc(
        "inkedge.Error", "Every failure of the library: one line that says what was expected and what was found.",
        nullptr, nullptr);
    warning =
        PyErr_NewExceptionWithDoc("inkedge.Warning", "What was asked for does nothing.", PyExc_UserWarning, nullptr);
    if (base == nullptr || warning == nullptr) throw py::error_already_set{};
    add(module, "inkedge.Error", base);
    add(module, "inkedge.Warning", warning);
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const py::tuple bases = py::make_tuple(py::handle{base}, py::handle{*kinds[i].alsoA});
        classes[i] = PyErr_NewExceptionWithDoc(kinds[i].name, kinds[i].meaning, bases.ptr(), nullptr);
        if (classes[i] == nullptr) throw py::error_already_set{};
        add(module, kinds[i].name, classes[i]);
    }
    py::register_exception_translator(translate);
}

void warn(const std::string& message) {
    if (PyErr_WarnEx(warning, message.c_str(), 1) != 0) throw py::error_already_set{};
}

py::str textOf(const std::string& text) {
    PyObject* const decoded = PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace");
    if (decoded == nullptr) throw py::error_already_set{};
    return py::reinterpret_steal<py::str>(decoded);
}

void refuse(const std::string& message) { throw Error{Error::Kind::Usage, message}; }

}  // namespace inkedge::python
