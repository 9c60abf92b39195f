// The program that reads 3MF files for the library, in a process of its own.
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <new>
#include <span>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <utility>

#include <Common/NMR_ErrorConst.h>
#include <Model/COM/NMR_DLLInterfaces.h>
#include <fmt/format.h>
#include <zlib.h>

#include <inkedge/scene.h>

#include "base/message.h"
#include "formats/cad/program_side.h"
#include "formats/cad/request.h"
#include "formats/cad/zip_directory.h"
#include "formats/text.h"

namespace inkedge::cad {
namespace {

using namespace NMR;

// An object of the library.
struct Release {
    void operator()(PLib3MFBase* object) const { lib3mf_release(object); }
};
using Handle = std::unique_ptr<PLib3MFBase, Release>;

// What the library says went wrong.
std::string reasonOf(PLib3MFBase* object, LIB3MFRESULT result) {
    DWORD code = 0;
    LPCSTR message = nullptr;
    if (object != nullptr && lib3mf_getlasterror(object, &code, &message) == 0 && message != nullptr &&
        *message != '\0')
        return base::printable(message);
    return fmt::format("error {:#x}", static_cast<unsigned>(result));
}

void expectDone(PLib3MFBase* object, LIB3MFRESULT result) {
    if (result != LIB3MF_OK) throw std::runtime_error{"expected a 3MF model, found: " + reasonOf(object, result)};
}

// An object that the library makes: made(&object) is one of its functions.
template <class Make>
Handle made(PLib3MFBase* of, Make&& make) {
    PLib3MFBase* object = nullptr;
    expectDone(of, make(&object));
    return Handle{object};
}

glm::dmat4 matrixOf(const MODELTRANSFORM& t) {
    glm::dmat4 matrix{1.0};
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column) matrix[column][row] = static_cast<double>(t.m_fFields[row][column]);
    return matrix;
}

// Millimetres.
double lengthOf(DWORD unit) {
    switch (unit) {
        case MODELUNIT_MICROMETER:
            return 0.001;
        case MODELUNIT_CENTIMETER:
            return 10.0;
        case MODELUNIT_INCH:
            return 25.4;
        case MODELUNIT_FOOT:
            return 304.8;
        case MODELUNIT_METER:
            return 1000.0;
        default:
            return 1.0;
    }
}

// IEC 61966-2-1.
float linear(std::uint8_t value) {
    const double v = value / 255.0;
    return static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
}

using Rgba = std::array<std::uint8_t, 4>;

class Reading {
public:
    Reading(std::vector<std::uint8_t> bytes, const Request& limits) : limits_{limits} {
        model_ = made(nullptr, [](PLib3MFBase** to) { return lib3mf_createmodel(to); });
        const Handle reader =
            made(model_.get(), [&](PLib3MFBase** to) { return lib3mf_model_queryreader(model_.get(), "3mf", to); });
        expectDone(reader.get(), lib3mf_reader_readfrombuffer(reader.get(), bytes.data(), bytes.size()));
        addWarnings(reader.get());
    }

