#include "tools/view/http_server.h"

#include "libscene/base/error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <poll.h>
#include <sys/random.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <memory>
#include <optional>
#include <semaphore>
#include <sstream>
#include <string_view>

namespace masu {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::seconds;

constexpr std::size_t largest_head = 8192; // bytes
constexpr seconds time_for_silence{5};
constexpr seconds time_for_head{5}, time_for_reply{20}; // from the first byte on
// Served at once, and together with those that wait for a thread. FD_SETSIZE bounds the library's sockets.
constexpr std::size_t connection_threads = 128, most_connections = 512;

// A request's head up to its empty line; none where the client sends none in time, or too long a one. `rest`
// has what has come already, and gets what comes behind the head. A call takes no longer than the server's
// read timeout.
std::optional<std::string> read_head(int socket, std::string& rest) {
  Clock::time_point end = Clock::now() + time_for_head;
  for (;;) {
    if (const std::size_t length = rest.find("\r\n\r\n"); length != std::string::npos) {
      std::string head = rest.substr(0, length + 4);
      rest.erase(0, length + 4);
      return head;
    }
    if (rest.size() >= largest_head || (!rest.empty() && Clock::now() > end)) return {};
    std::array<char, 2048> bytes{};
    const std::size_t most = std::min(bytes.size(), largest_head - rest.size());
    const ssize_t got = TEMP_FAILURE_RETRY(recv(socket, bytes.data(), most, 0));
    if (got <= 0) return {};
    if (rest.empty()) end = Clock::now() + time_for_head;
    rest.append(bytes.data(), static_cast<std::size_t>(got));
  }
}

// The status line of a refusal; null where the head is in order. Ranges are refused since a header of a few
// bytes could ask for a reply many times over, and one of 8 KiB takes the library megabytes of stack to
// parse.
const char* fault_of(std::string head) {
  std::ranges::transform(head, head.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (!head.starts_with("get ") && !head.starts_with("head ")) return "405 Method Not Allowed";
  const auto is_foreign = [](unsigned char c) {
    return (c < 0x20 && c != '\r' && c != '\n' && c != '\t') || c > 0x7e;
  };
  if (std::ranges::any_of(head, is_foreign)) return "400 Bad Request";
  for (const char* const body : {"\ncontent-length:", "\ntransfer-encoding:", "\nexpect:", "\nupgrade:"}) {
    if (head.find(body) != std::string::npos) return "413 Payload Too Large";
  }
  if (head.find("\nrange:") != std::string::npos) return "416 Range Not Satisfiable";
  return nullptr;
}

bool has_hung_up(int socket) {
  pollfd entry{socket, POLLRDHUP, 0};
  return poll(&entry, 1, 0) > 0 && (entry.revents & (POLLRDHUP | POLLHUP | POLLERR)) != 0;
}

// What the library reads and writes: a head that has come already, and the socket.
class Exchange final : public httplib::Stream {
public:
  Exchange(int socket, const std::string& head) : socket_(socket), head_(head) {}

  bool is_readable() const override { return !head_.empty(); }
  bool is_writable() const override { return true; }
  ssize_t read(char* bytes, std::size_t size) override {
    const std::size_t count = head_.copy(bytes, size);
    head_.remove_prefix(count);
    return static_cast<ssize_t>(count);
  }
  // A call takes no longer than the server's write timeout.
  ssize_t write(const char* bytes, std::size_t size) override {
    const Clock::time_point now = Clock::now();
    if (!end_) end_ = now + time_for_reply;
    if (now > *end_) return -1;
    return TEMP_FAILURE_RETRY(send(socket_, bytes, size, MSG_NOSIGNAL));
  }
  void get_remote_ip_and_port(std::string&, int&) const override {}
  void get_local_ip_and_port(std::string&, int&) const override {}
  socket_t socket() const override { return socket_; }

private:
  int socket_;
  std::string_view head_;
  std::optional<Clock::time_point> end_; // of the reply, once it has begun
};

// Beyond `most_connections` none is accepted until one has ended: they wait in the system's queue.
class BoundedPool final : public httplib::TaskQueue {
public:
  // void, and bool in later versions
  using Enqueued = decltype(std::declval<httplib::TaskQueue&>().enqueue({}));
  Enqueued enqueue(std::function<void()> task) override {
    places_.acquire();
    pool_.enqueue([this, task] {
      task();
      places_.release();
    });
    return static_cast<Enqueued>(true);
  }
  void shutdown() override { pool_.shutdown(); }

private:
  std::counting_semaphore<> places_{most_connections};
  httplib::ThreadPool pool_{connection_threads};
};

// Independent of where the first difference is.
bool are_equal(const std::string& a, const std::string& b) {
  unsigned difference = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    difference |= static_cast<unsigned>(static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]));
  return difference == 0;
}

std::string cookie(const std::string& header, const std::string& name) {
  std::istringstream entries(header);
  for (std::string entry; std::getline(entries, entry, ';');) {
    entry.erase(0, entry.find_first_not_of(' '));
    if (entry.starts_with(name + "=")) return entry.substr(name.size() + 1);
  }
  return {};
}

// Whether the name of a Host header, "localhost:8080", is that of a loopback address.
bool is_loopback_host(const std::string& host) {
  const std::size_t bracket = host.find(']'); // of an address of IPv6
  const std::string name = host.substr(0, bracket != std::string::npos ? bracket + 1 : host.find(':'));
  return name == "localhost" || name == "127.0.0.1" || name == "[::1]";
}

} // namespace

bool is_loopback_address(const std::string& address) {
  return address == "localhost" || address == "127.0.0.1" || address == "::1";
}

