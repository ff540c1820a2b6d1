#include "tools/edit_seams/server.h"

#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/version.hpp>
#include <chrono>
#include <csignal>
#include <random>

#include "geometry/error.h"

namespace toile {

/// Who may ask: pages of other sites may send requests here, but they can't know the token. A name
/// that another site lets point here is another host.
struct ServerDoor {
  std::string host;   ///< with the port
  std::string local;  ///< the same, by the name of this machine
  std::string path;   ///< the token between slashes

  bool opens_for(
      const boost::beast::http::request<boost::beast::http::string_body>& request) const {
    const auto host_asked = request[boost::beast::http::field::host];
    return (host_asked == host || host_asked == local) && request.target().starts_with(path);
  }
};

namespace {

namespace beast = boost::beast;
namespace http = beast::http;
namespace asio = boost::asio;
using Tcp = asio::ip::tcp;
using Handler = std::function<Answer(const Request&)>;

constexpr std::uint64_t max_body = 64 << 20;  // bytes
constexpr auto patience = std::chrono::seconds(30);
constexpr auto patience_for_strangers = std::chrono::seconds(5);  // until the header is there
constexpr auto patience_after = std::chrono::seconds(1);          // until the client closes
constexpr auto pause_after_failure = std::chrono::milliseconds(100);
// Browsers open six at a time; each may hold a body in memory.
constexpr int max_connections = 24;
constexpr const char* nothing_here = "There is nothing here.";

std::string random_token() {
  std::random_device source;  // of the system's own generator
  std::string token;
  for (int i = 0; i < 32; ++i) token += "0123456789abcdef"[source() % 16];
  return token;
}

ServerDoor door_of(const std::string& address) {
  const std::size_t host = address.find("//") + 2;
  const std::size_t path = address.find('/', host);
  const std::string name = address.substr(host, path - host);
  return {name, "localhost" + name.substr(name.find(':')), address.substr(path)};
}

/// One request of one connection, and its answer. `done` is called once the connection is over.
class Session : public std::enable_shared_from_this<Session> {
 public:
  Session(Tcp::socket socket, const ServerDoor& door, const Handler& handler,
          std::function<void()> done)
      : stream_(std::move(socket)), door_(door), handler_(handler), done_(std::move(done)) {
    parser_.body_limit(max_body);
  }
  ~Session() {
    // The place is free once its descriptor is.
    stream_.close();
    done_();
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  void start() {
    stream_.expires_after(patience_for_strangers);
    http::async_read_header(stream_, buffer_, parser_,
                            [self = shared_from_this()](beast::error_code failed, std::size_t) {
                              if (!failed || failed == http::error::body_limit)
                                self->look(failed.failed());
                            });
  }

 private:
  /// The body of a request is read only where its address is right.
  void look(bool is_too_large) {
    if (!door_.opens_for(parser_.get())) {
      send({404, "text/plain", nothing_here});
      return;
    }
    if (is_too_large) {
      send({413, "text/plain", "That is more than 64 MiB."});
      return;
    }
    // A client that waits for this word, as curl does, sends no large body before.
    if (beast::iequals(parser_.get()[http::field::expect], "100-continue")) {
      stream_.expires_after(patience);
      interim_ = {http::status::continue_, 11};
      http::async_write(stream_, interim_,
                        [self = shared_from_this()](beast::error_code failed, std::size_t) {
                          if (!failed) self->read();
                        });
      return;
    }
    read();
  }

  void read() {
    stream_.expires_after(patience);
    http::async_read(stream_, buffer_, parser_,
                     [self = shared_from_this()](beast::error_code failed, std::size_t) {
                       if (failed == http::error::body_limit) {
                         self->send({413, "text/plain", "That is more than 64 MiB."});
                       } else if (!failed) {
                         self->answer();
                       }
                     });
  }

  void answer() {
    auto& request = parser_.get();
    const std::string_view target(request.target().data(), request.target().size());
    send(handler_({std::string(request.method_string()),
                   std::string(target.substr(door_.path.size())), std::move(request.body())}));
  }

  void send(Answer given) {
    answer_ = {static_cast<http::status>(given.status), 11};
    answer_.set(http::field::content_type, given.type);
    answer_.set(http::field::cache_control, "no-store");
    answer_.set("X-Content-Type-Options", "nosniff");
    answer_.set("Referrer-Policy", "no-referrer");
    answer_.keep_alive(false);
    answer_.body() = std::move(given.body);
    answer_.prepare_payload();
    stream_.expires_after(patience);
    http::async_write(stream_, answer_,
                      [self = shared_from_this()](beast::error_code failed, std::size_t) {
                        if (failed) return;
                        beast::error_code ignored;
                        self->stream_.socket().shutdown(Tcp::socket::shutdown_send, ignored);
                        self->stream_.expires_after(patience_after);
                        self->drop();
                      });
  }

  /// Throws away what is still sent. To close before it is read would reset the connection, and
  /// take the answer with it.
  void drop() {
    stream_.async_read_some(asio::buffer(dropped_),
                            [self = shared_from_this()](beast::error_code failed, std::size_t) {
                              if (!failed) self->drop();
                            });
  }

  beast::tcp_stream stream_;
  beast::flat_buffer buffer_;
  http::request_parser<http::string_body> parser_;
  http::response<http::empty_body> interim_;
  http::response<http::string_body> answer_;
  std::array<char, 4096> dropped_ = {};
  const ServerDoor& door_;
  const Handler& handler_;
  std::function<void()> done_;
};

}  // namespace

struct Server::Listener {
  explicit Listener(const Tcp::endpoint& here) : acceptor(context, here), pause(context) {}

  // Destroyed last: the sessions that it holds count themselves off.
  int open = 0;  // connections
  bool waits = false;
  ServerDoor door;
  asio::io_context context{1};
  Tcp::acceptor acceptor;
  asio::steady_timer pause;

  void accept(const Handler& handler) {
    // Further connections wait in the system's queue.
    waits = open >= max_connections;
    if (waits) return;
    acceptor.async_accept([this, &handler](beast::error_code failed, Tcp::socket socket) {
      if (failed == asio::error::operation_aborted) return;
      if (failed) {
        // Such as too many open files. To try again at once would keep a core busy.
        pause.expires_after(pause_after_failure);
        pause.async_wait([this, &handler](beast::error_code ended) {
          if (!ended) accept(handler);
        });
        return;
      }
      ++open;
      std::make_shared<Session>(std::move(socket), door, handler, [this, &handler] {
        --open;
        if (waits && !context.stopped()) accept(handler);
      })->start();
      accept(handler);
    });
  }
};

Server::Server(int port) : token_(random_token()) {
  const Tcp::endpoint here(asio::ip::address_v4::loopback(), static_cast<std::uint16_t>(port));
  try {
    listener_ = std::make_unique<Listener>(here);
  } catch (const boost::system::system_error& problem) {
    throw Error("--port " + std::to_string(port), problem.code().message(),
                "give another port, or none");
  }
}

Server::~Server() = default;

std::string Server::address() const {
  return "http://127.0.0.1:" + std::to_string(listener_->acceptor.local_endpoint().port()) + "/" +
         token_ + "/";
}

void Server::run(const Handler& answer) {
  asio::signal_set signals(listener_->context, SIGINT, SIGTERM, SIGHUP);
  signals.async_wait([&](beast::error_code, int) { listener_->context.stop(); });
  listener_->door = door_of(address());
  listener_->accept(answer);
  listener_->context.run();
}

}  // namespace toile