    Model model() {
        DWORD unit = 0;
        expectDone(model_.get(), lib3mf_model_getunit(model_.get(), &unit));
        const glm::dmat4 toMillimetres = glm::dmat4{glm::dmat3{lengthOf(unit)}};
        const Handle items =
            made(model_.get(), [&](PLib3MFBase** to) { return lib3mf_model_getbuilditems(model_.get(), to); });
        for (BOOL more = false;;) {
            expectDone(items.get(), lib3mf_builditemiterator_movenext(items.get(), &more));
            if (!more) break;
            const Handle item = made(
                items.get(), [&](PLib3MFBase** to) { return lib3mf_builditemiterator_getcurrent(items.get(), to); });
            MODELTRANSFORM transform{};
            expectDone(item.get(), lib3mf_builditem_getobjecttransform(item.get(), &transform));
            const Handle object =
                made(item.get(), [&](PLib3MFBase** to) { return lib3mf_builditem_getobjectresource(item.get(), to); });
            addObject(object.get(), toMillimetres * matrixOf(transform), noNode, 0);
        }
        sayWhatIsNotBuilt();
        if (beams_ > 0) result_.undrawn.push_back(formats::counted(beams_, "beam"));
        return std::move(result_);
    }

private:
    void addObject(PLib3MFBase* object, const glm::dmat4& transform, std::uint32_t parent, int depth) {
        constexpr int maxDepth = 64;
        if (depth > maxDepth)
            throw std::runtime_error{fmt::format("expected components at most {} deep, found more", maxDepth)};
        const auto node = static_cast<std::uint32_t>(result_.nodes.size());
        const std::string name = nameOf(object);
        result_.nodes.push_back({name, parent});
        limits_.expectNodes(result_.nodes.size());
        BOOL isMesh = false;
        expectDone(object, lib3mf_object_ismeshobject(object, &isMesh));
        if (isMesh) {
            const std::uint32_t part = partOf(object, name);
            result_.instances.push_back({name, part, node, transform});
            limits_.expectInstances(result_.instances.size());
            return;
        }
        DWORD count = 0;
        expectDone(object, lib3mf_componentsobject_getcomponentcount(object, &count));
        for (DWORD i = 0; i < count; ++i) {
            const Handle component =
                made(object, [&](PLib3MFBase** to) { return lib3mf_componentsobject_getcomponent(object, i, to); });
            MODELTRANSFORM own{};
            expectDone(component.get(), lib3mf_component_gettransform(component.get(), &own));
            const Handle child = made(component.get(), [&](PLib3MFBase** to) {
                return lib3mf_component_getobjectresource(component.get(), to);
            });
            addObject(child.get(), transform * matrixOf(own), node, depth + 1);
        }
    }

    // What the library read otherwise than the file says it, once each.
    void addWarnings(PLib3MFBase* reader) {
        constexpr std::size_t maxWarnings = 8;
        DWORD count = 0;
        expectDone(reader, lib3mf_reader_getwarningcount(reader, &count));
        for (DWORD i = 0; i < count && result_.warnings.size() < maxWarnings; ++i) {
            std::array<char, 512> text{};
            DWORD code = 0;
            ULONG length = 0;
            if (lib3mf_reader_getwarningutf8(reader, i, &code, text.data(), text.size(), &length) != LIB3MF_OK)
                continue;
            if (code == NMR_ERROR_MISSINGUUID) continue;  // the core specification asks for none
            std::string warning = "lib3mf: " + base::printable(text.data());
            if (std::ranges::find(result_.warnings, warning) == result_.warnings.end())
                result_.warnings.push_back(std::move(warning));
        }
    }

    static std::string nameOf(PLib3MFBase* object) {
        ULONG length = 0;
        if (lib3mf_object_getnameutf8(object, nullptr, 0, &length) != LIB3MF_OK || length == 0) return {};
        std::string name(length + std::size_t{1}, '\0');
        if (lib3mf_object_getnameutf8(object, name.data(), length + 1, &length) != LIB3MF_OK) return {};
        name.resize(std::min<std::size_t>(name.find('\0'), length));
        return name;
    }

    // The part that an object's mesh is, made when it is first asked for.
    std::uint32_t partOf(PLib3MFBase* object, const std::string& name) {
        DWORD id = 0;
        expectDone(object, lib3mf_resource_getresourceid(object, &id));
        const auto [known, isNew] = parts_.try_emplace(id, static_cast<std::uint32_t>(result_.parts.size()));
        if (isNew) result_.parts.push_back(makePart(object, name));
        return known->second;
    }