std::string random_token() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw Error(ErrorCode::device, "random numbers", "can't be had for a token: listen on 127.0.0.1");
  std::string text;
  for (const unsigned char byte : bytes)
    text += fmt::format("{:02x}", byte);
  return text;
}

HttpServer::HttpServer(std::string address, int port, std::string token, HttpHandler handler)
    : address_(std::move(address)), token_(std::move(token)), handler_(std::move(handler)), port_(port) {
  new_task_queue = [] { return new BoundedPool; };
  set_default_headers(
      {{"Cache-Control", "no-store"},
       {"Content-Security-Policy", "default-src 'none'; script-src 'self'; style-src 'self'; connect-src "
                                   "'self'; img-src 'self' blob: data:; "
                                   "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
       {"Cross-Origin-Opener-Policy", "same-origin"},
       {"Cross-Origin-Resource-Policy", "same-origin"},
       {"Referrer-Policy", "no-referrer"},
       {"X-Content-Type-Options", "nosniff"},
       {"X-Frame-Options", "DENY"}});
  set_tcp_nodelay(true);
  set_read_timeout(time_for_silence.count());
  set_write_timeout(time_for_reply.count());
  set_keep_alive_timeout(time_for_silence.count()); // what replies say of it
  set_keep_alive_max_count(1000000);
  // Not SO_REUSEPORT, the library's own: two servers would share a port.
  set_socket_options([](socket_t socket) {
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
  set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
    answer(request, response);
    return HandlerResponse::Handled;
  });
  if (port_ == 0)
    port_ = bind_to_any_port(address_);
  else if (!bind_to_port(address_, port_))
    port_ = -1;
  if (port_ < 0)
    throw Error(ErrorCode::usage, fmt::format("{} port {}", address_, port),
                "can't be listened on: choose another --port or --bind");
}

void HttpServer::serve() {
  while (!listen_after_bind()) { // a connection can't be accepted
    stop();                      // later versions listen again only then
    if (!bind_to_port(address_, port_))
      throw Error(ErrorCode::usage, fmt::format("port {}", port_), "was lost: start again");
  }
}

// The library's own loses requests that come together, and bounds neither a head's length nor its time.
bool HttpServer::process_and_close_socket(socket_t socket) {
  std::string rest;
  while (svr_sock_ != INVALID_SOCKET) {
    const auto head = read_head(socket, rest);
    if (!head) break;
    if (const char* const fault = fault_of(*head)) {
      const auto reply = fmt::format("HTTP/1.1 {}\r\nContent-Length: 0\r\nConnection: close\r\n\r\n", fault);
      send(socket, reply.data(), reply.size(), MSG_NOSIGNAL);
      break;
    }
    Exchange exchange(socket, *head);
    bool closed = false;
    const auto set_up = [socket](httplib::Request& request) { // its progress: whether to go on
      request.progress = [socket](std::uint64_t, std::uint64_t) { return !has_hung_up(socket); };
    };
    // It takes the addresses of both ends, too, in later versions.
    const auto process = [&](auto& self) {
      if constexpr (requires { self.process_request(exchange, false, closed, set_up); })
        return self.process_request(exchange, false, closed, set_up);
      else
        return self.process_request(exchange, "", 0, "", 0, false, closed, set_up);
    };
    if (!process(*this) || closed) break;
  }
  ::shutdown(socket, SHUT_RDWR);
  ::close(socket);
  return true;
}

void HttpServer::answer(const httplib::Request& request, httplib::Response& response) const {
  const auto fail = [&](int status, const char* why) {
    response.status = status;
    response.set_content(nlohmann::json{{"error", why}}.dump(), "application/json");
  };
  const std::string host = request.get_header_value("Host");
  if (request.get_header_value_count("Host") != 1 || host.empty()) return fail(400, "no host is named");
  if (token_.empty() && !is_loopback_host(host)) return fail(421, "another host is named");
  if (request.has_header("Origin") && request.get_header_value("Origin") != "http://" + host &&
      request.get_header_value("Origin") != "https://" + host)
    return fail(403, "another origin");
  const std::string site = request.get_header_value("Sec-Fetch-Site");
  const bool is_page = request.path == "/";
  if (!site.empty() && site != "same-origin" && site != "none" &&
      !(is_page && request.get_header_value("Sec-Fetch-Dest") == "document"))
    return fail(403, "another site");
  HttpRequest query{request.path, {}, [&request] { return !request.progress(0, 0); }};
  for (const auto& [name, value] : request.params) {
    if (!query.parameters.emplace(name, value).second) return fail(400, "a parameter is given twice");
  }
  if (!token_.empty()) {
    const std::string name = fmt::format("masu_{}", port_);
    if (is_page && query.parameters.contains("token") && are_equal(query.parameters.at("token"), token_)) {
      response.set_header("Set-Cookie",
                          fmt::format("{}={}; HttpOnly; SameSite=Strict; Path=/", name, token_));
      response.set_header("Location", "/");
      response.status = 303;
      return;
    }
    if (!are_equal(cookie(request.get_header_value("Cookie"), name), token_))
      return fail(401, "the token is missing: open the address that gridview printed");
  }
  try {
    HttpReply made = handler_(query);
    response.status = made.status;
    if (!made.timing.empty()) response.set_header("Server-Timing", made.timing);
    if (made.body.empty()) return;
    // By a provider of known length, which cpp-httplib doesn't compress: its Brotli takes a second a
    // megabyte.
    const auto body = std::make_shared<const std::string>(std::move(made.body));
    response.set_content_provider(body->size(), made.type,
                                  [body](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
                                    return sink.write(body->data() + offset, length);
                                  });
  } catch (const Error& error) {
    fail(error.code() == ErrorCode::usage ? 400 : 500, error.what());
  } catch (const std::exception& error) {
    fail(500, error.what());
  }
}

} // namespace masu
