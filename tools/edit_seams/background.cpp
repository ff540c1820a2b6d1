#include "tools/edit_seams/background.h"

#include <nlohmann/json.hpp>

#include "geometry/error.h"

namespace toile {

void Background::finish() {
  if (thread_.joinable()) thread_.join();
}

void Background::set(const std::string& state, const std::string& text) {
  const std::lock_guard lock(mutex_);
  state_ = state;
  text_ = text;
}

void Background::start(std::function<std::string(const Say&)> work) {
  {
    const std::lock_guard lock(mutex_);
    if (state_ == "working") throw Error(name_, "is at work", "wait for it");
    state_ = "working";
    text_ = "";
  }
  finish();
  thread_ = std::thread([this, work = std::move(work)] {
    try {
      std::string made = work([this](const std::string& text) { set("working", text); });
      const std::lock_guard lock(mutex_);
      result_ = std::move(made);
      state_ = "done";
    } catch (const std::exception& problem) {
      set("failed", problem.what());
    }
  });
}

std::string Background::progress() const {
  const std::lock_guard lock(mutex_);
  return nlohmann::json{{"state", state_}, {"text", text_}}.dump();
}

std::string Background::result() const {
  const std::lock_guard lock(mutex_);
  if (result_.empty()) throw Error(name_, "has no result", "start it first");
  return result_;
}

}  // namespace toile
