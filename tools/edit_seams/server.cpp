#include "tools/edit_seams/server.h"

#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/version.hpp>
#include <chrono>
#include <csignal>
#include <optional>
#include <random>

#include "geometry/error.h"

namespace toile {

namespace {

namespace beast = boost::beast;
namespace http = beast::http;
namespace asio = boost::asio;
using Tcp = asio::ip::tcp;
using Handler = std::function<Answer(const Request&)>;

constexpr std::uint64_t max_body = 64 << 20;  // bytes
constexpr auto patience = std::chrono::seconds(30);

std::string random_token() {
  std::random_device source;  // of the system's own generator
  std::string token;
  for (int i = 0; i < 32; ++i) token += "0123456789abcdef"[source() % 16];
  return token;
}

/// One request of one connection, and its answer.
class Session : public std::enable_shared_from_this<Session> {
 public:
  Session(Tcp::socket socket, std::string host, std::string path, const Handler& handler)
      : stream_(std::move(socket)),
        host_(std::move(host)),
        path_(std::move(path)),
        handler_(handler) {
    parser_.body_limit(max_body);
  }

  void start() {
    stream_.expires_after(patience);
    http::async_read(stream_, buffer_, parser_,
                     [self = shared_from_this()](beast::error_code failed, std::size_t) {
                       if (!failed) self->answer();
                     });
  }

 private:
  /// Pages of other sites may send requests here, but they can't know the token. A name that
  /// another site lets point here is another host.
  bool is_allowed() const {
    const auto& request = parser_.get();
    const std::string local = "localhost" + host_.substr(host_.find(':'));
    return (request[http::field::host] == host_ || request[http::field::host] == local) &&
           request.target().starts_with(path_);
  }

  void answer() {
    Answer given{404, "text/plain", "There is nothing here."};
    const auto& request = parser_.get();
    if (is_allowed()) {
      const std::string_view target(request.target().data(), request.target().size());
      given = handler_({std::string(request.method_string()),
                        std::string(target.substr(path_.size())), request.body()});
    }
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
                      [self = shared_from_this()](beast::error_code, std::size_t) {
                        beast::error_code ignored;
                        self->stream_.socket().shutdown(Tcp::socket::shutdown_send, ignored);
                      });
  }

  beast::tcp_stream stream_;
  beast::flat_buffer buffer_;
  http::request_parser<http::string_body> parser_;
  http::response<http::string_body> answer_;
  std::string host_, path_;
  const Handler& handler_;
};

}  // namespace

struct Server::Listener {
  asio::io_context context{1};
  std::optional<Tcp::acceptor> acceptor;

  void accept(const std::string& host, const std::string& path, const Handler& handler) {
    acceptor->async_accept([=, this, &handler](beast::error_code failed, Tcp::socket socket) {
      if (!failed) std::make_shared<Session>(std::move(socket), host, path, handler)->start();
      if (acceptor->is_open()) accept(host, path, handler);
    });
  }
};

Server::Server(int port) : listener_(std::make_unique<Listener>()), token_(random_token()) {
  const Tcp::endpoint here(asio::ip::address_v4::loopback(), static_cast<std::uint16_t>(port));
  try {
    listener_->acceptor.emplace(listener_->context, here);
  } catch (const boost::system::system_error& problem) {
    throw Error("--port " + std::to_string(port), problem.code().message(),
                "give another port, or none");
  }
}

Server::~Server() = default;

std::string Server::address() const {
  return "http://127.0.0.1:" + std::to_string(listener_->acceptor->local_endpoint().port()) + "/" +
         token_ + "/";
}

void Server::run(const Handler& answer) {
  asio::signal_set signals(listener_->context, SIGINT, SIGTERM, SIGHUP);
  signals.async_wait([&](beast::error_code, int) { listener_->context.stop(); });
  const std::string whole = address();
  const std::size_t host = whole.find("//") + 2;
  const std::size_t path = whole.find('/', host);
  listener_->accept(whole.substr(host, path - host), whole.substr(path), answer);
  listener_->context.run();
}

}  // namespace toile
