#include "python/scene_arrays.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <inkedge/scene_arrays.h>

#include "python/arrays.h"
#include "python/released.h"

namespace inkedge::python {
namespace {

std::optional<NumberType> numberType(const py::dtype& type) {
    if (!type.attr("isnative").cast<bool>()) return {};
    switch (type.kind()) {
        case 'f':
            if (type.itemsize() == 4) return NumberType::Float32;
            if (type.itemsize() == 8) return NumberType::Float64;
            return {};
        case 'u':
            if (type.itemsize() == 1) return NumberType::UInt8;
            if (type.itemsize() == 2) return NumberType::UInt16;
            return type.itemsize() == 4 ? NumberType::UInt32 : NumberType::UInt64;
        case 'i':
            if (type.itemsize() == 4) return NumberType::Int32;
            if (type.itemsize() == 8) return NumberType::Int64;
            return {};
        default:
            return {};
    }
}

bool repeats(const py::array& array) {  // as np.broadcast_to() does
    for (py::ssize_t axis = 0; axis < array.ndim(); ++axis)
        if (array.strides(axis) == 0 && array.shape(axis) > 1) return true;
    return false;
}

// Numpy arrays, kept for as long as C++ reads them without the GIL.
class KeptArrays {
public:
    /// Whole numbers become real ones.
    ArrayView real(const py::object& value, std::string_view name) { return view(value, name, "float64", "f"); }
    /// Real numbers stay real, for C++ to refuse.
    ArrayView whole(const py::object& value, std::string_view name) { return view(value, name, "int64", "iuf"); }
    /// 4 x 4, or any number of them.
    ArrayView matrices(const py::object& value, std::string_view name) {
        if (value.is_none()) return {};
        const py::array array = numbers(value, name);
        const py::ssize_t axes = array.ndim();
        if (axes < 2 || axes > 3 || array.shape(axes - 1) != 4 || array.shape(axes - 2) != 4)
            refuse(fmt::format("{}: expected one or several matrices of 4 x 4 numbers, found another array", name));
        return real(array.attr("reshape")(py::make_tuple(-1, 16)), name);
    }

private:
    static py::array numbers(const py::object& value, std::string_view name) {
        py::array array = py::array::ensure(value);
        if (!array) PyErr_Clear();
        if (!array || std::string_view{"fiu"}.find(array.dtype().kind()) == std::string_view::npos)
            refuse(fmt::format("{}: expected an array of numbers, found another value", name));
        return array;
    }

    ArrayView view(const py::object& value, std::string_view name, const char* type, std::string_view kinds) {
        if (value.is_none()) return {};
        py::array array = numbers(value, name);
        if (array.ndim() < 1 || array.ndim() > 2 || array.shape(0) == 0)
            refuse(fmt::format("{}: expected an array of one row or more, found one of the shape {}", name,
                               py::str(array.attr("shape")).cast<std::string>()));
        const bool isKind = kinds.find(array.dtype().kind()) != std::string_view::npos;
        if (!isKind || !numberType(array.dtype())) array = array.attr("astype")(type);
        if (repeats(array)) array = array.attr("copy")();
        kept_.push_back(array);
        const bool table = array.ndim() == 2;
        return {.data = array.data(),
                .type = *numberType(array.dtype()),
                .rows = static_cast<std::size_t>(array.shape(0)),
                .columns = table ? static_cast<std::size_t>(array.shape(1)) : 1,
                .rowStride = array.strides(0),
                .columnStride = table ? array.strides(1) : 0};
    }

    std::vector<py::array> kept_;
};

bool isSeveral(const py::object& vertices) {
    if (!py::isinstance<py::list>(vertices) && !py::isinstance<py::tuple>(vertices)) return false;
    const auto list = py::reinterpret_borrow<py::sequence>(vertices);
    return list.size() > 0 && py::module_::import("numpy").attr("ndim")(list[0]).cast<int>() == 2;
}

// Item i of what several meshes have; None of None.
py::object itemOf(const py::object& list, std::size_t i, std::size_t count, std::string_view name) {
    if (list.is_none()) return list;
    if (!py::isinstance<py::sequence>(list) || py::len(list) != count)
        refuse(fmt::format("{}: expected {}, one a mesh, found another number", name, count));
    return py::reinterpret_borrow<py::sequence>(list)[i];
}

void setNames(InstancedArrays& arrays, const py::object& names) {
    if (names.is_none()) return;
    if (py::isinstance<py::str>(names)) {
        arrays.mesh.name = names.cast<std::string>();
        return;
    }
    try {
        arrays.names = names.cast<std::vector<std::string>>();
    } catch (const py::cast_error&) {
        refuse("names: expected a text, or a list of texts, found another value");
    }
}

}  // namespace

Scene sceneFromArrays(const py::object& vertices, const py::object& faces, const py::object& normals,
                      const py::object& uv, const py::object& transforms, const py::object& names,
                      const LoadSettings& settings) {
    KeptArrays kept;
    std::vector<InstancedArrays> meshes;
    const auto add = [&](const py::object& v, const py::object& f, const py::object& n, const py::object& t,
                         const py::object& m, const py::object& called) {
        InstancedArrays& arrays = meshes.emplace_back();
        arrays.mesh.positions = kept.real(v, "vertices");
        arrays.mesh.indices = kept.whole(f, "faces");
        arrays.mesh.normals = kept.real(n, "normals");
        arrays.mesh.textureCoordinates = kept.real(t, "uv");
        arrays.transforms = kept.matrices(m, "transforms");
        setNames(arrays, called);
    };
    if (isSeveral(vertices)) {
        const std::size_t count = py::len(vertices);
        for (std::size_t i = 0; i < count; ++i)
            add(itemOf(vertices, i, count, "vertices"), itemOf(faces, i, count, "faces"),
                itemOf(normals, i, count, "normals"), itemOf(uv, i, count, "uv"),
                itemOf(transforms, i, count, "transforms"), itemOf(names, i, count, "names"));
    } else {
        add(vertices, faces, normals, uv, transforms, names);
    }
    return released([&] { return makeScene(meshes, settings); });
}

}  // namespace inkedge::python
