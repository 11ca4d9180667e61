#pragma once

#include <string_view>

namespace rocinante::cli {

/// A line on standard error that replaces itself, on a terminal; nothing elsewhere. The terminal
/// itself cuts it to its width, however it is resized. One thread.
class StatusLine {
 public:
  /// Shows nothing unless `visible`, either.
  explicit StatusLine(bool visible = true);
  ~StatusLine();
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  bool isVisible() const { return visible_; }
  void show(std::string_view text);
  /// Removes the line until the next show(): before any other line is printed.
  void clear();

 private:
  bool visible_;
  bool shown_ = false;
};

}  // namespace rocinante::cli
