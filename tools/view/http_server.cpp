#include "tools/view/http_server.h"

#include "libscene/base/error.h"

#include <fmt/format.h>
#include <httplib.h>
#include <nlohmann/json.hpp>

#include <poll.h>
#include <sys/random.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <chrono>
#include <condition_variable>
#include <list>
#include <mutex>
#include <optional>
#include <string_view>
#include <system_error>
#include <thread>

namespace masu {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr std::size_t largest_head = 8192; // bytes
constexpr seconds time_for_head{5}, time_for_next_request{60}, time_for_reply{20};

bool wait_for(int socket, short events, Clock::time_point end) {
  for (;;) {
    const auto left = std::chrono::duration_cast<milliseconds>(end - Clock::now()).count();
    if (left <= 0) return false;
    pollfd entry{socket, events, 0};
    const int ready = poll(&entry, 1, static_cast<int>(left));
    if (ready > 0) return true;
    if (ready < 0 && errno != EINTR) return false;
  }
}

bool send_all(int socket, std::string_view bytes, Clock::time_point end) {
  while (!bytes.empty()) {
    const ssize_t sent = send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(sent));
    } else if (errno != EINTR &&
               ((errno != EAGAIN && errno != EWOULDBLOCK) || !wait_for(socket, POLLOUT, end))) {
      return false;
    }
  }
  return true;
}

bool has_hung_up(int socket) {
  pollfd entry{socket, POLLRDHUP, 0};
  return poll(&entry, 1, 0) > 0 && (entry.revents & (POLLRDHUP | POLLHUP | POLLERR)) != 0;
}

// A request's head up to its empty line; none where the client sends none in time, or too long a one. `rest`
// has what has come already, and gets what comes behind the head. `patience` is for the first byte.
std::optional<std::string> read_head(int socket, std::string& rest, seconds patience) {
  Clock::time_point end = Clock::now() + (rest.empty() ? patience : time_for_head);
  for (;;) {
    if (const std::size_t length = rest.find("\r\n\r\n"); length != std::string::npos) {
      std::string head = rest.substr(0, length + 4);
      rest.erase(0, length + 4);
      return head;
    }
    if (rest.size() >= largest_head || !wait_for(socket, POLLIN, end)) return {};
    std::array<char, 2048> bytes{};
    const ssize_t got = recv(socket, bytes.data(), std::min(bytes.size(), largest_head - rest.size()), 0);
    if (got == 0 || (got < 0 && errno != EINTR && errno != EAGAIN)) return {};
    if (got <= 0) continue;
    if (rest.empty()) end = std::min(end, Clock::now() + time_for_head);
    rest.append(bytes.data(), static_cast<std::size_t>(got));
  }
}

// The status line of a refusal; null where the head is in order. Ranges are refused since a header of a few
// bytes could ask for a reply many times over.
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

// What cpp-httplib reads and writes: a head that has come already, and the socket.
class Exchange final : public httplib::Stream {
public:
  Exchange(int socket, const std::string& head) : socket_(socket), head_(head) {}

  bool is_readable() const override { return !head_.empty(); }
  bool is_writable() const override { return true; }
  ssize_t read(char* bytes, std::size_t size) override {
    const std::size_t count = std::min(size, head_.size());
    std::copy_n(head_.data(), count, bytes);
    head_.remove_prefix(count);
    return static_cast<ssize_t>(count);
  }
  ssize_t write(const char* bytes, std::size_t size) override {
    if (!send_all(socket_, {bytes, size}, end_)) return -1;
    return static_cast<ssize_t>(size);
  }
  void get_remote_ip_and_port(std::string&, int&) const override {}
  void get_local_ip_and_port(std::string&, int&) const override {}
  socket_t socket() const override { return socket_; }
  void begin_reply() { end_ = Clock::now() + time_for_reply; }

private:
  int socket_;
  std::string_view head_;
  Clock::time_point end_ = Clock::now() + time_for_reply;
};

// Connections that are open. `waiting` is of those whose client has nothing to get: it owes a request.
class Connections {
public:
  struct Entry {
    int socket;
    bool waiting;
  };
  using Place = std::list<Entry>::iterator;

  Place add(int socket) {
    const std::lock_guard lock(mutex_);
    return entries_.insert(entries_.end(), {socket, true});
  }
  // Its socket may be closed from then on.
  void remove(Place place) {
    const std::lock_guard lock(mutex_);
    entries_.erase(place);
  }
  // To the end of the list, so that the one that has been waiting longest stays first.
  void set_waiting(Place place, bool waiting) {
    const std::lock_guard lock(mutex_);
    place->waiting = waiting;
    entries_.splice(entries_.end(), entries_, place);
  }
  // False where none waits.
  bool hang_up_longest_waiting() {
    const std::lock_guard lock(mutex_);
    const auto entry = std::ranges::find_if(entries_, &Entry::waiting);
    if (entry == entries_.end()) return false;
    entry->waiting = false;
    shutdown(entry->socket, SHUT_RDWR);
    return true;
  }
  void hang_up_all() {
    const std::lock_guard lock(mutex_);
    for (const Entry& entry : entries_)
      shutdown(entry.socket, SHUT_RDWR);
  }

private:
  std::mutex mutex_;
  std::list<Entry> entries_;
};

