// The program that reads CAD files for the library, in a process of its own: OpenCASCADE may crash, or never end.
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Standard_Failure.hxx>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "formats/cad/occt_document.h"
#include "formats/cad/occt_mesh.h"
#include "formats/cad/program_side.h"
#include "formats/cad/request.h"
#include "formats/text.h"
#include "process/large_pages.h"

namespace inkedge::cad {
namespace {

// A mesh that is this much finer than it need be, or coarser, is as good.
constexpr double goodEnough = 1.25;
// What is guessed from a box is guessed too large.
constexpr double ofBoxes = 0.7;

CadFormat formatOf(std::string_view name) {
    return name == "STEP" ? CadFormat::Step : name == "IGES" ? CadFormat::Iges : CadFormat::Brep;
}

class Reading {
public:
    explicit Reading(const Request& request) : request_{request} {}

    void run() {
        read(Healing::Quick);
        if (document_.mendedLess && std::ranges::any_of(document_.parts, lacksTriangles)) read(Healing::Full);
        std::vector<std::vector<glm::dvec3>> points;
        for (const DocumentPart& part : document_.parts) points.push_back(pointsOf(part));
        makeFine(std::move(points), 1.0);
        sendReady(model());
    }

private:
    void read(Healing healing) {
        const std::string file = fmt::format("/proc/self/fd/{}", process::bytesDescriptor);
        document_ = readDocument(file.c_str(), formatOf(request_.format), healing, request_);
        deflections_.assign(document_.parts.size(), 0.0);
        for (DocumentPart& part : document_.parts) bringToUsualSize(part);
        std::vector<std::vector<glm::dvec3>> boxes;
        for (const DocumentPart& part : document_.parts) boxes.push_back(boxOf(part));
        makeFine(std::move(boxes), ofBoxes);
    }

    // Asks how fine the parts are to be, and makes those anew that are not.
    void makeFine(std::vector<std::vector<glm::dvec3>> points, double share) {
        Outline outline;
        outline.parts = std::move(points);
        outline.instances = document_.model.instances;
        send(outline);
        const auto wanted = receive<Fineness>().deflections;
        for (std::size_t i = 0; i < deflections_.size() && i < wanted.size(); ++i) {
            if (outline.parts[i].empty() || !(wanted[i] > 0.0) || !std::isfinite(wanted[i])) continue;
            const double deflection = share * wanted[i];
            if (deflections_[i] > 0.0 && deflections_[i] <= goodEnough * deflection) continue;
            tessellate(document_.parts[i], deflection);
            deflections_[i] = deflection;
        }
    }

    Model model() {
        Model model = std::move(document_.model);
        std::uint64_t vertices = 0;
        for (std::size_t i = 0; i < document_.parts.size(); ++i) {
            model.parts.push_back(meshOf(document_.parts[i], deflections_[i]));
            vertices += model.parts.back().positions.size() + model.parts.back().indices.size();
            if (vertices > request_.maxVertices)
                throw std::runtime_error{
                    fmt::format("expected at most {} vertices and indices, found more; raise max-vertices or tolerance",
                                request_.maxVertices)};
        }
        addLoose(model);
        return model;
    }

    // Says in one line what is not drawn.
    void addLoose(Model& model) const {
        const auto add = [&](std::uint64_t count, std::string_view word) {
            if (count > 0) model.undrawn.push_back(formats::counted(count, word));
        };
        add(document_.curves, "curve");
        add(document_.points, "point");
        add(document_.invisible, "invisible item");
        if (document_.unreadable > 0)
            model.undrawn.push_back(formats::counted(document_.unreadable, "item") + " that OpenCASCADE cannot read");
    }

    const Request& request_;
    Document document_;
    std::vector<double> deflections_;  // one per part: as it is tessellated; 0: not yet
};

std::string run(const Request& request) {
    try {
        Message::DefaultMessenger()->ChangePrinters().Clear();
        Reading{request}.run();
    } catch (const Standard_Failure& failure) {
        const char* const message = failure.GetMessageString();
        return modules::oneLine(fmt::format("expected a model that OpenCASCADE reads, found {} in it{}{}",
                                            failure.DynamicType()->Name(), *message != '\0' ? ": " : "", message));
    }
    return {};
}

}  // namespace
}  // namespace inkedge::cad

int main(int count, char** arguments) {
    inkedge::process::useLargePages();
    inkedge::cad::runProgram([&] { return inkedge::cad::run(inkedge::cad::Request::of(count, arguments)); });
}