    Part makePart(PLib3MFBase* object, const std::string& name) {
        Part part;
        part.name = name;
        DWORD vertices = 0;
        DWORD triangles = 0;
        DWORD beams = 0;
        expectDone(object, lib3mf_meshobject_getvertexcount(object, &vertices));
        expectDone(object, lib3mf_meshobject_gettrianglecount(object, &triangles));
        if (lib3mf_meshobject_getbeamcount(object, &beams) == LIB3MF_OK) beams_ += beams;
        vertices_ += vertices + 3 * std::uint64_t{triangles};
        limits_.expectVertices(vertices_);
        std::vector<MODELMESHVERTEX> corners(vertices);
        if (vertices > 0) expectDone(object, lib3mf_meshobject_getvertices(object, corners.data(), vertices, nullptr));
        for (const MODELMESHVERTEX& v : corners)
            part.positions.emplace_back(v.m_fPosition[0], v.m_fPosition[1], v.m_fPosition[2]);
        std::vector<MODELMESHTRIANGLE> faces(triangles);
        if (triangles > 0)
            expectDone(object, lib3mf_meshobject_gettriangleindices(object, faces.data(), triangles, nullptr));
        for (const MODELMESHTRIANGLE& face : faces)
            part.indices.insert(part.indices.end(), std::begin(face.m_nIndices), std::end(face.m_nIndices));
        addMaterials(object, triangles, part);
        return part;
    }

    void addMaterials(PLib3MFBase* object, DWORD triangles, Part& part) {
        const Handle handler =
            made(object, [&](PLib3MFBase** to) { return lib3mf_meshobject_createpropertyhandler(object, to); });
        for (DWORD t = 0; t < triangles; ++t) part.materials.push_back(materialOf(handler.get(), t));
        if (std::ranges::all_of(part.materials, [](std::uint32_t m) { return m == 0; })) part.materials.clear();
    }

    std::uint32_t materialOf(PLib3MFBase* handler, DWORD triangle) {
        eModelPropertyType type = MODELPROPERTYTYPE_NONE;
        expectDone(handler, lib3mf_propertyhandler_getpropertytype(handler, triangle, &type));
        if (type == MODELPROPERTYTYPE_BASEMATERIALS) {
            DWORD group = 0;
            DWORD index = 0;
            expectDone(handler, lib3mf_propertyhandler_getbasematerial(handler, triangle, &group, &index));
            return numberOf({group, index, {}}, [&] { return baseMaterial(group, index); });
        }
        if (type == MODELPROPERTYTYPE_COLOR) {  // of three corners: the first one's
            MODELMESH_TRIANGLECOLOR_SRGB colors{};
            expectDone(handler, lib3mf_propertyhandler_getcolor(handler, triangle, &colors));
            const MODELMESHCOLOR_SRGB& c = colors.m_Colors[0];
            const Rgba rgba{c.m_Red, c.m_Green, c.m_Blue, c.m_Alpha};
            return numberOf({0, 0, rgba}, [&] { return materialOf({}, rgba); });
        }
        return 0;
    }

    static Material materialOf(std::string name, Rgba color) {
        return {std::move(name), {linear(color[0]), linear(color[1]), linear(color[2]), color[3] / 255.0F}};
    }

    Material baseMaterial(DWORD group, DWORD index) {
        const Handle materials = made(
            model_.get(), [&](PLib3MFBase** to) { return lib3mf_model_getbasematerialbyid(model_.get(), group, to); });
        Rgba color{};
        expectDone(materials.get(), lib3mf_basematerial_getdisplaycolor(materials.get(), index, &color[0], &color[1],
                                                                        &color[2], &color[3]));
        ULONG length = 0;
        std::string name;
        if (lib3mf_basematerial_getnameutf8(materials.get(), index, nullptr, 0, &length) == LIB3MF_OK) {
            name.resize(length + std::size_t{1});
            if (lib3mf_basematerial_getnameutf8(materials.get(), index, name.data(), length + 1, &length) != LIB3MF_OK)
                name.clear();
            name.resize(std::min(name.find('\0'), name.size()));
        }
        return materialOf(std::move(name), color);
    }