// A thread for each connection. Beyond `most`, the connection that has been waiting longest gives way; those
// that give way are waited for at twice as many. Where none waits, the task runs on the thread that accepts
// connections, whose connections are refused.
class ConnectionThreads final : public httplib::TaskQueue {
public:
  ConnectionThreads(Connections& connections, std::size_t most) : connections_(connections), most_(most) {}

  using Enqueued =
      decltype(std::declval<httplib::TaskQueue&>().enqueue({})); // void, and bool in later versions
  Enqueued enqueue(std::function<void()> task) override {
    if (!start(task)) task();
    return static_cast<Enqueued>(true);
  }
  void shutdown() override {
    connections_.hang_up_all();
    std::unique_lock lock(mutex_);
    ended_.wait(lock, [this] { return threads_ == 0; });
  }

private:
  bool start(const std::function<void()>& task) {
    std::unique_lock lock(mutex_);
    if (threads_ >= most_ && !connections_.hang_up_longest_waiting()) return false;
    if (!ended_.wait_for(lock, seconds(1), [this] { return threads_ < 2 * most_; })) return false;
    ++threads_;
    lock.unlock();
    try {
      std::thread([this, task] {
        task();
        const std::lock_guard end(mutex_);
        --threads_;
        ended_.notify_all();
      }).detach();
      return true;
    } catch (const std::system_error&) { // no more threads
      lock.lock();
      --threads_;
      return false;
    }
  }

  Connections& connections_;
  std::size_t most_;
  std::mutex mutex_;
  std::condition_variable ended_;
  std::size_t threads_ = 0;
};

// Independent of where the first difference is.
bool are_equal(const std::string& a, const std::string& b) {
  unsigned difference = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    difference |= static_cast<unsigned>(static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]));
  return difference == 0;
}

std::string cookie(const std::string& header, const std::string& name) {
  for (std::size_t begin = 0; begin < header.size();) {
    const std::size_t end = std::min(header.find(';', begin), header.size());
    const std::size_t first = std::min(header.find_first_not_of(' ', begin), end);
    if (header.compare(first, name.size() + 1, name + "=") == 0)
      return header.substr(first + name.size() + 1, end - first - name.size() - 1);
    begin = end + 1;
  }
  return {};
}

// Without the port. Addresses of IPv6 keep their brackets.
std::string host_name(const std::string& host) {
  const std::size_t bracket = host.find(']');
  return host.substr(0, bracket != std::string::npos ? bracket + 1 : host.find(':'));
}

httplib::Headers reply_headers() {
  return {{"Cache-Control", "no-store"},
          {"Content-Security-Policy", "default-src 'none'; script-src 'self'; style-src 'self'; connect-src "
                                      "'self'; img-src 'self' blob: data:; "
                                      "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
          {"Cross-Origin-Opener-Policy", "same-origin"},
          {"Cross-Origin-Resource-Policy", "same-origin"},
          {"Referrer-Policy", "no-referrer"},
          {"X-Content-Type-Options", "nosniff"},
          {"X-Frame-Options", "DENY"}};
}

} // namespace

bool is_loopback_host(const std::string& host) {
  const std::string name = host_name(host);
  return name == "localhost" || name == "127.0.0.1" || name == "[::1]";
}

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

// --- The server -------------------------------------------------------------------------------------------

class HttpServer::Guarded final : public httplib::Server {
public:
  Guarded(const HttpSettings& settings, HttpHandler handler)
      : settings_(settings), handler_(std::move(handler)) {
    new_task_queue = [this] { return new ConnectionThreads(connections_, settings_.connections); };
    set_default_headers(reply_headers());
    set_tcp_nodelay(true);
    set_keep_alive_timeout(time_for_next_request.count()); // what replies say of it; converse() keeps it
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
  }

  // The port, or -1.
  int bind() {
    if (settings_.port == 0) return port_ = bind_to_any_port(settings_.address);
    return port_ = bind_to_port(settings_.address, settings_.port) ? settings_.port : -1;
  }

  void serve() {
    accepting_ = std::this_thread::get_id();
    do {
      listen_after_bind(); // ends where a connection can't be accepted, too
      if (!is_ended_ && !bind_to_port(settings_.address, port_))
        throw Error(ErrorCode::usage, fmt::format("port {}", port_), "was lost: start again");
    } while (!is_ended_);
  }

