// A main window in a language, at the size of a lecturer's projector; and what can be read in it.
// For tests on the GUI thread.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "tests/ui/window/main_window_fixture.h"
#include "ui/language/language.h"

namespace asperity {

/// A window in a language, which goes back to English with it.
class WindowIn {
 public:
  explicit WindowIn(std::string_view code, const Scene& scene = smallScene()) {
    useLanguage(code);
    window_ = std::make_unique<MainWindow>(scene);
    window_->resize(1280, 720);
    window_->show();
  }
  ~WindowIn() {
    window_.reset();
    useLanguage("en");
  }
  MainWindow& operator*() { return *window_; }
  MainWindow* operator->() { return window_.get(); }

  /// Runs until there are a frame and a curve to speak of.
  bool waitForCurve() {
    return QTest::qWaitFor([this] { return window_->session().friction().progress() >= 1; },
                           kWindowPatience);
  }

 private:
  std::unique_ptr<MainWindow> window_;
};

using Texts = std::set<std::string>;

/// Everything that a person can read or hear of a window.
Texts textsOf(const MainWindow& window);

/// Words of one set that stand in the other, too, though they are not the same in both languages.
Texts leftOver(const Texts& shown, const Texts& other);

/// The options of the picture that a canvas shows, in the canvas's pixels.
ContactPictureOptions shownOptions(const ContactCanvas& canvas);

/// The middle of a label or an arrow, in pixels.
QPoint middleOf(const Box& place);

/// The middle of the label or arrow of a canvas that changes this; none where there is none.
std::optional<QPoint> handleIn(const ContactCanvas& canvas, ContactHandle wanted);

/// What is cut off of everything in sight, one a line, once the layout has settled.
std::string cutOffIn(const QWidget& window);

}  // namespace asperity
