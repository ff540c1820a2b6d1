// Work that goes on while the server answers.
#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace toile {

/// One piece of work at a time, in a thread of its own.
class Background {
 public:
  /// What the work calls to say how far it is.
  using Say = std::function<void(const std::string&)>;

  /// `name`: of the work, for messages, such as "dress".
  explicit Background(std::string name) : name_(std::move(name)) {}
  ~Background() { finish(); }

  /// Begins `work`, which returns the result. An exception is its end, too: its text is the
  /// progress. Throws Error while the last work is not done.
  void start(std::function<std::string(const Say&)> work);

  /// Waits for the work's end.
  void finish();

  /// JSON: `state` (idle, working, done, failed) and `text` for people.
  std::string progress() const;

  /// Of the last work that was done. Throws Error when there is none.
  std::string result() const;

 private:
  void set(const std::string& state, const std::string& text);

  std::string name_;
  mutable std::mutex mutex_;  // of what follows
  std::string state_ = "idle";
  std::string text_;
  std::string result_;
  std::thread thread_;
};

}  // namespace toile
