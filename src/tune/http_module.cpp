// HTTP by cpp-httplib.
#include <exception>

#include <httplib.h>

#include <inkedge/export.h>

#include "modules/failure.h"
#include "tune/http.h"

namespace inkedge::tune {
namespace {

constexpr std::size_t largestBody = std::size_t{1} << 20U;  // bytes: settings are a few thousand
constexpr std::size_t requestsOfConnection = 100'000;

HttpRequest requestOf(const httplib::Request& from) {
    HttpRequest request{from.method == "HEAD" ? "GET" : from.method,
                        from.path,
                        from.get_header_value("Host"),
                        from.get_header_value("Origin"),
                        from.get_header_value("X-Inkedge-Token"),
                        from.body};
    if (request.token.empty() && from.has_param("token")) request.token = from.get_param_value("token");
    return request;
}

std::string serve(int port, const std::function<HttpAnswer(const HttpRequest&)>& answer,
                  const std::function<void(int)>& waiting) {
    httplib::Server server;
    server.new_task_queue = [] { return new httplib::ThreadPool(httpThreads()); };
    server.set_payload_max_length(largestBody);
    server.set_keep_alive_max_count(requestsOfConnection);
    server.set_tcp_nodelay(true);
    // cpp-httplib's own option, SO_REUSEPORT, lets another server have the same port.
    server.set_socket_options([](socket_t socket) {
        const int yes = 1;
        (void)setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    const httplib::Server::Handler handle = [&](const httplib::Request& from, httplib::Response& to) {
        const HttpAnswer given = answer(requestOf(from));
        to.status = given.status;
        for (const auto& [name, value] : given.headers) to.set_header(name, value);
        to.set_content(given.body.data(), given.body.size(), given.type);
    };
    const std::string all = "[^]*";
    server.Get(all, handle).Post(all, handle).Put(all, handle).Patch(all, handle).Delete(all, handle);
    server.Options(all, handle);
    if (port == 0) {
        port = server.bind_to_any_port("127.0.0.1");
        if (port < 0) return "no port of 127.0.0.1 is free";
    } else if (!server.bind_to_port("127.0.0.1", port)) {
        return "port " + std::to_string(port) + " of 127.0.0.1 is taken or not allowed";
    }
    waiting(port);
    server.listen_after_bind();
    return "it waits no longer";
}

}  // namespace

extern "C" INKEDGE_API const HttpFunctions* inkedge_http_1() noexcept {
    static constexpr HttpFunctions functions{[](int port, const auto& answer, const auto& waiting) {
        try {
            return serve(port, answer, waiting);
        } catch (const std::exception& exception) {
            return modules::oneLine(exception.what());
        }
    }};
    return &functions;
}

}  // namespace inkedge::tune
