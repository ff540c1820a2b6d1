// A small web server for one person at this machine.
#pragma once

#include <functional>
#include <memory>
#include <string>

namespace toile {

struct Request {
  std::string method;  ///< such as "GET"
  std::string target;  ///< what follows the address, without a slash in front
  std::string body;
};

struct Answer {
  int status = 200;
  std::string type;  ///< of the content, such as "text/plain"
  std::string body;
};

/// Listens on the loopback address only. The address that it gives has a random token. Requests
/// without it, or for another host, get 404. So no other page of the browser can send any.
class Server {
 public:
  /// `port` 0: any that is free. Throws Error when it is taken.
  explicit Server(int port);
  ~Server();

  /// Such as "http://127.0.0.1:8080/3f…/".
  std::string address() const;

  /// Answers requests one after another, until SIGINT, SIGTERM or SIGHUP: `answer` has to be quick.
  /// A header has 8 KiB and 5 seconds, then a body has 64 MiB and 30 seconds. A body without the
  /// token is not read. 24 connections are open at most; others wait.
  void run(const std::function<Answer(const Request&)>& answer);

 private:
  struct Listener;
  std::unique_ptr<Listener> listener_;
  std::string token_;
};

}  // namespace toile