    using MaterialKey = std::tuple<DWORD, DWORD, Rgba>;  // of a group, or a colour by itself
    template <class Make>
    std::uint32_t numberOf(const MaterialKey& key, Make&& make) {
        const auto found = materials_.find(key);
        if (found != materials_.end()) return found->second;
        result_.materials.push_back(make());
        const auto number = static_cast<std::uint32_t>(result_.materials.size());
        materials_.emplace(key, number);
        return number;
    }

    void sayWhatIsNotBuilt() {
        const Handle meshes =
            made(model_.get(), [&](PLib3MFBase** to) { return lib3mf_model_getmeshobjects(model_.get(), to); });
        std::uint64_t count = 0;
        for (BOOL more = false;;) {
            if (lib3mf_resourceiterator_movenext(meshes.get(), &more) != LIB3MF_OK || !more) break;
            ++count;
        }
        if (count > parts_.size())
            result_.undrawn.push_back(formats::counted(count - parts_.size(), "mesh", "meshes") +
                                      " that no item builds");
    }

    Handle model_;
    const Request& limits_;
    Model result_;
    std::map<DWORD, std::uint32_t> parts_;  // by the numbers of resources
    std::map<MaterialKey, std::uint32_t> materials_;
    std::uint64_t vertices_ = 0;
    std::uint64_t beams_ = 0;
};

std::vector<std::uint8_t> bytesOfFile() {
    struct stat status {};
    if (::fstat(process::bytesDescriptor, &status) != 0) throw std::runtime_error{"expected a file, found none"};
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(status.st_size));
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t count =
            ::pread(process::bytesDescriptor, bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
        if (count <= 0) throw std::runtime_error{"expected a whole file, found a part of one"};
        done += static_cast<std::size_t>(count);
    }
    return bytes;
}

// How many bytes a deflated file comes to, as far as one more than expected.
std::uint64_t inflatedSize(std::string_view packed, std::uint64_t expected) {
    z_stream stream{};
    constexpr int withoutWrapper = -MAX_WBITS;
    if (inflateInit2(&stream, withoutWrapper) != Z_OK) throw std::bad_alloc{};
    const std::unique_ptr<z_stream, decltype(&inflateEnd)> end{&stream, inflateEnd};
    std::array<Bytef, 1 << 16> buffer{};
    std::uint64_t size = 0;
    int result = Z_OK;
    while (result == Z_OK && size <= expected) {
        if (stream.avail_in == 0) {
            const std::string_view next = packed.substr(0, 1 << 30);                    // it counts with 32 bits
            stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(next.data()));  // it is not changed
            stream.avail_in = static_cast<uInt>(next.size());
            packed.remove_prefix(next.size());
        }
        stream.next_out = buffer.data();
        stream.avail_out = static_cast<uInt>(buffer.size());
        result = inflate(&stream, Z_NO_FLUSH);
        size += buffer.size() - stream.avail_out;
    }
    return size;
}

// An archive may say that it holds less than it does; the library would read for ever, and take all memory.
void expectTrueSizes(std::span<const std::uint8_t> archive) {
    for (const ZipEntry& entry : zipDirectory(archive)) {
        const std::string name = base::quote(entry.name);
        if (entry.method != 0 && entry.method != Z_DEFLATED)
            throw std::runtime_error{
                fmt::format("expected stored or deflated files in a 3MF, found {} by method {}", name, entry.method)};
        const std::uint64_t size = entry.method == 0 ? entry.packed.size() : inflatedSize(entry.packed, entry.size);
        if (size != entry.size)
            throw std::runtime_error{fmt::format("expected {} bytes in {} of a 3MF, found {}", entry.size, name,
                                                 size < entry.size ? std::to_string(size) : "more")};
    }
}

}  // namespace
}  // namespace inkedge::cad

int main(int count, char** arguments) {
    using namespace inkedge::cad;
    runProgram([&]() -> std::string {
        const Request request = Request::of(count, arguments);
        std::vector<std::uint8_t> bytes = bytesOfFile();
        expectTrueSizes(bytes);
        sendReady(Reading{std::move(bytes), request}.model());
        return {};
    });
}
