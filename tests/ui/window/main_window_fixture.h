// The main window with a small scene, and a person in front of it. For tests on the GUI thread.
#pragma once

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QDragEnterEvent>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>

#include "tests/core/small_scene.h"
#include "ui/chart/chart_view.h"
#include "ui/panels/parameter_panel.h"
#include "ui/panels/value_entry.h"
#include "ui/panels/value_slider.h"
#include "ui/window/contact/contact_canvas.h"
#include "ui/window/figures/figure_pages.h"
#include "ui/window/main/appearance.h"
#include "ui/window/main/document_commands.h"
#include "ui/window/main/exports.h"
#include "ui/window/main/main_window.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/scene_document.h"
#include "ui/window/main/session.h"
#include "ui/window/main/tour.h"
#include "ui/window/main/window_layout.h"

namespace asperity {

inline constexpr int kWindowPatience = 20000;  // ms, far more than anything here takes

inline Scene smallScene() {
  Scene scene = sceneOfSize(256, 9, 3);
  scene.title = "small";
  return scene;
}

/// Opens a file in a window; whether its scene is shown, once it was read.
inline bool openIn(MainWindow& window, const QString& file) {
  QSignalSpy reads(&window.documentCommands(), &DocumentCommands::sceneRead);
  window.documentCommands().openFile(file);
  return QTest::qWaitFor([&] { return !reads.isEmpty(); }, kWindowPatience) &&
         reads.takeFirst().at(1).toBool();
}

class MainWindowTest : public testing::Test {
 protected:
  MainWindowTest() : window_(smallScene()) {
    window_.panel().setView({true, {}});  // all rows
    window_.show();
    window_.activateWindow();
  }

  Session& session() { return window_.session(); }
  const Frame* frame() { return session().frame().get(); }
  /// The friction curve as it is shown.
  const Diagram& chart() { return window_.plotView().sheet().diagrams.front(); }

  template <class Condition>
  bool waitFor(Condition condition) {
    return QTest::qWaitFor(condition, kWindowPatience);
  }
  void drop(const QString& file) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file)});
    QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window_, &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window_, &drop);
  }
  /// Whether the file's scene is shown, once it was read.
  bool open(const QString& file) { return openIn(window_, file); }
  bool waitForFrame() {
    return waitFor([&] { return frame() && frame()->sceneNumber == session().sceneNumber(); });
  }

  /// Until the runner stands still, as it does when it is paused or nobody sees it. It obeys one
  /// order after the other: the answer to one shows that nothing before it goes on.
  bool waitForRest() {
    const auto answered = [this](bool slopes) {
      FrameFields fields = window_.canvas().fields();
      fields.lineSlope = slopes;
      session().wantFields(fields);
      return waitFor([&] { return frame() && frame()->lineSlope.empty() != slopes; });
    };
    const bool had = window_.canvas().fields().lineSlope;
    return answered(!had) && answered(had);
  }

  template <class Control>
  Control& control(const QString& name) {
    return *window_.findChild<Control*>(name);
  }
  void type(const QString& key, const QString& text) {
    auto& entry = control<ValueEntry>("entry:" + key);
    entry.setFocus();
    entry.selectAll();
    QTest::keyClicks(&entry, text);
    QTest::keyClick(&entry, Qt::Key_Return);
  }
  QAction& action(const QString& name) { return control<QAction>(name); }
  void press(const QString& key) {
    QTest::keyClick(&control<ValueSlider>("slider:" + key), Qt::Key_Right);
  }

  /// Answers the next question before what is not saved would be lost.
  void answer(QMessageBox::StandardButton button) {
    asked_ = 0;
    answerWhenAsked(button, 100);
  }
  int asked_ = 0;

  QString fact(const QString& name) { return control<QLabel>(name).text(); }

  MainWindow window_;

 private:
  void answerWhenAsked(QMessageBox::StandardButton button, int patience) {
    QTimer::singleShot(10, &window_, [this, button, patience] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (!box) return patience > 0 ? answerWhenAsked(button, patience - 1) : void();
      ++asked_;
      QTest::mouseClick(box->button(button), Qt::LeftButton);
    });
  }
};

}  // namespace asperity
