#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "modules/open_module.h"

// The interface between the library and the module that speaks HTTP. cpp-httplib brings OpenSSL and Brotli.

namespace inkedge::tune {

struct HttpRequest {
    std::string method;
    std::string path;  ///< without what comes after "?"
    std::string host;  ///< headers; empty: not there
    std::string origin;
    std::string token;  ///< the header X-Inkedge-Token, or what the address says of "token"
    std::string body;
};

struct HttpAnswer {
    int status = 200;
    std::string type = "application/json";
    std::string body = {};
    std::vector<std::pair<std::string, std::string>> headers = {};
};

struct HttpFunctions {
    /// Waits at a port of 127.0.0.1 and answers requests, several at the same time, until the process ends.
    /// @param port     0: any that is free
    /// @param answer   called on several threads; throws nothing
    /// @param waiting  called once the port is taken, with its number; requests are answered after it
    /// @return         why it ended; there is always a reason
    std::string (*serve)(int port, const std::function<HttpAnswer(const HttpRequest&)>& answer,
                         const std::function<void(int port)>& waiting);
};

/// Requests at the same time. A connection that a tab keeps open has a thread to itself, and a browser keeps six.
inline std::size_t httpThreads() { return 48; }

inline constexpr modules::ModuleOf<HttpFunctions> httpModule{{.purpose = "the live page",
                                                              .file = "inkedge_http.so",
                                                              .symbol = "inkedge_http_1",
                                                              .library = "cpp-httplib",
                                                              .option = "INKEDGE_TUNE",
                                                              .remedy = "draw with inkedge render",
                                                              .threads = httpThreads}};

}  // namespace inkedge::tune
