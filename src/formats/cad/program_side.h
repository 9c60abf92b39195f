#pragma once

#include <unistd.h>

#include <exception>
#include <new>
#include <string>

#include "formats/cad/model.h"
#include "formats/cad/pack.h"
#include "modules/failure.h"
#include "process/program_side.h"

// What programs have in common that read files for the library, each in a process of its own: libraries may crash over
// a file, or never end.
namespace inkedge::cad {

template <class T>
void send(const T& value) {
    process::sendMessage(packed(value));
}

template <class T>
T receive() {
    return unpacked<T>(process::receiveMessage());
}

/// Sends a model of which nothing is to be asked.
inline void sendReady(const Model& model) {
    Outline ready;
    ready.ready = true;
    send(ready);
    send(model);
}

/// Does the work of such a program and ends it. What the work throws, or returns if it is not empty, is sent as the
/// reason why there is no model.
template <class Work>
[[noreturn]] void runProgram(Work work) {
    process::becomeDependent();
    Outline failed;
    try {
        failed.failure = work();
    } catch (const std::bad_alloc&) {
        failed.failure = modules::outOfMemory;
    } catch (const std::exception& exception) {
        failed.failure = modules::oneLine(exception.what());
    }
    if (!failed.failure.empty()) send(failed);
    ::_exit(0);  // what the libraries would tidy up ends with the process
}

}  // namespace inkedge::cad
