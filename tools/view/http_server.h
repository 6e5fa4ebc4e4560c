// HTTP for one page: cpp-httplib's server, which by itself reads heads of any length for as long as bytes
// come. Here they are bounded in size and time, and so are connections.
//
// Only GET and HEAD are heard, without a body. Requests of other origins, and those that name another host
// than this one (DNS rebinding), are refused.
#pragma once

#include <httplib.h>

#include <functional>
#include <map>
#include <string>

namespace masu {

struct HttpRequest {
  std::string path;
  std::map<std::string, std::string> parameters;
  std::function<bool()> is_gone; // whether the client has hung up: nobody needs the reply
};

struct HttpReply {
  int status = 200;
  std::string type = "application/json", body{};
  std::string timing{}; // header Server-Timing
};

// Called by many threads at once. An Error becomes status 400, any other exception 500.
using HttpHandler = std::function<HttpReply(const HttpRequest&)>;

class HttpServer final : public httplib::Server {
public:
  // port 0: any that is free. Without the token nothing is heard but /?token=TOKEN, which sets a cookie; an
  // empty one: no token. Throws Error(usage) where the address and port can't be had.
  HttpServer(std::string address, int port, std::string token, HttpHandler handler);

  int port() const { return port_; }
  // Until stop(), which any thread may call.
  void serve();

private:
  bool process_and_close_socket(socket_t socket) override;
  void answer(const httplib::Request& request, httplib::Response& response) const;

  std::string address_, token_;
  HttpHandler handler_;
  int port_;
};

// Whether an address to listen on is a loopback one.
bool is_loopback_address(const std::string& address);

// 128 random bits as hexadecimal digits.
std::string random_token();

} // namespace masu