  void end() {
    is_ended_ = true;
    stop();
  }

private:
  bool process_and_close_socket(socket_t socket) override {
    const auto place = connections_.add(socket);
    if (std::this_thread::get_id() == accepting_)
      refuse(socket, "503 Service Unavailable");
    else
      converse(socket, place);
    connections_.remove(place);
    ::shutdown(socket, SHUT_RDWR);
    ::close(socket);
    return true;
  }

  static void refuse(int socket, const char* status) {
    send_all(socket, fmt::format("HTTP/1.1 {}\r\nContent-Length: 0\r\nConnection: close\r\n\r\n", status),
             Clock::now() + milliseconds(10));
  }

  void converse(int socket, Connections::Place place) {
    std::string rest;
    bool closed = false;
    for (bool first = true; !closed; first = false) {
      const auto head = read_head(socket, rest, first ? time_for_head : time_for_next_request);
      if (!head) return;
      if (const char* const fault = fault_of(*head)) return refuse(socket, fault);
      connections_.set_waiting(place, false);
      Exchange exchange(socket, *head);
      if (!process(*this, exchange, closed)) return;
      connections_.set_waiting(place, true);
    }
  }

  // process_request() takes the addresses of both ends, too, in later versions.
  template <class Self>
  static bool process(Self& self, Exchange& exchange, bool& closed) {
    const auto set_up = [&exchange](httplib::Request& request) {
      request.headers.erase(socket_header);
      request.set_header(socket_header, std::to_string(exchange.socket()));
      exchange.begin_reply();
    };
    if constexpr (requires { self.process_request(exchange, false, closed, set_up); })
      return self.process_request(exchange, false, closed, set_up);
    else
      return self.process_request(exchange, "", 0, "", 0, false, closed, set_up);
  }

  void answer(const httplib::Request& request, httplib::Response& response) const {
    const std::string host = request.get_header_value("Host");
    const auto fail = [&](int status, const char* why) {
      response.status = status;
      response.set_content(nlohmann::json{{"error", why}}.dump(), "application/json");
    };
    if (request.get_header_value_count("Host") != 1 || host.empty()) return fail(400, "no host is named");
    if (settings_.token.empty() && !is_loopback_host(host)) return fail(421, "another host is named");
    if (request.has_header("Origin") && request.get_header_value("Origin") != "http://" + host &&
        request.get_header_value("Origin") != "https://" + host)
      return fail(403, "another origin");
    const std::string site = request.get_header_value("Sec-Fetch-Site");
    const bool is_page = request.path == "/";
    if (!site.empty() && site != "same-origin" && site != "none" &&
        !(is_page && request.get_header_value("Sec-Fetch-Dest") == "document"))
      return fail(403, "another site");
    HttpRequest query{request.path, {}, [&request] { return has_hung_up(socket_of(request)); }};
    for (const auto& [name, value] : request.params) {
      if (!query.parameters.emplace(name, value).second) return fail(400, "a parameter is given twice");
    }
    if (!settings_.token.empty()) {
      const std::string name = fmt::format("masu_{}", port_);
      if (is_page && query.parameters.contains("token") &&
          are_equal(query.parameters.at("token"), settings_.token)) {
        response.set_header("Set-Cookie",
                            fmt::format("{}={}; HttpOnly; SameSite=Strict; Path=/", name, settings_.token));
        response.set_header("Location", "/");
        response.status = 303;
        return;
      }
      if (!are_equal(cookie(request.get_header_value("Cookie"), name), settings_.token))
        return fail(401, "the token is missing: open the address that gridview printed");
    }
    reply(query, response, fail);
  }

  template <class Fail>
  void reply(const HttpRequest& query, httplib::Response& response, const Fail& fail) const {
    try {
      const HttpReply made = handler_(query);
      response.status = made.status;
      if (!made.timing.empty()) response.set_header("Server-Timing", made.timing);
      if (!made.body.empty()) response.set_content(made.body, made.type);
    } catch (const Error& error) {
      fail(error.code() == ErrorCode::usage ? 400 : 500, error.what());
    } catch (const std::exception& error) {
      fail(500, error.what());
    }
  }

  static int socket_of(const httplib::Request& request) {
    return std::stoi(request.get_header_value(socket_header));
  }

  static constexpr const char* socket_header = "Masu-Socket"; // replaces a client's own

  HttpSettings settings_;
  HttpHandler handler_;
  Connections connections_;
  std::thread::id accepting_;
  std::atomic<bool> is_ended_ = false;
  int port_ = 0;
};

HttpServer::HttpServer(const HttpSettings& settings, HttpHandler handler)
    : server_(std::make_unique<Guarded>(settings, std::move(handler))), port_(server_->bind()) {
  if (port_ < 0)
    throw Error(ErrorCode::usage, fmt::format("{} port {}", settings.address, settings.port),
                "can't be listened on: choose another --port or --bind");
}
HttpServer::~HttpServer() = default;

void HttpServer::serve() {
  server_->serve();
}
void HttpServer::stop() {
  server_->end();
}

} // namespace masu
